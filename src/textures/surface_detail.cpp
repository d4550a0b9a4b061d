#include "textures/surface_detail.h"

namespace vitrine {

V3f aboveHorizon(const V3d& n, const V3f& ng) {
    constexpr double least = 1e-3; // sine of the height above the horizon
    const V3d outside = toDouble(ng), unit = n / n.length();
    const double height = unit.dot(outside);
    if (height >= least) return toFloat(unit);
    return toFloat((unit + outside * (least - height)).normalized());
}

} // namespace vitrine
