#include "lights/light_bounds.h"

namespace vitrine {

LightBounds unite(const LightBounds& a, const LightBounds& b) {
    LightBounds both = a;
    both.box.extendBy(b.box);
    both.normals = unite(a.normals, b.normals);
    both.cosReach = std::min(a.cosReach, b.cosReach);
    both.twoSided |= b.twoSided;
    both.intensity += b.intensity;
    return both;
}

} // namespace vitrine
