#include "cameras/spherical.h"

#include "cameras/raster_window.h"
#include "core/equal_area.h"

namespace vitrine {

namespace {

/// pbrt's camera space has y up, the maps of the sphere z.
V3d swapYZ(const V3d& v) {
    return V3d(v.x, v.z, v.y);
}

constexpr double oneMinusEpsilon = 1 - 0x1p-53;

} // namespace

SphericalCamera::SphericalCamera(const Motion& worldFromCamera, const V2i& resolution, Mapping mapping)
    : space_(worldFromCamera), resolution_(resolution.x, resolution.y), mapping_(mapping) {
    checkResolution(resolution);
}

V3d SphericalCamera::directionFromSquare(const V2d& uv) const {
    if (mapping_ == Mapping::EqualArea) return equalAreaSquareToSphere(wrapEqualAreaSquare(uv));
    // Filters reach over the picture's edge: past a pole sin theta turns negative, which is the other side's meridian.
    const double theta = piD * uv.y, phi = 2 * piD * uv.x;
    return V3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
}

V2d SphericalCamera::squareFromDirection(const V3d& d) const {
    V2d uv;
    if (mapping_ == Mapping::EqualArea) {
        uv = equalAreaSphereToSquare(d);
    } else {
        const double u = std::atan2(d.y, d.x) / (2 * piD);
        uv = V2d(u < 0 ? u + 1 : u, std::atan2(std::hypot(d.x, d.y), d.z) / piD);
    }
    return V2d(std::min(uv.x, oneMinusEpsilon), std::min(uv.y, oneMinusEpsilon));
}

double SphericalCamera::solidAngleOfSquare(const V3d& d) const {
    if (mapping_ == Mapping::EqualArea) return 4 * piD;
    // The poles themselves, of measure zero, would have infinite density.
    constexpr double smallestSine = 1e-9;
    return 2 * piD * piD * std::max(std::hypot(d.x, d.y), smallestSine);
}

std::optional<CameraRay> SphericalCamera::generate(const CameraSample& sample) const {
    const V3d d = directionFromSquare(sample.raster / resolution_);
    std::optional<CameraSpace> room;
    return CameraRay{space_.at(sample.time, room).toWorld(V3d(0, 0, 0), swapYZ(d), sample.time), 1};
}

Camera::Density SphericalCamera::density(const Ray& ray) const {
    std::optional<CameraSpace> room;
    const CameraSpace& space = space_.at(ray.time, room);
    const V3d d = space.directionToCamera(ray.d), up = swapYZ(d);
    Density result;
    result.raster = squareFromDirection(up) * resolution_;
    result.position = 1;
    result.direction = float(space.solidAngleRatio(d) / solidAngleOfSquare(up));
    result.we = result.direction;
    return result;
}

std::optional<CameraConnection> SphericalCamera::connect(const V3d& p, const V2f&, const V2f&, double time) const {
    CameraConnection result;
    std::optional<CameraSpace> room;
    result.pLens = space_.at(time, room).pointToWorld(V3d(0, 0, 0));
    const V3d toCamera = result.pLens - p;
    const double distance2 = toCamera.length2();
    if (!(distance2 > 0)) return {};
    const V3d wi = toCamera / std::sqrt(distance2);
    const Density seen = density(Ray{result.pLens, -wi, infinityD, time});
    result.wi = toFloat(wi);
    result.raster = seen.raster;
    result.we = seen.we;
    result.pdf = float(distance2);
    return result;
}

std::vector<V2d> SphericalCamera::repeated(const V2d& raster, const V2f& margin) const {
    const V2d lo(margin.x, margin.y), hi = resolution_ - lo;
    if (raster.x >= lo.x && raster.y >= lo.y && raster.x < hi.x && raster.y < hi.y) return {};
    const V2d p = raster / resolution_;
    std::vector<V2d> all;
    if (mapping_ == Mapping::EqualArea) {
        // An edge is crossed back into the picture, mirrored in the edge's middle; two edges, about a corner.
        all = {V2d(-p.x, 1 - p.y), V2d(2 - p.x, 1 - p.y), V2d(1 - p.x, -p.y), V2d(1 - p.x, 2 - p.y)};
        for (const double x : {-1., 1.})
            for (const double y : {-1., 1.})
                all.push_back(p + V2d(x, y));
    } else {
        // Once round; and past the poles, half round.
        for (const double turn : {-1., 1.})
            all.push_back(p + V2d(turn, 0));
        for (const double turn : {-1.5, -0.5, 0.5, 1.5})
            for (const double pole : {0., 2.})
                all.push_back(V2d(p.x + turn, pole - p.y));
    }
    const auto isOff = [&](const V2d& q) {
        const V2d at = q * resolution_;
        return at.x < -lo.x || at.y < -lo.y || at.x >= resolution_.x + lo.x || at.y >= resolution_.y + lo.y;
    };
    std::erase_if(all, isOff);
    for (V2d& q : all)
        q = q * resolution_;
    return all;
}

} // namespace vitrine
