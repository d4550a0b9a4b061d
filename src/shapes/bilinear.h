// Functions that are bilinear over a patch: its points, texture coordinates and normals. Corners are named by (u,v).
#pragma once

#include "shapes/shape.h"

namespace vitrine {

/// The value at (u,v) = `at`.
template <class V>
V bilinear(const V& f00, const V& f10, const V& f01, const V& f11, const V2d& at) {
    using T = typename V::BaseType;
    const T u = T(at.x), v = T(at.y);
    return (f00 * (1 - u) + f10 * u) * (1 - v) + (f01 * (1 - u) + f11 * u) * v;
}
template <class V>
V bilinearDu(const V& f00, const V& f10, const V& f01, const V& f11, const V2d& at) {
    using T = typename V::BaseType;
    return (f10 - f00) * (1 - T(at.y)) + (f11 - f01) * T(at.y);
}
template <class V>
V bilinearDv(const V& f00, const V& f10, const V& f01, const V& f11, const V2d& at) {
    using T = typename V::BaseType;
    return (f01 - f00) * (1 - T(at.x)) + (f11 - f10) * T(at.x);
}

/// (u,v) of the point p of a flat convex patch whose normal is along `normal`, within [0,1].
V2d invertBilinear(const V3d& p00, const V3d& p10, const V3d& p01, const V3d& p11, const V3d& normal, const V3d& p);

/// Texture coordinates (s,t) over a patch, and derivatives by them instead of by (u,v).
class BilinearTexture {
  public:
    BilinearTexture(const V2f& st00, const V2f& st10, const V2f& st01, const V2f& st11, const V2d& at);

    const V2f& st() const { return st_; }
    /// df/ds and df/dt from df/du and df/dv; those themselves where (s,t) say nothing about (u,v).
    void derivatives(const V3d& du, const V3d& dv, V3f& ds, V3f& dt) const;

  private:
    V2f st_;
    V2d dstdu_, dstdv_;
    double determinant_;
};

/// Shading normal, its derivatives and the side of ng from given corner normals. `texture` is null where (s,t) is (u,v).
void shadeBilinear(const V3f n[4], const V2d& at, const BilinearTexture* texture, SurfacePoint& point);

} // namespace vitrine
