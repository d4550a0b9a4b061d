// Every camera's rays against the densities it claims, and its two ways to estimate the same picture.
#include "cameras/orthographic.h"
#include "cameras/perspective.h"
#include "cameras/spherical.h"
#include "core/frame.h"
#include "support/chi_squared.h"
#include "support/estimate.h"
#include "support/look_at.h"

namespace vitrine {
namespace {

Transform tilted() {
    return test::lookAt(V3d(1, 2, -3), V3d(0.3, 0.5, 0.2), V3d(0.1, 1, 0));
}

/// Stretched and sheared: densities need the Jacobians.
Transform skewed() {
    return Transform(M44d(1.5, 0, 0, 0, 0.4, 0.7, 0, 0, 0.2, 0, 1.3, 0, 0, 0, 0, 1)).then(tilted());
}

/// A camera whose rays from one point fill a rectangle of the plane of focus.
struct LensCamera {
    std::string name;
    V2i resolution;
    Transform worldFromCamera;
    ScreenWindow focus; ///< the picture in the plane of focus, in camera space
    double focalDistance;
    std::shared_ptr<const Camera> camera;
};

LensCamera perspective(const std::string& name, const V2i& resolution, const Transform& worldFromCamera, double fov,
                       const ScreenWindow& window, double lensRadius, const AperturePtr& aperture = nullptr) {
    PerspectiveCamera::Settings settings{window, fov, lensRadius, 2.5, aperture};
    const double scale = std::tan(radians(fov) / 2) * settings.focalDistance;
    const ScreenWindow focus{window.xMin * scale, window.xMax * scale, window.yMin * scale, window.yMax * scale};
    return {name,
            resolution,
            worldFromCamera,
            focus,
            settings.focalDistance,
            std::make_shared<PerspectiveCamera>(worldFromCamera, resolution, settings)};
}

const ScreenWindow orthographicWindow{-1, 2, -0.5, 1};

LensCamera orthographicWithLens(const V2i& resolution) {
    const OrthographicCamera::Settings settings{orthographicWindow, 0.3, 1.5};
    return {"orthographic with a lens",
            resolution,
            tilted(),
            orthographicWindow,
            settings.focalDistance,
            std::make_shared<OrthographicCamera>(tilted(), resolution, settings)};
}

/// 3 x 2 texels of very different brightness, one of them black.
AperturePtr mask(double rotation) {
    return std::make_shared<ImageAperture>(Image{3, 2, 1, {0.2f, 1, 0, 3, 0.5f, 0.1f}}, rotation);
}

std::vector<LensCamera> lensCameras() {
    const V2i wide(48, 32), square(32, 32);
    const ScreenWindow unit;
    return {perspective("pinhole", wide, tilted(), 70, ScreenWindow::ofAspect(1.5), 0),
            perspective("shifted window", wide, Transform(), 100, {0.1, 1.2, -0.3, 0.4}, 0),
            perspective("skewed pinhole", square, skewed(), 60, unit, 0),
            perspective("lens", square, tilted(), 60, unit, 0.4),
            perspective("skewed lens", square, skewed(), 60, unit, 0.4),
            perspective("star", square, tilted(), 60, unit, 0.4, PolygonAperture::star(5, 10)),
            perspective("skewed mask", square, skewed(), 60, unit, 0.4, mask(25)),
            orthographicWithLens(wide)};
}

CameraSample randomSample(const V2i& resolution, RandomStream& random) {
    CameraSample sample;
    sample.raster = V2d(random.uniformDouble() * resolution.x, random.uniformDouble() * resolution.y);
    sample.lens = V2f(random.uniform(), random.uniform());
    return sample;
}

/// Directions from the fixed point `lens` of the lens, as points of the picture's rectangle in the plane of focus,
/// where the picture's edges are the cells' edges. The density per area there has a Jacobian by finite differences.
test::ChiSquaredResult directionTest(const LensCamera& c, const V2f& lens) {
    const V3d origin = c.camera->generate({V2d(1, 1), lens})->ray.o;
    const V2d low(c.focus.xMin, c.focus.yMin), size(c.focus.xMax - c.focus.xMin, c.focus.yMax - c.focus.yMin);
    const auto directionTo = [&](const V2d& p) {
        const V3d target(low.x + p.x * size.x, low.y + p.y * size.y, c.focalDistance);
        return (c.worldFromCamera.point(target) - origin).normalized();
    };
    const auto sample = [&](RandomStream& random) -> std::optional<V2f> {
        CameraSample s = randomSample(c.resolution, random);
        s.lens = lens;
        const Ray ray = c.worldFromCamera.inverse().ray(c.camera->generate(s)->ray);
        const V3d focus = ray.at((c.focalDistance - ray.o.z) / ray.d.z);
        const V2d p = (V2d(focus.x, focus.y) - low) / size;
        if (!(p.x > -1e-6 && p.x < 1 + 1e-6 && p.y > -1e-6 && p.y < 1 + 1e-6)) return {};
        return V2f(std::clamp(float(p.x), 0.f, 0.999999f), std::clamp(float(p.y), 0.f, 0.999999f));
    };
    const auto pdf = [&](const V2f& p) {
        const double h = 1e-5;
        const V3d du = directionTo(V2d(p.x + h, p.y)) - directionTo(V2d(p.x - h, p.y));
        const V3d dv = directionTo(V2d(p.x, p.y + h)) - directionTo(V2d(p.x, p.y - h));
        const Ray ray{origin, directionTo(V2d(p.x, p.y)), infinityD};
        return c.camera->density(ray).direction * du.cross(dv).length() / (4 * h * h);
    };
    return test::chiSquaredSquare(sample, pdf);
}

TEST(CameraDensities, DirectionsFromAPointOfTheLens) {
    const auto cameras = lensCameras();
    const std::vector<V2f> lensPoints{V2f(0.5f, 0.5f), V2f(0.93f, 0.2f)};
    const double threshold = test::sidakThreshold(0.01, int(cameras.size() * lensPoints.size()));
    for (const auto& c : cameras)
        for (const V2f& lens : lensPoints) {
            const auto result = directionTest(c, lens);
            EXPECT_GT(result.pValue, threshold) << c.name << ": " << result.report;
            EXPECT_NEAR(result.mass, 1, 1e-4) << c.name;
        }
}

TEST(CameraDensities, NothingBesideThePicture) {
    for (const auto& c : lensCameras()) {
        const V3d origin = c.camera->generate({V2d(1, 1), V2f(0.5f, 0.5f)})->ray.o;
        const auto importance = [&](double x, double y) {
            const V3d target(lerp(x, c.focus.xMin, c.focus.xMax), lerp(y, c.focus.yMin, c.focus.yMax), c.focalDistance);
            return c.camera->density(Ray{origin, c.worldFromCamera.point(target) - origin, infinityD}).we;
        };
        for (double t : {0.001, 0.5, 0.999}) {
            for (double outside : {-0.001, 1.001}) {
                EXPECT_EQ(importance(outside, t), 0) << c.name;
                EXPECT_EQ(importance(t, outside), 0) << c.name;
            }
            EXPECT_GT(importance(t, 0.001), 0) << c.name;
            EXPECT_GT(importance(0.999, t), 0) << c.name;
        }
        const V3d behind = c.worldFromCamera.vector(V3d(0.01, 0.01, -1));
        EXPECT_EQ(c.camera->density(Ray{origin, behind, infinityD}).we, 0) << c.name;
    }
}

struct SphericalCase {
    std::string name;
    V2i resolution;
    std::shared_ptr<const Camera> camera;
};

std::vector<SphericalCase> sphericalCameras() {
    using Mapping = SphericalCamera::Mapping;
    const V2i wide(64, 32), square(32, 32);
    return {{"equal area", square, std::make_shared<SphericalCamera>(tilted(), square, Mapping::EqualArea)},
            {"skewed equal area", square, std::make_shared<SphericalCamera>(skewed(), square, Mapping::EqualArea)},
            {"equirectangular", wide, std::make_shared<SphericalCamera>(tilted(), wide, Mapping::Equirectangular)}};
}

TEST(CameraDensities, DirectionsOfSphericalCameras) {
    const auto cameras = sphericalCameras();
    const double threshold = test::sidakThreshold(0.01, int(cameras.size()));
    for (const auto& c : cameras) {
        const auto result = test::chiSquaredSphere(
            [&](RandomStream& random) {
                return toFloat(c.camera->generate(randomSample(c.resolution, random))->ray.d);
            },
            [&](const V3f& d) {
                return double(c.camera->density(Ray{c.camera->position(), toDouble(d), infinityD}).direction);
            });
        EXPECT_GT(result.pValue, threshold) << c.name << ": " << result.report;
        EXPECT_NEAR(result.mass, 1, 1e-3) << c.name;
    }
}

/// Positions on the lens or on the film, as points of a square that holds them, against the constant density.
TEST(CameraDensities, PositionsOnLensAndFilm) {
    const V2i resolution(30, 20);
    const PerspectiveCamera lens(Transform(), resolution, {ScreenWindow(), 60, 0.4, 2.5});
    const OrthographicCamera film(Transform(), resolution, {orthographicWindow, 0, 1});
    const auto test = [&](const Camera& camera, const V2d& low, const V2d& high, auto contains) {
        const V2d size = high - low;
        return test::chiSquaredSquare(
            [&](RandomStream& random) -> std::optional<V2f> {
                const V3d o = camera.generate(randomSample(resolution, random))->ray.o;
                return V2f(float((o.x - low.x) / size.x), float((o.y - low.y) / size.y));
            },
            [&](const V2f& p) {
                const V3d o(low.x + p.x * size.x, low.y + p.y * size.y, 0);
                return contains(o) ? camera.density(Ray{o, V3d(0, 0, 1), infinityD}).position * size.x * size.y : 0;
            });
    };
    const double threshold = test::sidakThreshold(0.01, 2);
    const auto onLens = test(lens, V2d(-0.4), V2d(0.4), [](const V3d& o) { return std::hypot(o.x, o.y) <= 0.4; });
    EXPECT_GT(onLens.pValue, threshold) << onLens.report;
    EXPECT_NEAR(onLens.mass, 1, 2e-3);
    const auto onFilm = test(film, V2d(-1, -0.5), V2d(2, 1), [](const V3d&) { return true; });
    EXPECT_GT(onFilm.pValue, threshold) << onFilm.report;
    EXPECT_NEAR(onFilm.mass, 1, 1e-3);
}

/// Points of the aperture against its density.
TEST(CameraDensities, PointsOfApertures) {
    const std::vector<std::pair<std::string, AperturePtr>> apertures{
        {"pentagon", PolygonAperture::polygon(5, 0)}, {"turned hexagon", PolygonAperture::polygon(6, 17)},
        {"triangle", PolygonAperture::polygon(3, -40)}, {"star", PolygonAperture::star(5, 0)},
        {"star of seven", PolygonAperture::star(7, 100)}, {"mask", mask(0)}, {"turned mask", mask(33)}};
    const double threshold = test::sidakThreshold(0.01, int(apertures.size()));
    // Turned squares reach to sqrt 2.
    const double reach = 1.5;
    for (const auto& [name, aperture] : apertures) {
        const auto result = test::chiSquaredSquare(
            [&](RandomStream& random) -> std::optional<V2f> {
                const V2d p = aperture->sample(V2f(random.uniform(), random.uniform()));
                return V2f(float((p.x / reach + 1) / 2), float((p.y / reach + 1) / 2));
            },
            [&](const V2f& p) {
                const V2d at((2 * double(p.x) - 1) * reach, (2 * double(p.y) - 1) * reach);
                return 4 * sqr(reach) / aperture->inverseDensity(at);
            });
        EXPECT_GT(result.pValue, threshold) << name << ": " << result.report;
        EXPECT_NEAR(result.mass, 1, 5e-3) << name;
    }
}

/// Some radiance that varies over the sphere of radius `glow` about the origin, which holds the cameras.
constexpr double glow = 50;

double radiance(const V3d& p) {
    return 1 + 0.5 * std::sin(p.x / 7) + 0.4 * std::cos(p.y / 5 + p.z / 9);
}

constexpr int estimateSamples = 200000;

/// The mean of the left half of the picture by camera rays.
test::Estimate byRays(const Camera& camera, const V2i& resolution, std::uint64_t seed) {
    RandomStream random(seed, 1);
    test::Estimate estimate;
    for (int i = 0; i < estimateSamples; ++i) {
        const CameraSample sample = randomSample(resolution, random);
        const auto generated = camera.generate(sample);
        const Ray& ray = generated->ray;
        const double b = ray.o.dot(ray.d), c = ray.o.length2() - sqr(glow);
        const V3d p = ray.at(-b + std::sqrt(b * b - c));
        estimate.add(sample.raster.x < resolution.x / 2. ? generated->weight * radiance(p) : 0);
    }
    return estimate;
}

/// The same by connecting the sphere's points to the camera, as light tracing does. Only points of the cap of the
/// sphere about the camera's axis are drawn.
test::Estimate byPoints(const Camera& camera, const V2i& resolution, double cosMin, std::uint64_t seed) {
    RandomStream random(seed, 2);
    const Frame frame(toFloat(camera.generate({V2d(resolution.x / 2., resolution.y / 2.), V2f(0.5f, 0.5f)})->ray.d));
    const double area = 2 * piD * sqr(glow) * (1 - cosMin);
    test::Estimate estimate;
    for (int i = 0; i < estimateSamples; ++i) {
        const double cosine = 1 - random.uniformDouble() * (1 - cosMin), phi = 2 * piD * random.uniformDouble();
        const double sine = std::sqrt(1 - cosine * cosine);
        const V3d n = (toDouble(frame.s) * (sine * std::cos(phi)) + toDouble(frame.t) * (sine * std::sin(phi)) +
                       toDouble(frame.n) * cosine)
                          .normalized();
        const auto seen = camera.connect(n * glow, V2f(random.uniform(), random.uniform()));
        const bool inHalf = seen && seen->raster.x < resolution.x / 2.;
        estimate.add(inHalf ? seen->we / seen->pdf * std::abs(toDouble(seen->wi).dot(n)) * radiance(n * glow) * area
                            : 0);
    }
    return estimate;
}

/// Agreement needs we, pdf and raster of connect to be right together.
TEST(CameraDensities, ConnectEstimatesTheSamePictureAsGenerate) {
    struct Case {
        std::string name;
        V2i resolution;
        std::shared_ptr<const Camera> camera;
        double cosMin; ///< of the cap of the sphere that fills the picture
    };
    std::vector<Case> cases;
    for (const auto& c : lensCameras())
        cases.push_back({c.name, c.resolution, c.camera, -1});
    for (const auto& c : sphericalCameras())
        cases.push_back({c.name, c.resolution, c.camera, -1});
    const V2i wide(48, 32);
    for (const auto& [name, space] : {std::pair{"orthographic", tilted()}, std::pair{"skewed orthographic", skewed()}})
        cases.push_back(
            {name, wide,
             std::make_shared<OrthographicCamera>(space, wide, OrthographicCamera::Settings{orthographicWindow, 0, 1}),
             0.98});
    const double threshold = test::sidakThreshold(0.01, int(cases.size()));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Case& c = cases[i];
        const test::Estimate rays = byRays(*c.camera, c.resolution, i);
        const test::Estimate points = byPoints(*c.camera, c.resolution, c.cosMin, i);
        const double z = (rays.mean() - points.mean()) / std::sqrt(rays.varianceOfMean() + points.varianceOfMean());
        EXPECT_GT(test::normalPValue(z), threshold)
            << c.name << ": " << rays.mean() << " by rays, " << points.mean() << " by points";
        EXPECT_LT(std::sqrt(points.varianceOfMean()), 0.05 * points.mean()) << c.name << ": too noisy to tell";
    }
}

} // namespace
} // namespace vitrine
