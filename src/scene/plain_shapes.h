// Shapes that pbrt-v4 has not, as such that it has.
#pragma once

#include "nodes/nodes.h"

namespace vitrine {

/// A box as a triangle mesh: twelve triangles, each face with its normal and the box's (u, v).
ShapeNode boxAsMesh(const ShapeNode& box);

/// A plane as a disk, which keeps its digits however large it is: about the foot of the middle of what is seen, with ten
/// thousand times its radius, so that the horizon does not sink (by 1/10^4 of the camera's height over that radius). Its
/// (u, v) are the disk's own.
/// \param seen what there is beside planes, cameras and lights included, in the plane's world (or its object
/// definition's space)
ShapeNode planeAsDisk(const ShapeNode& plane, const Box3d& seen);

ShapeNode asPlyMesh(const ShapeNode& shape, const std::string& fileName);

/// pbrt-v4 makes a light of every face of a mesh and gives each the whole "power": what it means for a mesh of this area,
/// by "scale".
Node powerAsScale(const Node& areaLight, double area);

} // namespace vitrine
