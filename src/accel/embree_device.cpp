#include "accel/embree_device.h"

#include <atomic>
#include <new>
#include <stdexcept>
#include <string>

namespace vitrine::embree {

namespace {

std::atomic<std::ptrdiff_t> bytes{0};

/// Embree reports to the thread that called it; rtcGetDeviceError tells the code, only the callback the words.
thread_local std::string message;

void keepMessage(void*, RTCError, const char* text) {
    message = text ? text : "";
}

bool countBytes(void*, ssize_t change, bool) {
    bytes += change;
    return true;
}

/// Never released: Embree's threads and the process end together.
struct Device {
    // No .embree3 file in the working directory may change the picture, nor may the processor: Embree would take AVX-512
    // where it finds it, which is no quicker here.
#ifdef __AVX2__
    RTCDevice handle = rtcNewDevice("ignore_config_files=1,isa=avx2");
#else
    RTCDevice handle = rtcNewDevice("ignore_config_files=1,isa=sse2");
#endif
    Device() {
        if (!handle) throw std::runtime_error("Embree cannot start on this machine");
        rtcSetDeviceErrorFunction(handle, keepMessage, nullptr);
        rtcSetDeviceMemoryMonitorFunction(handle, countBytes, nullptr);
    }
};

} // namespace

RTCDevice device() {
    static const Device shared;
    return shared.handle;
}

void throwIfFailed() {
    const RTCError error = rtcGetDeviceError(device());
    if (error == RTC_ERROR_NONE) return;
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    throw std::runtime_error("Embree: " + message);
}

std::size_t bytesInUse() {
    return std::size_t(std::max<std::ptrdiff_t>(0, bytes));
}

ScenePtr newScene() {
    ScenePtr scene(rtcNewScene(device()));
    throwIfFailed();
    // Robust: without it rays slip through the edges of closed meshes (tests/statistical/accel/leaks_test.cpp).
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
    return scene;
}

GeometryPtr newGeometry(RTCGeometryType type) {
    GeometryPtr geometry(rtcNewGeometry(device(), type));
    throwIfFailed();
    return geometry;
}

} // namespace vitrine::embree
