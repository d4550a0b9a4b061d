#include "core/random.h"
#include "lights/constant_infinite_light.h"
#include "lights/light.h"
#include "shapes/disk.h"
#include "shapes/mesh.h"
#include "shapes/plane.h"
#include "shapes/sphere.h"

#include <stdexcept>

namespace vitrine {
namespace {

const SampledWavelengths lambda = SampledWavelengths::visible(0.5f);
const SpectrumPtr one = std::make_shared<ConstantSpectrum>(1.f);
const double oneInNits = innerProduct(*one, cieY());

Transform placed(const V3d& p, double scale) {
    return Transform(M44d(scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, p.x, p.y, p.z, 1));
}

ShapePtr disk(const Transform& t) {
    return std::make_shared<Disk>(t, false, 0, 1, 0, 360);
}

ShapePtr sphere(const Transform& t) {
    return std::make_shared<Sphere>(t, false, 1, -1, 1, 360);
}

ShapePtr rectangle(const Transform& t) {
    MeshInput mesh;
    mesh.p = {V3f(-1, -1, 0), V3f(1, -1, 0), V3f(-1, 1, 0), V3f(1, 1, 0)};
    mesh.quads = {0, 1, 2, 3};
    return makeMeshShapes(mesh, t, false).at(0);
}

ShapePtr triangle(const Transform& t) {
    MeshInput mesh;
    mesh.p = {V3f(-1, -1, 0), V3f(1, -1, 0), V3f(-1, 1, 0)};
    mesh.triangles = {0, 1, 2};
    return makeMeshShapes(mesh, t, false).at(0);
}

TEST(AreaLight, ShinesFromTheNormalsSideOrBoth) {
    const V3d front(0.2, 0.1, 2), behind(0.2, 0.1, -2);
    const AreaLight single(disk(Transform()), one, false), both(disk(Transform()), one, true);
    SurfacePoint point;
    point.ng = V3f(0, 0, 1);
    EXPECT_FALSE(single.emitted(point, V3f(0.6f, 0, 0.8f), lambda).isBlack());
    EXPECT_TRUE(single.emitted(point, V3f(0.6f, 0, -0.8f), lambda).isBlack());
    EXPECT_FALSE(both.emitted(point, V3f(0.6f, 0, -0.8f), lambda).isBlack());
    const V2f u(0.3f, 0.8f);
    EXPECT_TRUE(single.sample(front, u, lambda));
    EXPECT_FALSE(single.sample(behind, u, lambda));
    EXPECT_TRUE(both.sample(front, u, lambda));
    EXPECT_TRUE(both.sample(behind, u, lambda));
    EXPECT_FALSE(AreaLight(disk(Transform()), std::make_shared<ConstantSpectrum>(0.f), true).sample(front, u, lambda));
}

TEST(AreaLight, PowerIsPiAreaPerSideAndCanBeAsked) {
    for (bool twoSided : {false, true}) {
        const double sides = twoSided ? 2 : 1;
        const AreaLight plain(disk(placed(V3d(1), 3)), one, twoSided);
        EXPECT_NEAR(plain.power(lambda)[1], sides * piD * piD * 9, 1e-3);
        const auto asked = AreaLight::create(sphere(placed(V3d(1), 3)), {one, 2, 40, twoSided});
        EXPECT_NEAR(asked->power(lambda)[1] * oneInNits, 80, 1e-3) << "scale multiplies, as in pbrt";
    }
    const auto light = AreaLight::create(disk(Transform()), {one, 7});
    SurfacePoint point;
    point.ng = V3f(0, 0, 1);
    EXPECT_NEAR(light->emitted(point, V3f(0, 0, 1), lambda)[3] * oneInNits, 7, 1e-4);
}

TEST(AreaLight, SampleAgreesWithTheHitOfItsRay) {
    RandomStream random(21);
    for (const auto& shape : {disk(Transform()), sphere(Transform()), rectangle(Transform()), triangle(Transform())}) {
        const AreaLight light(shape, one, false);
        int samples = 0;
        for (int i = 0; i < 300; ++i) {
            const V3d p(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(1.1, 3));
            const auto sample = light.sample(p, V2f(random.uniform(), random.uniform()), lambda);
            if (!sample) continue;
            ++samples;
            EXPECT_NEAR(sample->wi.length(), 1, 1e-6);
            // It ends off the surface on p's side; so far the directions are apart.
            const V3d end = p + sample->shadow.d * sample->shadow.tMax;
            EXPECT_GT(shape->isClosed() ? end.length() - 1 : end.z, 1e-16);
            EXPECT_LT((sample->shadow.d.normalized() - toDouble(sample->wi)).length(), 1e-5);
            const Ray ray{p, sample->shadow.d, infinityD};
            PrimitiveHit hit;
            ASSERT_TRUE(shape->intersect(0, ray, 0, infinityD, hit));
            EXPECT_NEAR(hit.s, 1, 1e-5);
            const SurfacePoint point = shape->pointAt(ray, hit);
            EXPECT_NEAR(light.pdf(p, hit, point), sample->pdf, 2e-3 * sample->pdf);
            EXPECT_FALSE(light.emitted(point, -sample->wi, lambda).isBlack());
        }
        EXPECT_GT(samples, 250);
    }
}

/// Whatever the scale, the place and the angle: the light does not shadow itself.
TEST(AreaLight, ShadowRaysStopShortOfTheLightsOwnSurface) {
    RandomStream random(22);
    for (const auto& make : {disk, sphere, rectangle, triangle})
        for (double away : {0., 1., 1e3, 1e5})
            for (double scale : {1e-3, 1., 1e3}) {
                if (scale < 1e-6 * away) continue; // the floats of a mesh would have no room for it
                const V3d place = V3d(0.36, -0.48, 0.8) * away;
                const ShapePtr shape = make(placed(place, scale));
                const AreaLight light(shape, one, true);
                int shadowed = 0, samples = 0;
                for (int i = 0; i < 400; ++i) {
                    // From grazing to straight, from near to far.
                    const V3d offset(random.uniform(-3, 3), random.uniform(-3, 3), std::pow(10, random.uniform(-3, 2)));
                    const V3d p = place + offset * scale;
                    const auto sample = light.sample(p, V2f(random.uniform(), random.uniform()), lambda);
                    if (!sample) continue;
                    ++samples;
                    Ray shadow = sample->shadow;
                    shadow.o = p;
                    // A point seen through a sphere's own front is rightly shadowed; light sampling gives only the front.
                    shadowed += shape->occludes(0, shadow, 0, shadow.tMax);
                }
                EXPECT_EQ(shadowed, 0) << away << " " << scale << " of " << samples;
                EXPECT_GT(samples, 100);
            }
}

TEST(AreaLight, InfiniteShapesShineButAreNotSampled) {
    const auto plane = std::make_shared<Plane>(Transform(), false, V3d(0, 0, 1), 0);
    const AreaLight light(plane, one, false);
    EXPECT_FALSE(light.sample(V3d(0, 0, 1), V2f(0.5f, 0.5f), lambda));
    EXPECT_FALSE(std::isfinite(light.power(lambda)[0]));
    EXPECT_THROW(AreaLight::create(plane, {one, 1, 100}), std::invalid_argument);
    EXPECT_NO_THROW(AreaLight::create(plane, {one, 1}));
}

TEST(ConstantInfiniteLight, SameFromEverywhere) {
    const auto light = ConstantInfiniteLight::create({one, 2, 10});
    const double expected = 2 * 10 / piD / oneInNits;
    EXPECT_NEAR(light->escaped(V3f(0, 0, 1), lambda)[0], expected, 1e-6);
    const auto sample = light->sample(V3d(4), V2f(0.1f, 0.6f), lambda);
    ASSERT_TRUE(sample);
    EXPECT_NEAR(sample->l[0], expected, 1e-6);
    EXPECT_NEAR(sample->pdf, 1 / (4 * piD), 1e-7);
    EXPECT_EQ(light->pdf(sample->wi), sample->pdf);
    EXPECT_EQ(sample->shadow.tMax, infinityD);
    EXPECT_TRUE(light->isInfinite() && !light->isDelta());
    light->preprocess(V3d(0), 2);
    EXPECT_NEAR(light->power(lambda)[0], 4 * piD * piD * 4 * expected, 1e-3);
}

} // namespace
} // namespace vitrine
