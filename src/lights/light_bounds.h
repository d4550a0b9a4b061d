// What is known of a light, or of many, from afar.
#pragma once

#include "core/direction_cone.h"
#include "lights/light_receiver.h"

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

/// What bounds say about the light that comes to a point, ready to be asked often.
class LightImportance {
  public:
    LightImportance() = default;
    explicit LightImportance(const LightBounds& bounds);

    /// Roughly the irradiance from there; 0 only where no light comes from there at all. The bound of sec. 4.1, with the
    /// cosine at the receiver.
    double at(const LightReceiver& receiver) const;

  private:
    V3d center_{0, 0, 0};
    double radius2_ = 0; ///< squared, of the box's sphere
    double intensity_ = 0;
    V3f axis_{0, 0, 1};
    float cosNormals_ = -1, sinNormals_ = 0, cosReach_ = -1;
    bool twoSided_ = false;
};

} // namespace vitrine
