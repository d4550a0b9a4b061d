// Scene text -> words, strings and brackets with places.
#pragma once

#include "core/errors.h"

#include <memory>
#include <string>
#include <string_view>

namespace vitrine {

struct Token {
    enum class Kind {
        End,
        Word,   ///< a directive, a number, true, false
        String, ///< text: between the quotes, escapes as written
        Open,   ///< [
        Close,  ///< ]
        Broken  ///< a string without its closing quote
    };
    Kind kind = Kind::End;
    std::string_view text;
    int line = 0, column = 0;
    int length = 1; ///< with quotes

    bool isWord(std::string_view word) const { return kind == Kind::Word && text == word; }
    /// For messages: `"abc"`, `the string "abc"`, `"]"`, `the end of the file`.
    std::string describe() const;
};

/// Reads tokens one after the other with one token of look-ahead. Never throws while reading: a broken string is a
/// token, so that skipping over garbage costs nothing.
class Lexer {
  public:
    explicit Lexer(std::shared_ptr<const SourceFile> file);
    /// Reads from a place on that lies at the byte `offset` of its file.
    Lexer(const Place& from, std::size_t offset);
    /// Reads `text`, a stand-in of the same length for what the file has from the place on.
    Lexer(const Place& from, std::string_view text);

    const Token& peek() {
        if (!havePeeked_) {
            peeked_ = scan();
            havePeeked_ = true;
        }
        return peeked_;
    }
    Token next() {
        if (!havePeeked_) return scan();
        havePeeked_ = false;
        return peeked_;
    }

    const std::shared_ptr<const SourceFile>& file() const { return file_; }
    /// Byte of the token's first character in the file's text.
    std::size_t offset(const Token& token) const {
        return std::size_t(token.text.data() - file_->text.data()) - (token.kind == Token::Kind::String);
    }
    Place place(const Token& token) const { return Place{file_, token.line, token.column, token.length}; }
    /// The string's value. \throws SceneError at an escape that pbrt-v4 does not know
    std::string unescaped(const Token& string) const;
    /// Takes a string token and returns its value. \throws SceneError `expected <what>, got ...` when it is none; the
    /// token is left to be read again.
    std::string takeString(std::string_view what);

  private:
    Token scan();
    Token scanString();
    Token token(Token::Kind kind, const char* begin, const char* textBegin, const char* textEnd) const;
    void skipBlanks();

    std::shared_ptr<const SourceFile> file_;
    const char* p_;
    const char* end_;
    const char* lineStart_;          ///< the column of p is p - lineStart_ + 1 + columnShift_
    std::ptrdiff_t columnShift_ = 0; ///< of a first line that is not read from its beginning
    int line_ = 1;
    Token peeked_;
    bool havePeeked_ = false;
};

/// The place of some bytes of a string's value, of which `string` is the place with its quotes: what stands before them
/// may have been written with escapes.
Place placeInString(const Place& string, std::size_t offset, std::size_t length);

} // namespace vitrine
