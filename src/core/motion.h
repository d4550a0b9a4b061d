// Affine maps that change while the shutter is open.
#pragma once

#include "core/transform.h"

#include <memory>

namespace vitrine {

/// The times between which a picture is exposed (seconds).
struct Shutter {
    double open = 0, close = 1;

    double at(double u) const { return open + (close - open) * u; }
};

/// A map that goes from one pose to another. Between them translation, rotation and stretch go by themselves: the linear
/// part is split into a rotation and a symmetric stretch (Shoemake & Duff 1992, "Matrix animation and polar
/// decomposition"); translation and stretch change linearly, the rotation at constant speed on the shorter way. Before the
/// first time and after the last the poses stay as they are.
class Motion {
  public:
    /// Stands still.
    Motion(const Transform& still = Transform()) : start_(still), end_(still) {}
    /// \throws std::domain_error if one pose mirrors and the other does not: between them it would be flat
    Motion(const Transform& start, double startTime, const Transform& end, double endTime);
    /// From the start pose to that of a time.
    Motion sinceStart() const;

    bool moves() const { return path_ != nullptr; }
    const Transform& start() const { return start_; }
    Transform at(double time) const;
    /// Holds the images of all points of the box over the times; a little larger where the map rotates.
    Box3d sweep(const Box3d& box, const Shutter& times) const;

  private:
    /// Both poses in parts, row vectors: linear part = stretch, then rotation.
    struct Path;
    double fraction(double time) const;
    Transform between(double u) const;

    Transform start_, end_;
    double startTime_ = 0, endTime_ = 1;
    std::shared_ptr<const Path> path_; ///< null: stands still
};

} // namespace vitrine
