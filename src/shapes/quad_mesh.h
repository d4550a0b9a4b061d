// Planar convex quads with shared vertices: the flat ones among bilinear patches.
#pragma once

#include "shapes/facet.h"
#include "shapes/mesh.h"
#include "shapes/spherical_rectangle.h"

namespace vitrine {

/// PrimitiveHit::u and v are Embree's: of the two triangles 0 1 3 and 2 3 1, the second counted from the far corner.
/// uv and derivatives are the bilinear patch's; its (u,v) are 00, 10, 11, 01 at the corners 0 to 3.
class QuadMesh final : public MeshShape {
  public:
    /// \param indices four a face, in order around it; only faces for which isPlanarQuad holds
    QuadMesh(std::shared_ptr<const MeshVertices> vertices, std::vector<std::uint32_t> indices);

    GeometryKind kind() const override { return GeometryKind::Quads; }
    bool intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const override;
    bool solve(unsigned prim, const Ray& ray, PrimitiveHit& hit) const override;
    SurfacePoint pointAt(const Ray& ray, const PrimitiveHit& hit) const override;
    using MeshShape::sample;
    /// A single rectangle that is near is sampled by its solid angle (Urena, Fajardo & King 2013). Seen from afar all its
    /// points are about alike, and sampling by area is several times quicker.
    std::optional<ShapeSample> sample(const V3d& from, const V2f& u) const override;
    using MeshShape::pdf;
    float pdf(const V3d& from, const PrimitiveHit& hit, const SurfacePoint& point) const override;
    std::size_t memoryBytes() const override;

  protected:
    unsigned verticesPerFace() const override { return 4; }
    void outline(unsigned prim, std::uint32_t corners[4]) const override { std::copy_n(face(prim), 4, corners); }
    double primitiveArea(unsigned prim) const override;
    PrimitiveHit drawPoint(unsigned prim, const V2f& u) const override;
    std::vector<PrimitiveHit> flatCorners(unsigned prim) const override;

  private:
    struct Corners {
        V3d p[4];
    };
    /// What there is to know of a quad before a ray comes.
    struct QuadFacet {
        /// What its points have in common: the normals, the part of the error that is the quad's own, and of a
        /// parallelogram without texture coordinates the derivatives.
        SurfacePoint common;
        bool isParallelogram = false; ///< then Embree's (u,v) are the patch's
        Parallelogram plane;
        V3d eu{0, 0, 0}, ev{0, 0, 0}; ///< the edges at plane.p0

        /// Of a parallelogram without texture coordinates and shading normals.
        void fill(double u, double v, SurfacePoint& point) const {
            point = common;
            point.p = plane.p0 + eu * u + ev * v;
            point.error += originError(point.p);
            point.uv = V2f(float(u), float(v));
        }
    };
    bool intersectTriangles(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const;
    bool isReadyParallelogram(unsigned prim) const { return !facets_.empty() && facets_[prim].isParallelogram; }
    /// The common case: a ready facet without texture coordinates or shading normals of its own.
    bool isPlainParallelogram(unsigned prim) const;
    Corners corners(unsigned prim) const;
    QuadFacet facet(unsigned prim) const;
    /// The patch's (u,v) of a point of the quad.
    V2d patchParameters(const Corners& c, const V3d& p) const;
    void addTexture(const std::uint32_t* v, const V2d& at, const Corners& c, SurfacePoint& point) const;
    /// Empty unless the mesh is one rectangle that is near to `from`.
    std::optional<SphericalRectangle> seenRectangle(const V3d& from) const;

    std::vector<QuadFacet> facets_; ///< of small meshes; large ones make them anew at each hit
    // Of a mesh that is one rectangle without shading normals; else the distance is zero.
    V3d center_{0, 0, 0};
    double nearDistance2_ = 0, rectanglePdf_ = 0;
};

/// Whether four corners, in order around the quad, lie in a plane as far as rounding them to float allows, and span a
/// convex quad with area (which may have shrunk to a triangle).
bool isPlanarQuad(const V3d& p0, const V3d& p1, const V3d& p2, const V3d& p3);

} // namespace vitrine
