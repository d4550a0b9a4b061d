#include "shapes/revolution/part_curve.h"

namespace vitrine {

PartCurve::PartCurve(const BezierCurve& curve) {
    // Next to the axis the radius must keep its relative accuracy.
    centre_ = curve.first().x == 0 ? 0 : curve.last().x == 0 ? 1 : 0.5;
    const PowerForm power(curve.points(), centre_);
    if (power.error().p > 2 * curve.pointError()) bernstein_.emplace(curve.points());
    pairs_ = curve.degree() / 2 + 1;
    bendPairs_ = std::max(1, curve.degree() / 2);
    std::vector<V2d> c = power.coefficients();
    c.resize(std::size_t(2 * pairs_ + 2), V2d(0, 0));
    for (std::size_t k = 0; k < std::size_t(2 * pairs_); ++k) {
        const V2d d = c[k + 1] * double(k + 1);
        rows_.push_back({Lanes{c[k].x, c[k].y, d.x, d.y}});
    }
    for (std::size_t k = 2; k < 2 + 2 * std::size_t(bendPairs_); k += 2) {
        const V2d even = c[k] * double(k * (k - 1)), odd = c[k + 1] * double((k + 1) * k);
        rows_.push_back({Lanes{even.x, even.y, odd.x, odd.y}});
    }
}

CurveSample PartCurve::atBernstein(double t) const {
    const CurvePoint c = bernstein_->evaluate(t);
    return {c.p.x, c.p.y, c.d1.x, c.d1.y, c.d2.x, c.d2.y};
}

} // namespace vitrine
