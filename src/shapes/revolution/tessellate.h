// Triangles in place of a turned profile.
#pragma once

#include "shapes/mesh.h"
#include "shapes/revolution/profile_stations.h"

namespace vitrine {

/// The larger of the diameter and the height of the turned profile: relative tolerances are parts of it.
double turnedSize(const Profile& profile);

/// What the tolerance of a mesh must be above: single precision of the vertices, in units of the profile.
double finestTolerance(const Profile& profile);

/// A mesh of which no point is farther than a tolerance from the exact surface, planned before it is made.
///
/// Rings of vertices stand where placeStations() says, each with as many sectors as its radius needs; between rings with
/// different numbers the triangles run in a zip, so there are no T-junctions. Faces are wound so that their normals are
/// those of the exact shape. Every vertex has the exact normal and the shape's (u, v).
///
/// Vertices are doubled, with the same bits for their place, where normals or (u, v) need it: at creases of the profile,
/// along the seam phi = 0, where a closed loop begins, and on the axis (one a triangle: its (u, v) and, on a cone, its normal
/// are those of the middle of the triangle). Welded by place, the mesh of a closed profile is a closed manifold.
class RevolutionTessellation {
  public:
    static constexpr std::uint64_t maxTriangles = (std::uint64_t(1) << 31) - 1; ///< pbrt-v4 counts them as int

    /// \param tolerance in units of the profile, positive
    /// \throws std::invalid_argument for a tolerance that is not positive, that single precision cannot keep (of a profile
    /// too small or too large for it: any), or that needs more than maxTriangles
    RevolutionTessellation(const Profile& profile, double phiMaxDegrees, double tolerance);

    std::uint64_t triangleCount() const { return triangles_; }
    std::uint64_t vertexCount() const { return vertices_; }

    /// In object space.
    MeshInput mesh() const;

  private:
    struct Row;
    void planSectors(double tolerance);
    std::uint32_t sectorsFor(double radius, double tolerance) const;
    std::vector<Row> rows(std::size_t station) const;
    void addRow(const ProfileStation& station, const V2d& tangent, const Row& row, MeshInput& mesh) const;
    void addStrip(const Row& a, const Row& b, MeshInput& mesh) const;

    std::vector<ProfileStation> stations_;
    std::vector<std::uint32_t> sectors_; ///< of each station; of one on the axis: 0
    double phiMax_;                      ///< radians
    bool isFull_, insideOut_;
    std::uint64_t triangles_ = 0, vertices_ = 0;
};

/// The mesh, in object space. \throws as RevolutionTessellation
MeshInput tessellate(const Profile& profile, double phiMaxDegrees, double tolerance);

/// The least tolerance, to a thousandth, that needs no more than so many triangles. \throws std::invalid_argument when even
/// the coarsest mesh has more
double toleranceForTriangles(const Profile& profile, double phiMaxDegrees, std::uint64_t triangles);

} // namespace vitrine
