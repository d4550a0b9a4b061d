// How far from the true surface hits and drawn points lie: in a hundred digits, against 64 n eps of the profile's size.
#include "shapes/revolution/revolution.h"
#include "support/exact_bezier.h"
#include "support/long_run.h"
#include "support/revolution_cases.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace vitrine {
namespace {

using namespace test;

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Distance of a point from the turned profile near the parameter v. One of Newton's steps for the nearest point: from
/// where the distance is some eps already it only takes off what lies along the curve.
double distanceFromSurface(const ProfilePoints& profile, const V3d& p, double v) {
    const double position = v * double(profile.size());
    const std::size_t segment = std::min(std::size_t(position), profile.size() - 1);
    const std::vector<ExactPoint> curve = exactHodograph(profile[segment], 0);
    const std::vector<ExactPoint> hodograph = exactHodograph(profile[segment], 1);
    const Exact x = p.x, z = p.z, radius = sqrt(x * x + z * z), height = p.y;
    Exact t = Exact(v) * Exact(double(profile.size())) - Exact(double(segment)), least = -1;
    for (int i = 0; i < 2; ++i) {
        const ExactPoint c = exactPoint(curve, t), d = exactPoint(hodograph, t);
        const Exact dx = radius - c.x, dy = height - c.y, distance = sqrt(dx * dx + dy * dy);
        if (least < 0 || distance < least) least = distance;
        const Exact speed2 = d.x * d.x + d.y * d.y;
        if (speed2 == 0) break;
        t += (dx * d.x + dy * d.y) / speed2;
        if (t < 0) t = 0;
        if (t > 1) t = 1;
    }
    return double(least);
}

struct Tally {
    long points = 0;
    double worst = 0;      ///< of points, in n eps of the size
    double worstOnRay = 0; ///< of the ray at s, in n eps of the size and the ray's own rounding
    long beyondOwnBound = 0;
};

void expectWithinBounds(const Tally& tally) {
    std::printf("%ld points: at most %.2f n eps size off the surface, %.2f on the ray (of 64)\n", tally.points,
                tally.worst, tally.worstOnRay);
    EXPECT_LE(tally.worst, 64);
    EXPECT_LE(tally.worstOnRay, 64);
    EXPECT_EQ(tally.beyondOwnBound, 0) << "SurfacePoint::error must hold";
}

TEST(RevolutionBackwardError, HitsLieOnTheTrueSurface) {
    Tally tally;
    for (int i = 0; i < 40 * longRun(); ++i) {
        RandomStream random(51, i);
        const int degree = 1 + i % 20;
        const ProfilePoints points = randomProfile(random, degree);
        const Revolution shape(Transform(), false, Profile(joined(points), degree));
        const double size = shape.profile().size(), unit = degree * eps * size;
        for (int k = 0; k < 2 * rayKinds; ++k) {
            const Ray ray = randomRay(random, RayKind(k % rayKinds), points);
            for (const PrimitiveHit& hit : shape.allHits(ray, -infinityD, infinityD)) {
                const SurfacePoint point = shape.pointAt(ray, hit);
                const double off = distanceFromSurface(points, point.p, hit.v);
                ++tally.points;
                tally.worst = std::max(tally.worst, off / unit);
                tally.beyondOwnBound += off > point.error;
                // The ray itself, rounded once when its direction is made unit and where s is applied.
                const double onRay = distanceFromSurface(points, ray.at(hit.s), hit.v);
                const double length = std::abs(hit.s) * ray.d.length() + maxAbs(ray.o);
                tally.worstOnRay = std::max(tally.worstOnRay, onRay / (unit + eps / 4 * length));
            }
        }
    }
    EXPECT_GT(tally.points, 2000);
    expectWithinBounds(tally);
}

TEST(RevolutionBackwardError, DrawnPointsLieOnTheTrueSurface) {
    Tally tally;
    for (int i = 0; i < 20 * longRun(); ++i) {
        RandomStream random(52, i);
        const int degree = 1 + 3 * i % 60;
        const ProfilePoints points = randomProfile(random, degree);
        const Revolution shape(Transform(), false, Profile(joined(points), degree));
        const double unit = degree * eps * shape.profile().size();
        const Ray ray{V3d(1, 0, 0), V3d(1, 0, 0)};
        for (int k = 0; k < 10; ++k) {
            const PrimitiveHit place{0, 0, random.uniformDouble(), 0};
            const SurfacePoint point = shape.pointAt(ray, place);
            const double off = distanceFromSurface(points, point.p, place.v);
            ++tally.points;
            tally.worst = std::max(tally.worst, off / unit);
            tally.beyondOwnBound += off > point.error;
        }
    }
    expectWithinBounds(tally);
}

} // namespace
} // namespace vitrine
