#include "nodes/lexer.h"

#include "nodes/text.h"

#include <algorithm>
#include <limits>

namespace vitrine {

namespace {

int clampedInt(std::ptrdiff_t n) {
    return int(std::min<std::ptrdiff_t>(n, std::numeric_limits<int>::max()));
}

/// Ends a word, as in pbrt-v4: note that '#' does not.
bool endsWord(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '"' || c == '[' || c == ']';
}

} // namespace

std::string Token::describe() const {
    switch (kind) {
    case Kind::End:
        return "the end of the file";
    case Kind::Word:
        return inQuotes(text);
    case Kind::String:
        return "the string " + inQuotes(text);
    case Kind::Open:
        return "\"[\"";
    case Kind::Close:
        return "\"]\"";
    case Kind::Broken:
        return "a string without its closing quote";
    }
    return {};
}

Lexer::Lexer(std::shared_ptr<const SourceFile> file)
    : file_(std::move(file)), p_(file_->text.data()), end_(p_ + file_->text.size()), lineStart_(p_) {
    // A byte order mark of UTF-8 says nothing; an editor put it there.
    if (std::string_view(file_->text).starts_with("\xef\xbb\xbf")) p_ += 3;
}

Lexer::Lexer(const Place& from, std::size_t offset) : Lexer(from, std::string_view(from.file->text).substr(offset)) {}

Lexer::Lexer(const Place& from, std::string_view text)
    : file_(from.file), p_(text.data()), end_(p_ + text.size()), lineStart_(p_),
      columnShift_(std::max(1, from.column) - 1), line_(from.line) {}

void Lexer::skipBlanks() {
    for (; p_ != end_; ++p_) {
        const char c = *p_;
        if (c == '\n') {
            ++line_;
            lineStart_ = p_ + 1;
            columnShift_ = 0;
        } else if (c == '#') {
            while (p_ + 1 != end_ && p_[1] != '\n' && p_[1] != '\r')
                ++p_;
        } else if (c != ' ' && c != '\t' && c != '\r') {
            return;
        }
    }
}

Token Lexer::token(Token::Kind kind, const char* begin, const char* textBegin, const char* textEnd) const {
    return Token{kind, std::string_view(textBegin, std::size_t(textEnd - textBegin)), line_,
                 clampedInt(begin - lineStart_ + 1 + columnShift_),
                 clampedInt(std::max<std::ptrdiff_t>(1, p_ - begin))};
}

Token Lexer::scan() {
    skipBlanks();
    const char* begin = p_;
    if (p_ == end_) return token(Token::Kind::End, begin, begin, begin);
    if (*p_ == '"') return scanString();
    if (*p_ == '[' || *p_ == ']') {
        ++p_;
        return token(*begin == '[' ? Token::Kind::Open : Token::Kind::Close, begin, begin, p_);
    }
    do
        ++p_;
    while (p_ != end_ && !endsWord(*p_));
    return token(Token::Kind::Word, begin, begin, p_);
}

Token Lexer::scanString() {
    const char* begin = p_++;
    while (p_ != end_ && *p_ != '"' && *p_ != '\n') {
        if (*p_ == '\\' && p_ + 1 != end_ && p_[1] != '\n') ++p_;
        ++p_;
    }
    if (p_ == end_ || *p_ == '\n') return token(Token::Kind::Broken, begin, begin, p_);
    ++p_;
    return token(Token::Kind::String, begin, begin + 1, p_ - 1);
}

std::string Lexer::unescaped(const Token& string) const {
    if (string.text.find('\\') == std::string_view::npos) return std::string(string.text);
    static constexpr std::string_view letters = "bfnrt\\'\"", meanings = "\b\f\n\r\t\\'\"";
    std::string value;
    for (std::size_t i = 0; i < string.text.size(); ++i) {
        char c = string.text[i];
        if (c == '\\') {
            const std::size_t k = letters.find(string.text[i + 1]);
            if (k == std::string_view::npos)
                throw SceneError(Place{file_, string.line, string.column + int(i) + 1, 2},
                                 "unknown escape " + inQuotes(string.text.substr(i, 2)) + " in a string",
                                 "write \"\\\\\" for a backslash");
            c = meanings[k];
            ++i;
        }
        value += c;
    }
    return value;
}

std::string Lexer::takeString(std::string_view what) {
    const Token token = peek();
    if (token.kind == Token::Kind::Broken) throw SceneError(place(next()), "the string lacks its closing quote");
    if (token.kind != Token::Kind::String) {
        const bool bareWord = token.kind == Token::Kind::Word;
        throw SceneError(place(token), "expected " + std::string(what) + ", got " + token.describe(),
                         bareWord ? "strings stand in double quotes" : "");
    }
    next();
    return unescaped(token);
}

Place placeInString(const Place& string, std::size_t offset, std::size_t length) {
    if (!string || string.line <= 0) return string;
    const std::string_view text = string.file->text;
    std::size_t begin = 0;
    for (int line = 1; line < string.line; ++line)
        begin = text.find('\n', begin) + 1;
    begin += std::size_t(string.column) - 1;
    if (begin >= text.size() || text[begin] != '"') return string;
    std::size_t at = begin + 1;
    const auto pass = [&](std::size_t count) {
        for (; count > 0 && at < text.size() && text[at] != '"'; --count)
            at += text[at] == '\\' ? 2 : 1;
    };
    pass(offset);
    const std::size_t first = at;
    pass(length);
    return Place{string.file, string.line, string.column + clampedInt(std::ptrdiff_t(first - begin)),
                 std::max(1, clampedInt(std::ptrdiff_t(at - first)))};
}

} // namespace vitrine
