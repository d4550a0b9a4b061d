// The maps of pbrt-v4's transformation directives, each with an exact or analytic inverse, in the row-vector
// convention.
#pragma once

#include "core/transform.h"

#include <span>

namespace vitrine {

// All throw std::domain_error with a message for the reader of the scene.

Transform translation(const V3d& offset);
Transform scaling(const V3d& factors);
/// About the axis, counterclockwise in a right-handed system; degrees. Quarter turns are exact.
Transform rotation(double angle, const V3d& axis);
/// Camera from world: the camera at `eye` looks along +z at `target`, +y is up, +x to the right (left-handed).
Transform lookAt(const V3d& eye, const V3d& target, const V3d& up);
/// 16 numbers as Transform lists them: the translation last, which is Imath's layout.
Transform fromNumbers(std::span<const double, 16> numbers);
/// `outer` after `inner`, checked for overflow.
Transform compose(const Transform& inner, const Transform& outer);

/// Exact at right angles.
double sinDegrees(double angle);
double cosDegrees(double angle);

} // namespace vitrine
