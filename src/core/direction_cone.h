// Directions about an axis.
#pragma once

#include "core/vec.h"

namespace vitrine {

/// All directions within an angle of an axis.
struct DirectionCone {
    V3d axis{0, 0, 1};    ///< unit
    double cosAngle = -1; ///< of the half angle: 1 for the axis alone, -1 for all directions

    /// \param axis of any length above zero
    static DirectionCone about(const V3d& axis) { return {axis.normalized(), 1}; }
    bool isAll() const { return cosAngle <= -1; }
};

/// A cone that holds both: the narrowest one about an axis between theirs (Conty Estevez & Kulla 2018, algorithm 1), but
/// for a few roundings that it is wider.
DirectionCone unite(const DirectionCone& a, const DirectionCone& b);

} // namespace vitrine
