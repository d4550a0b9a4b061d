// Numbers, flags and separators in the attributes of SVG.
#pragma once

#include <string>
#include <string_view>

namespace vitrine {

/// Reads a text from left to right. Numbers need no separators where the next one cannot be taken for a part of the
/// last: "1.5.5-2" are three.
class SvgScanner {
  public:
    explicit SvgScanner(std::string_view text) : text_(text) {}

    std::size_t offset() const { return at_; }
    bool atEnd() const { return at_ == text_.size(); }
    /// The character that comes, 0 at the end.
    char peek() const { return atEnd() ? '\0' : text_[at_]; }
    char take() { return atEnd() ? '\0' : text_[at_++]; }
    /// What has been read since the byte `from`.
    std::string_view since(std::size_t from) const { return text_.substr(from, at_ - from); }

    void skipBlanks();
    /// Passes blanks and a comma, which must stand between two values. \throws SvgTextError when it does not
    void skipSeparator();
    /// Whether a number comes.
    bool startsNumber() const;
    /// The number that comes; it fits into a float. \throws SvgTextError
    double number();
    /// The same, where none may come: then the error says that `what` was expected.
    double number(std::string_view what);
    /// Whether 0 or 1 comes: a flag, which needs no separator after it.
    bool startsFlag() const { return peek() == '0' || peek() == '1'; }
    bool flag() { return take() == '1'; }
    /// "expected `what`, got ..." \throws SvgTextError
    [[noreturn]] void refuseNext(std::string_view what) const;
    /// Letters, digits and '-' of a name, perhaps none.
    std::string_view name();

  private:
    std::size_t endOfNumber(std::size_t begin) const;
    std::size_t lengthOfNext() const;

    std::string_view text_;
    std::size_t at_ = 0;
};

} // namespace vitrine
