// All crossings of a ray with one part of a profile.
//
// A crossing is a change of sign; signs are counted by Descartes' rule on Bernstein coefficients, which bisection makes
// exact (Mourrain & Rouillier 2005, "Isolation of real roots in the Bernstein basis"; hull rejection as in Nishita,
// Sederberg & Kakimoto 1990). Two properties make the count watertight: the signs at a part's ends come from its end
// points alone, by the same operations for both neighbours, and halves share the value at which they meet. So a
// crossing at a joint is found once, and a ray meets a closed profile an even number of times whatever the rounding.
// A touch within rounding (two roots that cannot be told apart) is no crossing.
#pragma once

#include "shapes/revolution/hit_collector.h"
#include "shapes/revolution/part_curve.h"

#include <array>

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

    std::size_t memoryBytes() const;

  private:
    static constexpr int maxPoints = BezierCurve::maxDegree + 1;
    static constexpr int maxCoefficients = 2 * BezierCurve::maxDegree + 1;
    /// Halvings after which roots count as one place: 2^-44 of the part.
    static constexpr int maxDepth = 44;

    /// A stretch of the part at whose ends a function of the parameter differs in sign.
    struct Bracket {
        double ta, tb;
        bool negativeAtA;
    };
    /// Four coefficients each: x^2, y - middle and its square, in degree 2n.
    struct Quadruple {
        Lanes x2, y1, y2;
    };
    struct Quadratic; ///< F in degree 2n, for one ray
    struct Dip;
    struct Branch; ///< of the hyperbola: one sign of g
    struct Excess; ///< of x over a radius

    struct Root {
        double t, x, y;
    };

    /// The root in the bracket, from where the search for it may begin. A step shorter than Function::lastStep is the last.
    template <class Function>
    Root findRoot(const Function& function, Bracket bracket, double guess) const;
    template <class Function>
    bool offerRoot(const Function& function, Bracket bracket, double guess, HitCollector& hits) const;

    void solveSteep(HitCollector& hits) const;
    Dip findDip(const Quadratic& f) const;
    void solveSeveral(const Quadratic& f, int variations, HitCollector& hits) const;
    bool isolateSteep(const Quadratic& f, double* c, double ta, double tb, int depth, HitCollector& hits) const;
    bool isInOrder(const AxialRay& ray) const { return (y1_ > y0_) == (ray.v > 0); }
    bool isNoise(const AxialRay& ray, const double* c, const std::array<double, 2>& x,
                 const std::array<double, 2>& y) const;

    void solveShallow(HitCollector& hits) const;
    bool clipToReach(const AxialRay& ray, double* x, double* p, double& ta, double& tb) const;
    double reachAt(double radius) const;
    bool isolateShallow(const Branch& branch, const double* x, const double* p, const Bracket& bracket,
                        bool negativeAtB, int depth, HitCollector& hits) const;

    unsigned index_;
    int points_, coefficients_, quadruples_; ///< n + 1, 2n + 1, and that in fours
    unsigned inLast_;                        ///< lanes of the last quadruple before the last coefficient
    double x0_, y0_, x1_, y1_, xHalf_, yHalf_;
    double middle_; ///< reference height, of the part's middle or its pole
    double xMax_;   ///< of the control points: |x|
    double reach_;  ///< of the control points: |x| and |y|
    PartCurve curve_;
    std::vector<Quadruple> squares_;
    std::vector<double> control_; ///< x of the control points, then y
};

} // namespace vitrine
