// The root finder of the 2018 system, as a baseline to measure against: it misses roots.
#pragma once

#include "core/ray.h"

#include <optional>
#include <vector>

namespace vitrine::test {

/// Newton's method on f(t) = a (y(t) - b)^2 + c - x(t)^2 from equidistant starts on each segment, the curve in the power
/// basis. Outside [0,1] f goes on as its tangent, so that an iterate that leaves comes back. Rays at right angles to the
/// axis have no such f; there y(t) = o_y is solved, and each root gives two places on the ray. The nearest hit counts.
class Newton2018 {
  public:
    static constexpr int defaultStarts = 10;

    explicit Newton2018(const std::vector<std::vector<V2d>>& profile, int startsPerSegment = defaultStarts);

    struct Hit {
        double s;
        int segment;
        double t;
    };
    /// The nearest of the hits found with s in (sMin, sMax).
    std::optional<Hit> closest(const Ray& ray, double sMin, double sMax) const;

  private:
    struct Segment {
        std::vector<V2d> power; ///< coefficients, constant first
    };
    struct Value {
        V2d p, d;
    };
    static Value at(const Segment& segment, double t);
    template <class Function>
    static std::optional<double> iterate(double start, Function&& f);
    template <class Function, class Offer>
    void fromAllStarts(Function&& f, Offer&& offer) const;

    std::vector<Segment> segments_;
    int starts_;
};

} // namespace vitrine::test
