// Properties of turned surfaces that hold for every ray and point: parity, no self-hits, sampling by area.
#include "shapes/revolution/revolution.h"
#include "support/chi_squared.h"
#include "support/revolution_cases.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using namespace test;

V3d unitVector(RandomStream& random) {
    const double z = random.uniform(-1, 1), phi = random.uniform(0, 2 * piD), r = std::sqrt(1 - z * z);
    return V3d(r * std::cos(phi), r * std::sin(phi), z);
}

std::vector<V2d> closedProfile(RandomStream& random, int degree) {
    ProfilePoints points = randomProfile(random, degree);
    std::vector<V2d> all = joined(points);
    all.front().x = all.back().x = 0;
    return all;
}

/// The first crossing over all primitives.
bool first(const Revolution& shape, const Ray& ray, PrimitiveHit& best) {
    best = PrimitiveHit{};
    PrimitiveHit hit;
    for (unsigned prim = 0; prim < shape.primitiveCount(); ++prim)
        if (shape.intersect(prim, ray, 0, best.s, hit)) best = hit;
    return best.s < infinityD;
}

TEST(RevolutionSurface, ALineCrossesASolidAnEvenNumberOfTimes) {
    long pairs = 0, crossings = 0;
    for (int i = 0; i < 60; ++i) {
        RandomStream random(31, i);
        const int degree = 1 + i % 20;
        const std::vector<V2d> points = i == 0 ? joined(gobletProfile()) : closedProfile(random, degree);
        ProfilePoints segments{points};
        try {
            const Revolution shape(Transform(), false, Profile(points, i == 0 ? 3 : degree));
            ASSERT_TRUE(shape.isClosed());
            for (int k = 0; k < 9000; ++k) {
                const Ray ray = randomRay(random, RayKind(k % rayKinds), segments);
                const std::size_t count = shape.allHits(ray, -infinityD, infinityD).size();
                EXPECT_EQ(count % 2, 0u) << ray.o << " " << ray.d << " degree " << degree;
                ++pairs;
                crossings += long(count);
            }
        } catch (const std::invalid_argument&) {
            continue; // pulling the ends to the axis made the radius negative
        }
    }
    EXPECT_GT(pairs, 300000);
    EXPECT_GT(crossings, pairs / 2);
}

/// Paths of random directions from hits: inside and outside must alternate as the directions say.
TEST(RevolutionSurface, PathsNeverLeakAtAnyDistanceFromTheOrigin) {
    const std::vector<V2d> goblet = joined(gobletProfile());
    for (const double distance : {1e-3, 1., 1e2, 1e5}) {
        RandomStream random(32, std::uint64_t(distance * 1e3));
        M44d matrix;
        matrix.rotate(V3d(0.4, -0.3, 0.2));
        matrix.translate(V3d(0.6, -0.48, 0.64) * distance);
        const Revolution shape(Transform(matrix), false, Profile(goblet, 3));
        long bounces = 0, wrongSide = 0, lost = 0, grazing = 0;
        for (int path = 0; path < 4000; ++path) {
            const V3d target = Transform(matrix).point(V3d(random.uniform(-0.3, 0.3), random.uniform(0, 1.3), 0));
            Ray ray;
            ray.d = unitVector(random);
            ray.o = target - ray.d * 5.;
            bool inside = false;
            PrimitiveHit hit;
            for (int bounce = 0; bounce < 20; ++bounce) {
                if (!first(shape, ray, hit)) {
                    lost += inside;
                    break;
                }
                ++bounces;
                const SurfacePoint point = shape.pointAt(ray, hit);
                EXPECT_LT((point.p - ray.at(hit.s)).length(), 1e-12 * (1 + distance));
                EXPECT_GT(point.error, 0);
                EXPECT_LT(point.error, 1e-12 * (1 + distance));
                const double cosine = toDouble(point.ng).dot(ray.d);
                // A normal in single precision cannot tell sides closer to the tangent plane than this.
                if (std::abs(cosine) < 1e-5) {
                    ++grazing;
                    break;
                }
                wrongSide += (cosine > 0) != inside;
                const V3d w = unitVector(random);
                const double out = toDouble(point.ng).dot(w);
                if (std::abs(out) < 1e-5) {
                    ++grazing;
                    break;
                }
                inside = out < 0;
                ray = Ray{offsetOrigin(point, toFloat(w)), w};
            }
        }
        EXPECT_EQ(wrongSide, 0) << "at " << distance;
        EXPECT_EQ(lost, 0) << "at " << distance;
        EXPECT_GT(bounces, 6000);
        EXPECT_LT(grazing, bounces / 1000);
    }
}

/// A ray that leaves a convex solid outwards never meets it again; an inward one leaves it exactly once.
TEST(RevolutionSurface, ConvexSolidsAreNotHitTwice) {
    constexpr double k = 0.5522847498307936;
    const std::vector<V2d> ball{{0, -1}, {k, -1}, {1, -k}, {1, 0}, {1, k}, {k, 1}, {0, 1}};
    for (const double distance : {1e-3, 1., 1e3, 1e5}) {
        RandomStream random(33, std::uint64_t(distance * 1e3));
        M44d matrix;
        matrix.translate(V3d(1, 1, -1) * distance);
        const Revolution shape(Transform(matrix), false, Profile(ball, 3));
        for (int i = 0; i < 20000; ++i) {
            const SurfacePoint point = shape.sample(V2f(random.uniform(), random.uniform()))->point;
            const V3d w = unitVector(random);
            const double out = toDouble(point.ng).dot(w);
            if (std::abs(out) < 1e-5) continue;
            PrimitiveHit hit;
            const Ray ray{offsetOrigin(point, toFloat(w)), w};
            ASSERT_EQ(first(shape, ray, hit), out < 0) << point.p << w << distance;
            // The chord of a ball that is round to 3 parts in 10^4.
            if (out < 0) {
                ASSERT_NEAR(hit.s, -2 * out, 5e-3) << point.p << w << distance;
            }
        }
    }
}

struct SamplingCase {
    const char* name;
    std::vector<V2d> points;
    int degree;
    double phiMax;
    M44d matrix;
};

std::vector<SamplingCase> samplingCases() {
    M44d turned, sheared;
    turned.rotate(V3d(0.4, -0.3, 0.2));
    turned.scale(V3d(2));
    sheared.scale(V3d(1, 0.4, 2));
    sheared.rotate(V3d(0.4, -0.3, 0.2));
    sheared.scale(V3d(1.5, 1, 0.6));
    return {{"goblet", joined(gobletProfile()), 3, 360, M44d()},
            {"vase", joined(vaseProfile()), 8, 250, turned},
            {"cone", {{1, 0}, {0, 1}}, 1, 360, sheared},
            {"cusp, stops", {{2, 0}, {.7, 2}, {.7, 0}, {2, 2}, {2, 2}, {0, 3}, {0, 3}}, 3, 360, M44d()},
            {"goblet, sheared", joined(gobletProfile()), 3, 360, sheared}};
}

TEST(RevolutionSurface, SamplesFollowTheirDensity) {
    std::vector<SamplingCase> cases = samplingCases();
    const double threshold = sidakThreshold(1e-4, int(cases.size()));
    for (const SamplingCase& c : cases) {
        const Transform worldFromObject(c.matrix);
        const Revolution shape(worldFromObject, false, Profile(c.points, c.degree), c.phiMax);
        const auto draw = [&](RandomStream& random) -> std::optional<V2f> {
            const float u0 = random.uniform(), u1 = random.uniform();
            return shape.sample(V2f(u0, u1))->point.uv;
        };
        const auto density = [&](const V2f& uv) {
            const double phi = uv.x * radians(c.phiMax);
            const Ray ray{worldFromObject.point(V3d(std::cos(phi), 0, std::sin(phi))), V3d(1, 0, 0)};
            const PrimitiveHit hit{0, uv.x, uv.y, 0};
            const SurfacePoint p = shape.pointAt(ray, hit);
            return double(shape.pdf(hit)) * toDouble(p.dpdu).cross(toDouble(p.dpdv)).length();
        };
        const ChiSquaredResult result = chiSquaredSquare(draw, density, {.seed = 34});
        EXPECT_GT(result.pValue, threshold) << c.name << ": " << result.report;
        EXPECT_NEAR(result.mass, 1, 1e-3) << c.name;
    }
}

TEST(RevolutionSurface, DensityIsTheReciprocalOfTheArea) {
    for (const SamplingCase& c : samplingCases()) {
        const Transform worldFromObject(c.matrix);
        const Revolution shape(worldFromObject, false, Profile(c.points, c.degree), c.phiMax);
        RandomStream random(35);
        double mean = 0;
        int uneven = 0;
        constexpr int count = 20000;
        for (int i = 0; i < count; ++i) {
            const ShapeSample drawn = *shape.sample(V2f(random.uniform(), random.uniform()));
            mean += 1 / double(drawn.pdf) / count; // of 1/pdf: the area
            uneven += std::abs(drawn.pdf * shape.area() - 1) > 0.05;
        }
        EXPECT_NEAR(mean, shape.area(), 0.03 * shape.area()) << c.name;
        // Uniform, but that shear makes it vary over phi, and that next to a stop on the axis the area grows like the
        // fourth power of v, and not linearly over the cell.
        const std::string name = c.name;
        if (name.find("sheared") == std::string::npos && name != "cone") {
            EXPECT_LE(uneven, name == "cusp, stops" ? count / 1000 : 0) << c.name;
        }
    }
}

} // namespace
} // namespace vitrine
