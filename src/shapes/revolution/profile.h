// The profile of a surface of revolution: consecutive Bezier curves in the half-plane (radius x >= 0, height y).
#pragma once

#include "shapes/revolution/bezier_curve.h"

#include <span>
#include <stdexcept>
#include <vector>

namespace vitrine {

/// A stretch of one segment over which x(t) and y(t) are monotone and the curve is not far from its chord.
struct ProfilePart {
    BezierCurve curve; ///< neighbours share their end points bit for bit
    int segment;
    double v0, v1; ///< where it lies in the profile's parameter, (segment + t)/segments
};

/// Where a profile crosses the axis.
class NegativeRadius : public std::invalid_argument {
  public:
    NegativeRadius(std::size_t segmentIndex, double parameter, double radius);
    std::size_t segment;
    double t; ///< of the segment
};

class Profile {
  public:
    /// \param degree of every segment; the segments share end points, so there are 1 + degree * segments points.
    /// \throws std::invalid_argument for a wrong number of points, a degree outside 1..60; NegativeRadius for x(t) < 0
    /// somewhere. Control points may be negative.
    Profile(std::span<const V2d> points, int degree);
    /// Segments of any degrees; each must begin where the one before ends.
    explicit Profile(std::vector<BezierCurve> segments);

    const std::vector<BezierCurve>& segments() const { return segments_; }
    const std::vector<ProfilePart>& parts() const { return parts_; }

    /// Whether the turned profile bounds a solid: both ends lie on the axis, or they coincide. One end on the axis, the
    /// other off it (a vase without thickness, a bowl) is open.
    bool isClosed() const { return closed_; }
    /// For a closed profile, whether (y', -x') points into the solid: decided by the signed area in the half-plane.
    /// A profile that crosses itself is judged by the larger loops. False for an open profile.
    bool drawnInsideOut() const { return insideOut_; }

    /// Largest absolute coordinate of a control point: the size errors are measured by.
    double size() const { return size_; }
    /// Position and derivatives by v in [0,1], the parameter of the whole profile.
    CurvePoint evaluate(double v) const;
    /// The part that holds v.
    std::size_t partAt(double v) const;

  private:
    void prepare();
    void snapEnds();
    void checkRadius() const;
    void divide();

    std::vector<BezierCurve> segments_;
    std::vector<ProfilePart> parts_;
    double size_ = 0;
    bool closed_ = false, insideOut_ = false;
};

} // namespace vitrine
