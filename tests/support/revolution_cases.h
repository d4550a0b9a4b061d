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

/// A random profile: one to three segments of one degree (four when it is a loop): 15 % loops, 15 % from pole to pole,
/// 25 % of the rest with a pole below; of the segments 8 % flat rims, 8 % vertical walls, 5 % with coinciding control
/// points and, of the first ones, 10 % with a cusp; 40 % of the profiles wander freely (and mostly cross themselves), 30 %
/// have control points of negative radius.
ProfilePoints randomProfile(RandomStream& random, int degree);

/// 1 to 20, n with a share in proportion to 1/n: half of all below 4, one in 72 has degree 20.
int drawDegree(RandomStream& random);
/// 360 in 85 of 100 cases.
double drawPhiMax(RandomStream& random);

enum class RayKind {
    Generic,
    Horizontal,       ///< at right angles to the axis, at the height of a point of the profile
    NearlyHorizontal, ///< sloping by 1e-16 to 1e-1
    Parallel,         ///< to the axis
    NearlyParallel,
    OnAxis,        ///< along the axis itself
    ThroughAxis,   ///< half of them through the height of a segment's end: a pole, if it is one
    Joint,         ///< through a joint, or beside it by 1e-14 to 1e-1
    EndRing,       ///< the same at the profile's ends
    NearlyTangent, ///< beside a touching ray by 10^-k, k = 1 .. 14, on either side
    Tangent,       ///< touching but for rounding
    DoubleRoot,    ///< exactly: along a wall, in a rim's plane, touching a ring
    FromSurface,
    AtTheTip ///< nearly horizontal (1e-9 to 1e-2), closest to the axis on the surface or beside it by 1e-16 to 1e-6
};
inline constexpr int rayKinds = 14;
inline constexpr double genericShare = 0.35; ///< of drawKind(); each of the others 5 %
const char* toString(RayKind kind);
RayKind drawKind(RandomStream& random);

Ray randomRay(RandomStream& random, RayKind kind, const ProfilePoints& profile);

} // namespace vitrine::test
