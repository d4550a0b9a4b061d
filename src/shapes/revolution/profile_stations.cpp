#include "shapes/revolution/profile_stations.h"

#include <stdexcept>

namespace vitrine {

namespace {

/// A piece of the profile and how far it strays from its chord.
class Chord {
  public:
    explicit Chord(const BezierCurve& curve) : curve_(&curve) {
        const auto& points = curve.points();
        const V2d chord = curve.last() - curve.first();
        const double length = chord.length();
        for (const V2d& p : points) {
            const V2d d = p - curve.first();
            // Beyond the ends of the chord the distance to them counts; the hull holds for both.
            const double along = length > 0 ? d.dot(chord) / length : 0;
            const double across = length > 0 ? std::abs(d.x * chord.y - d.y * chord.x) / length : d.length();
            const double outside = std::max({0., -along, along - length});
            hull_ = std::max(hull_, std::hypot(across, outside));
        }
        // The end points do not stray, and at every t they have at least 2 (1/2)^n of the weight.
        hull_ *= 1 - std::ldexp(2, -curve.degree());
    }

    double deviation() const { return hull_; }

    /// Directions at the two ends; zero for a piece of no length.
    V2d firstDirection() const { return direction(curve_->points().begin(), curve_->points().end()); }
    V2d lastDirection() const { return -direction(curve_->points().rbegin(), curve_->points().rend()); }

    /// Bound of the angle between directions: how far those of the control polygon are from the chord's, twice.
    double turn() const {
        const V2d chord = curve_->last() - curve_->first();
        const double smallest = negligible();
        double widest = 0;
        for (std::size_t i = 1; i < curve_->points().size(); ++i) {
            const V2d d = curve_->points()[i] - curve_->points()[i - 1];
            if (d.length() > smallest)
                widest = std::max(widest, std::abs(std::atan2(chord.x * d.y - chord.y * d.x, chord.dot(d))));
        }
        return 2 * widest;
    }

  private:
    /// Differences of control points below this are rounding where the curve's derivative vanishes.
    double negligible() const {
        double length = 0;
        for (std::size_t i = 1; i < curve_->points().size(); ++i)
            length += (curve_->points()[i] - curve_->points()[i - 1]).length();
        return 1e-7 * length;
    }
    template <class Iterator>
    V2d direction(Iterator begin, Iterator end) const {
        const double smallest = negligible();
        for (Iterator i = begin + 1; i != end; ++i) {
            const V2d d = *i - *begin;
            if (d.length() > smallest) return d / d.length();
        }
        return V2d(0, 0);
    }

    const BezierCurve* curve_;
    double hull_ = 0;
};

class StationPlacer {
  public:
    StationPlacer(const Profile& profile, double tolerance, double maxTurn, std::size_t most)
        : tolerance_(tolerance), maxTurn_(maxTurn), most_(most), snap_(1e-9 * profile.size()) {
        for (const ProfilePart& part : profile.parts())
            cut(part.curve, part.v0, part.v1, 0);
        if (stations_.size() < 2) throw std::invalid_argument("the profile has no length");
        const V2d apart = stations_.back().p - stations_.front().p;
        if (apart.length() <= snap_ && !stations_.front().onAxis()) {
            stations_.back().p = stations_.front().p;
            closeLoop(stations_.front(), stations_.back());
        }
    }

    std::vector<ProfileStation> take() { return std::move(stations_); }

  private:
    /// Into pieces of equal length of the parameter, and each of those again where it is not yet flat enough.
    void cut(const BezierCurve& curve, double v0, double v1, int depth) {
        const Chord chord(curve);
        // A chord's distance goes with the square of the length, the turn with the length.
        const double pieces = std::max(std::sqrt(chord.deviation() / tolerance_), chord.turn() / maxTurn_);
        constexpr int deepest = 64; // then v0 and v1 are neighbours
        if (pieces <= 1 || depth == deepest) return add(curve, chord, v0, v1);
        if (!(pieces < double(most_))) tooMany();
        const int n = std::max(2, int(std::ceil(pieces)));
        for (int i = 0; i < n; ++i) {
            const double ta = double(i) / n, tb = double(i + 1) / n;
            cut(curve.part(ta, tb), lerp(ta, v0, v1), lerp(tb, v0, v1), depth + 1);
        }
    }

    void add(const BezierCurve& curve, const Chord& chord, double v0, double v1) {
        const V2d out = chord.firstDirection(), in = chord.lastDirection();
        if (out == V2d(0, 0) || (curve.last() - curve.first()).length() <= snap_) return;
        if (stations_.empty())
            stations_.push_back({snapped(curve.first()), v0, out, out});
        else
            join(stations_.back(), out);
        stations_.push_back({snapped(curve.last()), v1, in, in});
        if (stations_.size() > most_) tooMany();
    }

    static bool isSmooth(const V2d& a, const V2d& b) {
        return a.dot(b) > 0 && std::abs(a.x * b.y - a.y * b.x) < smoothJoint;
    }
    void join(ProfileStation& station, const V2d& out) {
        station.tangentOut = out;
        if (isSmooth(station.tangentIn, out))
            station.tangentIn = station.tangentOut = (station.tangentIn + out).normalized();
    }
    static void closeLoop(ProfileStation& first, ProfileStation& last) {
        if (isSmooth(last.tangentIn, first.tangentOut))
            first.tangentIn = first.tangentOut = last.tangentIn = last.tangentOut =
                (last.tangentIn + first.tangentOut).normalized();
    }
    V2d snapped(const V2d& p) const { return V2d(p.x <= snap_ ? 0. : p.x, p.y); }

    [[noreturn]] static void tooMany() {
        throw std::invalid_argument("the tolerance is so small that the mesh would have more than 2^31 triangles");
    }

    double tolerance_, maxTurn_;
    std::size_t most_;
    double snap_; ///< this near the axis, or each other, points are one
    std::vector<ProfileStation> stations_;
};

} // namespace

std::vector<ProfileStation> placeStations(const Profile& profile, double tolerance, double maxTurn, std::size_t most) {
    return StationPlacer(profile, tolerance, maxTurn, most).take();
}

} // namespace vitrine
