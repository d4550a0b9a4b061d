// Points drawn on meshes are where their densities say.
#include "support/chi_squared.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

namespace vitrine::test {

namespace {

struct SampledMesh {
    const char* name;
    MeshInput mesh;
};

std::vector<SampledMesh> singlePatches() {
    return {{"rectangle", patch(V3d(-1, 0, 0.5), V3d(-0.2, 1.6, 0.5), V3d(0, -0.5, 0.5), V3d(0.8, 1.1, 0.5))},
            {"parallelogram", patch(V3d(-1, 0, 0.5), V3d(0.2, 0.6, 0.5), V3d(0, -0.5, 0.5), V3d(1.2, 0.1, 0.5))},
            {"quad", patch(V3d(-1, -1, 0), V3d(1.5, -1.2, 0), V3d(-0.5, 0.2, 0), V3d(0.4, 0.9, 0))},
            {"bent patch", patch(V3d(-1, -1, 0.8), V3d(1, -1, -0.5), V3d(-1, 1, -0.7), V3d(1.5, 1, 0.5))}};
}

std::vector<SampledMesh> allMeshes() {
    std::vector<SampledMesh> meshes = singlePatches();
    meshes.push_back({"triangle", soup(1, 1, 3)});
    meshes.push_back({"triangles", soup(2, 5, 3)});
    meshes.push_back({"cube", cubeMesh(V3d(0.1, 0.2, 0.3), 0.6)});
    meshes.push_back({"bent patches", soup(3, 4, 4)});
    return meshes;
}

const V3d viewpoints[] = {V3d(0.3, 0.2, 1.5), V3d(-1.5, 2, -0.4), V3d(0.1, 0.4, 0.62), V3d(90, -70, 200)};

std::optional<ShapeSample> draw(const Shape& shape, const V3d& from, RandomStream& random) {
    const float x = random.uniform();
    return shape.sample(from, V2f(x, random.uniform()));
}

/// Solid angle per area.
double cosineOverDistance2(const V3d& from, const V3d& p, const V3d& unitNormal) {
    const V3d d = p - from;
    return std::abs(d.dot(unitNormal)) / std::pow(d.length2(), 1.5);
}

/// Calls visit(point, area vector of a small cell about it) all over a mesh given in pbrt's order.
template <class Visit>
void forCells(const MeshInput& mesh, int n, Visit&& visit) {
    const auto p = [&](std::uint32_t i) { return toDouble(mesh.p[i]); };
    for (std::size_t i = 0; i < mesh.quads.size(); i += 4)
        for (int a = 0; a < n; ++a)
            for (int b = 0; b < n; ++b) {
                const V3d p00 = p(mesh.quads[i]), p10 = p(mesh.quads[i + 1]), p01 = p(mesh.quads[i + 2]),
                          p11 = p(mesh.quads[i + 3]);
                const double u = (a + 0.5) / n, v = (b + 0.5) / n;
                const V3d du = (p10 - p00) * (1 - v) + (p11 - p01) * v, dv = (p01 - p00) * (1 - u) + (p11 - p10) * u;
                visit((p00 * (1 - u) + p10 * u) * (1 - v) + (p01 * (1 - u) + p11 * u) * v, du.cross(dv) / n / n);
            }
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const V3d p0 = p(mesh.triangles[i]), e1 = p(mesh.triangles[i + 1]) - p0, e2 = p(mesh.triangles[i + 2]) - p0;
        for (int a = 0; a < n; ++a)
            for (int b = 0; a + b < n; ++b)
                for (int far = 0; far < (a + b + 1 < n ? 2 : 1); ++far) {
                    const double third = far ? 2. / 3 : 1. / 3;
                    visit(p0 + e1 * ((a + third) / n) + e2 * ((b + third) / n), e1.cross(e2) / 2 / n / n);
                }
    }
}

/// Functions whose integrals a wrong density gets wrong.
constexpr int momentCount = 6;
double moment(int k, const V3d& p) {
    const double values[momentCount] = {1, 2 + p.x, 2 + p.y, 2 + p.z, sqr(p.x), sqr(p.y - p.x)};
    return values[k];
}

} // namespace

TEST(MeshSampling, PatchesFollowTheirDensityOverUv) {
    const auto meshes = singlePatches();
    const double threshold = sidakThreshold(0.01, int(meshes.size() * std::size(viewpoints)));
    std::uint64_t seed = 100;
    for (const auto& [name, mesh] : meshes) {
        const ShapePtr shape = onlyShape(mesh);
        const V3d p00 = toDouble(mesh.p[0]), p10 = toDouble(mesh.p[1]), p01 = toDouble(mesh.p[2]),
                  p11 = toDouble(mesh.p[3]);
        for (const V3d& from : viewpoints) {
            const auto density = [&](const V2f& uv) {
                const double u = uv.x, v = uv.y;
                const V3d p = (p00 * (1 - u) + p10 * u) * (1 - v) + (p01 * (1 - u) + p11 * u) * v;
                const V3d du = (p10 - p00) * (1 - v) + (p11 - p01) * v, dv = (p01 - p00) * (1 - u) + (p11 - p10) * u;
                const V3d n = du.cross(dv);
                // The hit's own parameters, of a ray along the normal.
                const V3d step = n.normalized() * 1e-6;
                PrimitiveHit hit;
                if (!shape->intersect(0, Ray{p + step, -step}, 0, 2, hit)) return 0.;
                const Ray ray{from, p - from};
                return shape->pdf(from, hit, shape->pointAt(ray, hit)) * cosineOverDistance2(from, p, n.normalized()) *
                       n.length();
            };
            const auto sample = [&](RandomStream& random) -> std::optional<V2f> {
                const auto drawn = draw(*shape, from, random);
                if (!drawn) return std::nullopt;
                return drawn->point.uv;
            };
            ChiSquaredSettings settings;
            settings.seed = ++seed;
            const ChiSquaredResult result = chiSquaredSquare(sample, density, settings);
            EXPECT_GT(result.pValue, threshold) << name << " from " << from << "\n" << result.report;
            EXPECT_NEAR(result.mass, 1, 1e-3) << name << " from " << from;
        }
    }
}

TEST(MeshSampling, EstimatesOfIntegralsAreUnbiased) {
    const auto meshes = allMeshes();
    const double threshold = sidakThreshold(0.01, int(meshes.size() * (1 + std::size(viewpoints)) * momentCount));
    constexpr int samples = 100'000;
    RandomStream random(7);
    for (const auto& [name, mesh] : meshes) {
        const ShapePtr shape = onlyShape(mesh);
        for (std::size_t view = 0; view <= std::size(viewpoints); ++view) {
            // The last one: over the area, not over the solid angle.
            const bool byArea = view == std::size(viewpoints);
            const V3d from = byArea ? V3d(0, 0, 0) : viewpoints[view];
            double truth[momentCount] = {}, sum[momentCount] = {}, sum2[momentCount] = {};
            forCells(mesh, 400, [&](const V3d& p, const V3d& area) {
                const double weight = byArea ? 1 : cosineOverDistance2(from, p, area.normalized());
                for (int k = 0; k < momentCount; ++k)
                    truth[k] += moment(k, p) * weight * area.length();
            });
            for (int i = 0; i < samples; ++i) {
                const float x = random.uniform(), y = random.uniform();
                const auto drawn = byArea ? shape->sample(V2f(x, y)) : shape->sample(from, V2f(x, y));
                for (int k = 0; drawn && k < momentCount; ++k) {
                    const double value = moment(k, drawn->point.p) / drawn->pdf;
                    sum[k] += value;
                    sum2[k] += sqr(value);
                }
            }
            for (int k = 0; k < momentCount; ++k) {
                const double mean = sum[k] / samples;
                const double deviation = std::sqrt(std::max(0., sum2[k] / samples - sqr(mean)) / samples);
                // The sum over cells is good to a few 1e-5.
                const double z = (mean - truth[k]) / (deviation + 5e-5 * std::abs(truth[k]));
                EXPECT_GT(normalPValue(z), threshold) << name << " view " << view << " moment " << k << ": " << mean
                                                      << " against " << truth[k] << ", z " << z;
            }
        }
    }
}

TEST(MeshSampling, ASampleHasTheDensityOfItsHit) {
    RandomStream random(5);
    const V3d from(0.3, 0.2, 1.5);
    for (const auto& [name, mesh] : allMeshes()) {
        const ShapePtr shape = onlyShape(mesh);
        int compared = 0;
        for (int i = 0; i < 1000; ++i) {
            const auto drawn = draw(*shape, from, random);
            if (!drawn) continue;
            const Ray ray{from, drawn->point.p - from};
            PrimitiveHit hit;
            bool found = false;
            for (unsigned prim = 0; prim < shape->primitiveCount() && !found; ++prim)
                found = shape->intersect(prim, ray, 1 - 1e-6, 1 + 1e-6, hit);
            // Rounding may throw a point at an edge off its face.
            if (!found) continue;
            ++compared;
            const SurfacePoint point = shape->pointAt(ray, hit);
            EXPECT_NEAR(shape->pdf(from, hit, point) / drawn->pdf, 1, 1e-3) << name;
            EXPECT_LT(maxAbs(point.p - drawn->point.p), 1e-5);
            EXPECT_GT(point.ng.dot(drawn->point.ng), 0.999f);
            EXPECT_LT((point.uv - drawn->point.uv).length(), 1e-3);
        }
        EXPECT_GT(compared, 900) << name;
    }
}

} // namespace vitrine::test
