#include "cameras/perspective.h"
#include "core/random.h"
#include "support/look_at.h"

#include <stdexcept>

namespace vitrine {
namespace {

using test::lookAt;

constexpr double noRaster = std::numeric_limits<double>::quiet_NaN();

V3d direction(const Camera& camera, double x, double y) {
    return camera.generate({V2d(x, y), V2f(0.5f, 0.5f)})->ray.d;
}

void expectNear(const V3d& a, const V3d& b, double tolerance) {
    EXPECT_TRUE(a.equalWithAbsError(b, tolerance)) << a << " is not " << b;
}

TEST(PerspectiveCamera, FovSpansTheNarrowerSide) {
    PerspectiveCamera::Settings settings;
    settings.fov = 90;
    settings.window = ScreenWindow::ofAspect(2);
    const PerspectiveCamera wide(Transform(), V2i(200, 100), settings);
    // tan 45 = 1: up and down by 45 degrees, left and right by atan 2.
    expectNear(direction(wide, 100, 0), V3d(0, 1, 1).normalized(), 1e-15);
    expectNear(direction(wide, 100, 100), V3d(0, -1, 1).normalized(), 1e-15);
    expectNear(direction(wide, 0, 50), V3d(-2, 0, 1).normalized(), 1e-15);
    expectNear(direction(wide, 200, 50), V3d(2, 0, 1).normalized(), 1e-15);
    expectNear(direction(wide, 100, 50), V3d(0, 0, 1), 1e-15);

    settings.fov = 60;
    settings.window = ScreenWindow::ofAspect(0.5);
    const PerspectiveCamera high(Transform(), V2i(100, 200), settings);
    const double t = 1 / std::sqrt(3.);
    expectNear(direction(high, 100, 100), V3d(t, 0, 1).normalized(), 1e-15);
    expectNear(direction(high, 50, 0), V3d(0, 2 * t, 1).normalized(), 1e-15);
}

TEST(PerspectiveCamera, ScreenWindowCutsAndShifts) {
    PerspectiveCamera::Settings settings;
    settings.fov = 90;
    settings.window = {0.25, 0.75, -0.5, 0.1};
    const PerspectiveCamera camera(Transform(), V2i(64, 32), settings);
    expectNear(direction(camera, 0, 0), V3d(0.25, 0.1, 1).normalized(), 1e-15);
    expectNear(direction(camera, 64, 32), V3d(0.75, -0.5, 1).normalized(), 1e-15);
    expectNear(direction(camera, 32, 16), V3d(0.5, -0.2, 1).normalized(), 1e-15);
}

TEST(PerspectiveCamera, LookAtPutsXToTheRightAndUpUp) {
    // From +z towards the origin: the world's +x lies to the right as pbrt draws it only because its camera space is
    // left-handed: x = up cross forward = y cross -z = -x.
    const PerspectiveCamera camera(lookAt(V3d(0, 0, 5), V3d(0, 0, 0), V3d(0, 1, 0)), V2i(100, 100), {});
    const auto raster = [&](const V3d& p) {
        const auto c = camera.connect(p, V2f(0.5f, 0.5f));
        return c ? c->raster : V2d(noRaster);
    };
    EXPECT_GT(raster(V3d(-1, 0, 0)).x, 50);
    EXPECT_LT(raster(V3d(1, 0, 0)).x, 50);
    EXPECT_LT(raster(V3d(0, 1, 0)).y, 50);
    EXPECT_NEAR(raster(V3d(-1, 0, 0)).x, 60, 1e-9);
    EXPECT_NEAR(raster(V3d(0, 1, 0)).y, 40, 1e-9);
    EXPECT_TRUE(std::isnan(raster(V3d(0, 0, 6)).x)) << "behind the camera";
    EXPECT_TRUE(std::isnan(raster(V3d(6, 0, 0)).x)) << "beside the picture";

    // pbrt's usual `Scale -1 1 1` before LookAt mirrors the picture.
    const Transform mirror(M44d(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1));
    const PerspectiveCamera mirrored(mirror.then(lookAt(V3d(0, 0, 5), V3d(0, 0, 0), V3d(0, 1, 0))), V2i(100, 100), {});
    EXPECT_NEAR(mirrored.connect(V3d(1, 0, 0), V2f(0, 0))->raster.x, 60, 1e-9);
}

TEST(PerspectiveCamera, RaysOfARasterPointMeetInThePlaneOfFocus) {
    PerspectiveCamera::Settings settings;
    settings.fov = 50;
    settings.lensRadius = 0.3;
    settings.focalDistance = 4;
    const Transform worldFromCamera = lookAt(V3d(1, 2, 3), V3d(4, -1, 0), V3d(0, 1, 0));
    const PerspectiveCamera camera(worldFromCamera, V2i(40, 40), settings);
    settings.lensRadius = 0;
    const PerspectiveCamera pinhole(worldFromCamera, V2i(40, 40), settings);
    const V3d axis = worldFromCamera.vector(V3d(0, 0, 1)), centre = worldFromCamera.point(V3d(0, 0, 0));
    RandomStream random(7);
    double largest = 0;
    for (int i = 0; i < 50; ++i) {
        const V2d raster(random.uniform(0, 40), random.uniform(0, 40));
        const Ray sharp = pinhole.generate({raster, V2f()})->ray;
        const V3d focus = sharp.at(4 / sharp.d.dot(axis));
        for (int j = 0; j < 20; ++j) {
            const Ray ray = camera.generate({raster, V2f(random.uniform(), random.uniform())})->ray;
            EXPECT_NEAR(ray.d.length(), 1, 1e-14);
            EXPECT_NEAR((ray.o - centre).dot(axis), 0, 1e-12) << "starts in the lens's plane";
            largest = std::max(largest, (ray.o - centre).length());
            expectNear(ray.at((focus - ray.o).dot(axis) / ray.d.dot(axis)), focus, 1e-12);
        }
    }
    EXPECT_LE(largest, 0.3 * (1 + 1e-6));
    EXPECT_GT(largest, 0.29);
}

TEST(PerspectiveCamera, ConnectsWithinAMargin) {
    for (const double lens : {0., 0.1}) {
        PerspectiveCamera::Settings settings;
        settings.lensRadius = lens;
        settings.focalDistance = 3;
        const PerspectiveCamera camera(Transform(), V2i(20, 20), settings);
        const V2f margin(2, 1), middle(0.5f, 0.5f);
        for (const auto& [raster, near] : {std::pair{V2d(-1.5, 10), true}, std::pair{V2d(21.5, -0.5), true},
                                           std::pair{V2d(-2.5, 10), false}, std::pair{V2d(10, 21.5), false}}) {
            const Ray ray = camera.generate({raster, middle})->ray;
            EXPECT_FALSE(camera.connect(ray.at(2), middle)) << raster;
            const auto connection = camera.connect(ray.at(2), middle, margin);
            ASSERT_EQ(connection.has_value(), near) << raster;
            if (!near) continue;
            EXPECT_TRUE(connection->raster.equalWithAbsError(raster, 1e-9));
            // The importance goes on as it is in the picture: A = 4 at z = 1.
            const double lensArea = lens > 0 ? piD * lens * lens : 1;
            EXPECT_NEAR(connection->we, 1 / (4 * lensArea * std::pow(ray.d.z, 4)), 1e-5 / lensArea);
        }
    }
}

TEST(PerspectiveCamera, PinholeImportanceByHand) {
    // fov 90, square: A = 4 at z = 1. On the axis: pdf 1/4, We 1/4; at 45 degrees cos = 1/sqrt 2.
    const PerspectiveCamera camera(Transform(), V2i(10, 10), {});
    const auto axis = camera.density(Ray{V3d(0, 0, 0), V3d(0, 0, 2), infinityD});
    EXPECT_FLOAT_EQ(axis.position, 1);
    EXPECT_FLOAT_EQ(axis.direction, 0.25f);
    EXPECT_FLOAT_EQ(axis.we, 0.25f);
    const auto side = camera.density(Ray{V3d(0, 0, 0), V3d(0.999999, 0, 1), infinityD});
    EXPECT_NEAR(side.direction, std::pow(2, 1.5) / 4, 1e-5);
    EXPECT_NEAR(side.we, 1, 1e-5);
    const auto connection = camera.connect(V3d(0.5, 0, 2), V2f(0.1f, 0.9f));
    const double cosine = 2 / std::sqrt(4.25);
    ASSERT_TRUE(connection);
    EXPECT_NEAR(connection->pdf, 4.25 / cosine, 1e-5);
    EXPECT_NEAR(connection->we, 1 / (4 * std::pow(cosine, 4)), 1e-6);
}

TEST(PerspectiveCamera, ConnectFindsTheRasterOfARay) {
    RandomStream random(11);
    PerspectiveCamera::Settings settings;
    settings.fov = 35;
    settings.window = ScreenWindow::ofAspect(1.5);
    settings.focalDistance = 3;
    const Transform stretched = Transform(M44d(1.2, 0, 0, 0, 0.3, 0.8, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1))
                                    .then(lookAt(V3d(9, 8, 7), V3d(0), V3d(0, 1, 0)));
    for (const Transform& worldFromCamera : {lookAt(V3d(1e3, 2, 3), V3d(4, 5, 6), V3d(0, 1, 0)), stretched})
        for (double radius : {0., 0.2}) {
            settings.lensRadius = radius;
            const PerspectiveCamera camera(worldFromCamera, V2i(300, 200), settings);
            for (int i = 0; i < 500; ++i) {
                const CameraSample sample{V2d(random.uniform(0, 300), random.uniform(0, 200)),
                                          V2f(random.uniform(), random.uniform())};
                const Ray ray = camera.generate(sample)->ray;
                const V3d p = ray.at(random.uniform(0.1, 20));
                const auto connection = camera.connect(p, sample.lens);
                ASSERT_TRUE(connection);
                EXPECT_TRUE(connection->raster.equalWithAbsError(sample.raster, 1e-6)) << connection->raster;
                expectNear(connection->pLens, ray.o, 1e-9);
                expectNear(toDouble(connection->wi), -ray.d, 1e-6);
                const auto density = camera.density(ray);
                EXPECT_TRUE(density.raster.equalWithAbsError(sample.raster, 1e-6));
                EXPECT_NEAR(density.we, connection->we, 1e-5 * density.we);
            }
        }
}

TEST(PerspectiveCamera, RefusesNonsense) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto make = [](auto change, V2i resolution = V2i(10, 10)) {
        PerspectiveCamera::Settings settings;
        change(settings);
        PerspectiveCamera camera(Transform(), resolution, settings);
    };
    EXPECT_NO_THROW(make([](auto&) {}));
    for (double fov : {0., -10., 180., 200., nan, infinityD})
        EXPECT_THROW(make([=](auto& s) { s.fov = fov; }), std::invalid_argument) << fov;
    for (double radius : {-0.1, nan, infinityD})
        EXPECT_THROW(make([=](auto& s) { s.lensRadius = radius; }), std::invalid_argument) << radius;
    for (double distance : {0., -1., nan, infinityD}) {
        EXPECT_THROW(make([=](auto& s) { s.lensRadius = 1, s.focalDistance = distance; }), std::invalid_argument);
        EXPECT_NO_THROW(make([=](auto& s) { s.focalDistance = distance; })) << "a pinhole has no focus";
    }
    for (const ScreenWindow& window : {ScreenWindow{1, 1, -1, 1}, ScreenWindow{-1, 1, 2, 2},
                                       ScreenWindow{nan, 1, -1, 1}, ScreenWindow{-1, infinityD, -1, 1}})
        EXPECT_THROW(make([=](auto& s) { s.window = window; }), std::invalid_argument);
    for (const V2i& resolution : {V2i(0, 10), V2i(10, -1)})
        EXPECT_THROW(make([](auto&) {}, resolution), std::invalid_argument);
    for (double aspect : {0., -1., nan, infinityD})
        EXPECT_THROW(ScreenWindow::ofAspect(aspect), std::invalid_argument);
}

} // namespace
} // namespace vitrine
