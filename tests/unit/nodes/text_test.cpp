#include "nodes/lexer.h"
#include "nodes/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

namespace vitrine {
namespace {

std::string repeat(std::string_view piece, int n) {
    std::string text;
    for (int i = 0; i < n; ++i)
        text += piece;
    return text;
}

double real(std::string_view word) {
    double value = -12345;
    EXPECT_EQ(parseReal(word, value), NumberFault::None) << word;
    return value;
}

NumberFault realFault(std::string_view word) {
    double value = 0;
    return parseReal(word, value);
}

TEST(Numbers, RealsInPbrtsSyntax) {
    EXPECT_EQ(real("7"), 7);
    EXPECT_EQ(real("-7"), -7);
    EXPECT_EQ(real("+7"), 7);
    EXPECT_EQ(real(".5"), 0.5);
    EXPECT_EQ(real("-.5"), -0.5);
    EXPECT_EQ(real("5."), 5);
    EXPECT_EQ(real("1e3"), 1000);
    EXPECT_EQ(real("1E-3"), 0.001);
    EXPECT_EQ(real("+2.5e+1"), 25);
    EXPECT_EQ(real("0x1F"), 31);
    EXPECT_EQ(real("00012.50"), 12.5);
    EXPECT_EQ(real("0.1"), 0.1);
    EXPECT_TRUE(std::signbit(real("-0")));
    EXPECT_EQ(real("123456789012345678901234567890"), 123456789012345678901234567890.0);
    EXPECT_EQ(real(repeat("0", 400) + "1"), 1);
}

TEST(Numbers, TooSmallIsZeroAndTooLargeIsAFault) {
    EXPECT_EQ(real("1e-400"), 0);
    EXPECT_EQ(real("-1e-4000000000000000000000"), 0);
    EXPECT_EQ(real(repeat("0.", 1) + repeat("0", 500) + "1"), 0);
    EXPECT_EQ(real(repeat("1", 1) + repeat("0", 100) + "e-500"), 0);
    EXPECT_EQ(real("3.4e38"), 3.4e38);
    EXPECT_EQ(realFault("3.5e38"), NumberFault::TooLarge);
    EXPECT_EQ(realFault("-1e39"), NumberFault::TooLarge);
    EXPECT_EQ(realFault("1e400"), NumberFault::TooLarge);
    EXPECT_EQ(realFault("1e99999999999999999999999"), NumberFault::TooLarge);
    EXPECT_EQ(realFault(repeat("9", 500)), NumberFault::TooLarge);
    EXPECT_EQ(realFault("0.001e400"), NumberFault::TooLarge);
    EXPECT_EQ(realFault("0xffffffffffffffffffff"), NumberFault::TooLarge);
}

TEST(Numbers, WhatIsNoNumber) {
    for (const char* word : {"", "+", "-", ".", "e5", "abc", "1.5abc", "1,5", "--1", "+-1", "1e", "1e+", "0x", "0xg",
                             "1 ", "\"1\"", "1.2.3", "#", "\xff"})
        EXPECT_EQ(realFault(word), NumberFault::NotANumber) << word;
    for (const char* word : {"nan", "NaN", "-nan", "inf", "-Inf", "+INFINITY", "nan(1)"})
        EXPECT_EQ(realFault(word), NumberFault::NotFinite) << word;
}

TEST(Numbers, Integers) {
    int value = 0;
    EXPECT_EQ(parseInteger("2147483647", value), NumberFault::None);
    EXPECT_EQ(value, std::numeric_limits<int>::max());
    EXPECT_EQ(parseInteger("-2147483648", value), NumberFault::None);
    EXPECT_EQ(value, std::numeric_limits<int>::min());
    EXPECT_EQ(parseInteger("+08", value), NumberFault::None);
    EXPECT_EQ(value, 8);
    EXPECT_EQ(parseInteger("2147483648", value), NumberFault::BeyondInt);
    EXPECT_EQ(parseInteger(repeat("-", 1) + repeat("9", 1000), value), NumberFault::BeyondInt);
    for (const char* word : {"", "-", "+-1", "1.0", "1e3", "0x10", "x"})
        EXPECT_EQ(parseInteger(word, value), NumberFault::NotAnInteger) << word;
    EXPECT_EQ(parseInteger("nan", value), NumberFault::NotFinite);
}

TEST(Numbers, DoublesRoundTrip) {
    for (double x : {0.1, 1 / 3., 6.02214076e23, 1.17549435e-38, 5e-324, 16777217., 3.4028234663852886e38}) {
        char buffer[64];
        std::snprintf(buffer, sizeof buffer, "%.17g", x);
        EXPECT_EQ(real(buffer), x);
    }
}

TEST(Quotes, ShowOnlyPrintableUtf8) {
    EXPECT_EQ(inQuotes("abc"), "\"abc\"");
    EXPECT_EQ(inQuotes("gr\xc3\xbcn"), "\"gr\xc3\xbcn\"");
    EXPECT_EQ(inQuotes("a\x01\xff\xc3"), "\"a\\x01\\xff\\xc3\"");
    EXPECT_EQ(inQuotes("\xed\xa0\x80"), "\"\\xed\\xa0\\x80\"") << "a surrogate is no character";
    EXPECT_EQ(inQuotes("\xc0\xaf"), "\"\\xc0\\xaf\"") << "an overlong form is no character";
    EXPECT_EQ(inQuotes("\xf0\x9f\x8d\xb7"), "\"\xf0\x9f\x8d\xb7\"");
    EXPECT_EQ(inQuotes(repeat("x", 100)), repeat("\"", 1) + repeat("x", 40) + "...\"");
}

std::shared_ptr<const SourceFile> source(std::string text) {
    return std::make_shared<const SourceFile>(SourceFile{"t", std::move(text), nullptr, 0});
}

TEST(Lexer, TokensHavePlaces) {
    Lexer lexer(source("Shape \"sphere\" # no \"token\" here\n\t[1 -.5]true"));
    struct Expected {
        Token::Kind kind;
        const char* text;
        int line, column, length;
    };
    const Expected expected[] = {
        {Token::Kind::Word, "Shape", 1, 1, 5}, {Token::Kind::String, "sphere", 1, 7, 8},
        {Token::Kind::Open, "[", 2, 2, 1},     {Token::Kind::Word, "1", 2, 3, 1},
        {Token::Kind::Word, "-.5", 2, 5, 3},   {Token::Kind::Close, "]", 2, 8, 1},
        {Token::Kind::Word, "true", 2, 9, 4},  {Token::Kind::End, "", 2, 13, 1},
    };
    for (const auto& e : expected) {
        const Token token = lexer.next();
        EXPECT_EQ(token.kind, e.kind) << e.text;
        EXPECT_EQ(token.text, e.text);
        EXPECT_EQ(token.line, e.line) << e.text;
        EXPECT_EQ(token.column, e.column) << e.text;
        EXPECT_EQ(token.length, e.length) << e.text;
    }
    EXPECT_EQ(lexer.next().kind, Token::Kind::End);
}

TEST(Lexer, CommentsEndWithTheLineAndHashInsideAWordIsPartOfIt) {
    Lexer lexer(source("#one\r#two\r\na#b \"c#d\" # end"));
    EXPECT_EQ(lexer.next().text, "a#b");
    EXPECT_EQ(lexer.next().text, "c#d");
    EXPECT_EQ(lexer.next().kind, Token::Kind::End);
}

TEST(Lexer, ByteOrderMarkIsSkipped) {
    Lexer lexer(source("\xef\xbb\xbfWorldBegin"));
    EXPECT_EQ(lexer.next().text, "WorldBegin");
}

TEST(Lexer, Escapes) {
    Lexer lexer(source(R"("a\"b\\c\n\t\r\b\f\'")"));
    EXPECT_EQ(lexer.takeString("a string"), "a\"b\\c\n\t\r\b\f'");
}

TEST(Lexer, BrokenStringsEndWithTheLine) {
    Lexer lexer(source("\"open\nnext \"also open"));
    EXPECT_EQ(lexer.next().kind, Token::Kind::Broken);
    EXPECT_EQ(lexer.next().text, "next");
    EXPECT_EQ(lexer.next().kind, Token::Kind::Broken);
    EXPECT_EQ(lexer.next().kind, Token::Kind::End);
}

TEST(Lexer, BackslashAtTheEndIsBroken) {
    for (const char* text : {"\"a\\", "\"a\\\"", "\"a\\\n\"", "\"\\"}) {
        Lexer lexer(source(text));
        EXPECT_EQ(lexer.next().kind, Token::Kind::Broken) << text;
    }
}

} // namespace
} // namespace vitrine
