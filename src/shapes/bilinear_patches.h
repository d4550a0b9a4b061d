// Bent bilinear patches with shared vertices, solved in double (Reshetov 2019, "Cool patches", Ray Tracing Gems ch. 8).
#pragma once

#include "shapes/mesh.h"

namespace vitrine {

/// PrimitiveHit::u and v are the patch's (u,v).
class BilinearPatches final : public MeshShape {
  public:
    /// \param indices four a patch: (u,v) = 00, 10, 01, 11
    BilinearPatches(std::shared_ptr<const MeshVertices> vertices, std::vector<std::uint32_t> indices)
        : MeshShape(std::move(vertices), std::move(indices)) {}

    bool intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const override;
    SurfacePoint pointAt(const Ray& ray, const PrimitiveHit& hit) const override;

  protected:
    unsigned verticesPerFace() const override { return 4; }
    void outline(unsigned prim, std::uint32_t corners[4]) const override;
    double primitiveArea(unsigned prim) const override;
    /// By area to first order: by the area elements at its corners.
    PrimitiveHit drawPoint(unsigned prim, const V2f& u) const override;
    double density(double probability, const PrimitiveHit& hit) const override;

  private:
    struct Corners {
        V3d p00, p10, p01, p11;
    };
    Corners corners(unsigned prim) const;
};

} // namespace vitrine
