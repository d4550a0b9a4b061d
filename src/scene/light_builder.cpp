#include "film/imageio.h"
#include "film/primaries.h"
#include "lights/constant_infinite_light.h"
#include "lights/distant_light.h"
#include "lights/image_infinite_light.h"
#include "lights/point_light.h"
#include "lights/spot_light.h"
#include "scene/registry.h"
#include "scene/world_builder.h"

namespace vitrine {

namespace {

struct LightInput {
    BuildContext& context;
    const LightNode& node;
    const ParameterSet& parameters;
    const Motion& worldFromLight;
    const Shutter& shutter;
};

/// The white of the colour space at the directive: what pbrt-v4's lights emit by default.
SpectrumPtr white(const ParameterSet& p) {
    const RgbColorSpace* space = RgbColorSpace::named(p.colorSpace());
    return SpectrumPtr(SpectrumPtr(), &(space ? *space : RgbColorSpace::srgb()).illuminant());
}

SpectrumPtr emission(BuildContext& context, const ParameterSet& p, std::string_view name) {
    const SpectrumPtr given = findSpectrum(context, p, name, SpectrumUse::Illuminant);
    return given ? given : white(p);
}

LightPtr point(const LightInput& in) {
    const ParameterSet& p = in.parameters;
    PointLight::Parameters s;
    s.i = emission(in.context, p, "I");
    s.scale = p.getFloat("scale", s.scale);
    s.power = p.getFloat("power", s.power);
    s.from = p.getPoint3("from", s.from);
    return PointLight::create(in.worldFromLight, in.shutter, s);
}

LightPtr spot(const LightInput& in) {
    const ParameterSet& p = in.parameters;
    SpotLight::Parameters s;
    s.i = emission(in.context, p, "I");
    s.scale = p.getFloat("scale", s.scale);
    s.power = p.getFloat("power", s.power);
    s.from = p.getPoint3("from", s.from);
    s.to = p.getPoint3("to", s.to);
    s.cone.angle = p.getFloat("coneangle", s.cone.angle);
    s.cone.delta = p.getFloat("conedeltaangle", s.cone.delta);
    return SpotLight::create(in.worldFromLight, in.shutter, s);
}

LightPtr distant(const LightInput& in) {
    const ParameterSet& p = in.parameters;
    DistantLight::Parameters s;
    s.l = emission(in.context, p, "L");
    s.scale = p.getFloat("scale", s.scale);
    s.illuminance = p.getFloat("illuminance", s.illuminance);
    s.from = p.getPoint3("from", s.from);
    s.to = p.getPoint3("to", s.to);
    return DistantLight::create(in.worldFromLight, in.shutter, s);
}

LightPtr infinite(const LightInput& in) {
    const ParameterSet& p = in.parameters;
    refuse(p, {"portal"});
    const double scale = p.getFloat("scale", 1), illuminance = p.getFloat("illuminance", -1);
    const auto file = p.findString("filename");
    if (!file) return ConstantInfiniteLight::create({emission(in.context, p, "L"), scale, illuminance});
    if (p.has("L")) throw SceneError(p.place("L"), "an infinite light takes \"L\" or \"filename\", not both");
    if (in.worldFromLight.moves())
        throw SceneError(in.node.place, "an environment image that moves is not yet supported");
    ImageMetadata metadata;
    Image image = readColours(in.context.file(p, "filename", *file), metadata);
    ImageInfiniteLight::Parameters s;
    s.colorSpace = RgbColorSpace::withChromaticities(metadata.chromaticities);
    if (!s.colorSpace) image = inRec709(image, metadata.chromaticities);
    // Twice as wide as high is a map of latitude and longitude; pbrt-v4's own maps are square.
    if (image.width == 2 * image.height) s.mapping = EnvironmentMapping::LatLong;
    s.scale = scale;
    s.illuminance = illuminance;
    return ImageInfiniteLight::create(in.worldFromLight.start(), image, s);
}

using LightBuilder = LightPtr (*)(const LightInput&);
constexpr RegistryEntry<LightBuilder> lightTypes[] = {{"point", point},       {"spot", spot},  {"distant", distant},
                                                      {"infinite", infinite}, {"goniometric"}, {"projection"}};

std::vector<std::shared_ptr<AreaLight>> diffuseArea(BuildContext& context, const Node& node,
                                                    const std::vector<ShapePtr>& shapes, const ShapeAlpha& alpha) {
    const ParameterSet& p = node.parameters;
    refuse(p, {"filename"});
    AreaLight::Parameters s;
    s.l = emission(context, p, "L");
    s.scale = p.getFloat("scale", s.scale);
    s.twoSided = p.getBool("twosided", s.twoSided);
    s.cutout = alpha.cutout;
    s.isUnseen = alpha.isUnseen;
    const double power = p.getFloat("power", s.power);

    double area = 0;
    for (const auto& shape : shapes)
        area += shape->area();
    std::vector<std::shared_ptr<AreaLight>> lights;
    for (const auto& shape : shapes) {
        s.power = power > 0 ? power * shape->area() / area : power;
        lights.push_back(AreaLight::create(shape, s));
    }
    return lights;
}

using AreaLightBuilder = std::vector<std::shared_ptr<AreaLight>> (*)(BuildContext&, const Node&,
                                                                     const std::vector<ShapePtr>&, const ShapeAlpha&);
constexpr RegistryEntry<AreaLightBuilder> areaLightTypes[] = {{"diffuse", diffuseArea}};

} // namespace

LightPtr buildLight(BuildContext& context, const LightNode& node, const Shutter& shutter) {
    return context.guarded(node, [&] {
        const auto build = findBuilder<LightBuilder>(lightTypes, node, "light");
        const Motion worldFromLight = motionOf(context, node.worldFromLight, node.place);
        return build({context, node, node.parameters, worldFromLight, shutter});
    });
}

std::vector<std::shared_ptr<AreaLight>> buildAreaLights(BuildContext& context, const Node& node,
                                                        const std::vector<ShapePtr>& shapes, const ShapeAlpha& alpha) {
    return context.guarded(node, [&] {
        return findBuilder<AreaLightBuilder>(areaLightTypes, node, "area light")(context, node, shapes, alpha);
    });
}

} // namespace vitrine
