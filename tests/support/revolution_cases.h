// Profiles and rays that a surface of revolution must get right.
#pragma once

#include "core/random.h"
#include "support/revolution_oracle.h"

namespace vitrine::test {

/// The profile as one list of points with shared ends, for segments of one degree.
std::vector<V2d> joined(const ProfilePoints& profile);

/// Of the reference scenes.
ProfilePoints gobletProfile(); ///< closed, eight cubics
ProfilePoints vaseProfile();   ///< open, one curve of degree 8

/// A random profile: one to three segments of one degree; some with flat rims, vertical walls, poles, cusps (coinciding
/// control points), loops, or control points of negative radius.
ProfilePoints randomProfile(RandomStream& random, int degree);

enum class RayKind {
    Generic,
    Horizontal,
    NearlyHorizontal,
    Axial,
    NearlyAxial,
    Joint,
    NearlyTangent,
    ThroughAxis,
    FromSurface
};
inline constexpr int rayKinds = 9;
const char* toString(RayKind kind);

Ray randomRay(RandomStream& random, RayKind kind, const ProfilePoints& profile);

} // namespace vitrine::test
