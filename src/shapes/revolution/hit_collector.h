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

    /// \param size of the profile: what, beside the ray's origin, rounding is measured by
    HitCollector(const AxialRay& ray, const PhiRange& phi, double size, double sMin, double sMax, Mode mode)
        : ray_(ray), phi_(phi), sMin_(sMin), sMax_(sMax), margin_(0x1p-44 * (ray.reach + size)),
          inverseLength_(1 / ray.length), mode_(mode) {
        lengthMin_ = sMin * ray.length;
        lengthMax_ = sMax * ray.length;
    }

    /// The root at the part's parameter t, where the profile is at (x, y).
    /// \param forward whether g >= 0 there
    /// \return whether it counts
    bool offer(unsigned part, double t, double x, double y, bool forward) {
        // From the height or from the radius, whichever errs less: an error of eps in y or x moves l by eps / v or by
        // eps x / (h g). Of a ray that is all but horizontal the height says nothing; where the radius is next to nothing,
        // neither can the radius do harm.
        const double width2 = std::max(0., (x - ray_.e) * (x + ray_.e));
        double l;
        if (width2 * sqr(ray_.h) > sqr(ray_.v * x) || std::abs(ray_.v) < 1e-7 ||
            std::abs(ray_.v) * x < 0x1p-8 * margin_ * ray_.h) {
            const double width = std::sqrt(width2);
            l = ((forward ? width : -width) - ray_.q) / ray_.h;
        } else
            l = (y - ray_.oy) * ray_.inverseV;
        const double s = l * inverseLength_;
        if (!(s > sMin_ && s < sMax_)) return false;
        if (!phi_.isFull() && !phi_.contains(ray_.ox + l * ray_.dx, ray_.oz + l * ray_.dz)) return false;
        if (mode_ == Mode::All) {
            all_.push_back({s, part, t});
            return true;
        }
        first_ = {s, part, t};
        found_ = true;
        sMax_ = s;
        lengthMax_ = l;
        return true;
    }
    /// Whether it is enough to know that there is a crossing somewhere between these heights, of a ray that is not
    /// nearly horizontal; then it is found.
    bool settles(double ya, double yb) {
        if (mode_ != Mode::Any || !phi_.isFull()) return false;
        const double a = (ya - ray_.oy) * ray_.inverseV, b = (yb - ray_.oy) * ray_.inverseV;
        const double slack = margin_ * std::abs(ray_.inverseV);
        if (!(std::min(a, b) - slack > lengthMin_ && std::max(a, b) + slack < lengthMax_)) return false;
        return found_ = true;
    }

    /// Whether a ray that is not nearly horizontal has what it needs before it comes to this height, rounding of both
    /// included: of a touch's two crossings the later one in the part may be the nearer by a rounding.
    bool needsNothingFrom(double y) const {
        return wantsOne() && (y - ray_.oy) * ray_.inverseV > lengthMax_ + margin_ * std::abs(ray_.inverseV);
    }

    const AxialRay& ray() const { return ray_; }
    double lengthMin() const { return lengthMin_; }
    double lengthMax() const { return lengthMax_; }
    /// Rounding of lengths and heights, all of it, with room to spare.
    double margin() const { return margin_; }
    /// Whether hits behind the first one do not matter.
    bool wantsOne() const { return mode_ != Mode::All; }
    bool done() const { return found_ && mode_ == Mode::Any; }
    bool found() const { return found_; }
    const ProfileHit& first() const { return first_; }
    std::vector<ProfileHit>& all() { return all_; }

  private:
    const AxialRay& ray_;
    const PhiRange& phi_;
    double sMin_, sMax_, lengthMin_, lengthMax_;
    double margin_, inverseLength_;
    Mode mode_;
    bool found_ = false;
    ProfileHit first_;
    std::vector<ProfileHit> all_;
};

} // namespace vitrine
