#include "shapes/placement.h"

#include <stdexcept>

namespace vitrine {

namespace {

bool isSimilarity3(const M44d& m, double scale) {
    // Five units in the last place of a float: what a rotation loses when it is printed in single precision.
    constexpr double tolerance = 3e-7;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j) {
            const double dot = m[i][0] * m[j][0] + m[i][1] * m[j][1] + m[i][2] * m[j][2];
            if (!(std::abs(dot - (i == j ? sqr(scale) : 0)) <= 2 * tolerance * sqr(scale))) return false;
        }
    return true;
}

} // namespace

Placement::Placement(const Transform& worldFromObject, bool reverseOrientation, double reach)
    : worldFromObject_(worldFromObject), objectFromWorld_(worldFromObject.inverse()),
      flips_(reverseOrientation != worldFromObject.swapsHandedness()) {
    volumeScale_ = std::abs(linearDeterminant(worldFromObject_.matrix()));
    scale_ = std::cbrt(volumeScale_);
    maxStretch_ = linearNorm(worldFromObject_.matrix());
    minStretch_ = 1 / linearNorm(objectFromWorld_.matrix());
    isSimilarity_ = isSimilarity3(worldFromObject_.matrix(), scale_);
    boundErrors(reach);
    if (!(volumeScale_ > 0) || !(minStretch_ > 0) || !std::isfinite(volumeScale_) || !std::isfinite(errorBase_) ||
        !std::isfinite(errorSlope_))
        throw std::invalid_argument("the transformation cannot be inverted");
}

void Placement::boundErrors(double reach) {
    // A dot product of four terms errs by less than four roundings of the sum of the absolute terms (Higham 2002,
    // ch. 3), the solution in object space by a few more; four times that leaves room for both.
    constexpr double gamma = 16 * 0x1p-53;
    const M44d &m = worldFromObject_.matrix(), &w = objectFromWorld_.matrix();
    V3d base, slope;
    for (int k = 0; k < 3; ++k) {
        double forward = 0, back = 0, backSlope = 0;
        for (int j = 0; j < 3; ++j) {
            // How far the point has moved in object coordinate j when it comes back: rounding, and what the two
            // matrices fail to be each other's inverse.
            double moved = std::abs(m[3][0] * w[0][j] + m[3][1] * w[1][j] + m[3][2] * w[2][j] + w[3][j]);
            double inverseSum = 0;
            for (int i = 0; i < 3; ++i) {
                const double product = m[i][0] * w[0][j] + m[i][1] * w[1][j] + m[i][2] * w[2][j];
                moved += reach * std::abs(product - (i == j));
                inverseSum += std::abs(w[i][j]);
            }
            back += (gamma * std::abs(w[3][j]) + moved) * std::abs(m[j][k]);
            backSlope += gamma * inverseSum * std::abs(m[j][k]);
            forward += reach * std::abs(m[j][k]);
        }
        base[k] = back + 2 * gamma * forward;
        slope[k] = backSlope + 2 * gamma;
    }
    errorBase_ = base.length();
    errorSlope_ = slope.length();
}

SurfacePoint Placement::toWorld(const ObjectPoint& point) const {
    SurfacePoint result;
    result.p = worldFromObject_.point(point.p);
    result.error = error(result.p);
    const V3d normal = worldFromObject_.normal(point.n);
    const double length = normal.length(), sign = flips_ ? -1 : 1;
    const V3d n = normal / length;
    result.ng = result.ns = toFloat(n * sign);
    result.uv = V2f(point.uv);
    result.dpdu = toFloat(worldFromObject_.vector(point.dpdu));
    result.dpdv = toFloat(worldFromObject_.vector(point.dpdv));
    // d(N/|N|) is dN/|N| less its part along N.
    const auto unitDerivative = [&](const V3d& dn) {
        const V3d d = worldFromObject_.normal(dn) / length;
        return toFloat((d - n * n.dot(d)) * sign);
    };
    result.dndu = unitDerivative(point.dndu);
    result.dndv = unitDerivative(point.dndv);
    return result;
}

} // namespace vitrine
