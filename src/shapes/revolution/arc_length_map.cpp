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
    const double tolerance = 4e-9 * polygon;

    for (const ProfilePart& part : profile.parts()) {
        // By the part's own segment: at a joint the next one may have another speed.
        const BezierCurve& segment = profile.segments()[std::size_t(part.segment)];
        const auto speed = [&](double v) {
            return count * segment.evaluate(std::clamp(v * count - part.segment, 0., 1.)).d1.length();
        };
        const auto divide = [&](const auto& self, double v0, double v1, int depth) -> void {
            std::array<double, 5> length{0};
            for (int i = 0; i < 4; ++i)
                length[std::size_t(i + 1)] = length[std::size_t(i)] + integratePanels(speed, lerp(i / 4., v0, v1),
                                                                                      lerp((i + 1) / 4., v0, v1), 1);
            const double slope0 = speed(v0), slope1 = speed(v1);
            double off = std::abs(integratePanels(speed, v0, v1, 1) - length[4]);
            for (int i = 1; i < 4; ++i)
                off = std::max(
                    off, std::abs(hermite(i / 4., v1 - v0, 0, length[4], slope0, slope1) - length[std::size_t(i)]));
            if (off > tolerance && depth > 0) {
                const double vm = (v0 + v1) / 2;
                self(self, v0, vm, depth - 1);
                self(self, vm, v1, depth - 1);
            } else {
                cells_.push_back({v0, v1, total_, total_ + length[4], slope0, slope1});
                total_ += length[4];
            }
        };
        constexpr int maxHalvings = 24; // next to a cusp each of them quarters the error
        divide(divide, part.v0, part.v1, maxHalvings);
    }
}

double ArcLengthMap::fraction(double v) const {
    const auto next = std::upper_bound(cells_.begin() + 1, cells_.end(), v,
                                       [](double value, const Cell& cell) { return value < cell.v0; });
    const Cell& cell = *(next - 1);
    const double x = std::clamp((v - cell.v0) / (cell.v1 - cell.v0), 0., 1.);
    return hermite(x, cell.v1 - cell.v0, cell.length0, cell.length1, cell.slope0, cell.slope1) / total_;
}

} // namespace vitrine
