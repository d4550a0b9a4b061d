#include "nodes/parser.h"

#include "nodes/hints.h"
#include "nodes/parameter_reader.h"
#include "nodes/scene_reader.h"
#include "nodes/source.h"
#include "nodes/text.h"

#include <fmt/format.h>

namespace vitrine {

namespace {

std::shared_ptr<const SourceFile> sourceOf(std::string text, const std::string& name) {
    return std::make_shared<const SourceFile>(SourceFile{name, std::move(text), nullptr, 0});
}

} // namespace

SceneNodes ParsedScene::checkedNodes() && {
    if (hasErrors) throw SceneError(std::move(diagnostics));
    return std::move(nodes);
}

ParsedScene readSceneFile(const std::string& fileName) {
    const std::string name = fileName == "-" ? standardInputName : fileName;
    SceneReader reader(name, std::filesystem::path(fileName).parent_path().string());
    reader.read(sourceOf(reader.openFile(fileName), name));
    return reader.finish();
}

ParsedScene readSceneString(std::string text, const std::string& name, const std::string& baseDirectory) {
    SceneReader reader(name, baseDirectory);
    reader.read(sourceOf(std::move(text), name));
    return reader.finish();
}

SceneNodes parseSceneFile(const std::string& fileName) {
    return readSceneFile(fileName).checkedNodes();
}

SceneNodes parseSceneString(std::string text, const std::string& name, const std::string& baseDirectory) {
    return readSceneString(std::move(text), name, baseDirectory).checkedNodes();
}

ParameterList parseParameters(const std::string& text, const std::string& name) {
    const auto file = sourceOf(text, name);
    checkIsText(file);
    Lexer lexer(file);
    Diagnostics diagnostics;
    ParameterList parameters = readParameters(lexer, "srgb", diagnostics);
    diagnostics.throwIfErrors();
    const Token rest = lexer.peek();
    if (rest.kind != Token::Kind::End)
        throw SceneError(lexer.place(rest), fmt::format("expected a parameter, got {}", rest.describe()));
    return parameters;
}

ParameterPtr parseSetting(const std::string& text) {
    const auto file = sourceOf(text, "--set");
    checkIsText(file);
    const std::size_t equals = text.find('=');
    const Place whole{file, 1, 1, int(std::max<std::size_t>(1, text.size()))};
    if (equals == std::string::npos || equals + 1 == text.size())
        throw SceneError(whole, "expected key=value", "as in --set maxdepth=8");
    Lexer key(Place{file, 1, 1}, std::string_view(text).substr(0, equals));
    Token first = key.next(), second = key.next();
    const bool words = first.kind == Token::Kind::Word && key.next().kind == Token::Kind::End &&
                       (second.kind == Token::Kind::Word || second.kind == Token::Kind::End);
    if (!words) throw SceneError(whole, "expected key=value or \"type key=value\"", "as in --set maxdepth=8");

    auto setting = std::make_shared<Parameter>();
    setting->type = ParameterType::Untyped;
    const bool typed = second.kind == Token::Kind::Word;
    setting->name = (typed ? second : first).text;
    setting->place = Place{file, 1, int(equals) + 2, int(text.size() - equals - 1)};
    setting->offset = equals + 1;
    setting->colorSpace = "srgb";
    setting->values = Parameter::Strings{text.substr(equals + 1)};
    return typed ? withType(*setting, parameterType(first.text, key.place(first))) : setting;
}

std::string resolveFile(const SceneNodes& scene, const Place& namedAt, const std::string& fileName) {
    return resolveIn(scene.baseDirectory, namedAt.file ? namedAt.file->name : scene.name, fileName);
}

SceneError unknownType(const Node& node, const std::string& family, const std::vector<std::string>& validTypes) {
    std::string hint = didYouMean(node.type, validTypes);
    const std::string_view renamed = renamedType(family, node.type);
    if (!renamed.empty()) hint = fmt::format("pbrt-v4 calls it \"{}\"", renamed);
    return SceneError(node.typePlace, fmt::format("unknown {} {}", family, inQuotes(node.type)), hint);
}

} // namespace vitrine
