#include "support/revolution_band.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace vitrine::test {

int inSector(const Ray& ray, double s, double phiMaxDegrees, double band) {
    if (phiMaxDegrees >= 360) return 1;
    const long double x = ray.o.x + (long double)(s)*ray.d.x, z = ray.o.z + (long double)(s)*ray.d.z;
    const long double end = (long double)(radians(phiMaxDegrees));
    for (const long double edge : {0.L, end}) {
        const long double along = x * std::cos(edge) + z * std::sin(edge);
        const long double aside = z * std::cos(edge) - x * std::sin(edge);
        if (std::hypot(std::min(along, 0.L), aside) <= band) return 0;
    }
    long double phi = std::atan2(z, x);
    if (phi < 0) phi += 2 * std::acos(-1.L);
    return phi < end ? 1 : -1;
}

namespace {

struct Nearest {
    long double distance, l;
};

/// A piece of the profile that is within the band of one half of the ray.
struct Stretch {
    long double ua, ub;
    bool forward;
};

struct Place {
    bool ours;
    long double u;
    bool forward;
    int sector;
    /// What of the profile within the band about the place is nearest to the halves' common tip; none where all is farther
    /// from it than the band. Unknown until it is asked for, as it is costly.
    mutable std::optional<std::optional<long double>> nearTip{};
};

class Scene {
  public:
    Scene(const ProfilePoints& profile, const Ray& ray, long double band) : ray_(ray), band_(band) {
        for (const std::vector<V2d>& points : profile) {
            curves_.emplace_back(points);
            fastest_ = std::max(fastest_, (long double)(3 * curves_.back().degree() * sizeOf(profile)));
        }
        isLoop_ = profile.front().front() == profile.back().back();
        firstIsFree_ = !isLoop_ && profile.front().front().x > 0;
        lastIsFree_ = !isLoop_ && profile.back().back().x > 0;
    }

    long double end() const { return (long double)(curves_.size()); }
    bool isLoop() const { return isLoop_; }
    bool isVertical() const { return ray_.h == 0; }

    SlowCurve::Sample at(long double u) const {
        const int segment = std::min(int(u), int(curves_.size()) - 1);
        return curves_[std::size_t(segment)].at(u - segment);
    }

    /// From the half of the ray's hyperbola, by Gauss and Newton from the points level with it and above it.
    Nearest nearest(long double u, bool forward) const {
        const SlowCurve::Sample c = at(u);
        const long double side = forward ? 1 : -1, wide = ray_.width(c.x);
        Nearest best{std::numeric_limits<long double>::infinity(), 0};
        // g = q + h l is what parts the halves; a vertical ray has one half, g = q.
        const auto descend = [&](long double l) {
            for (int i = 0; i < 6; ++i) {
                if (!isVertical() && side * (ray_.q + ray_.h * l) < 0) l = -ray_.q / ray_.h;
                const long double g = ray_.q + ray_.h * l, r = std::sqrt(ray_.e * ray_.e + g * g);
                const long double ex = c.x - r, ey = c.y - ray_.oy - ray_.v * l;
                const long double distance = std::sqrt(ex * ex + ey * ey);
                if (distance < best.distance) best = {distance, l};
                const long double tx = r > 0 ? ray_.h * g / r : side * ray_.h, slope2 = tx * tx + ray_.v * ray_.v;
                if (!(slope2 > 0)) break;
                const long double step = (ex * tx + ey * ray_.v) / slope2;
                l += step;
                if (std::fabs(step) < 1e-3L * band_) break;
            }
        };
        if (ray_.v != 0) descend((c.y - ray_.oy) / ray_.v);
        if (ray_.h > 0) descend((side * wide - ray_.q) / ray_.h);
        return best;
    }
    long double distance(long double u, bool forward) const { return nearest(u, forward).distance; }
    /// Distance with the sign of the side: above or below this half of the hyperbola.
    long double gap(long double u, bool forward) const {
        const SlowCurve::Sample c = at(u);
        const long double above =
            isVertical() ? c.x - ray_.e : ray_.rise(c.y) - (forward ? ray_.v : -ray_.v) * ray_.width(c.x);
        return above < 0 ? -distance(u, forward) : distance(u, forward);
    }
    bool isClose(long double u, bool forward) const { return distance(u, forward) <= band_; }
    bool isCloseAlong(long double ua, long double ub, bool forward, int steps = 64) const {
        if (std::fabs(ub - ua) * fastest_ < band_ / 2) return distance(ua, forward) <= band_ / 2;
        if (!isClose(ub, forward)) return false;
        for (int i = 0; i < steps; ++i)
            if (!isClose(ua + (ub - ua) * i / steps, forward)) return false;
        for (int joint = 1; joint < int(curves_.size()); ++joint)
            if (joint > std::min(ua, ub) && joint < std::max(ua, ub) && !isClose(joint, forward)) return false;
        return true;
    }
    /// Where on the stretch of the profile about these places the halves' common tip is within the band. Next to the tip
    /// rounding decides which half a crossing is said to be on.
    std::optional<long double> tipNear(const Place& a, const Place& b) const {
        if (isVertical()) return {};
        for (const long double u : {a.u, b.u, (a.u + b.u) / 2})
            if (const auto tip = tipFrom(u, a, b)) return tip;
        // The profile may turn between the places and the tip: look along all of what is in the band.
        for (const Place* place : {&a, &b})
            if (const auto near = nearestToTip(*place))
                if (const auto tip = tipFrom(*near, a, b)) return tip;
        return {};
    }
    /// Whether two places of one half hang together by way of the other: where a fold of the profile lies beyond the tip.
    bool meetBeyondTip(const Place& a, const Place& b) const {
        const auto tipA = tipNear(a, a), tipB = tipA ? tipNear(b, b) : std::nullopt;
        return tipB && isCloseAlong(*tipA, *tipB, !a.forward);
    }
    /// Whether the curve crosses the ray at less than 1e-6 radian.
    bool isGrazing(const Place& p) const {
        const SlowCurve::Sample c = at(p.u);
        const long double g = p.forward ? ray_.width(c.x) : -ray_.width(c.x);
        const long double tx = c.x > 0 ? ray_.h * g / c.x : ray_.h, ty = ray_.v;
        return std::fabs(c.dx * ty - c.dy * tx) <= 1e-6L * std::hypot(c.dx, c.dy) * std::hypot(tx, ty);
    }
    bool reachesRim(const Place& p) const {
        return (firstIsFree_ && isCloseAlong(0, p.u, p.forward)) ||
               (lastIsFree_ && isCloseAlong(p.u, end(), p.forward));
    }
    bool meetAcrossLoop(const Place& first, const Place& last) const {
        return isCloseAlong(0, first.u, first.forward) && isCloseAlong(last.u, end(), last.forward);
    }
    /// Lengthened at both ends while still in the band.
    Stretch lengthened(Stretch s) const {
        for (const int side : {-1, 1}) {
            long double& u = side < 0 ? s.ua : s.ub;
            for (long double step = 0x1p-2L; step > 0x1p-56L;) {
                const long double next = std::clamp(u + side * step, 0.L, end());
                if (next != u && isCloseAlong(u, next, s.forward, 8))
                    u = next;
                else
                    step /= 2;
            }
        }
        return s;
    }
    /// Whether the gap turns along the stretch.
    bool turns(const Stretch& s) const {
        constexpr int steps = 128;
        bool rises = false, falls = false;
        long double before = gap(s.ua, s.forward);
        for (int i = 1; i <= steps && !(rises && falls); ++i) {
            const long double here = gap(s.ua + (s.ub - s.ua) * i / steps, s.forward);
            (here > before ? rises : falls) = true;
            before = here;
        }
        return rises && falls;
    }

    /// Adds in which sectors the ray is beside the stretch.
    void sectorsAlong(const Stretch& s, const Ray& ray, double phiMax, bool& inside, bool& outside) const {
        constexpr int steps = 32;
        for (int i = 0; i <= steps; ++i) {
            const Nearest here = nearest(s.ua + (s.ub - s.ua) * i / steps, s.forward);
            const int sector = inSector(ray, double(here.l / ray_.length), phiMax, double(band_));
            inside = inside || sector >= 0;
            outside = outside || sector <= 0;
        }
    }

  private:
    std::pair<long double, long double> toTip(const SlowCurve::Sample& c) const {
        return {ray_.e - c.x, ray_.oy - ray_.v * ray_.q / ray_.h - c.y};
    }
    long double distanceToTip(long double u) const {
        const auto [x, y] = toTip(at(u));
        return std::hypot(x, y);
    }
    std::optional<long double> nearestToTip(const Place& place) const {
        if (place.nearTip) return *place.nearTip;
        place.nearTip.emplace();
        const Stretch s = lengthened({place.u, place.u, place.forward});
        if (distanceToTip((s.ua + s.ub) / 2) > band_ + fastest_ * (s.ub - s.ua) / 2) return {};
        constexpr int steps = 256;
        long double best = s.ua, least = distanceToTip(best);
        for (int i = 1; i <= steps; ++i) {
            const long double u = s.ua + (s.ub - s.ua) * i / steps, here = distanceToTip(u);
            if (here < least) best = u, least = here;
        }
        place.nearTip = best;
        return best;
    }
    /// By Newton's method from u.
    std::optional<long double> tipFrom(long double u, const Place& a, const Place& b) const {
        for (int i = 0; i < 12; ++i) {
            const SlowCurve::Sample c = at(u);
            const auto [ex, ey] = toTip(c);
            if (std::hypot(ex, ey) <= band_ && isCloseAlong(a.u, u, a.forward) && isCloseAlong(u, b.u, b.forward))
                return u;
            const long double speed2 = c.dx * c.dx + c.dy * c.dy;
            if (!(speed2 > 0)) break;
            const long double next = std::clamp(u + (ex * c.dx + ey * c.dy) / speed2, 0.L, end());
            if (std::fabs(next - u) < 1e-3L * band_) break;
            u = next;
        }
        return {};
    }

    std::vector<SlowCurve> curves_;
    HalfPlaneRay ray_;
    long double band_;
    long double fastest_ = 0; ///< bound of |P'(u)|
    bool isLoop_, firstIsFree_, lastIsFree_;
};

/// Which connected part of K each place is in.
class Parts {
  public:
    explicit Parts(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t(0)); }
    std::size_t of(std::size_t i) const {
        while (parent_[i] != i)
            i = parent_[i];
        return i;
    }
    void join(std::size_t a, std::size_t b) { parent_[of(b)] = of(a); }

  private:
    std::vector<std::size_t> parent_;
};

Parts connect(const Scene& scene, const std::vector<Place>& places) {
    Parts parts(places.size());
    for (const bool forward : {false, true}) {
        std::optional<std::size_t> first, last;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i].forward != forward) continue;
            if (last && scene.isCloseAlong(places[*last].u, places[i].u, forward)) parts.join(*last, i);
            if (!first) first = i;
            last = i;
        }
        if (first && scene.isLoop() && scene.meetAcrossLoop(places[*first], places[*last])) parts.join(*first, *last);
    }
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t k = i + 1; k < places.size(); ++k)
            if (parts.of(i) != parts.of(k) &&
                (places[i].forward != places[k].forward ? scene.tipNear(places[i], places[k]).has_value()
                                                        : scene.meetBeyondTip(places[i], places[k])))
                parts.join(i, k);
    return parts;
}

bool touchesTip(const Scene& scene, const std::vector<Place>& part) {
    return std::any_of(part.begin(), part.end(), [&](const Place& p) { return scene.tipNear(p, p).has_value(); });
}

/// What the part covers of the profile, by halves of the ray; of both halves when they meet in it.
std::vector<Stretch> stretchesOf(const Scene& scene, const std::vector<Place>& part) {
    const bool tip = touchesTip(scene, part);
    std::vector<Stretch> result;
    for (const bool forward : {false, true}) {
        long double ua = std::numeric_limits<long double>::infinity(), ub = -ua;
        for (const Place& place : part)
            if (place.forward == forward || tip) ua = std::min(ua, place.u), ub = std::max(ub, place.u);
        if (ua <= ub) result.push_back(scene.lengthened({ua, ub, forward}));
    }
    return result;
}

bool isAtRim(const Scene& scene, const std::vector<Place>& part, const Ray& ray, double phiMax) {
    for (const Place& place : part)
        if (scene.reachesRim(place)) return true;
    if (phiMax >= 360) return false;
    bool inside = false, outside = false;
    for (const Place& place : part) {
        inside = inside || place.sector >= 0;
        outside = outside || place.sector <= 0;
    }
    for (const Stretch& stretch : stretchesOf(scene, part))
        scene.sectorsAlong(stretch, ray, phiMax, inside, outside);
    return inside && outside;
}

bool turnsBack(const Scene& scene, const std::vector<Place>& part) {
    // Between two true crossings of one half the gap turns, however small the loop.
    for (const bool forward : {false, true})
        if (std::count_if(part.begin(), part.end(),
                          [&](const Place& p) { return !p.ours && p.forward == forward; }) > 1)
            return true;
    for (const Place& place : part)
        if (scene.isGrazing(place)) return true;
    if (touchesTip(scene, part)) return true;
    for (const Stretch& stretch : stretchesOf(scene, part))
        if (scene.turns(stretch)) return true;
    return false;
}

} // namespace

Judgement judge(const ProfilePoints& profile, double phiMaxDegrees, const Ray& ray, const std::vector<OracleHit>& exact,
                const std::vector<OracleHit>& ours, double band) {
    const Scene scene(profile, ray, band);
    std::vector<Place> places;
    for (const auto* list : {&exact, &ours})
        for (const OracleHit& hit : *list)
            places.push_back({list == &ours, hit.segment + (long double)(hit.t), hit.forward || scene.isVertical(),
                              inSector(ray, hit.s, phiMaxDegrees, band)});
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.u < b.u; });
    const Parts parts = connect(scene, places);

    Judgement result;
    for (std::size_t root = 0; root < places.size(); ++root) {
        if (parts.of(root) != root) continue;
        std::vector<Place> members;
        for (std::size_t i = 0; i < places.size(); ++i)
            if (parts.of(i) == root) members.push_back(places[i]);
        int surplus = 0;
        for (const Place& place : members)
            if (place.ours || place.sector >= 0) surplus += place.ours ? 1 : -1;
        if (surplus == 0) continue;
        if (isAtRim(scene, members, ray, phiMaxDegrees) || (surplus % 2 == 0 && turnsBack(scene, members))) {
            result.excused = true;
            result.tooManyAtATouch = std::max(result.tooManyAtATouch, surplus);
        } else {
            (surplus > 0 ? result.spurious : result.missed) += std::abs(surplus);
        }
    }
    return result;
}

} // namespace vitrine::test
