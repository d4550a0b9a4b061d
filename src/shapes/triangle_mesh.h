// Triangles with shared vertices.
#pragma once

#include "shapes/facet.h"
#include "shapes/mesh.h"

namespace vitrine {

/// PrimitiveHit::u and v are the barycentric weights of the second and third vertex. Texture coordinates default to
/// (0,0), (1,0), (1,1), as pbrt's. Normals, if given, decide which side is out; tangents turn dpdu, lengths kept.
class TriangleMesh final : public MeshShape {
  public:
    /// \param indices three a face; no face without area
    TriangleMesh(std::shared_ptr<const MeshVertices> vertices, std::vector<std::uint32_t> indices);

    GeometryKind kind() const override { return GeometryKind::Triangles; }
    bool intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const override;
    SurfacePoint pointAt(const Ray& ray, const PrimitiveHit& hit) const override;
    std::size_t memoryBytes() const override;

  protected:
    unsigned verticesPerFace() const override { return 3; }
    void outline(unsigned prim, std::uint32_t corners[4]) const override { std::copy_n(face(prim), 3, corners); }
    double primitiveArea(unsigned prim) const override;
    PrimitiveHit drawPoint(unsigned prim, const V2f& u) const override;
    std::vector<PrimitiveHit> flatCorners(unsigned prim) const override;

  private:
    struct Corners {
        V3d p0, p1, p2;
    };
    Corners corners(const std::uint32_t* v) const { return {corner(v[0]), corner(v[1]), corner(v[2])}; }
    void textureCorners(const std::uint32_t* v, V2f uv[3]) const;
    Facet facet(unsigned prim) const;
    void addShading(const std::uint32_t* v, double b0, double b1, double b2, SurfacePoint& point) const;

    std::vector<Facet> facets_; ///< of small meshes; large ones make them anew at each hit
};

} // namespace vitrine
