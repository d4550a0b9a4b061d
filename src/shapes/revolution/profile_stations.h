// Where the profile of a surface of revolution is cut into chords, for its tessellation.
#pragma once

#include "shapes/revolution/profile.h"

namespace vitrine {

/// A point of the profile at which chords meet.
struct ProfileStation {
    V2d p;
    double v;             ///< of the whole profile
    V2d tangentIn{0, 0};  ///< unit direction in which the curve arrives; of the first station as tangentOut
    V2d tangentOut{0, 0}; ///< and leaves; the same vector where the profile is smooth

    bool onAxis() const { return p.x == 0; }
    bool isCrease() const { return tangentIn != tangentOut; }
};

/// Below this angle (radians) a change of direction counts as drawn smooth, with few decimals.
inline constexpr double smoothJoint = 1e-3;

/// The curve stays within `tolerance` of the chords between neighbours and turns by no more than `maxTurn` radians from one to
/// the next. The ends of segments are stations. Where a closed loop joins smoothly, its two ends have one direction.
/// \throws std::invalid_argument when more than `most` stations would be needed
std::vector<ProfileStation> placeStations(const Profile& profile, double tolerance, double maxTurn, std::size_t most);

} // namespace vitrine
