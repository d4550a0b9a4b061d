// Writes meshes in the polygon file format (PLY 1.0; Turk 1994).
#pragma once

#include "shapes/mesh.h"

namespace vitrine {

/// Binary, little-endian. Vertices have x y z, then nx ny nz and s t if the mesh has normals and (u, v); faces are lists
/// "vertex_indices". pbrt-v4, Blender and Mitsuba read these names.
/// \param mesh of triangles alone, without tangents
/// \param comment one line for the header
/// \throws FileError
void writePly(const std::string& path, const MeshInput& mesh, const std::string& comment = {});

} // namespace vitrine
