#include "scene/mapping_builder.h"

namespace vitrine {

TextureSpace findTextureSpace(BuildContext& context, const TextureNode& node) {
    return TextureSpace(still(context, node.worldFromTexture, node.place));
}

MappingPtr findMapping(BuildContext& context, const TextureNode& node) {
    const ParameterSet& p = node.parameters;
    const std::string type = p.getChoice("mapping", "uv", {"uv", "spherical", "cylindrical", "planar", "axis"});
    const auto delta = [&] { return V2d(p.getFloat("udelta", 0), p.getFloat("vdelta", 0)); };
    if (type == "spherical") return std::make_shared<SphericalMapping>(findTextureSpace(context, node));
    if (type == "cylindrical") return std::make_shared<CylindricalMapping>(findTextureSpace(context, node));
    if (type == "planar")
        return std::make_shared<PlanarMapping>(findTextureSpace(context, node), p.getVector3("v1", V3d(1, 0, 0)),
                                               p.getVector3("v2", V3d(0, 1, 0)), delta());
    if (type == "axis")
        return std::make_shared<AxisMapping>(findTextureSpace(context, node), p.getVector3("axis", V3d(0, 1, 0)),
                                             p.getFloat("period", 1), p.getFloat("offset", 0));
    return std::make_shared<UvMapping>(V2d(p.getFloat("uscale", 1), p.getFloat("vscale", 1)), delta());
}

} // namespace vitrine
