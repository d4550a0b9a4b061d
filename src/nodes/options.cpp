#include "nodes/options.h"

#include "nodes/text.h"

#include <fmt/format.h>

#include <array>
#include <cctype>

namespace vitrine {

namespace {

enum class OptionType { Bool, Integer, Float, String, CoordinateSystem };

struct OptionInfo {
    std::string_view name;
    OptionType type;
};

constexpr std::array<OptionInfo, 12> knownOptions = {{
    {"disablepixeljitter", OptionType::Bool},
    {"disabletexturefiltering", OptionType::Bool},
    {"disablewavelengthjitter", OptionType::Bool},
    {"displacementedgescale", OptionType::Float},
    {"forcediffuse", OptionType::Bool},
    {"msereferenceimage", OptionType::String},
    {"msereferenceout", OptionType::String},
    {"pixelstats", OptionType::Bool},
    {"rendercoordsys", OptionType::CoordinateSystem},
    {"seed", OptionType::Integer},
    {"texturecachemb", OptionType::Integer},
    {"wavefront", OptionType::Bool},
}};

/// pbrt-v4 does not care for case, '-' and '_' here.
std::string folded(std::string_view name) {
    std::string result;
    for (char c : name)
        if (c != '-' && c != '_') result += char(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

const OptionInfo& findOption(const std::string& written, const Place& place) {
    std::vector<std::string> names;
    const std::string name = folded(written);
    for (const auto& option : knownOptions) {
        if (option.name == name) return option;
        names.emplace_back(option.name);
    }
    // A parameter's type does not belong here, but is an easy mistake.
    const std::size_t space = name.find_last_of(" \t");
    std::string hint = didYouMean(space == std::string::npos ? name : name.substr(space + 1), names);
    throw SceneError(place, "unknown option " + inQuotes(written), hint);
}

/// The number of a word token. \throws SceneError
template <class T, class Parse>
T number(const Lexer& lexer, const Token& token, Parse parse) {
    T value{};
    const NumberFault fault = token.kind == Token::Kind::Word ? parse(token.text, value) : NumberFault::NotANumber;
    if (fault != NumberFault::None) throw SceneError(lexer.place(token), describe(fault, token.text));
    return value;
}

} // namespace

OptionNode readOption(Lexer& lexer) {
    OptionNode option;
    option.place = lexer.place(lexer.peek());
    const OptionInfo& info = findOption(lexer.takeString("the name of an option"), option.place);
    option.name = info.name;
    const Token token = lexer.peek();
    switch (info.type) {
    case OptionType::Bool:
        if (!token.isWord("true") && !token.isWord("false"))
            throw SceneError(lexer.place(token), fmt::format("expected true or false, got {}", token.describe()));
        option.value = token.isWord("true");
        break;
    case OptionType::Integer:
        option.value = number<int>(lexer, token, parseInteger);
        break;
    case OptionType::Float:
        option.value = number<double>(lexer, token, parseReal);
        break;
    case OptionType::String:
    case OptionType::CoordinateSystem: {
        const std::string value = lexer.takeString("a string");
        const std::vector<std::string> systems = {"camera", "cameraworld", "world"};
        if (info.type == OptionType::CoordinateSystem &&
            std::find(systems.begin(), systems.end(), value) == systems.end())
            throw SceneError(lexer.place(token), "unknown rendering coordinate system " + inQuotes(value),
                             didYouMean(value, systems));
        option.value = value;
        return option;
    }
    }
    lexer.next();
    return option;
}

} // namespace vitrine
