// A ray and a turned profile in the half-plane of height y and distance d from the axis, where the ray is a hyperbola
//     d_r(y) = sqrt(a (y - b)^2 + c).
#pragma once

#include "core/ray.h"
#include "shapes/revolution/profile.h"

#include <string>
#include <vector>

namespace vitrine::plot {

/// Where the line of a ray meets the turned profile.
struct RayRoot {
    double s;      ///< along the ray, in units of its direction; below 0 behind its origin
    int segment;   ///< of the profile
    double t;      ///< the segment's parameter
    double d, y;   ///< distance from the axis and height
    bool inSector; ///< false where phimax leaves the surface out
    bool counts() const { return s > 0 && inSector; }
};

class RaySection {
  public:
    /// \param ray in the space of the profile; its direction is not zero
    explicit RaySection(const Ray& ray);

    /// Height is constant: the ray crosses the half-plane of (y, d) along y = height(0), down to d = closest() and back.
    bool isHorizontal() const { return horizontal_; }
    /// Distance is constant.
    bool isAxial() const { return axial_; }
    double a() const { return a_; }
    double b() const { return b_; }
    double c() const { return closest_ * closest_; }
    /// Least distance of the line from the axis, and where along the ray.
    double closest() const { return closest_; }
    double sAtClosest() const { return sAtClosest_; }

    double height(double s) const { return ray_.o.y + s * ray_.d.y; }
    double distance(double s) const;
    /// (y, d)
    V2d at(double s) const { return V2d(height(s), distance(s)); }

    /// The stretch of s over which height lies in [y0, y1] and distance is at most dMax; empty (first > second) if none.
    std::pair<double, double> stretch(double y0, double y1, double dMax) const;
    /// Points (y, d) over [s0, s1], the closest one among them.
    std::vector<V2d> points(double s0, double s1) const;

    /// Every meeting of the whole line with the profile turned by 360 degrees, by s.
    std::vector<RayRoot> roots(const Profile& profile, double phiMaxDegrees) const;

  private:
    Ray ray_;
    bool horizontal_, axial_;
    double a_ = 0, b_ = 0, closest_, sAtClosest_ = 0;
};

} // namespace vitrine::plot
