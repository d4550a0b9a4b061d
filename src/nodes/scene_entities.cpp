// Directives that make nodes.
#include "nodes/options.h"
#include "nodes/parameter_reader.h"
#include "nodes/scene_reader.h"
#include "nodes/text.h"

#include <fmt/format.h>

namespace vitrine {

Node SceneReader::readNode() {
    Node node;
    node.place = place_;
    node.typePlace = lexer_->place(lexer_->peek());
    node.type = lexer_->takeString(fmt::format("the type of {}", directive_));
    const std::string& space = states_.current().colorSpace;
    node.parameters = ParameterSet(readParameters(*lexer_, space, diagnostics_), nullptr, space, place_);
    return node;
}

Node SceneReader::readNode(AttributeTarget target) {
    Node node = readNode();
    node.parameters.setDefaults(states_.current().defaults[std::size_t(target)]);
    return node;
}

/// MakeNamedMaterial and MakeNamedMedium: the type is a parameter. False when that was wrong and reported.
bool SceneReader::readNamedNode(Node& node, AttributeTarget target) {
    node.place = place_;
    const auto& state = states_.current();
    node.parameters = ParameterSet(readParameters(*lexer_, state.colorSpace, diagnostics_),
                                   state.defaults[std::size_t(target)], state.colorSpace, place_);
    const auto type = node.parameters.findString("type");
    node.typePlace = node.parameters.valuePlace("type", 0);
    node.parameters.reportErrors(diagnostics_);
    if (node.parameters.hasErrors()) return false;
    if (!type) throw SceneError(place_, fmt::format("{} needs a \"string type\"", directive_));
    node.type = *type;
    return true;
}

void SceneReader::option() {
    OptionNode option = readOption(*lexer_);
    std::string name = option.name;
    nodes_.options.insert_or_assign(std::move(name), std::move(option));
}

void SceneReader::camera() {
    CameraNode camera;
    static_cast<Node&>(camera) = readNode();
    const auto& state = states_.current();
    auto inverse = std::make_shared<MovingTransform>(*state.ctm);
    inverse->start = state.ctm->start.inverse();
    inverse->end = state.ctm->end.inverse();
    coordinateSystems_["camera"] = inverse;
    camera.worldFromCamera = std::move(inverse);
    camera.medium = state.outsideMedium;
    nodes_.camera = std::move(camera);
}

void SceneReader::sampler() {
    nodes_.sampler = readNode();
}

void SceneReader::integrator() {
    nodes_.integrator = readNode();
}

void SceneReader::pixelFilter() {
    nodes_.filter = readNode();
}

void SceneReader::film() {
    nodes_.film = readNode();
}

void SceneReader::accelerator() {
    nodes_.accelerator = readNode();
}

void SceneReader::shape() {
    ShapeNode shape;
    static_cast<Node&>(shape) = readNode(AttributeTarget::Shape);
    const auto& state = states_.current();
    shape.worldFromObject = state.ctm;
    shape.reverseOrientation = state.reverseOrientation;
    shape.material = state.material;
    shape.areaLight = state.areaLight;
    shape.insideMedium = state.insideMedium;
    shape.outsideMedium = state.outsideMedium;
    auto& shapes = objects_.empty() || nodes_.objects.empty() ? nodes_.shapes
                                                              : nodes_.objects[std::size_t(objects_.back())].shapes;
    shapes.push_back(std::move(shape));
}

void SceneReader::lightSource() {
    LightNode light;
    static_cast<Node&>(light) = readNode(AttributeTarget::Light);
    light.worldFromLight = states_.current().ctm;
    light.medium = states_.current().outsideMedium;
    if (!objects_.empty())
        warnOnce("a LightSource in an object definition is not part of the object",
                 "as in pbrt-v4 it shines once, where it stands");
    nodes_.lights.push_back(std::move(light));
}

void SceneReader::areaLightSource() {
    Node light = readNode(AttributeTarget::Light);
    // pbrt-v4: an empty type turns area lights off again.
    if (!light.type.empty()) nodes_.areaLights.push_back(light);
    states_.edit().areaLight = light.type.empty() ? -1 : int(nodes_.areaLights.size()) - 1;
}

void SceneReader::material() {
    MaterialNode material;
    static_cast<Node&>(material) = readNode(AttributeTarget::Material);
    nodes_.materials.push_back(std::move(material));
    states_.edit().material = int(nodes_.materials.size()) - 1;
}

void SceneReader::makeNamedMaterial() {
    const Place namePlace = lexer_->place(lexer_->peek());
    MaterialNode material;
    material.name = lexer_->takeString("the name of a material");
    if (!readNamedNode(material, AttributeTarget::Material)) return;
    const auto make = [&] { return nodes_.materials.emplace_back(), int(nodes_.materials.size()) - 1; };
    const int index = materialNames_.define(material.name, namePlace, make);
    nodes_.namedMaterials[material.name] = index;
    nodes_.materials[std::size_t(index)] = std::move(material);
}

void SceneReader::makeNamedMedium() {
    const Place namePlace = lexer_->place(lexer_->peek());
    MediumNode medium;
    medium.name = lexer_->takeString("the name of a medium");
    if (!readNamedNode(medium, AttributeTarget::Medium)) return;
    medium.worldFromMedium = states_.current().ctm;
    const auto make = [&] { return nodes_.media.emplace_back(), int(nodes_.media.size()) - 1; };
    const int index = mediumNames_.define(medium.name, namePlace, make);
    nodes_.media[std::size_t(index)] = std::move(medium);
}

int SceneReader::useMedium(const std::string& name, const Place& place) {
    if (name.empty()) return -1;
    const auto make = [&] { return nodes_.media.emplace_back(), int(nodes_.media.size()) - 1; };
    return mediumNames_.use(name, place, make);
}

void SceneReader::texture() {
    const Place namePlace = lexer_->place(lexer_->peek());
    TextureNode texture;
    texture.name = lexer_->takeString("the name of a texture");
    const Place kindPlace = lexer_->place(lexer_->peek());
    const std::string kind = lexer_->takeString("\"float\" or \"spectrum\"");
    static_cast<Node&>(texture) = readNode(AttributeTarget::Texture);
    texture.worldFromTexture = states_.current().ctm;
    const bool isFloat = kind == "float";
    if (!isFloat && kind != "spectrum")
        throw SceneError(kindPlace, fmt::format("a texture is \"float\" or \"spectrum\", not {}", inQuotes(kind)),
                         kind == "color" ? "pbrt-v4 calls it \"spectrum\"" : "");
    const auto [first, isNew] = textureNames_[isFloat ? 0 : 1].try_emplace(texture.name, namePlace);
    if (!isNew)
        throw SceneError(namePlace, fmt::format("{} texture {} is defined twice", kind, inQuotes(texture.name)),
                         fmt::format("first at {}", first->second.toString()));
    (isFloat ? nodes_.floatTextures : nodes_.spectrumTextures).push_back(std::move(texture));
}

} // namespace vitrine
