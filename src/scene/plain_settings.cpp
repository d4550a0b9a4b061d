#include "scene/plain_settings.h"

#include "scene/rewritten.h"

#include <fmt/format.h>

#include <array>

namespace vitrine {

namespace {

/// pbrt-v4's integrators and what they read.
struct IntegratorInfo {
    std::string_view name;
    bool followsMedia;
    std::vector<std::string_view> parameters;
};

const std::vector<IntegratorInfo>& pbrtIntegrators() {
    static const std::vector<IntegratorInfo> table = {
        {"path", false, {"maxdepth", "regularize", "lightsampler"}},
        {"volpath", true, {"maxdepth", "regularize", "lightsampler"}},
        {"simplepath", false, {"maxdepth", "samplelights", "samplebsdf"}},
        {"simplevolpath", true, {"maxdepth"}},
        {"lightpath", false, {"maxdepth"}},
        {"bdpt", true, {"maxdepth", "regularize", "visualizestrategies", "visualizeweights"}},
        {"mlt",
         true,
         {"maxdepth", "regularize", "bootstrapsamples", "chains", "mutationsperpixel", "largestepprobability",
          "sigma"}},
        {"sppm", false, {"maxdepth", "photonsperiteration", "radius", "seed"}},
        {"ambientocclusion", false, {"cossample", "maxdistance"}},
        {"randomwalk", false, {"maxdepth"}},
        {"function", false, {"function", "filename", "skipbad", "imagefilename"}},
    };
    return table;
}

const IntegratorInfo* findIntegrator(std::string_view name) {
    for (const auto& info : pbrtIntegrators())
        if (info.name == name) return &info;
    return nullptr;
}

/// The absorption of a dielectric as the medium that fills it: every event absorbs, none scatters.
MediumNode absorbingMedium(const MaterialNode& material, const ParameterPtr& absorption, const std::string& name) {
    const auto constant = [](double value) { return Parameter::Numbers{360, value, 830, value}; };
    auto sigmaA = std::make_shared<Parameter>(*absorption);
    sigmaA->name = "sigma_a";
    if (absorption->type == ParameterType::Float) {
        sigmaA->type = ParameterType::Spectrum;
        sigmaA->values = constant(std::get<Parameter::Numbers>(absorption->values).at(0));
    }
    MediumNode medium;
    medium.name = name;
    medium.type = "homogeneous";
    medium.place = material.place;
    medium.worldFromMedium = std::make_shared<MovingTransform>();
    medium.parameters = ParameterSet({makeParameter(ParameterType::String, "type", Parameter::Strings{"homogeneous"}),
                                      sigmaA, makeParameter(ParameterType::Spectrum, "sigma_s", constant(0))},
                                     nullptr, absorption->colorSpace, material.place);
    return medium;
}

std::string freeMediumName(const SceneNodes& scene, std::size_t material) {
    const std::string& own = scene.materials[material].name;
    std::string name = "absorption-" + (own.empty() ? std::to_string(material) : own);
    const auto isTaken = [&](const MediumNode& medium) { return medium.name == name; };
    while (std::any_of(scene.media.begin(), scene.media.end(), isTaken))
        name += "'";
    return name;
}

} // namespace

bool interiorsAsMedia(SceneNodes& scene, Diagnostics& diagnostics) {
    std::vector<int> mediumOf(scene.materials.size(), -1);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        MaterialNode& material = scene.materials[i];
        if (material.type.empty() || material.type == "none") material.type = "interface"; // a named one needs a type
        if (material.type != "dielectric") continue;
        if (const auto priority = findParameter(material, "priority"))
            diagnostics.warning(priority->place, "pbrt-v4 has no \"priority\" of nested dielectrics: dropped",
                                "where solids overlap or touch, its picture will differ");
        if (const auto absorption = findParameter(material, "absorption")) {
            mediumOf[i] = int(scene.media.size());
            scene.media.push_back(absorbingMedium(material, absorption, freeMediumName(scene, i)));
        }
    }
    for (auto& material : scene.materials)
        material.parameters = rewritten(material, [&](const ParameterPtr& p) {
            const bool ours = material.type == "dielectric" && (p->name == "absorption" || p->name == "priority");
            return ours || p->name == "type" ? nullptr : p;
        });
    const auto fill = [&](std::vector<ShapeNode>& shapes) {
        for (auto& shape : shapes) {
            const int medium = mediumOf[std::size_t(shape.material)];
            if (medium < 0) continue;
            if (shape.insideMedium >= 0)
                diagnostics.error(shape.place, "pbrt-v4 has no place for both a medium and a material's absorption");
            shape.insideMedium = medium;
        }
    };
    fill(scene.shapes);
    for (auto& object : scene.objects)
        fill(object.shapes);
    return !scene.media.empty();
}

Node plainIntegrator(const Node& integrator, bool needsVolumes, Diagnostics& diagnostics) {
    Node result = integrator;
    const IntegratorInfo* info = findIntegrator(integrator.type);
    if (!info) {
        info = findIntegrator(needsVolumes ? "volpath" : "path");
        diagnostics.warning(integrator.typePlace, fmt::format("pbrt-v4 has no integrator \"{}\": written as \"{}\"",
                                                              integrator.type, info->name));
    } else if (needsVolumes && !info->followsMedia) {
        info = findIntegrator("volpath");
        if (integrator.type != "path") // pbrt-v4's volpath is its path with media: nothing is lost
            diagnostics.warning(
                integrator.typePlace,
                fmt::format("pbrt-v4's integrator \"{}\" follows no light through media, nor always through "
                            "surfaces without a material: written as \"{}\"",
                            integrator.type, info->name));
    }
    result.type = info->name;
    result.parameters = rewritten(integrator, [&](const ParameterPtr& p) {
        if (std::find(info->parameters.begin(), info->parameters.end(), p->name) != info->parameters.end()) return p;
        diagnostics.warning(p->place, fmt::format("pbrt-v4's integrator \"{}\" has no parameter \"{}\": dropped",
                                                  result.type, p->name));
        return ParameterPtr();
    });
    return result;
}

} // namespace vitrine
