// Rays that start exactly on a mesh, where Embree reports the crossing at distance 0, which is none, again and again; and
// rays that start farther away than Embree can take.
#include "accel/caster.h"
#include "core/random.h"
#include "core/sampling.h"
#include "shapes/mesh.h"

#include <gtest/gtest.h>

#include <pmmintrin.h>

namespace vitrine {
namespace {

enum class Faces { Triangles, Quads, Both };

/// A floor with a corner in the origin, and one that lies `gap` behind it.
CasterInput floors(Faces faces, float gap) {
    CasterInput input;
    for (const float z : {0.f, gap}) {
        MeshInput mesh;
        mesh.p = {V3f(0, 0, z), V3f(1, 0, z), V3f(1, 1, z), V3f(0, 1, z)};
        if (faces != Faces::Triangles) mesh.quads = {0, 1, 3, 2};
        if (faces != Faces::Quads) mesh.triangles = {0, 1, 2, 0, 2, 3};
        for (const auto& shape : makeMeshShapes(std::move(mesh), Transform(), false))
            input.shapes.push_back({shape, std::uint32_t(input.shapes.size()), true});
    }
    return input;
}
/// Embree, and without a tree.
constexpr auto casters = {&makeEmbreeCaster, &makeCaster};
constexpr Faces allFaces[] = {Faces::Triangles, Faces::Quads, Faces::Both};

class OriginOnMesh : public testing::TestWithParam<std::unique_ptr<Caster> (*)(CasterInput)> {};
class FarOrigin : public OriginOnMesh {};

TEST_P(OriginOnMesh, TheCrossingAtTheOriginIsNone) {
    for (const Faces faces : allFaces) {
        const auto caster = GetParam()(floors(faces, 2));
        for (const V3d& o : {V3d(0, 0, 0), V3d(.25, .5, 0), V3d(0, .5, 0), V3d(.5, .5, 0)})
            for (const V3d& d : {V3d(.1, .05, .9), V3d(0, 0, 1), V3d(1e-30, 1e-30, 1), V3d(.2, 0, 1)}) {
                CasterHit hit;
                ASSERT_TRUE(caster->intersect(Ray{o, d, infinityD}, hit));
                EXPECT_NEAR(hit.s * d.z, 2, 1e-12);
                EXPECT_FALSE(caster->intersect(Ray{o, -d, infinityD}, hit));
                EXPECT_FALSE(caster->intersect(Ray{o, d, 1}, hit));
            }
    }
}

TEST_P(OriginOnMesh, TheSearchEnds) {
    // Whatever is found at such tiny distances, it is found soon; also where denormal numbers count as 0, as Embree wishes
    // and as TBB hands on from Embree's threads.
    const unsigned settings = _mm_getcsr();
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    for (const Faces faces : allFaces)
        for (const float gap : {1e-45f, 1e-40f, 1e-38f, 1e-30f, 1e-10f, 1.f}) {
            const auto caster = GetParam()(floors(faces, gap));
            RandomStream random(1, int(faces));
            for (int i = 0; i < 1000; ++i) {
                const V3d d = toDouble(sampleUniformSphere(V2f(random.uniform(), random.uniform())));
                for (const V3d& o : {V3d(0, 0, 0), V3d(.5, .5, gap), V3d(1, .5, 0), V3d(1, 1, gap)}) {
                    CasterHit hit;
                    if (caster->intersect(Ray{o, d, infinityD}, hit)) {
                        EXPECT_GT(hit.s, 0);
                    }
                }
            }
        }
    _mm_setcsr(settings);
}

TEST_P(FarOrigin, AnyDistanceIsTaken) {
    const auto caster = GetParam()(floors(Faces::Quads, 1));
    for (const double distance : {1e3, 1e10, 1e17, 1e30, 3e38, 1e300}) {
        // Along an axis nothing is rounded; aslant the ray may miss, but nothing else may happen.
        CasterHit hit;
        EXPECT_TRUE(caster->intersect(Ray{V3d(.25, .5, distance), V3d(0, 0, -1), infinityD}, hit)) << distance;
        EXPECT_TRUE(caster->occluded(Ray{V3d(.25, .5, distance), V3d(0, 0, -1), infinityD})) << distance;
        const V3d o = V3d(.3, -.2, .9) * distance;
        caster->intersect(Ray{o, V3d(.25, .5, 1) - o, infinityD}, hit);
        caster->intersect(Ray{o, V3d(-.3, .2, -.9), infinityD}, hit);
        caster->occluded(Ray{o, V3d(-.3, .2, -.9000001), infinityD});
    }
}

const auto nameOf = [](const auto& which) { return which.index == 0 ? "Embree" : "Flat"; };
INSTANTIATE_TEST_SUITE_P(Casters, OriginOnMesh, testing::ValuesIn(casters), nameOf);
INSTANTIATE_TEST_SUITE_P(Casters, FarOrigin, testing::ValuesIn(casters), nameOf);

} // namespace
} // namespace vitrine
