// When two lists of crossings differ: a miss, a surplus, or a touch that is within the tangency band.
#pragma once

#include "support/revolution_oracle.h"

namespace vitrine::test {

/// The band. Let P(u) be the profile in the half-plane, u = segment + t, and R(l) the ray at length l there; let K be the
/// set of (u, l) for which |P(u) - R(l)| <= band. Every crossing lies in K. Moving the surface by less than the band can
/// make or unmake crossings only by pairs within a connected part of K, or singly where that part reaches a rim: a free
/// end of the profile (off the axis), or an edge of the sector when phimax < 360. So in each part of K
///  - equal numbers agree;
///  - numbers that differ by an even count are excused, but only when the surface really turns back within the part:
///    the gap between profile and ray is not monotone over it, or it crosses the ray at less than 1e-6 radian;
///  - any numbers are excused at a rim;
///  - all else is missed or spurious.
struct Judgement {
    int missed = 0, spurious = 0;
    bool excused = false;
    int tooManyAtATouch = 0; ///< the most in one excused part: above 2, rounding was taken for roots

    bool isClean() const { return missed == 0 && spurious == 0; }
};

/// \param exact on the whole line and turn, whatever phimax is
/// \param band absolute
Judgement judge(const ProfilePoints& profile, double phiMaxDegrees, const Ray& ray, const std::vector<OracleHit>& exact,
                const std::vector<OracleHit>& ours, double band);

/// Whether the point of the ray at s lies in the sector (+1), outside (-1), or within `band` of its edges (0).
int inSector(const Ray& ray, double s, double phiMaxDegrees, double band);

} // namespace vitrine::test
