// Every light's samples against the density it claims, by the chi-squared test.
#include "lights/constant_infinite_light.h"
#include "lights/light.h"
#include "shapes/cylinder.h"
#include "shapes/disk.h"
#include "shapes/mesh.h"
#include "shapes/sphere.h"
#include "support/chi_squared.h"

namespace vitrine {
namespace {

const SampledWavelengths lambda = SampledWavelengths::visible(0.5f);
const SpectrumPtr one = std::make_shared<ConstantSpectrum>(1.f);

/// A one-sided light seen from a point, with coordinates in which the seen part of it is the unit square: so that its
/// edges are edges of the test's cells.
struct AreaCase {
    std::string name;
    ShapePtr shape;
    V3d from;
    std::function<V3d(const V2d&)> point;  ///< of the light
    std::function<V2d(const V3d&)> square; ///< inverse
};

const Transform tilt = Transform(M44d(0.8, 0.6, 0, 0, -0.36, 0.48, 0.8, 0, 0.48, -0.64, 0.6, 0, 3, -2, 1, 1));

AreaCase diskCase(const V3d& fromObject, double innerRadius, double phiMax) {
    const double inner2 = innerRadius * innerRadius, sector = radians(phiMax);
    return {"disk", std::make_shared<Disk>(tilt, false, 0, 1, innerRadius, phiMax), tilt.point(fromObject),
            [=](const V2d& s) {
                const double r = std::sqrt(lerp(s.x, inner2, 1.));
                return tilt.point(V3d(r * std::cos(s.y * sector), r * std::sin(s.y * sector), 0));
            },
            [=](const V3d& p) {
                const V3d q = tilt.inverse().point(p);
                const double phi = std::atan2(q.y, q.x);
                return V2d((sqr(q.x) + sqr(q.y) - inner2) / (1 - inner2), (phi < 0 ? phi + 2 * piD : phi) / sector);
            }};
}

AreaCase rectangleCase(const std::string& name, const V3d& fromObject, bool triangles) {
    MeshInput mesh;
    mesh.p = {V3f(-1, -0.5f, 0), V3f(1, -0.5f, 0), V3f(-1, 0.5f, 0), V3f(1, 0.5f, 0)};
    if (triangles)
        mesh.triangles = {0, 1, 3, 0, 3, 2};
    else
        mesh.quads = {0, 1, 2, 3};
    return {name, makeMeshShapes(mesh, tilt, false).at(0), tilt.point(fromObject),
            [](const V2d& s) { return tilt.point(V3d(2 * s.x - 1, s.y - 0.5, 0)); },
            [](const V3d& p) {
                const V3d q = tilt.inverse().point(p);
                return V2d((q.x + 1) / 2, q.y + 0.5);
            }};
}

/// The cap that is seen from (0, 0, distance): uniform in z and phi.
AreaCase sphereCase(double distance) {
    const double zMin = 1 / distance;
    return {"sphere", std::make_shared<Sphere>(tilt, false, 1, -1, 1, 360), tilt.point(V3d(0, 0, distance)),
            [=](const V2d& s) {
                const double z = lerp(s.x, zMin, 1.), r = std::sqrt(1 - z * z), phi = 2 * piD * s.y;
                return tilt.point(V3d(r * std::cos(phi), r * std::sin(phi), z));
            },
            [=](const V3d& p) {
                const V3d q = tilt.inverse().point(p);
                const double phi = std::atan2(q.y, q.x);
                return V2d((q.z - zMin) / (1 - zMin), (phi < 0 ? phi + 2 * piD : phi) / (2 * piD));
            }};
}

/// Seen from (distance, 0, 0.4): the angles about the x axis within acos(1 / distance).
AreaCase cylinderCase(double distance) {
    const double half = std::acos(1 / distance);
    return {"cylinder", std::make_shared<Cylinder>(tilt, false, 1, -1, 2, 360), tilt.point(V3d(distance, 0, 0.4)),
            [=](const V2d& s) {
                const double phi = (2 * s.x - 1) * half;
                return tilt.point(V3d(std::cos(phi), std::sin(phi), 3 * s.y - 1));
            },
            [=](const V3d& p) {
                const V3d q = tilt.inverse().point(p);
                return V2d((std::atan2(q.y, q.x) / half + 1) / 2, (q.z + 1) / 3);
            }};
}

bool hitShape(const Shape& shape, const Ray& ray, PrimitiveHit& hit) {
    bool met = false;
    for (unsigned prim = 0; prim < shape.primitiveCount(); ++prim)
        met |= shape.intersect(prim, ray, 0, met ? hit.s : ray.tMax, hit);
    return met;
}

test::ChiSquaredResult areaTest(const AreaCase& c) {
    const AreaLight light(c.shape, one, false);
    const auto sample = [&](RandomStream& random) -> std::optional<V2f> {
        const auto drawn = light.sample(c.from, V2f(random.uniform(), random.uniform()), lambda);
        if (!drawn) return {};
        // The shadow ray ends at the point, but for the offset off the surface.
        const V2d s = c.square(c.from + drawn->shadow.d);
        return V2f(std::clamp(float(s.x), 0.f, 0.999999f), std::clamp(float(s.y), 0.f, 0.999999f));
    };
    const auto direction = [&](const V2d& s) { return (c.point(s) - c.from).normalized(); };
    const auto pdf = [&](const V2f& s) -> double {
        const double h = 1e-6;
        const V3d du = direction(V2d(s.x + h, s.y)) - direction(V2d(s.x - h, s.y));
        const V3d dv = direction(V2d(s.x, s.y + h)) - direction(V2d(s.x, s.y - h));
        const Ray ray{c.from, direction(V2d(s.x, s.y)), infinityD};
        PrimitiveHit hit;
        if (!hitShape(*c.shape, ray, hit)) return 0;
        const SurfacePoint point = c.shape->pointAt(ray, hit);
        if (light.emitted(point, toFloat(-ray.d), lambda).isBlack()) return 0;
        return light.pdf(c.from, hit, point) * du.cross(dv).length() / (4 * h * h);
    };
    return test::chiSquaredSquare(sample, pdf);
}

TEST(LightDensities, AreaLights) {
    const std::vector<AreaCase> cases{diskCase(V3d(0.3, -0.5, 1.2), 0, 360),
                                      diskCase(V3d(4, 1, 0.7), 0.4, 250),
                                      rectangleCase("rectangle near", V3d(0.2, 0.3, 0.4), false),
                                      rectangleCase("rectangle far", V3d(20, 30, 40), false),
                                      rectangleCase("two triangles", V3d(0.2, -1, 0.6), true),
                                      sphereCase(1.1),
                                      sphereCase(30),
                                      cylinderCase(2)};
    const double threshold = test::sidakThreshold(0.01, int(cases.size()));
    for (const AreaCase& c : cases) {
        const auto result = areaTest(c);
        EXPECT_GT(result.pValue, threshold) << c.name << ": " << result.report;
        EXPECT_GT(result.mass, 0.05) << c.name;
    }
}

TEST(LightDensities, ConstantSky) {
    const ConstantInfiniteLight light(one);
    const auto result = test::chiSquaredSphere(
        [&](RandomStream& random) {
            return std::optional(light.sample(V3d(0), V2f(random.uniform(), random.uniform()), lambda)->wi);
        },
        [&](const V3f& w) { return double(light.pdf(w)); });
    EXPECT_GT(result.pValue, 0.01) << result.report;
    EXPECT_NEAR(result.mass, 1, 1e-5);
}

} // namespace
} // namespace vitrine
