#include "shapes/revolution/area_table.h"

#include "shapes/quadrature.h"

#include <stdexcept>

namespace vitrine {

AreaTable::AreaTable(const Profile& profile) {
    constexpr int cellsAPart = 16;
    cumulative_.push_back(0);
    const auto density = [&](double v) { return areaDensity(profile.evaluate(v)); };
    for (const ProfilePart& part : profile.parts()) {
        for (int i = 0; i < cellsAPart; ++i) {
            // The ends of a part may be cusps or corners: the density just inside is what counts.
            const double v0 = lerp(double(i) / cellsAPart, part.v0, part.v1);
            const double v1 = lerp(double(i + 1) / cellsAPart, part.v0, part.v1);
            const double inside = 1e-9 * (v1 - v0);
            cells_.push_back({v0, v1, density(v0 + inside), density(v1 - inside)});
            cumulative_.push_back(cumulative_.back() + integratePanels(density, v0, v1, 1));
        }
    }
    if (!(total() > 0)) throw std::invalid_argument("the profile has no area");
}

double AreaTable::sample(double u) const {
    const double target = u * total();
    const auto next = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, target);
    const std::size_t i = std::size_t(next - cumulative_.begin()) - 1;
    const Cell& cell = cells_[i];
    const double mass = cumulative_[i + 1] - cumulative_[i];
    const double x = mass > 0 ? std::clamp((target - cumulative_[i]) / mass, 0., 1.) : 0.5;
    // Inverse of the integral of a linear density, in the form that does not cancel.
    const double root = std::sqrt(lerp(x, sqr(cell.f0), sqr(cell.f1)));
    const double t = cell.f0 + root > 0 ? x * (cell.f0 + cell.f1) / (cell.f0 + root) : x;
    return lerp(std::min(t, 1.), cell.v0, cell.v1);
}

double AreaTable::pdf(double v, double density) const {
    const auto next = std::upper_bound(cells_.begin() + 1, cells_.end(), v,
                                       [](double value, const Cell& cell) { return value < cell.v0; });
    const std::size_t i = std::size_t(next - cells_.begin()) - 1;
    const Cell& cell = cells_[i];
    const double sum = cell.f0 + cell.f1, mass = cumulative_[i + 1] - cumulative_[i];
    // At a pole both the density of area and that of v vanish, and their ratio is a limit.
    if (!(density > 0) || !(sum > 0)) return 1 / total();
    const double linear = lerp(std::clamp((v - cell.v0) / (cell.v1 - cell.v0), 0., 1.), cell.f0, cell.f1);
    return mass / total() * 2 * linear / (sum * (cell.v1 - cell.v0)) / density;
}

} // namespace vitrine
