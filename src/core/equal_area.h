// The equal-area map between the unit square and the sphere: Clarberg 2008, "Fast Equal-Area Mapping of the
// (Hemi)Sphere using SIMD". The square is folded as an octahedron: +z in its middle, -z in its four corners.
#pragma once

#include "core/vec.h"

namespace vitrine {

/// Unit direction of a point of the unit square; areas are multiplied by 4 pi everywhere. float or double.
template <class T>
Imath::Vec3<T> equalAreaSquareToSphere(const Imath::Vec2<T>& p);

/// The inverse. \param d unit length
template <class T>
Imath::Vec2<T> equalAreaSphereToSquare(const Imath::Vec3<T>& d);

/// The point of the unit square that a point up to one unit outside stands for: crossing an edge leads back in through
/// the same edge, mirrored in the edge's middle.
template <class T>
Imath::Vec2<T> wrapEqualAreaSquare(const Imath::Vec2<T>& p);

extern template V3f equalAreaSquareToSphere(const V2f&);
extern template V3d equalAreaSquareToSphere(const V2d&);
extern template V2f equalAreaSphereToSquare(const V3f&);
extern template V2d equalAreaSphereToSquare(const V3d&);
extern template V2f wrapEqualAreaSquare(const V2f&);
extern template V2d wrapEqualAreaSquare(const V2d&);

} // namespace vitrine
