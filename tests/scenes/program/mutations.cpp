#include "mutations.h"

#include "core/random.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

namespace vitrine::test {

namespace {

constexpr std::uint64_t seed = 20240603;

struct Span {
    std::size_t begin, size;
};

class Mutator {
  public:
    Mutator(std::string text, std::uint64_t number) : text_(std::move(text)), random_(seed, number) {}

    std::string run() {
        using Fault = void (Mutator::*)();
        static constexpr std::array<Fault, 18> faults = {
            &Mutator::flipBit,       &Mutator::setByte,       &Mutator::cutBytes,    &Mutator::repeatBytes,
            &Mutator::swapTokens,    &Mutator::dropToken,     &Mutator::doubleToken, &Mutator::replaceNumber,
            &Mutator::replaceNumber, &Mutator::listLength,    &Mutator::scaleNumber, &Mutator::scaleNumber,
            &Mutator::changeType,    &Mutator::replaceString, &Mutator::dropLine,    &Mutator::doubleLine,
            &Mutator::shuffleLines,  &Mutator::cutEnd};
        static constexpr std::array<int, 6> counts = {1, 1, 1, 1, 2, 3};
        for (int n = pick(counts); n > 0; --n)
            if (!text_.empty()) (this->*pick(faults))();
        return std::move(text_);
    }

  private:
    std::size_t below(std::size_t n) { return std::size_t(random_.bits() % std::max<std::size_t>(1, n)); }
    template <class Items>
    const typename Items::value_type& pick(const Items& items) {
        return items[below(items.size())];
    }

    void flipBit() { text_[below(text_.size())] ^= char(1 << below(8)); }
    void setByte() { text_[below(text_.size())] = char(below(256)); }
    void cutBytes() { text_.erase(below(text_.size()), 1 + below(20)); }
    void repeatBytes() {
        const std::string piece = text_.substr(below(text_.size()), 1 + below(40));
        text_.insert(below(text_.size()), piece);
    }

    void swapTokens() {
        const auto all = tokens();
        if (all.empty()) return;
        Span a = pick(all), b = pick(all);
        if (a.begin == b.begin) return;
        if (a.begin > b.begin) std::swap(a, b);
        const std::string textA = text_.substr(a.begin, a.size), textB = text_.substr(b.begin, b.size);
        text_.replace(b.begin, b.size, textA);
        text_.replace(a.begin, a.size, textB);
    }
    void dropToken() {
        if (const auto all = tokens(); !all.empty()) replace(pick(all), "");
    }
    void doubleToken() {
        const auto all = tokens();
        if (all.empty()) return;
        const Span token = pick(all);
        text_.insert(token.begin, text_.substr(token.begin, token.size) + " ");
    }

    void replaceNumber() {
        static constexpr std::array values = {"0",          "-0",
                                              "1",          "-1",
                                              "2",          "3",
                                              "0.5",        "1e-7",
                                              "1e-30",      "1e-320",
                                              "1e4",        "1e10",
                                              "1e30",       "3.4e38",
                                              "-3e38",      "1e39",
                                              "1e308",      "-1e308",
                                              "1e999",      "nan",
                                              "inf",        "-inf",
                                              "2147483647", "-2147483648",
                                              "4294967296", "99999999999999999999",
                                              "0x10",       "1,5",
                                              "1e",         "--1",
                                              "true",       "1000000"};
        if (const auto all = numbers(); !all.empty()) replace(pick(all), pick(values));
    }
    void scaleNumber() {
        static constexpr std::array factors = {"-", "0.", "1", "10", "-.0", "1000", "00000", "-1e3"};
        if (const auto all = numbers(); !all.empty()) text_.insert(pick(all).begin, pick(factors));
    }
    void listLength() {
        const auto all = numbers();
        if (all.empty()) return;
        const Span number = pick(all);
        if (below(2))
            replace(number, "");
        else
            for (std::size_t n = 1 + below(5); n > 0; --n)
                text_.insert(number.begin, "0.25 ");
    }

    void changeType() {
        static constexpr std::array<std::string_view, 17> types = {
            "integer", "float",   "bool", "string",    "texture",  "point",  "point2", "vector2", "point3",
            "vector3", "normal3", "rgb",  "blackbody", "spectrum", "normal", "color",  ""};
        std::vector<Span> declared;
        for (const Span& token : tokens())
            for (const auto type : types)
                if (!type.empty() && text_.compare(token.begin + 1, type.size() + 1, std::string(type) + " ") == 0)
                    declared.push_back({token.begin + 1, type.size()});
        if (!declared.empty()) replace(pick(declared), pick(types));
    }
    void replaceString() {
        std::vector<Span> strings;
        for (const Span& token : tokens())
            if (text_[token.begin] == '"') strings.push_back(token);
        if (strings.empty()) return;
        const Span from = pick(strings);
        replace(pick(strings), text_.substr(from.begin, from.size));
    }

    void dropLine() {
        changeLines([&](auto& lines) { lines.erase(lines.begin() + std::ptrdiff_t(below(lines.size()))); });
    }
    void doubleLine() {
        changeLines([&](auto& lines) {
            const std::string line = pick(lines);
            lines.insert(lines.begin() + std::ptrdiff_t(below(lines.size())), line);
        });
    }
    void shuffleLines() {
        changeLines([&](auto& lines) {
            if (below(4)) return std::swap(lines[below(lines.size())], lines[below(lines.size())]);
            for (std::size_t i = lines.size(); i > 1; --i)
                std::swap(lines[i - 1], lines[below(i)]);
        });
    }
    void cutEnd() { text_.resize(below(text_.size())); }

    std::vector<Span> tokens() const {
        std::vector<Span> found;
        for (std::size_t i = 0; i < text_.size();) {
            if (std::isspace(static_cast<unsigned char>(text_[i]))) {
                ++i;
                continue;
            }
            std::size_t end = text_[i] == '"' ? text_.find('"', i + 1) : text_.find_first_of(" \t\n\"[]", i);
            end = end == std::string::npos ? text_.size() : text_[i] == '"' ? end + 1 : std::max(end, i + 1);
            found.push_back({i, end - i});
            i = end;
        }
        return found;
    }
    std::vector<Span> numbers() const {
        auto found = tokens();
        std::erase_if(found, [&](const Span& t) {
            return std::string_view("0123456789.-").find(text_[t.begin]) == std::string_view::npos;
        });
        return found;
    }
    void replace(const Span& span, std::string_view by) { text_.replace(span.begin, span.size, by); }

    template <class Change>
    void changeLines(Change&& change) {
        std::vector<std::string> lines;
        for (std::size_t i = 0; i < text_.size();) {
            const std::size_t end = std::min(text_.find('\n', i), text_.size() - 1) + 1;
            lines.push_back(text_.substr(i, end - i));
            i = end;
        }
        change(lines);
        text_.clear();
        for (const auto& line : lines)
            text_ += line;
    }

    std::string text_;
    RandomStream random_;
};

} // namespace

std::string mutated(const std::string& text, std::uint64_t number) {
    return Mutator(text, number).run();
}

} // namespace vitrine::test
