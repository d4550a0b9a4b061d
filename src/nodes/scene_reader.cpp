#include "nodes/scene_reader.h"

#include "nodes/hints.h"
#include "nodes/source.h"
#include "nodes/text.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace vitrine {

namespace {

/// Whether all others mean what they mean without this directive. Without a transformation, a block, the film or a file
/// their errors may be follow-ups.
bool standsAlone(const std::string& directive) {
    static const std::set<std::string_view> alone = {
        "Accelerator",       "AreaLightSource", "Camera",        "Integrator",     "LightSource",
        "MakeNamedMaterial", "Material",        "NamedMaterial", "ObjectInstance", "Option",
        "PixelFilter",       "Sampler",         "Shape",         "Texture"};
    return alone.contains(directive);
}

} // namespace

const std::map<std::string_view, SceneReader::Directive>& SceneReader::directives() {
    using R = SceneReader;
    static const std::map<std::string_view, Directive> table = {
        {"Accelerator", {Where::Options, &R::accelerator}},
        {"ActiveTransform", {Where::Anywhere, &R::activeTransform}},
        {"AreaLightSource", {Where::World, &R::areaLightSource}},
        {"Attribute", {Where::Anywhere, &R::attribute}},
        {"AttributeBegin", {Where::World, &R::attributeBegin}},
        {"AttributeEnd", {Where::World, &R::attributeEnd}},
        {"Camera", {Where::Options, &R::camera}},
        {"ColorSpace", {Where::Anywhere, &R::colorSpace}},
        {"ConcatTransform", {Where::Anywhere, &R::concatTransform}},
        {"CoordSysTransform", {Where::Anywhere, &R::coordSysTransform}},
        {"CoordinateSystem", {Where::Anywhere, &R::coordinateSystem}},
        {"Film", {Where::Options, &R::film}},
        {"Identity", {Where::Anywhere, &R::identity}},
        {"Import", {Where::World, &R::import}},
        {"Include", {Where::Anywhere, &R::include}},
        {"Integrator", {Where::Options, &R::integrator}},
        {"LightSource", {Where::World, &R::lightSource}},
        {"LookAt", {Where::Anywhere, &R::lookAtDirective}},
        {"MakeNamedMaterial", {Where::World, &R::makeNamedMaterial}},
        {"MakeNamedMedium", {Where::Anywhere, &R::makeNamedMedium}},
        {"Material", {Where::World, &R::material}},
        {"MediumInterface", {Where::Anywhere, &R::mediumInterface}},
        {"NamedMaterial", {Where::World, &R::namedMaterial}},
        {"ObjectBegin", {Where::World, &R::objectBegin}},
        {"ObjectEnd", {Where::World, &R::objectEnd}},
        {"ObjectInstance", {Where::World, &R::objectInstance}},
        {"Option", {Where::Anywhere, &R::option}},
        {"PixelFilter", {Where::Options, &R::pixelFilter}},
        {"ReverseOrientation", {Where::World, &R::reverseOrientation}},
        {"Rotate", {Where::Anywhere, &R::rotate}},
        {"Sampler", {Where::Options, &R::sampler}},
        {"Scale", {Where::Anywhere, &R::scale}},
        {"Shape", {Where::World, &R::shape}},
        {"Texture", {Where::World, &R::texture}},
        {"Transform", {Where::Anywhere, &R::transform}},
        {"TransformBegin", {Where::World, &R::transformBegin}},
        {"TransformEnd", {Where::World, &R::transformEnd}},
        {"TransformTimes", {Where::Options, &R::transformTimes}},
        {"Translate", {Where::Anywhere, &R::translate}},
        {"WorldBegin", {Where::Options, &R::worldBegin}},
    };
    return table;
}

SceneReader::SceneReader(std::string name, std::string baseDirectory) {
    nodes_.name = std::move(name);
    nodes_.baseDirectory = std::move(baseDirectory);
    nodes_.camera.type = "perspective";
    nodes_.film.type = "rgb";
    nodes_.filter.type = "gaussian";
    nodes_.sampler.type = "zsobol";
    nodes_.integrator.type = "volpath";
    nodes_.accelerator.type = "bvh";
    nodes_.materials.emplace_back().type = "diffuse";
}

void SceneReader::fail(const SceneError& error) {
    for (const auto& d : error.diagnostics())
        if (!diagnostics_.full()) diagnostics_.error(d.place, d.message, d.hint);
}

void SceneReader::warnOnce(const std::string& message, const std::string& hint) {
    if (warned_.insert(message).second) diagnostics_.warning(place_, message, hint);
}

void SceneReader::read(const std::shared_ptr<const SourceFile>& file) {
    try {
        checkIsText(file);
    } catch (const SceneError& error) {
        return fail(error);
    }
    readText(file);
    if (diagnostics_.full()) return;
    closeBlocksDownTo(0);
    if (!inWorld_ && !diagnostics_.hasErrors()) diagnostics_.error(Place{file}, "the scene ends without WorldBegin");
}

ParsedScene SceneReader::finish() {
    // After an error a missing definition says little: it may be what could not be read.
    if (!diagnostics_.hasErrors())
        for (const NameTable* table : {&materialNames_, &mediumNames_, &objectNames_})
            table->reportUndefined(diagnostics_);
    for (const Diagnostic& d : diagnostics_.all())
        if (d.severity == Diagnostic::Severity::Warning) nodes_.warnings.push_back(d);
    return {std::move(nodes_), diagnostics_.all(), diagnostics_.hasErrors(), nodesTellMore_ && !diagnostics_.full()};
}

void SceneReader::readText(const std::shared_ptr<const SourceFile>& file) {
    nodes_.sources.push_back(file);
    Lexer lexer(file);
    Lexer* const outer = std::exchange(lexer_, &lexer);
    while (!diagnostics_.full() && lexer.peek().kind != Token::Kind::End) {
        const Token token = lexer.next();
        place_ = lexer.place(token);
        directive_ = token.text;
        try {
            runDirective(token);
        } catch (const SceneError& error) {
            fail(error);
            nodesTellMore_ &= standsAlone(directive_);
            skipToDirective();
        } catch (const std::domain_error& error) {
            // The numbers of a transformation; place_ is its directive's, for no other files are read in between.
            fail(SceneError(place_, fmt::format("{}: {}", directive_, error.what())));
            nodesTellMore_ = false;
        }
    }
    lexer_ = outer;
}

void SceneReader::runDirective(const Token& token) {
    if (token.kind != Token::Kind::Word) refuseToken(token);
    const auto directive = directives().find(token.text);
    if (directive == directives().end()) refuseToken(token);
    checkWhere(directive->second.where);
    (this->*directive->second.run)();
}

void SceneReader::refuseToken(const Token& token) const {
    double number = 0;
    const bool isName = token.kind == Token::Kind::Word && parseReal(token.text, number) == NumberFault::NotANumber;
    if (!isName) throw SceneError(place_, fmt::format("expected a directive, got {}", token.describe()));
    std::string hint = hintForOldDirective(token.text);
    if (hint.empty()) {
        std::vector<std::string> names;
        for (const auto& entry : directives())
            names.emplace_back(entry.first);
        hint = didYouMean(std::string(token.text), names);
    }
    throw SceneError(place_, "unknown directive " + inQuotes(token.text), hint);
}

void SceneReader::checkWhere(Where where) {
    if (where == Where::Options && inWorld_)
        throw SceneError(place_, directive_ == "WorldBegin"
                                     ? "WorldBegin stands here a second time"
                                     : fmt::format("{} must stand before WorldBegin", directive_));
    if (where != Where::World || inWorld_ || reportedMissingWorld_) return;
    // Once: whoever forgot WorldBegin forgot it for everything that follows.
    reportedMissingWorld_ = true;
    throw SceneError(place_, fmt::format("{} must stand after WorldBegin", directive_));
}

void SceneReader::skipToDirective() {
    structureUncertain_ = true;
    for (;;) {
        const Token& token = lexer_->peek();
        if (token.kind == Token::Kind::End) return;
        if (token.kind == Token::Kind::Word && directives().contains(token.text)) return;
        lexer_->next();
    }
}

} // namespace vitrine
