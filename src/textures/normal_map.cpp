#include "textures/normal_map.h"

#include "core/frame.h"

namespace vitrine {

ShadingDirections NormalMap::shade(const SurfacePoint& point, const TexturePoint& at) const {
    const Texel texel =
        image_->look(0, V2d(at.uv.x, 1 - double(at.uv.y)), ImageWrap::Repeat, TexelInterpolation::Bilinear);
    const V3f local(2 * texel[0] - 1, 2 * texel[1] - 1, 2 * texel[2] - 1);
    const float length = local.length();
    if (!(length > 0)) return {point.ns, point.dpdu}; // where neighbours cancel, no direction is left
    const V3f n = Frame(point.ns, point.dpdu).toWorld(local / length);
    return {aboveHorizon(toDouble(n), point.ng), point.dpdu};
}

} // namespace vitrine
