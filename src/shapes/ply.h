// Reads the polygon file format (PLY 1.0; Turk 1994): ASCII and both binary orders, plain or compressed by gzip.
#pragma once

#include "shapes/mesh.h"

namespace vitrine {

/// Shape "plymesh": triangles and bilinear patches from a file.
///
/// | name     | type   | unit | default | meaning |
/// |----------|--------|------|---------|---------|
/// | filename | string |      |         | PLY file, ASCII or binary of either byte order; may be compressed (.ply.gz) |
///
/// The element "vertex": x y z; optionally nx ny nz; optionally u v, s t, texture_u texture_v or texture_s texture_t.
/// The element "face": the list vertex_indices (or vertex_index): triangles, quads (bilinear patches, as in pbrt), and
/// convex polygons of more corners, which become a fan of triangles. Other elements and properties are passed over.
/// Memory grows with what is in the file, not with what its header promises.
/// \throws FileError with the line or byte
MeshInput readPly(const std::string& file);

} // namespace vitrine
