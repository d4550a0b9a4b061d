#include "nodes/svg_scanner.h"

#include "nodes/svg_path.h"
#include "nodes/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine {

namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

} // namespace

void SvgScanner::skipBlanks() {
    while (!atEnd() && isBlank(text_[at_]))
        ++at_;
}

void SvgScanner::skipSeparator() {
    skipBlanks();
    if (peek() != ',') return;
    const std::size_t comma = at_++;
    skipBlanks();
    if (!startsNumber()) throw SvgTextError(comma, 1, "a comma must stand between two numbers");
}

bool SvgScanner::startsNumber() const {
    std::size_t i = at_;
    if (i < text_.size() && (text_[i] == '+' || text_[i] == '-')) ++i;
    if (i < text_.size() && text_[i] == '.') ++i;
    return i < text_.size() && isDigit(text_[i]);
}

/// SVG 2, 9.3.9, which has no point at a number's end ("1."); that of SVG 1.1 has, and so do files.
std::size_t SvgScanner::endOfNumber(std::size_t begin) const {
    std::size_t i = begin;
    const auto at = [&](std::size_t k) { return k < text_.size() ? text_[k] : '\0'; };
    const auto skipDigits = [&] {
        while (isDigit(at(i)))
            ++i;
    };
    if (at(i) == '+' || at(i) == '-') ++i;
    skipDigits();
    if (at(i) == '.') ++i;
    skipDigits();
    if (at(i) == 'e' || at(i) == 'E') {
        const std::size_t sign = i + 1, digit = sign + (at(sign) == '+' || at(sign) == '-');
        if (!isDigit(at(digit))) return i; // a unit: "2em"
        i = digit;
        skipDigits();
    }
    return i;
}

double SvgScanner::number() {
    const std::size_t begin = at_;
    at_ = endOfNumber(begin);
    double value = 0;
    const NumberFault fault = parseReal(since(begin), value);
    if (fault != NumberFault::None) throw SvgTextError(begin, at_ - begin, describe(fault, since(begin)));
    return value;
}

double SvgScanner::number(std::string_view what) {
    if (!startsNumber()) refuseNext(what);
    return number();
}

std::string_view SvgScanner::name() {
    const std::size_t begin = at_;
    while (!atEnd() && (isLetter(text_[at_]) || isDigit(text_[at_]) || text_[at_] == '-'))
        ++at_;
    return since(begin);
}

std::size_t SvgScanner::lengthOfNext() const {
    if (startsNumber()) return endOfNumber(at_) - at_;
    std::size_t i = at_;
    while (i < text_.size() && isLetter(text_[i]))
        ++i;
    if (i == at_)
        while (i < text_.size() && !isBlank(text_[i]) && !isLetter(text_[i]) && !isDigit(text_[i]))
            ++i;
    return std::max<std::size_t>(1, i - at_);
}

void SvgScanner::refuseNext(std::string_view what) const {
    const std::string got = atEnd() ? "the end" : inQuotes(text_.substr(at_, lengthOfNext()));
    throw SvgTextError(at_, lengthOfNext(), fmt::format("expected {}, got {}", what, got));
}

} // namespace vitrine
