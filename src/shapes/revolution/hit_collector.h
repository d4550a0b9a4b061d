// Receives the crossings of one ray with a profile and keeps those that count.
#pragma once

#include "shapes/parameters.h"
#include "shapes/revolution/axial_ray.h"

#include <vector>

namespace vitrine {

struct ProfileHit {
    double s = infinityD; ///< in units of the ray's direction
    unsigned part = 0;    ///< which part of the profile
    double t = 0;         ///< the part's parameter
};

class HitCollector {
  public:
    enum class Mode { First, Any, All };

    HitCollector(const AxialRay& ray, const PhiRange& phi, double sMin, double sMax, Mode mode)
        : ray_(ray), phi_(phi), sMin_(sMin), sMax_(sMax), inverseLength_(1 / ray.length), mode_(mode) {
        lengthMin_ = sMin * ray.length;
        lengthMax_ = sMax * ray.length;
    }

    /// The root at the part's parameter t, where the profile is at (x, y).
    /// \param forward whether g >= 0 there
    void offer(unsigned part, double t, double x, double y, bool forward) {
        const double width = ray_.halfWidth(x);
        // From the height or from the radius, whichever errs less: an error of eps in y or x moves l by eps / v or by
        // eps x / (h g). Of a ray that is all but horizontal the height says nothing.
        const bool fromRadius = width * ray_.h > std::abs(ray_.v) * x || std::abs(ray_.v) < 1e-7;
        const double l = fromRadius ? ((forward ? width : -width) - ray_.q) / ray_.h : (y - ray_.oy) / ray_.v;
        const double s = l * inverseLength_;
        if (!(s > sMin_ && s < sMax_)) return;
        if (!phi_.isFull() && !phi_.contains(ray_.ox + l * ray_.dx, ray_.oz + l * ray_.dz)) return;
        if (mode_ == Mode::All) {
            all_.push_back({s, part, t});
            return;
        }
        first_ = {s, part, t};
        found_ = true;
        sMax_ = s;
        lengthMax_ = l;
    }

    const AxialRay& ray() const { return ray_; }
    double lengthMin() const { return lengthMin_; }
    double lengthMax() const { return lengthMax_; }
    bool done() const { return found_ && mode_ == Mode::Any; }
    bool found() const { return found_; }
    const ProfileHit& first() const { return first_; }
    std::vector<ProfileHit>& all() { return all_; }

  private:
    const AxialRay& ray_;
    const PhiRange& phi_;
    double sMin_, sMax_, lengthMin_, lengthMax_;
    double inverseLength_;
    Mode mode_;
    bool found_ = false;
    ProfileHit first_;
    std::vector<ProfileHit> all_;
};

} // namespace vitrine
