// The shape of a lens's opening.
#pragma once

#include "core/image.h"
#include "core/sampling.h"

#include <memory>

namespace vitrine {

/// How much light passes each point of a lens, as a density over it: as a whole every aperture lets as much light through
/// as the full circle, so that the picture's brightness does not change with it. Points are in units of the lens radius,
/// x to the right and y up in camera space.
class Aperture {
  public:
    virtual ~Aperture() = default;
    /// A point with the aperture's density.
    virtual V2d sample(const V2f& u) const = 0;
    /// One over the density at a point, per area; infinite where nothing passes. Of an even opening its area.
    virtual double inverseDensity(const V2d& p) const = 0;
};

using AperturePtr = std::shared_ptr<const Aperture>;

/// The even opening between blades: a regular polygon or star with corners on the lens's circle.
class PolygonAperture final : public Aperture {
  public:
    /// \param rotation counterclockwise in the picture's sense of x and y, degrees; at 0 a corner is up
    /// \throws std::invalid_argument for fewer than 3 corners, or not finite
    static std::shared_ptr<PolygonAperture> polygon(int corners, double rotation);
    /// Its edges run from each point to the next but one.
    /// \throws std::invalid_argument for fewer than 5 points
    static std::shared_ptr<PolygonAperture> star(int points, double rotation);

    V2d sample(const V2f& u) const override;
    double inverseDensity(const V2d& p) const override;

  private:
    PolygonAperture(int corners, double innerRadius, double rotation);

    std::vector<V2d> corners_; ///< counterclockwise; with the centre each pair of neighbours spans the same area
    double area_;
};

/// A mask: brightness over the square round the lens's circle, chosen by importance.
class ImageAperture final : public Aperture {
  public:
    /// \param image its channels are averaged; row 0 is up  \param rotation as of polygons
    /// \throws std::invalid_argument for values that are negative or not finite, and when all are 0
    ImageAperture(const Image& image, double rotation);

    V2d sample(const V2f& u) const override;
    double inverseDensity(const V2d& p) const override;

  private:
    PiecewiseConstant2D mask_; ///< v runs down
    double cosine_, sine_;
};

} // namespace vitrine
