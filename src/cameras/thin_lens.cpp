#include "cameras/thin_lens.h"

#include <stdexcept>

namespace vitrine {

void checkLens(double lensRadius, double focalDistance) {
    if (!(lensRadius >= 0) || !std::isfinite(lensRadius))
        throw std::invalid_argument("the lens radius must not be negative");
    if (lensRadius > 0 && (!(focalDistance > 0) || !std::isfinite(focalDistance)))
        throw std::invalid_argument("the focal distance must be positive and finite");
}

ThinLens::ThinLens(const CameraMotion& space, const RasterWindow& unitWindow, double lensRadius, double focalDistance,
                   AperturePtr aperture)
    : space_(space), window_(unitWindow), lensRadius_(lensRadius), focalDistance_(focalDistance),
      aperture_(std::move(aperture)) {
    checkLens(lensRadius, focalDistance);
}

V2d ThinLens::lensPoint(const V2f& u) const {
    if (aperture_) return aperture_->sample(u);
    const V2f disk = sampleUniformDisk(u);
    return V2d(disk.x, disk.y);
}

double ThinLens::inverseDensity(const CameraSpace& space, const V2d& lens) const {
    if (lensRadius_ == 0) return 1;
    return (aperture_ ? aperture_->inverseDensity(lens) : piD) * sqr(lensRadius_) * space.planeArea();
}

CameraRay ThinLens::generate(const CameraSample& sample) const {
    std::optional<CameraSpace> room;
    const CameraSpace& space = space_.at(sample.time, room);
    const V2d unit = window_.planeFromRaster(sample.raster);
    const V3d pinhole(unit.x, unit.y, 1);
    if (lensRadius_ == 0) return {space.toWorld(V3d(0, 0, 0), pinhole, sample.time), 1};
    const V3d o = inCamera(lensPoint(sample.lens));
    return {space.toWorld(o, pinhole * focalDistance_ - o, sample.time), 1};
}

Camera::Density ThinLens::density(const Ray& ray, const V2f& margin) const {
    std::optional<CameraSpace> room;
    const CameraSpace& space = space_.at(ray.time, room);
    V2d lens(0, 0);
    if (aperture_ && lensRadius_ > 0) {
        const V3d o = space.pointToCamera(ray.o) / lensRadius_;
        lens = V2d(o.x, o.y);
    }
    return density(space, ray, inverseDensity(space, lens), margin);
}

Camera::Density ThinLens::density(const CameraSpace& space, const Ray& ray, double inverseDensity,
                                  const V2f& margin) const {
    const V3d d = space.directionToCamera(ray.d);
    if (!(d.z > 0) || !std::isfinite(inverseDensity)) return {};
    V3d unit = d / d.z;
    if (lensRadius_ > 0) unit = unit + space.pointToCamera(ray.o) / focalDistance_;
    Camera::Density result;
    result.raster = window_.rasterFromPlane(V2d(unit.x, unit.y));
    if (!window_.contains(result.raster, margin)) return {};
    const double direction = space.solidAngleRatio(d) / (window_.area() * d.z * d.z * d.z);
    result.position = float(1 / inverseDensity);
    result.direction = float(direction);
    result.we = float(direction / (inverseDensity * space.cosine(ray.d.normalized())));
    return result;
}

std::optional<CameraConnection> ThinLens::connect(const V3d& p, const V2f& u, const V2f& margin, double time) const {
    std::optional<CameraSpace> room;
    const CameraSpace& space = space_.at(time, room);
    const V2d lens = lensPoint(u);
    CameraConnection result;
    result.pLens = space.pointToWorld(inCamera(lens));
    const V3d toLens = result.pLens - p;
    const double distance2 = toLens.length2();
    if (!(distance2 > 0)) return {};
    const V3d wi = toLens / std::sqrt(distance2);
    const double area = inverseDensity(space, lens);
    const Camera::Density seen = density(space, Ray{result.pLens, -wi}, area, margin);
    if (!(seen.we > 0)) return {};
    result.wi = toFloat(wi);
    result.raster = seen.raster;
    result.we = seen.we;
    result.pdf = float(distance2 / (space.cosine(wi) * area));
    return result;
}

} // namespace vitrine
