#include "cameras/orthographic.h"

namespace vitrine {

namespace {

constexpr double parallelTolerance = 1e-6;

} // namespace

OrthographicCamera::OrthographicCamera(const Motion& worldFromCamera, const V2i& resolution, const Settings& settings)
    : projection_(project(worldFromCamera, resolution, settings)) {}

std::variant<OrthographicCamera::Parallel, ThinLens>
OrthographicCamera::project(const Motion& worldFromCamera, const V2i& resolution, const Settings& settings) {
    checkLens(settings.lensRadius, settings.focalDistance);
    if (settings.lensRadius == 0) return Parallel{worldFromCamera, RasterWindow(resolution, settings.window, 1)};
    return ThinLens(worldFromCamera, RasterWindow(resolution, settings.window, 1 / settings.focalDistance),
                    settings.lensRadius, settings.focalDistance, settings.aperture);
}

std::optional<CameraRay> OrthographicCamera::generate(const CameraSample& sample) const {
    if (const auto* lens = std::get_if<ThinLens>(&projection_)) return lens->generate(sample);
    const auto& parallel = std::get<Parallel>(projection_);
    const V2d film = parallel.window.planeFromRaster(sample.raster);
    std::optional<CameraSpace> room;
    return CameraRay{parallel.space.at(sample.time, room).toWorld(V3d(film.x, film.y, 0), V3d(0, 0, 1), sample.time),
                     1};
}

Camera::Density OrthographicCamera::Parallel::densityAt(const CameraSpace& at, const V3d& cameraPoint,
                                                        const V2f& margin) const {
    Density result;
    result.raster = window.rasterFromPlane(V2d(cameraPoint.x, cameraPoint.y));
    if (!window.contains(result.raster, margin)) return {};
    const double position = 1 / (window.area() * at.planeArea());
    result.position = float(position);
    result.direction = 1;
    const V3d axis = at.toWorld(V3d(0, 0, 0), V3d(0, 0, 1)).d;
    result.we = float(position / at.cosine(axis));
    return result;
}

Camera::Density OrthographicCamera::density(const Ray& ray) const {
    if (const auto* lens = std::get_if<ThinLens>(&projection_)) return lens->density(ray);
    const auto& parallel = std::get<Parallel>(projection_);
    std::optional<CameraSpace> room;
    const CameraSpace& space = parallel.space.at(ray.time, room);
    const V3d d = space.directionToCamera(ray.d);
    if (!(d.z > 0) || sqr(d.x) + sqr(d.y) > sqr(parallelTolerance)) return {};
    return parallel.densityAt(space, space.pointToCamera(ray.o), V2f(0));
}

std::optional<CameraConnection> OrthographicCamera::connect(const V3d& p, const V2f& u, const V2f& margin,
                                                            double time) const {
    if (const auto* lens = std::get_if<ThinLens>(&projection_)) return lens->connect(p, u, margin, time);
    const auto& parallel = std::get<Parallel>(projection_);
    std::optional<CameraSpace> room;
    const CameraSpace& space = parallel.space.at(time, room);
    const V3d inCamera = space.pointToCamera(p);
    const Density seen = parallel.densityAt(space, inCamera, margin);
    if (!(inCamera.z > 0) || !(seen.we > 0)) return {};
    CameraConnection result;
    result.wi = toFloat(-space.toWorld(V3d(0, 0, 0), V3d(0, 0, 1)).d);
    result.pLens = space.pointToWorld(V3d(inCamera.x, inCamera.y, 0));
    result.raster = seen.raster;
    result.we = seen.we;
    result.pdf = 1;
    return result;
}

V3d OrthographicCamera::position() const {
    if (const auto* lens = std::get_if<ThinLens>(&projection_)) return lens->position();
    return std::get<Parallel>(projection_).space.start().pointToWorld(V3d(0, 0, 0));
}

bool OrthographicCamera::moves() const {
    if (const auto* lens = std::get_if<ThinLens>(&projection_)) return lens->moves();
    return std::get<Parallel>(projection_).space.moves();
}

} // namespace vitrine
