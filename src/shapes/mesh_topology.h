// Whether the faces of a mesh bound a solid.
#pragma once

#include "shapes/mesh.h"

namespace vitrine {

/// Collects faces; vertices at the same place count as one (seams of uv or normals double them).
class MeshTopology {
  public:
    explicit MeshTopology(const MeshVertices& mesh);
    void addFace(const std::uint32_t* corners, unsigned count);
    /// Every edge lies between exactly two faces that run along it in opposite directions, and the normals that the
    /// mesh reports point out of the volume.
    bool isClosedOutward();

  private:
    const MeshVertices* mesh_;
    std::vector<std::uint32_t> welded_; ///< the first vertex at each vertex's place
    std::vector<std::uint64_t> edges_;  ///< start << 32 | end
    double volume_ = 0;                 ///< six times the signed one, positive when reported normals point outwards
};

} // namespace vitrine
