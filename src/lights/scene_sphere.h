// What lights at infinity shine into.
#pragma once

#include "core/frame.h"
#include "core/ray.h"
#include "core/sampling.h"

namespace vitrine {

struct SceneSphere {
    V3d center{0, 0, 0};
    double radius = 0;

    /// Round a box; a point if the box is empty.
    static SceneSphere around(const Box3d& box) {
        if (box.isEmpty()) return {};
        return {box.center(), box.size().length() / 2};
    }

    /// Area across a beam that fills the sphere.
    double crossSection() const { return piD * sqr(radius); }

    /// A ray of such a beam, uniform over its cross section, from before the sphere. \param direction unit length
    Ray beam(const V3f& direction, const V2f& u) const {
        const V2f disk = sampleUniformDisk(u);
        const Frame frame(direction);
        const V3d across = toDouble(frame.s) * double(disk.x) + toDouble(frame.t) * double(disk.y);
        return Ray{center + (across - toDouble(direction)) * radius, toDouble(direction), infinityD};
    }
};

} // namespace vitrine
