#include "cameras/orthographic.h"
#include "core/random.h"
#include "support/look_at.h"

#include <stdexcept>

namespace vitrine {
namespace {

using test::lookAt;

void expectNear(const V3d& a, const V3d& b, double tolerance) {
    EXPECT_TRUE(a.equalWithAbsError(b, tolerance)) << a << " is not " << b;
}

TEST(OrthographicCamera, RaysAreParallelOverTheScreenWindow) {
    OrthographicCamera::Settings settings;
    settings.window = {-3, 5, -1, 2};
    const OrthographicCamera camera(Transform(), V2i(80, 30), settings);
    for (const auto& [raster, film] : {std::pair{V2d(0, 0), V3d(-3, 2, 0)}, std::pair{V2d(80, 30), V3d(5, -1, 0)},
                                       std::pair{V2d(40, 10), V3d(1, 1, 0)}}) {
        const Ray ray = camera.generate({raster, V2f(0.2f, 0.3f)})->ray;
        expectNear(ray.o, film, 1e-14);
        expectNear(ray.d, V3d(0, 0, 1), 0);
    }
}

TEST(OrthographicCamera, ConnectFindsTheRasterOfARay) {
    OrthographicCamera::Settings settings;
    settings.window = ScreenWindow::ofAspect(0.5);
    const OrthographicCamera camera(lookAt(V3d(1, 2, 3), V3d(0, 0, 0), V3d(0, 1, 0)), V2i(50, 100), settings);
    RandomStream random(3);
    for (int i = 0; i < 200; ++i) {
        const V2d raster(random.uniform(0, 50), random.uniform(0, 100));
        const Ray ray = camera.generate({raster, V2f()})->ray;
        const auto connection = camera.connect(ray.at(random.uniform(0.1, 10)), V2f());
        ASSERT_TRUE(connection);
        EXPECT_TRUE(connection->raster.equalWithAbsError(raster, 1e-9));
        expectNear(connection->pLens, ray.o, 1e-12);
        expectNear(toDouble(connection->wi), -ray.d, 1e-6);
        // The window is 2 x 4.
        EXPECT_FLOAT_EQ(connection->we, 1 / 8.f);
        EXPECT_EQ(connection->pdf, 1);
        const auto density = camera.density(ray);
        EXPECT_FLOAT_EQ(density.position, 1 / 8.f);
        EXPECT_EQ(density.direction, 1);
        EXPECT_TRUE(density.raster.equalWithAbsError(raster, 1e-9));
        EXPECT_EQ(camera.density(Ray{ray.o, ray.d + V3d(0.01, 0, 0), infinityD}).we, 0) << "a slanted ray";
        EXPECT_FALSE(camera.connect(ray.at(-1), V2f())) << "behind the camera";
    }
    EXPECT_FALSE(camera.connect(camera.generate({V2d(-1, 50), V2f()})->ray.at(1), V2f())) << "beside the picture";
    const V2f margin(2, 1);
    for (const auto& [raster, near] : {std::pair{V2d(-1.5, 50), true}, std::pair{V2d(51.5, 50), true},
                                       std::pair{V2d(52.5, 50), false}, std::pair{V2d(20, -1.5), false}}) {
        const auto beside = camera.connect(camera.generate({raster, V2f()})->ray.at(1), V2f(), margin);
        ASSERT_EQ(beside.has_value(), near) << raster;
        if (!near) continue;
        EXPECT_TRUE(beside->raster.equalWithAbsError(raster, 1e-9));
        EXPECT_FLOAT_EQ(beside->we, 1 / 8.f);
    }
}

TEST(OrthographicCamera, ImportanceTimesAreaOfAStretchedFilmIsOne) {
    // A point's contribution is we / pdf per area across the rays; over the whole picture that makes one.
    const Transform stretch(M44d(2, 0, 0, 0, 0, 3, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1));
    const OrthographicCamera camera(stretch, V2i(10, 10), {});
    const auto connection = camera.connect(camera.generate({V2d(3, 4), V2f()})->ray.at(2), V2f());
    ASSERT_TRUE(connection);
    const double filmArea = 4 * 2 * 3, cosine = 1 / std::sqrt(1.25);
    EXPECT_NEAR(connection->we / connection->pdf * filmArea * cosine, 1, 1e-6);
}

TEST(OrthographicCamera, WithALensRaysMeetInThePlaneOfFocusAsInPbrt) {
    OrthographicCamera::Settings settings;
    settings.window = {-2, 2, -1, 1};
    settings.lensRadius = 0.25;
    settings.focalDistance = 5;
    const OrthographicCamera camera(Transform(), V2i(40, 20), settings);
    RandomStream random(5);
    for (int i = 0; i < 200; ++i) {
        const V2d raster(random.uniform(0, 40), random.uniform(0, 20));
        const CameraSample sample{raster, V2f(random.uniform(), random.uniform())};
        const Ray ray = camera.generate(sample)->ray;
        EXPECT_LE(std::hypot(ray.o.x, ray.o.y), 0.25 * (1 + 1e-6));
        EXPECT_EQ(ray.o.z, 0);
        expectNear(ray.at(5 / ray.d.z), V3d(raster.x / 10 - 2, 1 - raster.y / 10, 5), 1e-12);
        const auto connection = camera.connect(ray.at(3), sample.lens);
        ASSERT_TRUE(connection);
        EXPECT_TRUE(connection->raster.equalWithAbsError(raster, 1e-9));
    }
}

TEST(OrthographicCamera, RefusesNonsense) {
    const auto make = [](double radius, double distance, V2i resolution) {
        OrthographicCamera::Settings settings;
        settings.lensRadius = radius;
        settings.focalDistance = distance;
        OrthographicCamera camera(Transform(), resolution, settings);
    };
    EXPECT_NO_THROW(make(0, 0, V2i(1, 1)));
    EXPECT_THROW(make(-1, 1, V2i(1, 1)), std::invalid_argument);
    EXPECT_THROW(make(1, 0, V2i(1, 1)), std::invalid_argument);
    EXPECT_THROW(make(0, 1, V2i(0, 1)), std::invalid_argument);
}

} // namespace
} // namespace vitrine
