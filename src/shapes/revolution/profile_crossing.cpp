#include "shapes/revolution/profile_crossing.h"

#include <algorithm>

namespace vitrine {

namespace {

/// How often the profile, closed along the axis, runs round a point: parts that cross the point's horizontal to its right.
/// Heights of joints are shared bit for bit and intervals half-open, so that a joint is crossed once.
class Winding {
  public:
    explicit Winding(const std::vector<ProfilePart>& parts) : parts_(parts) {
        for (const ProfilePart& part : parts) {
            low_ = std::min(low_, lowest(part));
            high_ = std::max(high_, highest(part));
        }
        slabs_.resize(std::clamp<std::size_t>(parts.size(), 1, mostSlabs));
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (lowest(parts[i]) < highest(parts[i]))
                for (std::size_t k = slabOf(lowest(parts[i])); k <= slabOf(highest(parts[i])); ++k)
                    slabs_[k].push_back(std::uint32_t(i));
    }

    int about(const V2d& q) const {
        if (q.y < low_ || q.y >= high_) return 0;
        int winding = 0;
        for (const std::uint32_t i : slabs_[slabOf(q.y)]) {
            const BezierCurve& curve = parts_[i].curve;
            const bool rises = curve.last().y > curve.first().y;
            if (q.y >= lowest(parts_[i]) && q.y < highest(parts_[i]) && isRightOf(curve, rises, q))
                winding += rises ? 1 : -1;
        }
        return winding;
    }

  private:
    static constexpr std::size_t mostSlabs = 256;

    static double lowest(const ProfilePart& part) { return std::min(part.curve.first().y, part.curve.last().y); }
    static double highest(const ProfilePart& part) { return std::max(part.curve.first().y, part.curve.last().y); }

    std::size_t slabOf(double y) const {
        const double place = high_ > low_ ? (y - low_) / (high_ - low_) : 0;
        return std::min(std::size_t(place * double(slabs_.size())), slabs_.size() - 1);
    }

    /// Whether the part, which is monotone, is right of the point at the point's height.
    static bool isRightOf(const BezierCurve& curve, bool rises, const V2d& q) {
        if (q.x < std::min(curve.first().x, curve.last().x)) return true;
        if (q.x > std::max(curve.first().x, curve.last().x)) return false;
        double ta = 0, tb = 1;
        for (int i = 0; i < 50; ++i) {
            const double t = (ta + tb) / 2;
            ((curve.point(t).y < q.y) == rises ? ta : tb) = t;
        }
        return curve.point((ta + tb) / 2).x > q.x;
    }

    const std::vector<ProfilePart>& parts_;
    double low_ = infinityD, high_ = -infinityD;
    std::vector<std::vector<std::uint32_t>> slabs_; ///< of equal height: the parts that reach into each
};

} // namespace

std::optional<WrongSide> findWrongSide(const Profile& profile) {
    if (!profile.isClosed()) return {};
    const auto& parts = profile.parts();
    const double aside = 1e-6 * profile.size(), sign = profile.drawnInsideOut() ? -1 : 1;
    const int samples = int(std::clamp<std::size_t>(16000 / parts.size(), 1, 8));
    const Winding winding(parts);
    std::optional<WrongSide> found;
    double foundLength = 0;
    for (const ProfilePart& part : parts) {
        std::vector<WrongSide> wrong;
        for (int i = 0; i < samples; ++i) {
            const CurvePoint c = part.curve.evaluate((i + 0.5) / samples);
            const double speed = c.d1.length();
            if (!(speed > 0) || c.p.x < 2 * aside) continue;
            const V2d inward = V2d(-c.d1.y, c.d1.x) * (sign * aside / speed);
            const int inside = int(sign) * winding.about(c.p + inward);
            const int outside = int(sign) * winding.about(c.p - inward);
            // Otherwise other parts pass just here: a line drawn twice, a wall of no thickness, the tip of a wedge.
            if (inside - outside == 1 && inside != 1) wrong.push_back({c.p, inside});
        }
        const double length = double(wrong.size()) * (part.curve.last() - part.curve.first()).length();
        if (length <= foundLength) continue;
        found = wrong[wrong.size() / 2];
        foundLength = length;
    }
    return found;
}

} // namespace vitrine
