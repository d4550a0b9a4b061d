#include "textures/footprint.h"

namespace vitrine {

namespace {

/// Beams that graze the surface see no longer patches than this times their width.
constexpr float longest = 32;

/// What of uv belongs to a step along the surface: the least-squares solution of dp = du dpdu + dv dpdv.
V2f parameterStep(const SurfacePoint& s, const V3f& dp) {
    const float uu = s.dpdu.dot(s.dpdu), uv = s.dpdu.dot(s.dpdv), vv = s.dpdv.dot(s.dpdv);
    const float determinant = uu * vv - uv * uv;
    if (!(determinant > 0)) return V2f(0);
    const float a = s.dpdu.dot(dp), b = s.dpdv.dot(dp);
    const V2f step((vv * a - uv * b) / determinant, (uu * b - uv * a) / determinant);
    const auto finite = [](float x) { return std::isfinite(x) ? std::clamp(x, -1e8f, 1e8f) : 0.f; };
    return {finite(step.x), finite(step.y)};
}

} // namespace

void spreadOver(const SurfacePoint& surface, const V3f& d, float width, TexturePoint& at) {
    const V3f across = surface.ng.cross(d);
    const float sine = across.length(), cosine = std::abs(surface.ng.dot(d));
    const V3f x = sine > 1e-6f ? across / sine : surface.dpdu.normalized();
    const V3f y = surface.ng.cross(x);
    at.dpdx = x * width;
    at.dpdy = y * (width / std::max(cosine, 1 / longest));
    at.duvdx = parameterStep(surface, at.dpdx);
    at.duvdy = parameterStep(surface, at.dpdy);
}

} // namespace vitrine
