// Sampling of the analytic shapes: by area, and as lights seen from a point.
#include "core/frame.h"
#include "support/analytic_shapes.h"
#include "support/chi_squared.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

/// For the about 200 tests of this file together.
double threshold() {
    return sidakThreshold(0.001, 200);
}

V2f uniform2(RandomStream& rng) {
    const float u = rng.uniform();
    return V2f(u, rng.uniform());
}

/// World area per unit of (u, v), by central differences of the shape's definition.
double areaPerParameter(const AnalyticShape& analytic, const Transform& transform, double u, double v) {
    constexpr double h = 1e-5;
    const V3d du = analytic.pointOf(u + h, v) - analytic.pointOf(u - h, v);
    const V3d dv = analytic.pointOf(u, v + h) - analytic.pointOf(u, v - h);
    return (transform.vector(du) / (2 * h)).cross(transform.vector(dv) / (2 * h)).length();
}

/// The hit of a ray that meets the point of parameters (u, v) at a right angle.
PrimitiveHit hitAt(const AnalyticShape& analytic, const Transform& transform, const Shape& shape, double u, double v) {
    constexpr double h = 1e-5;
    const V3d p = transform.point(analytic.pointOf(u, v));
    const V3d du = transform.vector(analytic.pointOf(u + h, v) - analytic.pointOf(u - h, v));
    const V3d dv = transform.vector(analytic.pointOf(u, v + h) - analytic.pointOf(u, v - h));
    const V3d n = du.cross(dv).normalized();
    PrimitiveHit hit;
    EXPECT_TRUE(shape.intersect(0, Ray{p + n * 1e-6, -n, infinityD}, 0, infinityD, hit)) << u << ' ' << v;
    return hit;
}

TEST(AnalyticSampling, PointsFollowTheirDensityOverTheParameters) {
    std::uint64_t seed = 1;
    for (const AnalyticShape& analytic : boundedAnalyticShapes()) {
        if (!analytic.pointOf) continue; // the box: below
        for (const NamedTransform& placement : placements(1, 0.5)) {
            SCOPED_TRACE(analytic.name + ", " + placement.name);
            const Transform& transform = placement.worldFromObject;
            const ShapePtr shape = analytic.make(transform, false);
            const auto density = [&](const V2f& uv) {
                // Kept off the poles and seams, where the hit would be in doubt.
                const double u = std::clamp(double(uv.x), 1e-4, 1 - 1e-4), v = std::clamp(double(uv.y), 1e-4, 1 - 1e-4);
                return shape->pdf(hitAt(analytic, transform, *shape, u, v)) *
                       areaPerParameter(analytic, transform, u, v);
            };
            const auto sample = [&](RandomStream& rng) -> std::optional<V2f> {
                return shape->sample(uniform2(rng))->point.uv;
            };
            ChiSquaredSettings settings;
            settings.seed = seed++;
            const ChiSquaredResult result = chiSquaredSquare(sample, density, settings);
            EXPECT_GT(result.pValue, threshold()) << result.report;
            EXPECT_NEAR(result.mass, 1, 1e-3);
        }
    }
}

TEST(AnalyticSampling, MeanOfReciprocalDensityIsTheArea) {
    RandomStream rng(20291);
    for (const AnalyticShape& analytic : boundedAnalyticShapes())
        for (const NamedTransform& placement : placements(1, 0.5)) {
            SCOPED_TRACE(analytic.name + ", " + placement.name);
            const ShapePtr shape = analytic.make(placement.worldFromObject, false);
            constexpr int n = 20000;
            double sum = 0, sum2 = 0;
            for (int i = 0; i < n; ++i) {
                const double area = 1 / double(shape->sample(uniform2(rng))->pdf);
                sum += area;
                sum2 += area * area;
            }
            const double mean = sum / n, error = std::sqrt(std::max(0., sum2 / n - mean * mean) / n);
            const double rounding = 1e-6 * shape->area();
            EXPECT_GT(normalPValue((mean - shape->area()) / (error + rounding)), threshold());
        }
}

TEST(AnalyticSampling, BoxFacesAreChosenByArea) {
    const Transform transform = placements(1, 0.5)[2].worldFromObject;
    const V3d low(-0.5, -0.7, -0.3), high(0.6, 0.4, 0.9);
    const Box box(transform, false, low, high);
    RandomStream rng(20292);
    constexpr int n = 60000, cells = 4;
    double observed[6][cells] = {};
    for (int i = 0; i < n; ++i) {
        const SurfacePoint point = box.sample(uniform2(rng))->point;
        const V3d p = transform.inverse().point(point.p);
        int face = -1;
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(p[axis] - low[axis]) < 1e-9) face = 2 * axis;
            if (std::abs(p[axis] - high[axis]) < 1e-9) face = 2 * axis + 1;
        }
        ASSERT_GE(face, 0);
        observed[face][(point.uv.x < 0.5f ? 0 : 1) + (point.uv.y < 0.5f ? 0 : 2)] += 1;
    }
    double statistic = 0;
    for (int face = 0; face < 6; ++face) {
        const int i = (face / 2 + 1) % 3, j = (face / 2 + 2) % 3;
        V3d a(0, 0, 0), b(0, 0, 0);
        a[i] = high[i] - low[i];
        b[j] = high[j] - low[j];
        const double expected = n * transform.vector(a).cross(transform.vector(b)).length() / box.area() / cells;
        for (const double count : observed[face])
            statistic += sqr(count - expected) / expected;
    }
    EXPECT_GT(chiSquaredPValue(statistic, 6 * cells - 1), threshold());
}

double cosineAt(const SurfacePoint& point, const V3d& from) {
    return std::abs((point.p - from).normalized().dot(toDouble(point.ng)));
}

/// Density of the direction w, and w times powers of the cosine at the points that it stands for.
struct DirectionDensity {
    double plain = 0, byCosine = 0, byCosine2 = 0;
};

/// Sum over all that a ray meets, as sampling by area takes no heed of what hides what; of the first alone when the
/// shape is sampled by what is seen.
DirectionDensity directionDensity(const Shape& shape, const V3d& from, const V3f& w, bool firstOnly) {
    const Ray ray{from, toDouble(w), infinityD};
    DirectionDensity sum;
    double after = 0;
    PrimitiveHit hit;
    while (shape.intersect(0, ray, after, infinityD, hit)) {
        const SurfacePoint point = shape.pointAt(ray, hit);
        const double pdf = shape.pdf(from, hit, point), cosine = cosineAt(point, from);
        sum.plain += pdf;
        sum.byCosine += pdf * cosine;
        sum.byCosine2 += pdf * sqr(cosine);
        if (firstOnly) break;
        after = hit.s;
    }
    return sum;
}

struct View {
    V3d from; ///< object space
    bool isInside;
};

const View views[] = {{V3d(1.9, -1.3, 0.8), false}, {V3d(0.3, 0.15, 5), false}, {V3d(0.1, 0.2, -0.1), true}};

/// A cap of directions about `axis` that holds all of the shape, or the whole sphere; in cells of equal solid angle.
class Cap {
  public:
    Cap(const Box3d& bounds, const V3d& from) : frame_(toFloat((bounds.center() - from).normalized())) {
        const double sine = bounds.size().length() / 2 / (bounds.center() - from).length();
        height_ = sine < 1 ? 1 - std::sqrt(1 - sine * sine) : 2;
    }

    static constexpr int rows = 12, columns = 16, cells = rows * columns;
    double solidAngle() const { return 2 * piD * height_; }
    V3f direction(RandomStream& rng) const {
        const double z = 1 - rng.uniform(0, height_), r = safeSqrt(1 - z * z), phi = rng.uniform(0, 2 * piD);
        return frame_.toWorld(V3f(float(r * std::cos(phi)), float(r * std::sin(phi)), float(z)));
    }
    int cell(const V3f& w) const {
        const V3f local = frame_.toLocal(w);
        const double row = (1 - local.z) / height_ * rows,
                     column = (std::atan2(local.y, local.x) / (2 * piD) + 0.5) * columns;
        return std::clamp(int(row), 0, rows - 1) * columns + std::clamp(int(column), 0, columns - 1);
    }

  private:
    Frame frame_;
    double height_;
};

/// A sum over drawn directions beside what it should be by the density at uniform directions. The terms are cosines at
/// the shape, as plain counts grow without bound towards the rim, and have no variance to speak of.
struct Cell {
    double observed = 0, expected = 0, variance = 0; ///< of the difference
    double draws = 0;                                ///< to be expected
    int hits = 0;

    void add(const Cell& other) {
        observed += other.observed;
        expected += other.expected;
        variance += other.variance;
    }
    double statistic() const { return sqr(observed - expected) / std::max(variance, 1e-4); }
};

std::vector<Cell> histogram(const Shape& shape, const V3d& from, bool byCone, RandomStream& rng) {
    constexpr int draws = 40000, tries = 160000;
    const Cap cap(shape.bounds(), from);
    std::vector<Cell> cells(Cap::cells);
    for (int i = 0; i < draws; ++i) {
        const auto drawn = shape.sample(from, uniform2(rng));
        if (!drawn) continue;
        const V3f w = toFloat((drawn->point.p - from).normalized());
        cells[std::size_t(cap.cell(w))].observed += cosineAt(drawn->point, from);
    }
    const double weight = cap.solidAngle() * draws / tries;
    for (int i = 0; i < tries; ++i) {
        const V3f w = cap.direction(rng);
        const DirectionDensity density = directionDensity(shape, from, w, byCone);
        Cell& cell = cells[std::size_t(cap.cell(w))];
        cell.expected += weight * density.byCosine;
        // Of the draws, then of this estimate.
        cell.variance += weight * density.byCosine2 + sqr(weight * density.byCosine);
        cell.draws += weight * density.plain;
        cell.hits += density.plain > 0;
    }
    return cells;
}

template <class Check>
void forAllViews(Check&& check) {
    for (const AnalyticShape& analytic : boundedAnalyticShapes())
        for (const NamedTransform& placement : placements(1, 0.5))
            for (const View& view : views) {
                SCOPED_TRACE(analytic.name + ", " + placement.name + ", from " + std::to_string(view.from.x));
                const ShapePtr shape = analytic.make(placement.worldFromObject, false);
                const bool byCone = analytic.name == "sphere" && placement.name != "uneven" && !view.isInside;
                check(*shape, placement.worldFromObject.point(view.from), byCone);
            }
}

TEST(AnalyticSampling, DirectionsFollowTheirDensity) {
    RandomStream rng(20295);
    forAllViews([&](const Shape& shape, const V3d& from, bool byCone) {
        // Cells where few terms make the sums, which are not yet normal variables, count as one.
        double statistic = 0;
        int cells = 1;
        Cell rest;
        for (const Cell& cell : histogram(shape, from, byCone, rng)) {
            if (cell.hits < 50 || cell.draws < 50) {
                rest.add(cell);
                continue;
            }
            statistic += cell.statistic();
            ++cells;
        }
        statistic += rest.statistic();
        EXPECT_GT(cells, 5);
        EXPECT_GT(chiSquaredPValue(statistic, cells), threshold()) << "chi^2 " << statistic << " of " << cells;
    });
}

TEST(AnalyticSampling, DensitiesOfDirectionsIntegrateToOne) {
    RandomStream rng(20293);
    forAllViews([&](const Shape& shape, const V3d& from, bool byCone) {
        constexpr int n = 50000;
        const Cap cap(shape.bounds(), from);
        double sum = 0, sum2 = 0;
        for (int i = 0; i < n; ++i) {
            const double x = cap.solidAngle() * directionDensity(shape, from, cap.direction(rng), byCone).plain;
            sum += x;
            sum2 += x * x;
        }
        const double mean = sum / n, error = std::sqrt((sum2 / n - mean * mean) / (n - 1));
        EXPECT_GT(normalPValue((mean - 1) / (error + 1e-6)), threshold()) << mean << " +- " << error;
    });
}

TEST(AnalyticSampling, DrawnPointsAreFoundAgainWithTheSameDensity) {
    RandomStream rng(20294);
    forAllViews([&](const Shape& shape, const V3d& from, bool) {
        for (int i = 0; i < 1000; ++i) {
            const auto drawn = shape.sample(from, uniform2(rng));
            ASSERT_TRUE(drawn);
            const V3d d = drawn->point.p - from;
            const double cosine = std::abs(d.normalized().dot(toDouble(drawn->point.ng)));
            if (cosine < 1e-3) continue; // the rim, where the density has too few digits left
            const Ray ray{from, d, infinityD};
            PrimitiveHit hit;
            ASSERT_TRUE(shape.intersect(0, ray, 1 - 1e-6, 1 + 1e-6, hit));
            EXPECT_NEAR(hit.s, 1, 1e-9);
            EXPECT_NEAR(shape.pdf(from, hit, shape.pointAt(ray, hit)) / drawn->pdf, 1, 1e-3);
        }
    });
}

TEST(AnalyticSampling, NarrowAndWideConesAreFilledEvenly) {
    std::uint64_t seed = 1000;
    const Sphere sphere(Transform(), false, 2, -2, 2, 360);
    for (const double distance : {2.0000001, 2.1, 5., 1e3, 1e6}) {
        const V3d from = V3d(0.48, -0.64, 0.6) * distance, axis = -from / distance;
        const Frame frame(toFloat(axis));
        const double sin2Max = sqr(2 / distance), heightMax = sin2Max / (1 + std::sqrt(1 - sin2Max));
        const auto sample = [&](RandomStream& rng) -> std::optional<V2f> {
            const V3d d = (sphere.sample(from, uniform2(rng))->point.p - from).normalized();
            const double sin2 = axis.cross(d).length2(), height = sin2 / (1 + std::sqrt(std::max(0., 1 - sin2)));
            const double phi = std::atan2(d.dot(toDouble(frame.t)), d.dot(toDouble(frame.s)));
            // Cones up to a half space: the cosine is not negative.
            return V2f(float(std::clamp(height / heightMax, 0., 1.)), float(phi / (2 * piD) + 0.5));
        };
        ChiSquaredSettings settings;
        settings.seed = seed++;
        const ChiSquaredResult result = chiSquaredSquare(
            sample, [](const V2f&) { return 1.; }, settings);
        EXPECT_GT(result.pValue, threshold()) << distance << ": " << result.report;
    }
}

} // namespace
} // namespace vitrine::test
