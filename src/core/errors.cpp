#include "core/errors.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace vitrine {

namespace {

/// Line `number` (from 1) of `text`, without its line end.
std::string lineOf(const std::string& text, int number) {
    std::size_t begin = 0;
    for (int i = 1; i < number; ++i) {
        begin = text.find('\n', begin);
        if (begin == std::string::npos) return {};
        ++begin;
    }
    const std::size_t end = text.find_first_of("\r\n", begin);
    return text.substr(begin, end == std::string::npos ? end : end - begin);
}

/// The part of a long line around the column, control characters as spaces so that the caret stays below its place.
std::string excerpt(std::string line, int column, int length) {
    constexpr int width = 120;
    for (char& c : line)
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = ' ';
    const int first = column > width - 20 ? column - width / 2 : 0;
    if (first >= int(line.size()) + 1) return {};
    std::string shown = line.substr(std::size_t(first), width);
    // Never cut inside a UTF-8 sequence: an error must be valid text.
    while (!shown.empty() && first > 0 && (static_cast<unsigned char>(shown.front()) & 0xc0) == 0x80) shown.front() = ' ';
    const int caretColumn = std::max(0, column - 1 - first);
    const int carets = std::clamp(length, 1, std::max(1, int(shown.size()) - caretColumn));
    return "    " + shown + "\n    " + std::string(std::size_t(caretColumn), ' ') + std::string(std::size_t(carets), '^');
}

int editDistance(const std::string& a, const std::string& b) {
    std::vector<int> previous2, previous(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = int(j);
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
    for (char& c : s) c = char(std::tolower(static_cast<unsigned char>(c)));
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
        const std::string shown = excerpt(lineOf(place.file->text, place.line), std::max(1, place.column), place.length);
        if (!shown.empty()) text += "\n" + shown;
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
    ++errors_;
    all_.push_back({Diagnostic::Severity::Error, std::move(place), std::move(message), std::move(hint)});
}

void Diagnostics::warning(Place place, std::string message, std::string hint) {
    all_.push_back({Diagnostic::Severity::Warning, std::move(place), std::move(message), std::move(hint)});
}

void Diagnostics::throwIfErrors() const {
    if (hasErrors()) throw SceneError(all_);
}

std::string nearestName(const std::string& word, const std::vector<std::string>& candidates) {
    // Words of user input can be of any length; no valid name is longer than this.
    if (word.size() > 64) return {};
    std::string best;
    int bestDistance = std::max(1, int(word.size()) / 3) + 1;
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
