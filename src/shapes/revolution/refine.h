// One root in a bracket: Halley's method kept in it by bisection.
#pragma once

#include "shapes/revolution/part_solver.h"

namespace vitrine {

/// A function and its derivatives by the part's parameter.
struct Derivatives {
    double f, d1, d2;
};

template <class Function>
PartSolver::Root PartSolver::findRoot(const Function& function, Bracket bracket, double guess) const {
    auto [ta, tb, negativeAtA] = bracket;
    // Not at the ends: there the function may be nothing but rounding, whose sign would lose a root inside.
    const double inset = 0x1p-10 * (tb - ta);
    double t = guess > ta && guess < tb ? std::clamp(guess, ta + inset, tb - inset) : (ta + tb) / 2;
    CurveSample c;
    // The function comes from the curve itself, not from coefficients, so the root is as exact as the point.
    for (int i = 1; i < 100; ++i) {
        c = curve_.at(t);
        const Derivatives v = function(c);
        ((v.f < 0) == negativeAtA ? ta : tb) = t;
        const double slope2 = v.d1 * v.d1, bend = v.f * v.d2;
        double next = t - 2 * v.f * v.d1 / (2 * slope2 - bend);
        // Where the slope vanishes Halley's step does, root or not.
        const bool halley = std::abs(bend) < slope2 && next >= ta && next <= tb && i % 8 != 0;
        if (!halley) next = (ta + tb) / 2;
        const double step = next - t;
        t = next;
        c.x += step * (c.dx + 0.5 * step * c.ddx);
        c.y += step * (c.dy + 0.5 * step * c.ddy);
        // What a step of Halley's leaves is the step times the square of f f''/f'^2, and times its own square and the
        // third derivative over 6 f': both are below a rounding of the parameter, and the curve is its parabola.
        const bool last = halley && std::abs(step) < Function::lastStep && std::abs(bend) < 0x1p-17 * slope2;
        if (last || std::abs(step) <= 0x1p-51) break;
    }
    return {t, c.x, c.y};
}

template <class Function>
bool PartSolver::offerRoot(const Function& function, Bracket bracket, double guess, HitCollector& hits) const {
    const Root root = findRoot(function, bracket, guess);
    return hits.offer(index_, root.t, root.x, root.y, function.isForward(root.y));
}

} // namespace vitrine
