#include "core/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace vitrine {

namespace {

/// Line `number` (from 1) of `text`, without its line end.
std::string_view lineOf(std::string_view text, int number) {
    std::size_t begin = 0;
    for (int i = 1; i < number; ++i) {
        begin = text.find('\n', begin);
        if (begin == std::string_view::npos) return {};
        ++begin;
    }
    return text.substr(begin, text.find_first_of("\r\n", begin) - begin);
}

/// One character of an excerpt and the byte of the line at which it stood.
struct Cell {
    std::string_view shown;
    std::size_t byte;
};

/// Length of the well-formed UTF-8 sequence at the start of `text`, or 0 (Unicode 15, table 3-7).
std::size_t utf8Length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto continues = [&](std::size_t i, unsigned low = 0x80, unsigned high = 0xbf) {
        return byte(i) >= low && byte(i) <= high;
    };
    const unsigned lead = byte(0);
    if (lead < 0x80) return 1;
    if (lead >= 0xc2 && lead <= 0xdf) return continues(1) ? 2 : 0;
    if (lead >= 0xe0 && lead <= 0xef)
        return continues(1, lead == 0xe0 ? 0xa0 : 0x80, lead == 0xed ? 0x9f : 0xbf) && continues(2) ? 3 : 0;
    if (lead >= 0xf0 && lead <= 0xf4)
        return continues(1, lead == 0xf0 ? 0x90 : 0x80, lead == 0xf4 ? 0x8f : 0xbf) && continues(2) && continues(3) ? 4
                                                                                                                    : 0;
    return 0;
}

bool isControl(std::string_view character) {
    const auto lead = static_cast<unsigned char>(character[0]);
    if (character.size() == 2) return lead == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0;
    return lead < ' ' || lead == 127;
}

/// The characters of line[begin, end): a space for each control character, so that the caret stays below its place, and
/// U+FFFD for each byte that is not UTF-8, since an error must be valid text.
std::vector<Cell> cellsOf(std::string_view line, std::size_t begin, std::size_t end) {
    std::vector<Cell> cells;
    for (std::size_t i = begin; i < std::min(end, line.size());) {
        const std::size_t length = utf8Length(line.substr(i));
        const std::string_view character = line.substr(i, std::max<std::size_t>(1, length));
        cells.push_back({length == 0 ? "\xef\xbf\xbd" : isControl(character) ? " " : character, i});
        i += character.size();
    }
    return cells;
}

/// The part of a line around its byte `column` (from 1), and below it carets for `length` bytes.
std::string excerpt(std::string_view line, int column, int length) {
    constexpr std::size_t width = 120, before = 60, longestCharacter = 4;
    const std::size_t at = std::min(std::size_t(column - 1), line.size());
    std::size_t begin = at - std::min(at, longestCharacter * width);
    while (begin > 0 && begin < line.size() && (static_cast<unsigned char>(line[begin]) & 0xc0) == 0x80)
        ++begin;
    const std::vector<Cell> cells = cellsOf(line, begin, at + longestCharacter * width);

    const auto cellAt = [&](std::size_t byte) {
        const auto after =
            std::upper_bound(cells.begin(), cells.end(), byte, [](std::size_t b, const Cell& c) { return b < c.byte; });
        return byte >= line.size() ? cells.size() : std::size_t(std::max<std::ptrdiff_t>(0, after - cells.begin() - 1));
    };
    const std::size_t caret = cellAt(at);
    // A line that would leave the caret near the right edge or beyond it is cut on the left.
    const std::size_t first = begin > 0 || caret >= width - 20 ? caret - std::min(caret, before) : 0;
    const std::size_t last = std::min(cells.size(), first + width);
    const std::size_t caretEnd = std::min(cellAt(at + std::size_t(std::max(1, length)) - 1) + 1, last);

    std::string text = "    ";
    for (std::size_t i = first; i < last; ++i)
        text += cells[i].shown;
    text += "\n    " + std::string(caret - first, ' ');
    return text + std::string(std::max(caret + 1, caretEnd) - caret, '^');
}

int editDistance(const std::string& a, const std::string& b) {
    std::vector<int> previous2, previous(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        previous[j] = int(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = int(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({previous[j] + 1, row[j - 1] + 1, previous[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], previous2[j - 2] + 1);
        }
        previous2 = previous;
        previous = row;
    }
    return previous.back();
}

std::string lower(std::string s) {
    for (char& c : s)
        c = char(std::tolower(static_cast<unsigned char>(c)));
    return s;
}

std::string joined(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const auto& d : diagnostics) {
        if (!text.empty()) text += '\n';
        text += d.toString();
    }
    return text;
}

} // namespace

std::string Place::toString() const {
    if (!file) return {};
    if (line <= 0) return file->name;
    return fmt::format("{}:{}:{}", file->name, line, std::max(1, column));
}

std::string Diagnostic::toString() const {
    std::string text;
    if (place) text += place.toString() + ": ";
    text += severity == Severity::Error ? "error: " : "warning: ";
    text += message;
    if (place && place.line > 0) {
        text += '\n';
        text += excerpt(lineOf(place.file->text, place.line), std::max(1, place.column), place.length);
    }
    if (!hint.empty()) text += "\n    " + hint;
    if (place)
        for (const SourceFile* f = place.file.get(); f->includedFrom; f = f->includedFrom.get())
            text += fmt::format("\n    included from {}:{}", f->includedFrom->name, f->includedAtLine);
    return text;
}

SceneError::SceneError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(joined(diagnostics)), diagnostics_(std::move(diagnostics)) {}

SceneError::SceneError(Place place, std::string message, std::string hint)
    : SceneError(std::vector<Diagnostic>{
          Diagnostic{Diagnostic::Severity::Error, std::move(place), std::move(message), std::move(hint)}}) {}

FileError::FileError(std::string file, const std::string& message)
    : std::runtime_error(file + ": " + message), file_(std::move(file)) {}

void Diagnostics::error(Place place, std::string message, std::string hint) {
    if (full()) return;
    ++errors_;
    all_.push_back({Diagnostic::Severity::Error, std::move(place), std::move(message), std::move(hint)});
}

void Diagnostics::warning(Place place, std::string message, std::string hint) {
    if (all_.size() - errors_ >= maxErrors) return;
    all_.push_back({Diagnostic::Severity::Warning, std::move(place), std::move(message), std::move(hint)});
}

void Diagnostics::throwIfErrors() const {
    if (hasErrors()) throw SceneError(all_);
}

std::string nearestName(const std::string& word, const std::vector<std::string>& candidates) {
    // Words of user input can be of any length; no valid name is longer than this.
    if (word.size() > 64) return {};
    std::string best;
    // One slip in three letters; a single letter that is wrong says nothing of what was meant.
    int bestDistance = word.size() < 2 ? 1 : std::max(1, int(word.size()) / 3) + 1;
    for (const auto& candidate : candidates) {
        const int distance = editDistance(lower(word), lower(candidate));
        if (distance < bestDistance) {
            bestDistance = distance;
            best = candidate;
        }
    }
    return best;
}

std::string didYouMean(const std::string& word, const std::vector<std::string>& candidates) {
    const std::string name = nearestName(word, candidates);
    return name.empty() ? std::string() : fmt::format("did you mean \"{}\"?", name);
}

} // namespace vitrine
