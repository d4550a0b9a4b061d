// How a point of a surface becomes a point of a texture's plane or space.
#pragma once

#include "core/transform.h"
#include "textures/texture.h"

namespace vitrine {

/// A point of the plane of a 2D texture, and how far the pixel's footprint reaches there.
struct PlanePoint {
    V2d st{0, 0};
    V2d dstdx{0, 0}, dstdy{0, 0};
};

/// Always finite for a finite TexturePoint. An angle changes by at most one turn over a footprint.
class Mapping {
  public:
    virtual ~Mapping() = default;
    virtual PlanePoint map(const TexturePoint& at) const = 0;
};

using MappingPtr = std::shared_ptr<const Mapping>;

/// Mapping "uv": the parameters of the shape's surface, scaled and shifted: s = uscale u + udelta, t = vscale v + vdelta.
/// It is the default; the texture's transformation plays no part.
///
/// | name           | type  | unit | default | meaning |
/// |----------------|-------|------|---------|---------|
/// | uscale, vscale | float | 1    | 1       | how often the texture's unit square repeats along u and v |
/// | udelta, vdelta | float | 1    | 0       | shift   |
class UvMapping final : public Mapping {
  public:
    explicit UvMapping(const V2d& scale = V2d(1, 1), const V2d& delta = V2d(0, 0)) : scale_(scale), delta_(delta) {}
    PlanePoint map(const TexturePoint& at) const override;

  private:
    V2d scale_, delta_;
};

/// A point of the texture's own space, and how far the pixel's footprint reaches there.
struct SpacePoint {
    V3d p{0, 0, 0};
    V3d dpdx{0, 0, 0}, dpdy{0, 0, 0};
};

/// The space that the transformation in front of `Texture` makes: where 3D textures fill it and all mappings but "uv" project.
class TextureSpace {
  public:
    explicit TextureSpace(const Transform& worldFromTexture = {}) : textureFromWorld_(worldFromTexture.inverse()) {}
    SpacePoint map(const TexturePoint& at) const {
        return {textureFromWorld_.point(at.p), textureFromWorld_.vector(toDouble(at.dpdx)),
                textureFromWorld_.vector(toDouble(at.dpdy))};
    }

  private:
    Transform textureFromWorld_;
};

/// Mapping "spherical": seen from the texture's origin. s is the angle from +z, in half turns; t the angle from +x
/// towards +y, in turns, in [0, 1).
class SphericalMapping final : public Mapping {
  public:
    explicit SphericalMapping(const TextureSpace& space) : space_(space) {}
    PlanePoint map(const TexturePoint& at) const override;

  private:
    TextureSpace space_;
};

/// Mapping "cylindrical": about the texture's z axis. s is the angle from -x towards -y, in turns, in [0, 1]; t is z.
class CylindricalMapping final : public Mapping {
  public:
    explicit CylindricalMapping(const TextureSpace& space) : space_(space) {}
    PlanePoint map(const TexturePoint& at) const override;

  private:
    TextureSpace space_;
};

/// Mapping "planar": projected along straight lines: s = p.v1 + udelta and t = p.v2 + vdelta for the point p in the texture's space.
///
/// | name           | type    | unit     | default        | meaning                           |
/// |----------------|---------|----------|----------------|-----------------------------------|
/// | v1, v2         | vector3 | 1/length | (1,0,0), (0,1,0) | how s and t grow with the point |
/// | udelta, vdelta | float   | 1        | 0              | shift                             |
class PlanarMapping final : public Mapping {
  public:
    PlanarMapping(const TextureSpace& space, const V3d& v1, const V3d& v2, const V2d& delta)
        : space_(space), v1_(v1), v2_(v2), delta_(delta) {}
    PlanePoint map(const TexturePoint& at) const override;

  private:
    V2d project(const V3d& v) const { return {v.dot(v1_), v.dot(v2_)}; }

    TextureSpace space_;
    V3d v1_, v2_;
    V2d delta_;
};

/// Mapping "axis" (not in pbrt-v4): stripes across an axis. s = (p.a - offset) / period for the point p in the texture's
/// space and a the axis made a unit vector; t is 1/2 everywhere. Integer s is a border of a "checkerboard" or the edge
/// of an image; the image's middle row gives the colours.
///
/// | name   | type    | unit   | default | meaning                                                    |
/// |--------|---------|--------|---------|------------------------------------------------------------|
/// | axis   | vector3 |        | (0,1,0) | direction across the stripes; its length does not matter   |
/// | period | float   | length | 1       | along the axis over which s grows by 1; negative: the other way round |
/// | offset | float   | length | 0       | where s is 0, along the axis                               |
class AxisMapping final : public Mapping {
  public:
    /// \throws std::invalid_argument for an axis or a period of 0.
    AxisMapping(const TextureSpace& space, const V3d& axis, double period, double offset);
    PlanePoint map(const TexturePoint& at) const override;

  private:
    TextureSpace space_;
    V3d axis_; ///< 1/period long
    double s0_;
};

} // namespace vitrine
