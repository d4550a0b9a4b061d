// A Bezier profile turned about the y axis: exact, no tessellation.
#pragma once

#include "shapes/parameters.h"
#include "shapes/placement.h"
#include "shapes/revolution/arc_length_map.h"
#include "shapes/revolution/area_table.h"
#include "shapes/revolution/root_finder.h"

namespace vitrine {

/// What the texture coordinate v follows along the profile.
enum class VMap { Parameter, ArcLength };

/// Shape "revolution": a Bezier profile turned about the y axis, exact. Not in pbrt-v4.
///
/// | name     | type    | unit        | default              | meaning |
/// |----------|---------|-------------|----------------------|---------|
/// | P        | point2  | scene units |                      | control points (radius, height) of the profile |
/// | degree   | integer |             | number of points - 1 | of every segment, 1 to 60; consecutive segments share end points |
/// | path     | string  |             |                      | in place of P: SVG path data; several strings are read as one |
/// | filename | string  |             |                      | in place of P: an SVG file, perhaps compressed |
/// | id       | string  |             |                      | of the shape in the file, or its label in Inkscape; may be left out when only one is shown |
/// | unit     | string  |             | "user"               | of the file: "user" as its coordinates are written, or by its width, height and viewBox "mm", "cm", "m", "in" |
/// | origin   | point2  | `unit`      | 0 0                  | point of the drawing that becomes radius 0, height 0: the axis goes through it |
/// | axis     | string  |             | "y"                  | direction of the axis in the drawing: "y" upright, "x" lying, with the height to the right |
/// | flipx    | bool    |             | false                | mirrors the drawing left and right of `origin` |
/// | flipy    | bool    |             | true for a file      | mirrors it above and below `origin`: in an SVG file y points down, in `path` it points up |
/// | scale    | float   | scene units | 1                    | length of a unit of the drawing |
/// | phimax   | float   | degrees     | 360                  | extent of the angle about the y axis, phi = atan2(z, x) |
/// | vmap     | string  |             | "parameter"          | v runs with the profile's "parameter" or its "arclength" |
///
/// Control points may have a negative radius as long as the curve has none. (u, v) = (phi / phimax, (segment + t) /
/// segments), or with "arclength" v = the length of the profile from its beginning over its whole length, so that a
/// texture is not stretched where control points lie far apart. The normal is (y', -x') of the profile, turned; that of
/// a closed profile (both ends on the axis, or coinciding) points out of the solid however it was drawn.
///
/// Path data: M L H V Q C S T A Z and lower case, one subpath. An arc becomes cubics (each a segment) within 1e-6 of
/// its radius. In a file: path, line, polyline, polygon, rect, circle, ellipse, with all transformations and view boxes
/// around them; of styles only this matters: nothing hidden is taken without `id`, and one that would move an outline is
/// an error. What lies within 1e-6 of the profile's extent from the axis is put onto it, ends so near to each other are
/// joined, and lines along the axis at the profile's ends are left out. A profile on the other side of the axis is an error; `flipx` mirrors it.
class Revolution final : public Shape {
  public:
    /// \throws std::invalid_argument
    Revolution(const Transform& worldFromObject, bool reverseOrientation, Profile profile, double phiMaxDegrees = 360,
               VMap vmap = VMap::Parameter);

    unsigned primitiveCount() const override { return roots_.groupCount(); }
    Box3d bounds(unsigned prim) const override;
    using Shape::bounds;
    bool intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const override;
    bool occludes(unsigned prim, const Ray& ray, double sMin, double sMax) const override;
    SurfacePoint pointAt(const Ray& ray, const PrimitiveHit& hit) const override;
    /// Every crossing with s in (sMin, sMax), in order.
    std::vector<PrimitiveHit> allHits(const Ray& ray, double sMin, double sMax) const;

    double area() const override { return area_; }
    std::optional<ShapeSample> sample(const V2f& u) const override;
    float pdf(const PrimitiveHit& hit) const override;
    using Shape::pdf;
    using Shape::sample;

    bool isClosed() const override { return profile_.isClosed() && phi_.isFull() && !placement_.flips(); }
    std::size_t memoryBytes() const override;

    /// Why the surface bounds no solid, for a message; empty when it does.
    std::string_view whyOpen() const;

    const Profile& profile() const { return profile_; }
    bool isFullTurn() const { return phi_.isFull(); }
    double phiMaxDegrees() const { return phi_.isFull() ? 360 : degrees(phi_.max()); }
    /// The texture coordinate at a place v of the profile.
    double textureV(double v) const { return arcLength_ ? arcLength_->fraction(v) : v; }

  private:
    struct Angle {
        double cos, sin;
    };
    PrimitiveHit primitiveHit(const Ray& objectRay, const ProfileHit& hit, unsigned prim) const;
    ObjectPoint describe(double u, double v, const Angle& phi) const;
    SurfacePoint toWorld(const ObjectPoint& point) const;
    V2d tangentNear(double v) const;
    Angle angle(double u) const;
    double pdfAt(double v, const V3d& normal) const;
    double integrateArea() const;
    Box3d ringBox(const Ring& ring) const;
    Box3d sectorBox(const Ring& ring) const;

    Profile profile_;
    PhiRange phi_;
    Placement placement_;
    RootFinder roots_;
    AreaTable table_;
    std::optional<ArcLengthMap> arcLength_; ///< when v follows it
    double profileError_;                   ///< bound of a curve point's error, in world units
    double area_;
};

} // namespace vitrine
