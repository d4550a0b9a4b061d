#include "nodes/parameter_reader.h"

#include "nodes/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <unordered_map>

namespace vitrine {

namespace {

struct TypeInfo {
    ParameterType type;
    std::string_view name;
    std::size_t itemSize;
};

constexpr std::array<TypeInfo, 14> types = {{
    {ParameterType::Integer, "integer", 1},
    {ParameterType::Float, "float", 1},
    {ParameterType::Bool, "bool", 1},
    {ParameterType::String, "string", 1},
    {ParameterType::Texture, "texture", 1},
    {ParameterType::Point2, "point2", 2},
    {ParameterType::Vector2, "vector2", 2},
    {ParameterType::Point3, "point3", 3},
    {ParameterType::Vector3, "vector3", 3},
    {ParameterType::Normal, "normal", 3},
    {ParameterType::Rgb, "rgb", 3},
    {ParameterType::Blackbody, "blackbody", 1},
    {ParameterType::Spectrum, "spectrum", 1},
    {ParameterType::Untyped, "untyped", 1},
}};

/// Reads the values of one parameter into its variant.
class ValueReader {
  public:
    ValueReader(Lexer& lexer, Parameter& parameter) : lexer_(lexer), parameter_(parameter) {}

    /// One value, or a list in brackets.
    void read() {
        const Token first = lexer_.peek();
        if (first.kind != Token::Kind::Open) {
            choose(first);
            take(first);
        } else {
            readList();
        }
        std::visit([](auto& values) { values.shrink_to_fit(); }, parameter_.values);
    }

    /// Values up to the end of the text.
    void readToEnd() {
        choose(lexer_.peek());
        do
            take(lexer_.peek());
        while (lexer_.peek().kind != Token::Kind::End);
    }

  private:
    void readList() {
        const Token open = lexer_.next();
        choose(lexer_.peek());
        while (lexer_.peek().kind != Token::Kind::Close) {
            const Token token = lexer_.peek();
            if (token.kind == Token::Kind::End || token.kind == Token::Kind::Open || looksLikeDirective(token))
                throw SceneError(
                    lexer_.place(token), fmt::format("expected \"]\", got {}", token.describe()),
                    fmt::format("the list of \"{}\" begins at {}:{}", parameter_.name, open.line, open.column));
            take(token);
        }
        if (parameter_.size() == 0) throw SceneError(lexer_.place(open), fmt::format("{} has no value", declaration()));
        lexer_.next();
    }

    /// A word among numbers that is more likely the next directive, the bracket having been forgotten.
    bool looksLikeDirective(const Token& token) const {
        double number = 0;
        const bool wantsNumbers =
            parameter_.type != ParameterType::Bool && !std::holds_alternative<Parameter::Strings>(parameter_.values);
        return wantsNumbers && token.kind == Token::Kind::Word &&
               std::isupper(static_cast<unsigned char>(token.text[0])) &&
               parseReal(token.text, number) != NumberFault::NotFinite;
    }

    /// A spectrum is a name or numbers: its first value decides.
    void choose(const Token& first) {
        switch (parameter_.type) {
        case ParameterType::Integer:
        case ParameterType::Bool:
            parameter_.values = Parameter::Integers();
            return;
        case ParameterType::String:
        case ParameterType::Texture:
            parameter_.values = Parameter::Strings();
            return;
        case ParameterType::Spectrum:
            if (first.kind == Token::Kind::String) parameter_.values = Parameter::Strings();
            return;
        default:
            return;
        }
    }

    /// Appends a token; it is consumed only when it is a value, so that a directive is left for the recovery.
    void take(const Token& token) {
        if (token.kind == Token::Kind::Broken)
            throw SceneError(lexer_.place(lexer_.next()), "the string lacks its closing quote");
        if (auto* strings = std::get_if<Parameter::Strings>(&parameter_.values))
            takeString(token, *strings);
        else if (parameter_.type == ParameterType::Bool)
            takeBool(token);
        else
            takeNumber(token);
        lexer_.next();
    }

    void takeString(const Token& token, Parameter::Strings& strings) {
        if (token.kind != Token::Kind::String) refuse(token, "a string", "strings stand in double quotes");
        strings.push_back(lexer_.unescaped(token));
    }

    void takeBool(const Token& token) {
        const bool hasText = token.kind == Token::Kind::Word || token.kind == Token::Kind::String;
        if (!hasText || (token.text != "true" && token.text != "false")) refuse(token, "true or false");
        std::get<Parameter::Integers>(parameter_.values).push_back(token.text == "true");
    }

    void takeNumber(const Token& token) {
        const bool integer = parameter_.type == ParameterType::Integer;
        if (token.kind != Token::Kind::Word) refuse(token, integer ? "an integer" : "a number");
        NumberFault fault = NumberFault::None;
        if (integer) {
            int value = 0;
            fault = parseInteger(token.text, value);
            std::get<Parameter::Integers>(parameter_.values).push_back(value);
        } else {
            double value = 0;
            fault = parseReal(token.text, value);
            std::get<Parameter::Numbers>(parameter_.values).push_back(value);
        }
        if (fault != NumberFault::None)
            throw SceneError(lexer_.place(token), fmt::format("{}: {}", declaration(), describe(fault, token.text)));
    }

    [[noreturn]] void refuse(const Token& token, std::string_view wanted, std::string hint = {}) {
        throw SceneError(lexer_.place(token),
                         fmt::format("{}: expected {}, got {}", declaration(), wanted, token.describe()),
                         token.kind == Token::Kind::Word ? std::move(hint) : std::string());
    }

    std::string declaration() const { return fmt::format("\"{} {}\"", typeName(parameter_.type), parameter_.name); }

    Lexer& lexer_;
    Parameter& parameter_;
};

/// The words of "type name".
std::vector<std::string> words(const std::string& text) {
    std::vector<std::string> found;
    std::size_t i = 0;
    while ((i = text.find_first_not_of(" \t", i)) != std::string::npos) {
        const std::size_t end = std::min(text.find_first_of(" \t", i), text.size());
        found.push_back(text.substr(i, end - i));
        i = end;
    }
    return found;
}

ParameterPtr readParameter(Lexer& lexer, const std::string& colorSpace) {
    const Token token = lexer.peek();
    const std::string declared = lexer.takeString("a parameter");
    const std::vector<std::string> parts = words(declared);
    const Place place = lexer.place(token);
    if (parts.size() != 2)
        throw SceneError(place,
                         inQuotes(declared) + " is no parameter: it needs a type and a name, as in \"float radius\"");
    auto parameter = std::make_shared<Parameter>();
    parameter->type = parameterType(parts[0], place);
    parameter->name = parts[1];
    parameter->place = place;
    parameter->offset = lexer.offset(token);
    parameter->colorSpace = colorSpace;
    ValueReader(lexer, *parameter).read();
    return parameter;
}

} // namespace

std::string_view typeName(ParameterType type) {
    return types[std::size_t(type)].name;
}

std::size_t itemSize(ParameterType type) {
    return types[std::size_t(type)].itemSize;
}

ParameterType parameterType(std::string_view name, const Place& place) {
    if (name == "point") name = "point3";
    if (name == "vector") name = "vector3";
    if (name == "normal3") name = "normal";
    std::vector<std::string> names;
    for (const auto& info : types) {
        if (info.type == ParameterType::Untyped) continue;
        if (info.name == name) return info.type;
        names.emplace_back(info.name);
    }
    std::string hint = didYouMean(std::string(name), names);
    if (name == "color") hint = "pbrt-v4 calls it \"rgb\"";
    if (name == "xyz") hint = "pbrt-v4 has no xyz colours: use \"rgb\" or \"spectrum\"";
    throw SceneError(place, "unknown parameter type " + inQuotes(name), hint);
}

ParameterList readParameters(Lexer& lexer, const std::string& colorSpace, Diagnostics& diagnostics) {
    ParameterList parameters;
    std::unordered_map<std::string_view, const Parameter*> seen;
    for (;;) {
        const Token token = lexer.peek();
        if (token.kind != Token::Kind::String && token.kind != Token::Kind::Broken) return parameters;
        const ParameterPtr parameter = readParameter(lexer, colorSpace);
        const auto [first, isNew] = seen.emplace(parameter->name, parameter.get());
        if (isNew)
            parameters.push_back(parameter);
        else
            diagnostics.error(parameter->place, fmt::format("parameter {} is given twice", inQuotes(parameter->name)),
                              fmt::format("first at {}", first->second->place.toString()));
    }
}

ParameterPtr withType(const Parameter& untyped, ParameterType type) {
    auto parameter = std::make_shared<Parameter>(untyped);
    parameter->type = type;
    const std::string text = std::get<Parameter::Strings>(untyped.values).front();
    const bool bare = !text.empty() && text[0] != '"';
    const bool named = type == ParameterType::Spectrum && bare && std::isalpha(static_cast<unsigned char>(text[0]));
    if (bare && (type == ParameterType::String || type == ParameterType::Texture || named)) return parameter;
    std::string list = text;
    std::replace(list.begin(), list.end(), ',', ' ');
    parameter->values = Parameter::Numbers();
    Lexer lexer(untyped.place, list);
    ValueReader(lexer, *parameter).readToEnd();
    return parameter;
}

} // namespace vitrine
