// Holes for tests of casters.
#pragma once

#include "accel/cutout.h"
#include "core/random.h"

namespace vitrine::test {

/// Space is cut into cubes, each with an opacity of its own: nothing, everything, beyond both, or something between.
class SpottedCutout final : public Cutout {
  public:
    explicit SpottedCutout(double side = 0.25, bool between = true) : side_(side), between_(between) {}

    float opacity(const SurfacePoint& point) const override {
        const auto cell = [&](double x) { return std::int64_t(std::floor(x / side_)); };
        const std::uint64_t bits = streamKey(cell(point.p.x), cell(point.p.y), cell(point.p.z));
        if (!between_) return bits % 2 ? 1.f : 0.f;
        constexpr float kinds[] = {0, 1, -0.5f, 2};
        return bits % 3 == 0 ? unitFloat(std::uint32_t(bits >> 32)) : kinds[bits % 4];
    }

  private:
    double side_;
    bool between_;
};

class EvenCutout final : public Cutout {
  public:
    explicit EvenCutout(float opacity) : opacity_(opacity) {}
    float opacity(const SurfacePoint&) const override { return opacity_; }

  private:
    float opacity_;
};

} // namespace vitrine::test
