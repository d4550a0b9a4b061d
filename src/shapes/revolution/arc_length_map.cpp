#include "shapes/revolution/arc_length_map.h"

#include "shapes/quadrature.h"

#include <array>

namespace vitrine {

namespace {

/// Cubic Hermite interpolation: x in [0,1] over a cell as wide as `width`.
double hermite(double x, double width, double f0, double f1, double slope0, double slope1) {
    const double y = 1 - x;
    return y * y * (1 + 2 * x) * f0 + x * x * (1 + 2 * y) * f1 + x * y * width * (y * slope0 - x * slope1);
}

} // namespace

ArcLengthMap::ArcLengthMap(const Profile& profile) {
    const double count = double(profile.segments().size());
    double polygon = 0;
    for (const ProfilePart& part : profile.parts())
        polygon += (part.curve.last() - part.curve.first()).length();
    for (std::size_t i = 0; i < profile.segments().size(); ++i) {
        // Between its extremes the speed has no corners.
        std::vector<double> cuts = profile.segments()[i].speedExtrema();
        cuts.push_back(1);
        double from = 0;
        for (const double cut : cuts) {
            append({profile.segments()[i], double(i), count, 4e-9 * polygon}, from, cut, maxHalvings);
            from = cut;
        }
    }
}

void ArcLengthMap::append(const Stretch& stretch, double t0, double t1, int depth) {
    const auto speed = [&](double t) { return stretch.curve.evaluate(t).d1.length(); };
    std::array<double, 5> length{0};
    for (std::size_t i = 0; i < 4; ++i)
        length[i + 1] =
            length[i] + integratePanels(speed, lerp(double(i) / 4, t0, t1), lerp(double(i + 1) / 4, t0, t1), 1);
    const double slope0 = speed(t0), slope1 = speed(t1);
    double off = std::abs(integratePanels(speed, t0, t1, 1) - length[4]);
    for (std::size_t i = 1; i < 4; ++i)
        off = std::max(off, std::abs(hermite(double(i) / 4, t1 - t0, 0, length[4], slope0, slope1) - length[i]));
    if (off > stretch.tolerance && depth > 0) {
        const double tm = (t0 + t1) / 2;
        append(stretch, t0, tm, depth - 1);
        append(stretch, tm, t1, depth - 1);
        return;
    }
    const double v0 = (stretch.segment + t0) / stretch.segments, v1 = (stretch.segment + t1) / stretch.segments;
    cells_.push_back({v0, v1, total_, total_ + length[4], slope0 * stretch.segments, slope1 * stretch.segments});
    total_ += length[4];
}

double ArcLengthMap::fraction(double v) const {
    const auto next = std::upper_bound(cells_.begin() + 1, cells_.end(), v,
                                       [](double value, const Cell& cell) { return value < cell.v0; });
    const Cell& cell = *(next - 1);
    const double x = std::clamp((v - cell.v0) / (cell.v1 - cell.v0), 0., 1.);
    return hermite(x, cell.v1 - cell.v0, cell.length0, cell.length1, cell.slope0, cell.slope1) / total_;
}

} // namespace vitrine
