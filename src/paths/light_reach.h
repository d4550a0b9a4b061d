// Whether a ray has any chance to run into a light.
#pragma once

#include "paths/world.h"

namespace vitrine {

/// For paths that end, but for the light that their last direction may run into: most directions lead past all lights,
/// which a few boxes tell sooner than a scene.
class LightReach {
  public:
    LightReach() = default;
    explicit LightReach(const World& world);

    /// False only where neither the ray nor its continuation through surfaces that do not scatter meets a light.
    bool mayMeet(const Ray& ray) const;

  private:
    bool everywhere_ = false; ///< a light at infinity shines from all directions
    std::vector<Box3d> boxes_;
};

} // namespace vitrine
