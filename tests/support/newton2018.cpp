#include "support/newton2018.h"

namespace vitrine::test {

Newton2018::Newton2018(const std::vector<std::vector<V2d>>& profile, int startsPerSegment) : starts_(startsPerSegment) {
    for (const std::vector<V2d>& points : profile) {
        const std::size_t n = points.size() - 1;
        Segment segment;
        std::vector<V2d> c = points; // forward differences
        double binomial = 1;
        for (std::size_t k = 0; k <= n; ++k) {
            segment.power.push_back(c[0] * binomial);
            for (std::size_t i = 0; i + 1 < c.size(); ++i)
                c[i] = c[i + 1] - c[i];
            c.pop_back();
            binomial = binomial * double(n - k) / double(k + 1);
        }
        segments_.push_back(std::move(segment));
    }
}

Newton2018::Value Newton2018::at(const Segment& segment, double t) {
    Value value{V2d(0, 0), V2d(0, 0)};
    for (std::size_t k = segment.power.size(); k-- > 0;) {
        value.d = value.d * t + value.p;
        value.p = value.p * t + segment.power[k];
    }
    return value;
}

/// \param f gives value and derivative
template <class Function>
std::optional<double> Newton2018::iterate(double start, Function&& f) {
    double t = start;
    for (int i = 0; i < 30; ++i) {
        const double inside = std::clamp(t, 0., 1.);
        auto [value, slope] = f(inside);
        value += slope * (t - inside);
        const double next = t - value / slope;
        if (!std::isfinite(next)) return std::nullopt;
        const bool settled = std::abs(next - t) < 1e-12;
        t = next;
        if (settled) break;
        if (i == 29) return std::nullopt;
    }
    return t >= 0 && t <= 1 ? std::optional(t) : std::nullopt;
}

template <class Function, class Offer>
void Newton2018::fromAllStarts(Function&& f, Offer&& offer) const {
    for (std::size_t i = 0; i < segments_.size(); ++i)
        for (int k = 0; k < starts_; ++k) {
            const auto t = iterate((k + 0.5) / starts_, [&](double at_) { return f(at(segments_[i], at_)); });
            if (t) offer(int(i), *t, at(segments_[i], *t).p);
        }
}

std::optional<Newton2018::Hit> Newton2018::closest(const Ray& ray, double sMin, double sMax) const {
    std::optional<Hit> best;
    const auto keep = [&](double s, int segment, double t) {
        if (s > sMin && s < (best ? best->s : sMax)) best = Hit{s, segment, t};
    };
    const double horizontal2 = ray.d.x * ray.d.x + ray.d.z * ray.d.z;
    const double along = ray.o.x * ray.d.x + ray.o.z * ray.d.z, cross = ray.o.x * ray.d.z - ray.o.z * ray.d.x;
    if (ray.d.y == 0) {
        fromAllStarts([&](const Value& c) { return std::pair(c.p.y - ray.o.y, c.d.y); },
                      [&](int segment, double t, const V2d& p) {
                          const double discriminant = horizontal2 * p.x * p.x - cross * cross;
                          if (discriminant < 0) return;
                          for (const double sign : {-1., 1.})
                              keep((-along + sign * std::sqrt(discriminant)) / horizontal2, segment, t);
                      });
        return best;
    }
    // The distance from the axis at height y: a (y - b)^2 + c; of a ray parallel to the axis, c alone.
    const double a = horizontal2 / (ray.d.y * ray.d.y);
    const double b = horizontal2 > 0 ? ray.o.y - ray.d.y * along / horizontal2 : 0;
    const double c = horizontal2 > 0 ? cross * cross / horizontal2 : ray.o.x * ray.o.x + ray.o.z * ray.o.z;
    fromAllStarts(
        [&](const Value& curve) {
            const double height = curve.p.y - b;
            return std::pair(a * height * height + c - curve.p.x * curve.p.x,
                             2 * (a * height * curve.d.y - curve.p.x * curve.d.x));
        },
        [&](int segment, double t, const V2d& p) { keep((p.y - ray.o.y) / ray.d.y, segment, t); });
    return best;
}

} // namespace vitrine::test
