#include "cameras/spherical.h"
#include "core/random.h"
#include "support/look_at.h"

#include <stdexcept>

namespace vitrine {
namespace {

using Mapping = SphericalCamera::Mapping;

void expectNear(const V3d& a, const V3d& b, double tolerance) {
    EXPECT_TRUE(a.equalWithAbsError(b, tolerance)) << a << " is not " << b;
}

V3d direction(const Camera& camera, double x, double y) {
    return camera.generate({V2d(x, y), V2f()})->ray.d;
}

TEST(SphericalCamera, EquirectangularRunsFromXOverZ) {
    const SphericalCamera camera(Transform(), V2i(400, 200), Mapping::Equirectangular);
    expectNear(direction(camera, 0, 100), V3d(1, 0, 0), 1e-15);
    expectNear(direction(camera, 100, 100), V3d(0, 0, 1), 1e-15);
    expectNear(direction(camera, 200, 100), V3d(-1, 0, 0), 1e-15);
    expectNear(direction(camera, 50, 50), V3d(0.5, std::sqrt(0.5), 0.5), 1e-15);
    expectNear(direction(camera, 77, 0), V3d(0, 1, 0), 1e-15);
    // Filters reach over the edges.
    expectNear(direction(camera, -10, 60), direction(camera, 390, 60), 1e-14);
    expectNear(direction(camera, 30, -5), direction(camera, 230, 5), 1e-14);
}

TEST(SphericalCamera, EqualAreaHasYInTheMiddle) {
    const SphericalCamera camera(Transform(), V2i(100, 100), Mapping::EqualArea);
    expectNear(direction(camera, 50, 50), V3d(0, 1, 0), 1e-15);
    expectNear(direction(camera, 100, 50), V3d(1, 0, 0), 1e-15);
    expectNear(direction(camera, 50, 100), V3d(0, 0, 1), 1e-15);
    expectNear(direction(camera, 0, 0), V3d(0, -1, 0), 1e-15);
    expectNear(direction(camera, -1, 20), direction(camera, 1, 80), 1e-14);
}

TEST(SphericalCamera, ConnectFindsTheRasterOfARay) {
    RandomStream random(17);
    for (Mapping mapping : {Mapping::EqualArea, Mapping::Equirectangular}) {
        const SphericalCamera camera(test::lookAt(V3d(5, 6, 7), V3d(0, 1, 0), V3d(0, 1, 0)), V2i(64, 48), mapping);
        for (int i = 0; i < 500; ++i) {
            const V2d raster(random.uniform(0, 64), random.uniform(0, 48));
            const Ray ray = camera.generate({raster, V2f()})->ray;
            expectNear(ray.o, V3d(5, 6, 7), 1e-14);
            const auto connection = camera.connect(ray.at(2), V2f());
            ASSERT_TRUE(connection);
            EXPECT_TRUE(connection->raster.equalWithAbsError(raster, 1e-7)) << connection->raster << raster;
            EXPECT_NEAR(connection->pdf, 4, 1e-5);
            const float we = camera.density(ray).we;
            EXPECT_NEAR(connection->we, we, 1e-5 * we);
        }
    }
}

TEST(SphericalCamera, ThePictureIsRepeatedAroundIt) {
    RandomStream random(19);
    const V2f margin(5, 3);
    for (Mapping mapping : {Mapping::EqualArea, Mapping::Equirectangular}) {
        const V2d size(64, 48);
        const SphericalCamera camera(Transform(), V2i(64, 48), mapping);
        // Each point of the margin must be the repetition of just that point of the picture which looks the same way.
        for (int i = 0; i < 2000; ++i) {
            const V2d beside(random.uniform(-5, 69), random.uniform(-3, 51));
            if (beside.x >= 0 && beside.y >= 0 && beside.x < size.x && beside.y < size.y) continue;
            const Ray ray = camera.generate({beside, V2f()})->ray;
            const V2d inside = camera.connect(ray.at(1), V2f(), margin)->raster;
            int found = 0;
            for (const V2d& repeated : camera.repeated(inside, margin)) {
                expectNear(direction(camera, repeated.x, repeated.y), ray.d, 1e-6);
                EXPECT_TRUE(repeated.x >= -5 && repeated.x < 69 && repeated.y >= -3 && repeated.y < 51) << repeated;
                found += (repeated - beside).length() < 1e-5;
            }
            EXPECT_EQ(found, 1) << beside << " is " << inside;
        }
        EXPECT_TRUE(camera.repeated(V2d(30, 20), margin).empty());
        EXPECT_TRUE(camera.repeated(V2d(1, 1), V2f(0)).empty());
    }
}

TEST(SphericalCamera, DensityIsFiniteAndRasterInsideEverywhere) {
    for (Mapping mapping : {Mapping::EqualArea, Mapping::Equirectangular}) {
        const SphericalCamera camera(Transform(), V2i(1023, 511), mapping);
        for (double x : {-1., -0., 0., 1.})
            for (double y : {-1., -0., 0., 1.})
                for (double z : {-1., -1e-300, -0., 0., 1.}) {
                    if (V3d(x, y, z).length() == 0) continue;
                    const auto density = camera.density(Ray{V3d(0, 0, 0), V3d(x, y, z), infinityD});
                    EXPECT_TRUE(std::isfinite(density.we) && density.we > 0) << V3d(x, y, z);
                    EXPECT_TRUE(density.raster.x >= 0 && density.raster.x < 1023) << density.raster;
                    EXPECT_TRUE(density.raster.y >= 0 && density.raster.y < 511) << density.raster;
                }
    }
}

TEST(SphericalCamera, RefusesAnEmptyPicture) {
    EXPECT_THROW(SphericalCamera(Transform(), V2i(0, 4), Mapping::EqualArea), std::invalid_argument);
}

} // namespace
} // namespace vitrine
