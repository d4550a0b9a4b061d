// Points that textures are looked up at.
#pragma once

#include "shapes/shape.h"
#include "textures/texture.h"

#include <gtest/gtest.h>

namespace vitrine {

inline TexturePoint pointAt(const V3d& p, const V3f& dpdx = V3f(0), const V3f& dpdy = V3f(0)) {
    TexturePoint at;
    at.p = p;
    at.dpdx = dpdx;
    at.dpdy = dpdy;
    return at;
}

inline TexturePoint uvAt(const V2f& uv, const V2f& duvdx = V2f(0), const V2f& duvdy = V2f(0)) {
    TexturePoint at;
    at.uv = uv;
    at.duvdx = duvdx;
    at.duvdy = duvdy;
    return at;
}

/// Without a footprint.
inline TexturePoint textureAt(const SurfacePoint& point) {
    TexturePoint at;
    at.p = point.p;
    at.ng = point.ng;
    at.uv = point.uv;
    return at;
}

} // namespace vitrine
