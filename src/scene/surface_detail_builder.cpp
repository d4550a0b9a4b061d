#include "scene/surface_detail_builder.h"

#include "textures/bump_map.h"
#include "textures/normal_map.h"

#include <fmt/format.h>

namespace vitrine {

namespace {

SurfaceDetailPtr normalMap(BuildContext& context, const ParameterSet& p, const std::string& name) {
    const std::string path = context.file(p, "normalmap", name);
    try {
        const TextureImage& image = context.images().colours(path, {ImageEncoding::Kind::Gamma, 1});
        if (image.image->channels() == 3) return std::make_shared<NormalMap>(image.image);
        p.error("normalmap", fmt::format("{} is grey, but a normal map needs red, green and blue", path));
    } catch (const FileError& e) {
        p.error("normalmap", e.what());
    }
    return nullptr;
}

} // namespace

SurfaceDetailPtr findSurfaceDetail(BuildContext& context, const ParameterSet& parameters) {
    const auto displacement = findFloatInput(context, parameters, "displacement");
    if (const auto name = parameters.findString("normalmap")) {
        if (displacement)
            context.diagnostics().warning(parameters.place("displacement"),
                                          "\"displacement\" has no effect beside \"normalmap\"");
        return normalMap(context, parameters, *name);
    }
    // Moved by the same everywhere a surface keeps its normals.
    if (!displacement || displacement->isConstant()) return nullptr;
    return std::make_shared<BumpMap>(displacement->texture());
}

} // namespace vitrine
