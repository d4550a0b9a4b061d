#include "nodes/spd.h"

#include "nodes/lexer.h"
#include "nodes/source.h"
#include "nodes/text.h"

#include <fmt/format.h>

namespace vitrine {

namespace {

double takeNumber(Lexer& lexer) {
    const Token token = lexer.peek();
    double value = 0;
    if (token.kind != Token::Kind::Word)
        throw SceneError(lexer.place(token), fmt::format("expected a number, got {}", token.describe()));
    const NumberFault fault = parseReal(token.text, value);
    if (fault != NumberFault::None) throw SceneError(lexer.place(token), describe(fault, token.text));
    lexer.next();
    return value;
}

} // namespace

SpdSamples readSpd(const std::string& fileName) {
    auto file = std::make_shared<SourceFile>();
    file->name = fileName;
    file->text = readWholeFile(fileName);
    checkIsText(file);
    Lexer lexer(file);
    SpdSamples samples;
    while (lexer.peek().kind != Token::Kind::End) {
        const Token first = lexer.peek();
        const double wavelength = takeNumber(lexer);
        if (wavelength <= 0) throw SceneError(lexer.place(first), "wavelengths (nm) must be positive");
        if (!samples.wavelengths.empty() && wavelength <= samples.wavelengths.back())
            throw SceneError(lexer.place(first), "wavelengths must increase");
        if (lexer.peek().kind == Token::Kind::End)
            throw SceneError(lexer.place(first), "the last wavelength lacks its value");
        samples.wavelengths.push_back(wavelength);
        samples.values.push_back(takeNumber(lexer));
    }
    if (samples.values.empty()) throw SceneError(Place{file}, "the file holds no spectrum");
    return samples;
}

} // namespace vitrine
