// Triangles, planar quads and bilinear patches over one set of vertices.
#pragma once

#include "core/sampling.h"
#include "shapes/shape.h"

#include <mutex>
#include <vector>

namespace vitrine {

/// Shape "trianglemesh": triangles over a list of vertices.
///
/// | name    | type    | unit        | default | meaning |
/// |---------|---------|-------------|---------|---------|
/// | P       | point3  | scene units |         | vertices |
/// | indices | integer |             | 0 1 2   | three vertices a triangle, counted from 0; needed unless there are just three |
/// | N       | normal  |             | none    | shading normals, one a vertex; they also say which side is out |
/// | S       | vector3 |             | none    | shading tangents, one a vertex |
/// | uv      | point2  |             | none    | texture coordinates, one a vertex; else a triangle's are (0,0), (1,0), (1,1) |
///
/// Triangles without area are left out.

/// Shape "bilinearmesh": bilinear patches over a list of vertices; those that are flat are kept as plain quads.
///
/// | name    | type    | unit        | default | meaning |
/// |---------|---------|-------------|---------|---------|
/// | P       | point3  | scene units |         | vertices |
/// | indices | integer |             | 0 1 2 3 | four vertices a patch, (u,v) = 00 10 01 11; needed unless there are just four |
/// | N       | normal  |             | none    | shading normals, one a vertex; they also say which side is out |
/// | uv      | point2  |             | none    | texture coordinates, one a vertex; else the patch's own (u,v) |
///
/// Patches without area are left out.

/// A mesh as scene files give it, in object space.
struct MeshInput {
    std::vector<V3f> p;
    std::vector<V3f> n;                   ///< empty, or one a vertex: shading normals of any length
    std::vector<V3f> s;                   ///< empty, or one a vertex: shading tangents
    std::vector<V2f> uv;                  ///< empty, or one a vertex
    std::vector<std::uint32_t> triangles; ///< 3 a face
    std::vector<std::uint32_t> quads;     ///< 4 a bilinear patch, in pbrt's order: (u,v) = 00 10 01 11
};

/// The shapes that make up a mesh: at most one each of triangles, planar quads and bent patches, in this order. Faces
/// without area are left out. The vertices are taken to world space in double and rounded to float once.
/// \throws std::invalid_argument for counts that do not fit, indices out of range, or values that are not finite
std::vector<ShapePtr> makeMeshShapes(MeshInput input, const Transform& worldFromObject, bool reverseOrientation);

/// World-space vertices, shared by the shapes of a mesh.
struct MeshVertices {
    std::vector<V3f> p; ///< one more than there are: Embree reads 16 bytes at the last vertex
    std::vector<V3f> n; ///< reversed where ReverseOrientation says so
    std::vector<V3f> s;
    std::vector<V2f> uv;
    bool flips = false; ///< the faces' own normals are turned round: reversed or mirrored, but not both

    std::size_t count() const { return p.size() - 1; }
};

/// What the kinds of mesh have in common.
class MeshShape : public Shape {
  public:
    unsigned primitiveCount() const final { return unsigned(indices_.size() / verticesPerFace()); }
    using Shape::bounds;
    Box3d bounds(unsigned prim) const final;
    const float* vertices() const final { return &vertices_->p.front().x; }
    std::size_t vertexCount() const final { return vertices_->count(); }
    const std::uint32_t* indices() const final { return indices_.data(); }

    double area() const final { return areas().total; }
    using Shape::pdf;
    /// 1/area but for the rounding of the probabilities with which primitives are drawn.
    float pdf(const PrimitiveHit& hit) const final { return float(density(drawProbability(hit.prim), hit)); }
    using Shape::sample;
    /// A primitive by its area, then a point of it.
    std::optional<ShapeSample> sample(const V2f& u) const final;
    unsigned partCount() const final { return primitiveCount(); }
    ShapePart part(unsigned part) const final;
    std::optional<ShapeSample> samplePart(unsigned part, const V3d& from, const V2f& u) const final;
    float partPdf(const V3d& from, const PrimitiveHit& hit, const SurfacePoint& point) const final;
    bool isClosed() const final;
    std::size_t memoryBytes() const override;

  protected:
    MeshShape(std::shared_ptr<const MeshVertices> vertices, std::vector<std::uint32_t> indices)
        : vertices_(std::move(vertices)), indices_(std::move(indices)) {}

    virtual unsigned verticesPerFace() const = 0;
    /// Corners in order around the face.
    virtual void outline(unsigned prim, std::uint32_t corners[4]) const = 0;
    virtual double primitiveArea(unsigned prim) const = 0;
    /// A point of a primitive, by area or roughly so.
    virtual PrimitiveHit drawPoint(unsigned prim, const V2f& u) const = 0;
    /// Of drawPoint to give the hit, per area, times the probability that its primitive is drawn.
    virtual double density(double probability, const PrimitiveHit& hit) const {
        return probability / primitiveArea(hit.prim);
    }
    /// Hits at the corners of a flat primitive; empty for bent ones.
    virtual std::vector<PrimitiveHit> flatCorners(unsigned prim) const {
        return (void)prim, std::vector<PrimitiveHit>();
    }

    const MeshVertices& mesh() const { return *vertices_; }
    const std::uint32_t* face(unsigned prim) const { return &indices_[std::size_t(prim) * verticesPerFace()]; }
    V3d corner(std::uint32_t vertex) const { return toDouble(mesh().p[vertex]); }

  private:
    /// Draws a primitive by its area and makes u.x fresh again.
    unsigned drawPrimitive(V2f& u) const;
    /// The probability with which drawPrimitive draws it.
    double drawProbability(unsigned prim) const;
    /// Of a point of a primitive that was drawn with this probability.
    std::optional<ShapeSample> sampleOn(unsigned prim, double probability, const V2f& u) const;

    struct Areas {
        double total = 0;
        AliasTable table; ///< of more than one primitive
    };
    /// Made when first asked for: only lights need them.
    const Areas& areas() const;

    std::shared_ptr<const MeshVertices> vertices_;
    std::vector<std::uint32_t> indices_;
    mutable std::once_flag areasMade_, closedKnown_;
    mutable Areas areas_;
    mutable bool closed_ = false;
};

} // namespace vitrine
