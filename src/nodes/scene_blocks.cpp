// Directives that open and close blocks or change the graphics state.
#include "nodes/parameter_reader.h"
#include "nodes/scene_reader.h"
#include "nodes/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace vitrine {

namespace {

/// Each Attribute directive copies the list: without a bound a hostile file could make that quadratic.
constexpr std::size_t maxDefaults = 100;

constexpr const char* oldBlocks = "TransformBegin and TransformEnd are deprecated";
constexpr const char* oldBlocksHint = "they mean AttributeBegin and AttributeEnd";

} // namespace

void SceneReader::worldBegin() {
    inWorld_ = true;
    auto& state = states_.edit();
    state.startActive = state.endActive = true;
    state.changeTransform([](const Transform&) { return Transform(); });
    coordinateSystems_["world"] = state.ctm;
}

void SceneReader::attributeBegin() {
    states_.push(StateStack::Block::Attribute, place_);
}

void SceneReader::attributeEnd() {
    const bool none = states_.open() == importFloor_;
    if (!none && states_.top().block == StateStack::Block::Attribute) return closeBlock();
    if (structureUncertain_) return;
    if (none) throw SceneError(place_, fmt::format("{} closes nothing", directive_));
    throw SceneError(place_, fmt::format("{} inside the object definition of line {}, which is still open", directive_,
                                         states_.top().place.line));
}

void SceneReader::transformBegin() {
    warnOnce(oldBlocks, oldBlocksHint);
    attributeBegin();
}

void SceneReader::transformEnd() {
    warnOnce(oldBlocks, oldBlocksHint);
    attributeEnd();
}

void SceneReader::closeBlock() {
    if (states_.top().block == StateStack::Block::Object) objects_.pop_back();
    states_.pop();
}

void SceneReader::closeBlocksDownTo(std::size_t open) {
    for (std::size_t i = open; i < states_.open(); ++i) {
        if (structureUncertain_ || diagnostics_.full()) break;
        const bool object = states_.at(i).block == StateStack::Block::Object;
        nodesTellMore_ = false;
        diagnostics_.error(states_.at(i).place,
                           object ? "this ObjectBegin has no ObjectEnd" : "this AttributeBegin has no AttributeEnd");
    }
    while (states_.open() > open)
        closeBlock();
}

void SceneReader::objectBegin() {
    const Place namePlace = lexer_->place(lexer_->peek());
    const std::string name = lexer_->takeString("the name of an object");
    const int outer = objects_.empty() ? -1 : objects_.back();
    states_.push(StateStack::Block::Object, place_);
    objects_.push_back(std::max(0, outer));
    if (outer >= 0)
        throw SceneError(place_, "ObjectBegin inside an object definition",
                         fmt::format("that of {} begins at {}", inQuotes(nodes_.objects[std::size_t(outer)].name),
                                     nodes_.objects[std::size_t(outer)].place.toString()));
    const auto make = [&] { return nodes_.objects.push_back({name, place_, {}}), int(nodes_.objects.size()) - 1; };
    const int object = objectNames_.define(name, namePlace, make);
    nodes_.objects[std::size_t(object)].place = place_;
    objects_.back() = object;
}

void SceneReader::objectEnd() {
    std::size_t begin = states_.open();
    while (begin > importFloor_ && states_.at(begin - 1).block != StateStack::Block::Object)
        --begin;
    if (begin == importFloor_) {
        if (structureUncertain_) return;
        throw SceneError(place_, "ObjectEnd closes nothing");
    }
    const bool nested = begin < states_.open();
    const Place inner = states_.top().place;
    while (states_.open() >= begin)
        closeBlock();
    if (nested && !structureUncertain_)
        throw SceneError(place_, "ObjectEnd inside an AttributeBegin block",
                         fmt::format("the block begins at {}", inner.toString()));
}

void SceneReader::objectInstance() {
    const Place namePlace = lexer_->place(lexer_->peek());
    const std::string name = lexer_->takeString("the name of an object");
    if (!objects_.empty()) throw SceneError(place_, "ObjectInstance inside an object definition");
    const auto make = [&] { return nodes_.objects.push_back({name, place_, {}}), int(nodes_.objects.size()) - 1; };
    const int object = objectNames_.use(name, namePlace, make);
    nodes_.instances.push_back({object, states_.current().ctm, place_});
}

void SceneReader::attribute() {
    static const std::vector<std::string> targets = {"shape", "light", "material", "medium", "texture"};
    const Place targetPlace = lexer_->place(lexer_->peek());
    const std::string target = lexer_->takeString("what the attributes are for");
    const auto found = std::find(targets.begin(), targets.end(), target);
    if (found == targets.end())
        throw SceneError(targetPlace, "unknown attribute target " + inQuotes(target),
                         "it is \"shape\", \"light\", \"material\", \"medium\" or \"texture\"");
    ParameterList added = readParameters(*lexer_, states_.current().colorSpace, diagnostics_);
    auto& slot = states_.edit().defaults[std::size_t(found - targets.begin())];
    auto list = std::make_shared<ParameterList>(added.rbegin(), added.rend());
    for (const auto& old : slot ? *slot : ParameterList()) {
        const auto same = [&](const ParameterPtr& p) { return p->name == old->name; };
        if (std::none_of(added.begin(), added.end(), same)) list->push_back(old);
    }
    if (list->size() > maxDefaults)
        throw SceneError(place_, fmt::format("more than {} attributes for \"{}\"", maxDefaults, target));
    slot = std::move(list);
}

void SceneReader::reverseOrientation() {
    auto& state = states_.edit();
    state.reverseOrientation = !state.reverseOrientation;
}

void SceneReader::colorSpace() {
    static const std::vector<std::string> spaces = {"aces2065-1", "dci-p3", "rec2020", "srgb"};
    const Place namePlace = lexer_->place(lexer_->peek());
    const std::string written = lexer_->takeString("the name of a colour space");
    std::string name = written;
    for (char& c : name)
        c = char(std::tolower(static_cast<unsigned char>(c)));
    if (std::find(spaces.begin(), spaces.end(), name) == spaces.end()) {
        std::string hint = didYouMean(name, spaces);
        if (hint.empty()) hint = fmt::format("it is one of \"{}\"", fmt::join(spaces, "\", \""));
        throw SceneError(namePlace, "unknown colour space " + inQuotes(written), hint);
    }
    states_.edit().colorSpace = name;
}

void SceneReader::mediumInterface() {
    const Token first = lexer_->peek();
    const std::string inside = lexer_->takeString("the name of the medium inside");
    const Token second = lexer_->peek();
    std::string outside = inside;
    if (second.kind == Token::Kind::String) outside = lexer_->takeString("the name of the medium outside");
    auto& state = states_.edit();
    state.insideMedium = useMedium(inside, lexer_->place(first));
    const bool one = second.kind != Token::Kind::String;
    state.outsideMedium = useMedium(outside, lexer_->place(one ? first : second));
}

void SceneReader::namedMaterial() {
    const Place namePlace = lexer_->place(lexer_->peek());
    const std::string name = lexer_->takeString("the name of a material");
    const auto make = [&] { return nodes_.materials.emplace_back(), int(nodes_.materials.size()) - 1; };
    states_.edit().material = materialNames_.use(name, namePlace, make);
}

} // namespace vitrine
