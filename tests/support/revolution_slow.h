// An independent solver for long campaigns: interval bounds of first and second derivatives, in long double.
#pragma once

#include "support/revolution_oracle.h"

namespace vitrine::test {

/// A profile cut where x(t) turns, each piece with a binary tree of bounds of |x|, |x'|, |x''|, |y'|, |y''|. A ray's
/// function f on an interval with middle m and half-width r has no root when |f(m)| > |f'(m)| r + max|f''| r^2 / 2, and
/// one at most when |f'(m)| > max|f''| r; otherwise the interval is halved. For steep rays f is the squared equation, for
/// shallow ones (|v| < 1e-3) either half of the hyperbola is taken by itself, with first derivatives only.
class SlowSolver {
  public:
    explicit SlowSolver(const ProfilePoints& profile);
    /// Every crossing on the whole line, ascending in s; at() of each lies on the ray to about 1e-17.
    std::vector<OracleHit> hits(const Ray& ray) const;

  private:
    static constexpr int treeDepth = 4;
    struct Bounds {
        long double x, x1, x2, y1, y2;
    };
    struct Node {
        SlowCurve::Sample middle;
        Bounds bounds;
        long double xLow, xHigh, yLow, yHigh;
    };
    struct Piece {
        int segment;
        long double ta, tb;
        SlowCurve::Sample first, last;
        std::vector<Node> nodes; ///< the i-th's halves are 2i + 1 and 2i + 2
    };
    struct Steep;
    struct Shallow;

    void addPieces(int segment, const std::vector<V2d>& points);
    void addPiece(int segment, const std::vector<V2d>& points, long double ta, long double tb);

    std::vector<SlowCurve> curves_;
    std::vector<Piece> pieces_;
};

} // namespace vitrine::test
