#include "cameras/thin_lens.h"

#include "core/sampling.h"

#include <stdexcept>

namespace vitrine {

void checkLens(double lensRadius, double focalDistance) {
    if (!(lensRadius >= 0) || !std::isfinite(lensRadius))
        throw std::invalid_argument("the lens radius must not be negative");
    if (lensRadius > 0 && (!(focalDistance > 0) || !std::isfinite(focalDistance)))
        throw std::invalid_argument("the focal distance must be positive and finite");
}

ThinLens::ThinLens(const CameraSpace& space, const RasterWindow& unitWindow, double lensRadius, double focalDistance)
    : space_(space), window_(unitWindow), lensRadius_(lensRadius), focalDistance_(focalDistance) {
    checkLens(lensRadius, focalDistance);
    lensArea_ = lensRadius > 0 ? piD * sqr(lensRadius) * space.planeArea() : 1;
}

V3d ThinLens::lensPoint(const V2f& u) const {
    const V2f disk = sampleUniformDisk(u);
    return V3d(disk.x, disk.y, 0) * lensRadius_;
}

CameraRay ThinLens::generate(const CameraSample& sample) const {
    const V2d unit = window_.planeFromRaster(sample.raster);
    const V3d pinhole(unit.x, unit.y, 1);
    if (lensRadius_ == 0) return {space_.toWorld(V3d(0, 0, 0), pinhole), 1};
    const V3d o = lensPoint(sample.lens);
    return {space_.toWorld(o, pinhole * focalDistance_ - o), 1};
}

Camera::Density ThinLens::density(const Ray& ray, const V2f& margin) const {
    const V3d d = space_.directionToCamera(ray.d);
    if (!(d.z > 0)) return {};
    V3d unit = d / d.z;
    if (lensRadius_ > 0) unit = unit + space_.pointToCamera(ray.o) / focalDistance_;
    Camera::Density result;
    result.raster = window_.rasterFromPlane(V2d(unit.x, unit.y));
    if (!window_.contains(result.raster, margin)) return {};
    const double direction = space_.solidAngleRatio(d) / (window_.area() * d.z * d.z * d.z);
    result.position = float(1 / lensArea_);
    result.direction = float(direction);
    result.we = float(direction / (lensArea_ * space_.cosine(ray.d.normalized())));
    return result;
}

std::optional<CameraConnection> ThinLens::connect(const V3d& p, const V2f& u, const V2f& margin) const {
    CameraConnection result;
    result.pLens = space_.pointToWorld(lensPoint(u));
    const V3d toLens = result.pLens - p;
    const double distance2 = toLens.length2();
    if (!(distance2 > 0)) return {};
    const V3d wi = toLens / std::sqrt(distance2);
    const Camera::Density seen = density(Ray{result.pLens, -wi}, margin);
    if (!(seen.we > 0)) return {};
    result.wi = toFloat(wi);
    result.raster = seen.raster;
    result.we = seen.we;
    result.pdf = float(distance2 / (space_.cosine(wi) * lensArea_));
    return result;
}

} // namespace vitrine
