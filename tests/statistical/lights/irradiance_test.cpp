// Irradiance by sampling lights against closed forms.
#include "lights/constant_infinite_light.h"
#include "lights/image_infinite_light.h"
#include "shapes/cylinder.h"
#include "shapes/disk.h"
#include "shapes/mesh.h"
#include "shapes/sphere.h"
#include "support/chi_squared.h"
#include "support/estimate.h"

namespace vitrine {
namespace {

const SampledWavelengths lambda = SampledWavelengths::visible(0.5f);
const SpectrumPtr one = std::make_shared<ConstantSpectrum>(1.f);

Transform placed(const V3d& p) {
    return Transform(M44d(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, p.x, p.y, p.z, 1));
}

/// E of a surface at p with normal n under radiance 1, nothing in between.
test::Estimate irradiance(const Light& light, const V3d& p, const V3f& n, std::uint64_t seed) {
    RandomStream random(51, seed);
    test::Estimate estimate;
    for (int i = 0; i < 100000; ++i) {
        const auto sample = light.sample(p, V2f(random.uniform(), random.uniform()), lambda);
        estimate.add(sample ? sample->l[0] * std::max(0.f, sample->wi.dot(n)) / sample->pdf : 0);
    }
    return estimate;
}

struct Case {
    std::string name;
    LightPtr light;
    V3d p;
    V3f n;
    double expected;
};

LightPtr area(ShapePtr shape, bool twoSided = false) {
    return std::make_shared<AreaLight>(std::move(shape), one, twoSided);
}

/// Form factor of a parallel rectangle [0, x] x [0, y] at distance z, for a point below its corner (Howell, B-4).
double corner(double x, double y, double z) {
    const double a = x / z, b = y / z;
    return (a / std::sqrt(1 + a * a) * std::atan(b / std::sqrt(1 + a * a)) +
            b / std::sqrt(1 + b * b) * std::atan(a / std::sqrt(1 + b * b))) /
           (2 * piD);
}

ShapePtr rectangle(double z, bool triangles) {
    MeshInput mesh;
    mesh.p = {V3f(-1, -0.5f, 0), V3f(2, -0.5f, 0), V3f(-1, 1.5f, 0), V3f(2, 1.5f, 0)};
    if (triangles)
        mesh.triangles = {0, 3, 1, 0, 2, 3}; // the normal is -z
    else
        mesh.quads = {2, 3, 0, 1};
    return makeMeshShapes(mesh, placed(V3d(0, 0, z)), false).at(0);
}

std::vector<Case> areaCases() {
    const V3f up(0, 0, 1);
    const auto disk = [](double z, bool reversed) {
        return std::make_shared<Disk>(placed(V3d(0, 0, z)), reversed, 0, 1.5, 0, 360);
    };
    const auto sphere = [](const V3d& p, double radius) {
        return std::make_shared<Sphere>(placed(p), false, radius, -radius, radius, 360);
    };
    std::vector<Case> cases;
    for (double z : {0.1, 1., 50.}) {
        // E = pi r^2 / (r^2 + z^2); the disk's normal is +z.
        const double expected = piD * 2.25 / (2.25 + z * z);
        cases.push_back({"disk", area(disk(z, true)), V3d(0), up, expected});
        cases.push_back({"disk of two sides", area(disk(z, false), true), V3d(0), up, expected});
        cases.push_back({"disk's back", area(disk(z, false)), V3d(0), up, 0});
        // From below the point (0, 0) the rectangle is four corners.
        const double rectangleExpected =
            piD * (corner(1, 0.5, z) + corner(2, 0.5, z) + corner(1, 1.5, z) + corner(2, 1.5, z));
        cases.push_back({"rectangle", area(rectangle(z, false)), V3d(0), up, rectangleExpected});
        cases.push_back({"two triangles", area(rectangle(z, true)), V3d(0), up, rectangleExpected});
    }
    for (double distance : {1.05, 2., 100.}) {
        // E = pi (r / d)^2 cos as long as the whole sphere is above the horizon.
        cases.push_back({"sphere", area(sphere(V3d(0, 0, distance), 1)), V3d(0), up, piD / sqr(distance)});
        const double slant = 3 * distance;
        cases.push_back(
            {"sphere aslant", area(sphere(V3d(0.6, 0, 0.8) * slant, 1)), V3d(0), up, 0.8 * piD / sqr(slant)});
    }
    cases.push_back({"inside a sphere", area(sphere(V3d(0, 0.3, 0), 2), true), V3d(0), up, piD});
    const auto tube = std::make_shared<Cylinder>(Transform(), true, 1, 0, 3, 360);
    // Inside a tube, from the middle of its floor: the sky of half angle atan(1/3) is missing.
    cases.push_back({"inside a tube", area(tube), V3d(0), up, piD * (1 - 0.1)});
    return cases;
}

void check(const std::vector<Case>& cases) {
    const double threshold = test::sidakThreshold(0.01, int(cases.size()));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Case& c = cases[i];
        const test::Estimate e = irradiance(*c.light, c.p, c.n, i);
        // Float rounding beside the noise: samplers by solid angle leave none to speak of.
        const double z = (e.mean() - c.expected) / std::sqrt(e.varianceOfMean() + sqr(1e-5 * c.expected) + 1e-30);
        EXPECT_GT(test::normalPValue(z), threshold) << c.name << " " << i << ": " << e.mean() << ", not " << c.expected;
    }
}

TEST(Irradiance, AreaLights) {
    check(areaCases());
}

TEST(Irradiance, Skies) {
    const auto sky = std::make_shared<ConstantInfiniteLight>(one);
    const Image image{8, 8, 3, std::vector<float>(192, 1.f)};
    std::vector<Case> cases{{"constant", sky, V3d(5), V3f(0, 0.6f, 0.8f), piD}};
    const double white = RgbIlluminantSpectrum(RgbColorSpace::srgb(), Rgb(1, 1, 1)).sample(lambda)[0];
    const EnvironmentImage flat(image, RgbColorSpace::srgb(), EnvironmentMapping::EqualArea,
                                EnvironmentLookup::Bilinear);
    cases.push_back({"flat image", std::make_shared<ImageInfiniteLight>(Transform(), flat, 1.f), V3d(0),
                     V3f(0.6f, 0.8f, 0), piD * white});
    check(cases);
}

} // namespace
} // namespace vitrine
