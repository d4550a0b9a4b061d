// Point, spot and distant lights against values worked out by hand.
#include "core/random.h"
#include "lights/distant_light.h"
#include "lights/point_light.h"
#include "lights/spot_light.h"

#include <stdexcept>

namespace vitrine {
namespace {

const SampledWavelengths lambda = SampledWavelengths::visible(0.5f);
const SpectrumPtr one = std::make_shared<ConstantSpectrum>(1.f);
/// photometric() of `one`: what emission of one nit is divided by.
const double oneInNits = innerProduct(*one, cieY());

Transform translated(double x, double y, double z) {
    return Transform(M44d(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1));
}

double value(const std::optional<LightSample>& sample) {
    return sample ? sample->l[0] / sample->pdf : 0;
}

void expectNear(const V3d& a, const V3d& b, double tolerance) {
    EXPECT_TRUE(a.equalWithAbsError(b, tolerance)) << a << " is not " << b;
}

TEST(PointLight, IntensityOverSquaredDistance) {
    const auto light = PointLight::create(translated(1, 0, 0), {one, 3, -1, V3d(0, 2, 0)});
    const auto sample = light->sample(V3d(1, 0, 0), V2f(0.3f, 0.4f), lambda);
    ASSERT_TRUE(sample);
    EXPECT_NEAR(value(sample), 3 / oneInNits / 4, 1e-6);
    EXPECT_EQ(sample->wi, V3f(0, 1, 0));
    EXPECT_EQ(sample->pdf, 1);
    EXPECT_TRUE(sample->isDelta && light->isDelta());
    expectNear(sample->shadow.d, V3d(0, 2, 0), 0);
    EXPECT_LT(sample->shadow.tMax, 1);
    EXPECT_GT(sample->shadow.tMax, 0.9999);
    EXPECT_FALSE(light->sample(V3d(1, 2, 0), V2f(), lambda)) << "at the light itself";
    EXPECT_FALSE(PointLight(V3d(0), std::make_shared<ConstantSpectrum>(0.f)).sample(V3d(1), V2f(), lambda));
}

TEST(PointLight, PowerIsFourPiIntensityAndCanBeAsked) {
    EXPECT_NEAR(PointLight(V3d(0), one).power(lambda)[2], 4 * piD, 1e-5);
    const auto light = PointLight::create(Transform(), {one, 2, 100});
    // scale multiplies, as in pbrt.
    EXPECT_NEAR(light->power(lambda)[0] * oneInNits, 200, 1e-3);
}

TEST(SpotLight, ProfileIsASmoothstepInTheCosine) {
    const SpotLight::Cone cone{40, 15};
    const auto light = SpotLight::create(translated(0, 0, 5), {one, 1, -1, V3d(1, 0, 0), V3d(1, 0, -3), cone});
    const auto intensity = [&](double degrees) {
        const double angle = radians(degrees);
        const V3d p = V3d(1, 0, 5) + V3d(std::sin(angle), 0, -std::cos(angle)) * 2.;
        return value(light->sample(p, V2f(), lambda)) * 4 * oneInNits;
    };
    EXPECT_NEAR(intensity(0), 1, 1e-6);
    EXPECT_NEAR(intensity(24.9), 1, 1e-6);
    EXPECT_EQ(intensity(40.1), 0);
    EXPECT_EQ(intensity(120), 0);
    // In the middle between the cosines the smoothstep is 1/2; at a quarter 5/32, at three quarters 27/32.
    const double start = std::cos(radians(25)), end = std::cos(radians(40));
    EXPECT_NEAR(intensity(degrees(std::acos(lerp(0.5, end, start)))), 0.5, 1e-6);
    EXPECT_NEAR(intensity(degrees(std::acos(lerp(0.25, end, start)))), 5 / 32., 1e-6);
    EXPECT_NEAR(intensity(degrees(std::acos(lerp(0.75, end, start)))), 27 / 32., 1e-6);
}

TEST(SpotLight, PowerIsTheIntegralOfTheIntensity) {
    for (const SpotLight::Cone& cone : {SpotLight::Cone{30, 5}, SpotLight::Cone{90, 90}, SpotLight::Cone{20, 0}}) {
        const SpotLight light(Transform(), one, cone);
        double sum = 0;
        const int steps = 20000;
        for (int i = 0; i < steps; ++i) {
            const double c = -1 + 2 * (i + 0.5) / steps;
            sum += value(light.sample(V3d(std::sqrt(1 - c * c), 0, c), V2f(), lambda)) * 2 * piD * 2 / steps;
        }
        EXPECT_NEAR(light.power(lambda)[1], sum, 2e-4 * sum) << cone.angle;
        const auto asked = SpotLight::create(Transform(), {one, 1, 50, V3d(0), V3d(1, 2, 3), cone});
        EXPECT_NEAR(asked->power(lambda)[1] * oneInNits, 50, 1e-3);
    }
}

TEST(SpotLight, RefusesNonsense) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const SpotLight::Cone& cone :
         {SpotLight::Cone{0, 0}, SpotLight::Cone{-5, 0}, SpotLight::Cone{181, 5}, SpotLight::Cone{nan, 5},
          SpotLight::Cone{30, -1}, SpotLight::Cone{30, 31}, SpotLight::Cone{30, nan}})
        EXPECT_THROW(SpotLight(Transform(), one, cone), std::invalid_argument) << cone.angle << " " << cone.delta;
    EXPECT_THROW(SpotLight::create(Transform(), {one, 1, -1, V3d(1), V3d(1), {}}), std::invalid_argument);
}

TEST(DistantLight, SameEverywhereFromItsDirection) {
    const auto light = DistantLight::create(Transform(), {one, 2, 10, V3d(0, 3, 4), V3d(0, 0, 0)});
    for (const V3d& p : {V3d(0), V3d(1e4, -3, 2)}) {
        const auto sample = light->sample(p, V2f(), lambda);
        ASSERT_TRUE(sample);
        EXPECT_NEAR(value(sample), 20 / oneInNits, 1e-5);
        expectNear(toDouble(sample->wi), V3d(0, 0.6, 0.8), 1e-7);
        expectNear(sample->shadow.d, V3d(0, 0.6, 0.8), 1e-7);
        EXPECT_EQ(sample->shadow.tMax, infinityD);
        EXPECT_TRUE(sample->isDelta);
    }
    EXPECT_TRUE(light->escaped(V3f(0, 0.6f, 0.8f), lambda).isBlack());
    EXPECT_THROW(DistantLight::create(Transform(), {one, 1, -1, V3d(1), V3d(1)}), std::invalid_argument);
}

TEST(DistantLight, DefaultRunsAlongPlusZAndTurnsWithItsSpace) {
    const Transform quarterTurn(M44d(0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1)); // z to x
    EXPECT_EQ(DistantLight::create(Transform(), {one})->sample(V3d(0), V2f(), lambda)->wi, V3f(0, 0, -1));
    EXPECT_EQ(DistantLight::create(quarterTurn, {one})->sample(V3d(0), V2f(), lambda)->wi, V3f(-1, 0, 0));
}

TEST(DistantLight, PowerFallsOnTheScenesDisk) {
    DistantLight light(V3d(0, 0, 1), one);
    light.preprocess(V3d(1, 2, 3), 3);
    EXPECT_NEAR(light.power(lambda)[0], piD * 9, 1e-4);
}

} // namespace
} // namespace vitrine
