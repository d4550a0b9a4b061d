// What is known of a light, or of many, from afar.
#pragma once

#include "core/direction_cone.h"

namespace vitrine {

/// Where lights lie and which way they shine (Conty Estevez & Kulla 2018, "Importance sampling of many lights with
/// adaptive tree splitting", sec. 4.1).
struct LightBounds {
    Box3d box;
    DirectionCone normals; ///< theta_o: what lights face; all directions for those that shine all around
    double cosReach = -1;  ///< cosine of theta_e: how far from a normal they shine; not more than 90 degrees unless the
                           ///< normals are all directions
    bool twoSided = false; ///< they shine likewise to the other side
    double intensity = 0;  ///< W/sr along the normals, summed
};

/// \pre both have boxes that are not empty
LightBounds unite(const LightBounds& a, const LightBounds& b);

} // namespace vitrine
