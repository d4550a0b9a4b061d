// Who asks for light.
#pragma once

#include "core/vec.h"

namespace vitrine {

/// A point that light is asked for.
struct LightReceiver {
    V3d p{0, 0, 0};
    /// Unit: light from behind it counts for nothing, as with a surface that lets no light through. Zero: from all around.
    V3f n{0, 0, 0};
    double time = 0;

    LightReceiver() = default;
    LightReceiver(const V3d& at, const V3f& normal = V3f(0, 0, 0), double when = 0) : p(at), n(normal), time(when) {}
};

} // namespace vitrine
