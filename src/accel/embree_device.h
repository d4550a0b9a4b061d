// Embree's handles as C++ objects, its errors as exceptions.
#pragma once

#include <embree3/rtcore.h>

#include <cstddef>
#include <memory>

namespace vitrine::embree {

/// The one device of the process.
RTCDevice device();

/// Throws what went wrong since the last call on this thread. \throws std::bad_alloc, std::runtime_error
void throwIfFailed();

/// Bytes that Embree holds now, over all scenes of the process.
std::size_t bytesInUse();

struct SceneDeleter {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct GeometryDeleter {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using ScenePtr = std::unique_ptr<RTCSceneTy, SceneDeleter>;
using GeometryPtr = std::unique_ptr<RTCGeometryTy, GeometryDeleter>;

ScenePtr newScene();
GeometryPtr newGeometry(RTCGeometryType type);

} // namespace vitrine::embree
