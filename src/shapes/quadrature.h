// Integrals of smooth functions, for areas that have no closed form.
#pragma once

#include <array>
#include <cmath>

namespace vitrine {

/// Integral of f over [a, b]: Gauss-Legendre with 8 nodes on each of `panels` equal panels.
template <class F>
double integratePanels(F&& f, double a, double b, int panels) {
    constexpr std::array<double, 4> node{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                         0.9602898564975363};
    constexpr std::array<double, 4> weight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                           0.1012285362903763};
    const double half = (b - a) / (2 * panels);
    double sum = 0;
    for (int i = 0; i < panels; ++i) {
        const double middle = a + (2 * i + 1) * half;
        for (std::size_t k = 0; k < node.size(); ++k)
            sum += weight[k] * (f(middle - half * node[k]) + f(middle + half * node[k]));
    }
    return sum * half;
}

/// estimate(panels) for 1, 2, 4 ... panels until two agree to 1e-10, or `maxPanels` is reached.
template <class F>
double refinePanels(F&& estimate, int maxPanels) {
    double last = estimate(1);
    for (int panels = 2; panels <= maxPanels; panels *= 2) {
        const double next = estimate(panels);
        const bool agree = std::abs(next - last) <= 1e-10 * std::abs(next);
        last = next;
        if (agree) break;
    }
    return last;
}

} // namespace vitrine
