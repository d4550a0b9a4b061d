// pbrt's LookAt, for tests of cameras and lights.
#pragma once

#include "core/transform.h"

namespace vitrine::test {

/// worldFromCamera of `LookAt position target up` (PBRT 4ed, 3.9.6), whose left-handed camera space has x = up x
/// forward.
inline Transform lookAt(const V3d& position, const V3d& target, const V3d& up) {
    const V3d z = (target - position).normalized(), x = up.cross(z).normalized(), y = z.cross(x);
    return Transform(M44d(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, position.x, position.y, position.z, 1));
}

} // namespace vitrine::test
