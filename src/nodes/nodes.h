// A scene as plain data: what the text said, with places, after the rules of pbrt-v4's graphics state. Nothing here
// knows what a type or a parameter means.
#pragma once

#include "core/transform.h"
#include "nodes/parameters.h"

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace vitrine {

/// The current transformation at the two times of ActiveTransform. Shared by all nodes written under it.
struct MovingTransform {
    Transform start, end;
    double startTime = 0, endTime = 1; ///< TransformTimes

    bool isMoving() const { return start.matrix() != end.matrix(); }
};
using MovingTransformPtr = std::shared_ptr<const MovingTransform>;

/// One directive: its type string and parameters.
struct Node {
    std::string type;
    ParameterSet parameters;
    Place place;     ///< of the directive; none for a default that the text does not give
    Place typePlace; ///< of the type string: for "unknown type"
};

struct CameraNode : Node {
    MovingTransformPtr worldFromCamera = std::make_shared<MovingTransform>();
    int medium = -1; ///< the camera stands in it; index into SceneNodes::media, -1 for none
};

/// An inline material, or a named one.
struct MaterialNode : Node {
    std::string name; ///< of MakeNamedMaterial; empty for an inline one
};

struct TextureNode : Node {
    std::string name;
    MovingTransformPtr worldFromTexture;
};

struct MediumNode : Node {
    std::string name;
    MovingTransformPtr worldFromMedium;
};

struct LightNode : Node {
    MovingTransformPtr worldFromLight;
    int medium = -1; ///< the outside medium
};

struct ShapeNode : Node {
    MovingTransformPtr worldFromObject; ///< inside an object definition: definition's space from object's space
    bool reverseOrientation = false;
    int material = 0;   ///< index into SceneNodes::materials
    int areaLight = -1; ///< index into SceneNodes::areaLights, -1 for none
    int insideMedium = -1, outsideMedium = -1;
};

/// ObjectBegin ... ObjectEnd.
struct ObjectNode {
    std::string name;
    Place place;
    std::vector<ShapeNode> shapes;
};

/// A point of a shape in an object definition goes to world by the shape's transform, then by this one.
struct InstanceNode {
    int object = -1; ///< index into SceneNodes::objects
    MovingTransformPtr worldFromInstance;
    Place place;
};

/// `Option "name" value`. The name is folded as pbrt-v4 does (lower case, no '-' or '_') and known; the value has the
/// option's type.
struct OptionNode {
    std::string name;
    std::variant<bool, int, double, std::string> value;
    Place place;
};

struct SceneNodes {
    std::string name;          ///< of the file, as given
    std::string baseDirectory; ///< file names are relative to it: see resolveFile()

    std::map<std::string, OptionNode> options; ///< the last one given under a name
    CameraNode camera;
    Node film, filter, sampler, integrator, accelerator; ///< pbrt-v4's default types when the text has none

    std::vector<ShapeNode> shapes;       ///< outside object definitions
    std::vector<LightNode> lights;       ///< LightSource
    std::vector<Node> areaLights;        ///< AreaLightSource; shapes refer to them, several to one
    std::vector<MaterialNode> materials; ///< 0 is pbrt-v4's default, "diffuse"
    std::vector<TextureNode> floatTextures, spectrumTextures;
    std::vector<MediumNode> media;
    std::vector<ObjectNode> objects;
    std::vector<InstanceNode> instances;

    std::vector<Diagnostic> warnings;
    std::vector<std::shared_ptr<const SourceFile>> sources; ///< every text that was read, in order

    /// Index by the name of MakeNamedMaterial: mix refers to materials by name.
    std::map<std::string, int> namedMaterials;
};

} // namespace vitrine
