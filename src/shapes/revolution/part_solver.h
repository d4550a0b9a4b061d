// All crossings of a ray with one part of a profile.
//
// A crossing is a change of sign; signs are counted by Descartes' rule on Bernstein coefficients, which bisection makes
// exact (Mourrain & Rouillier 2005, "Isolation of real roots in the Bernstein basis"; hull rejection as in Nishita,
// Sederberg & Kakimoto 1990). Two properties make the count watertight: the signs at a part's ends come from its end
// points alone, by the same operations for both neighbours, and halves share the value at which they meet. So a
// crossing at a joint is found once, and a ray meets a closed profile an even number of times whatever the rounding.
// A touch within rounding (two roots that cannot be told apart) is no crossing.
#pragma once

#include "shapes/revolution/bezier_curve.h"
#include "shapes/revolution/hit_collector.h"

namespace vitrine {

class PartSolver {
  public:
    PartSolver(const BezierCurve& curve, unsigned index);

    void solve(HitCollector& hits) const {
        if (hits.ray().isShallow())
            solveShallow(hits);
        else
            solveSteep(hits);
    }

    std::size_t memoryBytes() const { return sizeof(*this) + numbers_.size() * sizeof(double); }

  private:
    static constexpr int maxPoints = BezierCurve::maxDegree + 1;
    static constexpr int maxCoefficients = 2 * BezierCurve::maxDegree + 1;
    /// Halvings after which roots count as one place: 2^-44 of the part.
    static constexpr int maxDepth = 44;

    struct Sample {
        double x, y, dx, dy;
    };
    Sample at(double t) const;

    void solveSteep(HitCollector& hits) const;
    void isolateSteep(double* c, double ta, double tb, int depth, HitCollector& hits) const;
    double steepNoise(const AxialRay& ray, double ta, double tb) const;
    void refineSteep(double ta, double tb, bool negativeAtA, double guess, HitCollector& hits) const;

    struct Branch; ///< of the hyperbola: one sign of g
    void solveShallow(HitCollector& hits) const;
    bool clipToReach(const AxialRay& ray, double* x, double* p, double& ta, double& tb) const;
    double reachAt(const double* x, double radius) const;
    void isolateShallow(const Branch& branch, double* x, double* p, double ta, double tb, int depth,
                        HitCollector& hits) const;
    void refineShallow(const Branch& branch, double ta, double tb, bool negativeAtA, HitCollector& hits) const;

    const double* scaled() const { return numbers_.data(); }    ///< (x, y) times binomials, interleaved
    const double* xs() const { return scaled() + 2 * points_; } ///< control points
    const double* ys() const { return xs() + points_; }
    const double* xSquared() const { return ys() + points_; }           ///< x^2, in degree 2n
    const double* raised() const { return xSquared() + coefficients_; } ///< y - middle, in degree 2n
    const double* squared() const { return raised() + coefficients_; }  ///< (y - middle)^2

    unsigned index_;
    int points_, coefficients_; ///< n + 1, 2n + 1
    double middle_;             ///< reference height, of the part's middle or its pole
    double xMax_;               ///< of the control points: |x|
    std::vector<double> numbers_;
};

} // namespace vitrine
