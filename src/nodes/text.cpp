#include "nodes/text.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

namespace vitrine {

namespace {

/// Length of the UTF-8 sequence at the start of `s`, 0 when it is none (overlong forms and surrogates included).
std::size_t utf8Length(std::string_view s) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
    const unsigned lead = byte(0);
    const std::size_t n = lead < 0x80                   ? 1
                          : lead >= 0xc2 && lead < 0xe0 ? 2
                          : lead >= 0xe0 && lead < 0xf0 ? 3
                          : lead >= 0xf0 && lead < 0xf5 ? 4
                                                        : 0;
    if (n == 0 || n > s.size()) return 0;
    for (std::size_t i = 1; i < n; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    if (lead == 0xe0 && byte(1) < 0xa0) return 0;
    if (lead == 0xed && byte(1) >= 0xa0) return 0;
    if (lead == 0xf0 && byte(1) < 0x90) return 0;
    if (lead == 0xf4 && byte(1) >= 0x90) return 0;
    return n;
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Whether a decimal number that no double holds is too small rather than too large: the sign of the power of ten of
/// its first digit that is not zero.
bool underflows(std::string_view word) {
    long power = 0;
    bool point = false, significant = false;
    std::size_t i = 0;
    for (; i < word.size() && (isDigit(word[i]) || word[i] == '.'); ++i) {
        if (word[i] == '.') {
            point = true;
            continue;
        }
        significant |= word[i] != '0';
        if (significant && !point) ++power;
        if (!significant && point) --power;
    }
    if (i < word.size() && (word[i] == 'e' || word[i] == 'E')) {
        ++i;
        const bool negative = i < word.size() && word[i] == '-';
        if (i < word.size() && (word[i] == '-' || word[i] == '+')) ++i;
        long exponent = 0;
        for (; i < word.size() && isDigit(word[i]); ++i)
            if (exponent < 1'000'000'000'000) exponent = exponent * 10 + (word[i] - '0');
        power += negative ? -exponent : exponent;
    }
    return power < 0;
}

bool saysNotFinite(std::string_view word) {
    std::string lower;
    for (char c : word.substr(0, 9))
        lower += char(std::tolower(static_cast<unsigned char>(c)));
    return lower == "nan" || lower == "inf" || lower == "infinity" || lower.starts_with("nan(");
}

} // namespace

std::string inQuotes(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text = "\"";
    std::size_t i = 0;
    while (i < word.size() && i < longest) {
        const std::size_t n = utf8Length(word.substr(i));
        const auto c = static_cast<unsigned char>(word[i]);
        if (n == 0 || c < ' ' || c == 127) {
            text += fmt::format("\\x{:02x}", c);
            ++i;
        } else {
            text += word.substr(i, n);
            i += n;
        }
    }
    return text + (i < word.size() ? "...\"" : "\"");
}

NumberFault parseReal(std::string_view word, double& value) {
    const char* first = word.data();
    const char* last = first + word.size();
    bool negative = false;
    if (first != last && (*first == '+' || *first == '-')) negative = *first++ == '-';
    const std::string_view magnitude(first, std::size_t(last - first));
    if (saysNotFinite(magnitude)) return NumberFault::NotFinite;
    if (first == last || !(isDigit(*first) || *first == '.')) return NumberFault::NotANumber;

    std::from_chars_result result{};
    if (last - first > 2 && first[0] == '0' && (first[1] == 'x' || first[1] == 'X')) {
        std::uint64_t bits = 0;
        result = std::from_chars(first + 2, last, bits, 16);
        value = double(bits);
    } else {
        result = std::from_chars(first, last, value);
    }
    if (result.ptr != last || result.ec == std::errc::invalid_argument) return NumberFault::NotANumber;
    if (result.ec == std::errc::result_out_of_range) {
        if (first[0] == '0' && (first[1] == 'x' || first[1] == 'X')) return NumberFault::TooLarge;
        if (!underflows(magnitude)) return NumberFault::TooLarge;
        value = 0;
    }
    if (value > double(std::numeric_limits<float>::max())) return NumberFault::TooLarge;
    if (negative) value = -value;
    return NumberFault::None;
}

NumberFault parseInteger(std::string_view word, int& value) {
    std::string_view digits = word;
    if (!digits.empty() && (digits[0] == '+' || digits[0] == '-')) digits.remove_prefix(1);
    if (digits.empty()) return NumberFault::NotAnInteger;
    for (char c : digits)
        if (!isDigit(c)) {
            double real = 0;
            const NumberFault fault = parseReal(word, real);
            return fault == NumberFault::NotFinite ? fault : NumberFault::NotAnInteger;
        }
    const char* first = word.data() + (word[0] == '+');
    const auto result = std::from_chars(first, word.data() + word.size(), value);
    return result.ec == std::errc::result_out_of_range ? NumberFault::BeyondInt : NumberFault::None;
}

std::string describe(NumberFault fault, std::string_view word) {
    switch (fault) {
    case NumberFault::None:
        return {};
    case NumberFault::NotANumber:
        return "expected a number, got " + inQuotes(word);
    case NumberFault::NotFinite:
        return "numbers must be finite, got " + inQuotes(word);
    case NumberFault::TooLarge:
        return inQuotes(word) + " is too large: numbers go up to 3.4e38";
    case NumberFault::NotAnInteger:
        return "expected an integer, got " + inQuotes(word);
    case NumberFault::BeyondInt:
        return inQuotes(word) + " does not fit in a 32-bit integer";
    }
    return {};
}

} // namespace vitrine
