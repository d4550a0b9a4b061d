// Rays that lights emit carry the light that next-event estimation finds: the flux through a window, counted both ways.
#include "core/random.h"
#include "lights/constant_infinite_light.h"
#include "lights/distant_light.h"
#include "lights/image_infinite_light.h"
#include "lights/point_light.h"
#include "lights/spot_light.h"
#include "shapes/disk.h"
#include "shapes/sphere.h"
#include "support/estimate.h"

#include <gtest/gtest.h>

#include <functional>

namespace vitrine {
namespace {

using test::Estimate;

const SampledWavelengths lambda = SampledWavelengths::visible(0.3f);
const SpectrumPtr one = std::make_shared<ConstantSpectrum>(1.f);

struct Window {
    V3d corner, a, b; ///< what leaves through it on the side of a x b, which points away from the light
};

struct Case {
    const char* name;
    std::function<LightPtr()> light;
    std::vector<Window> windows;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

/// Signed by side: +1 through to the side of a x b, -1 back, 0 beside it.
int crossing(const Window& w, const Ray& ray) {
    const V3d n = w.a.cross(w.b);
    const double along = ray.d.dot(n);
    if (along == 0) return 0;
    const double s = (w.corner - ray.o).dot(n) / along;
    const V3d q = ray.at(s) - w.corner;
    const double u = q.dot(w.a) / w.a.length2(), v = q.dot(w.b) / w.b.length2();
    return s > 0 && u >= 0 && u < 1 && v >= 0 && v < 1 ? (along > 0 ? 1 : -1) : 0;
}

class Emission : public testing::TestWithParam<Case> {};

TEST_P(Emission, CarriesTheFluxThatLightSamplesFind) {
    const LightPtr light = GetParam().light();
    light->preprocess(V3d(0.5, 0.3, -0.2), 4);
    RandomStream random(701, 1);
    const auto number = [&] { return V2f(random.uniform(), random.uniform()); };
    for (const Window& w : GetParam().windows) {
        const V3d n = w.a.cross(w.b).normalized();
        const double area = w.a.cross(w.b).length();
        Estimate emitted, found;
        for (int i = 0; i < 200000; ++i) {
            const auto ray = light->emit(number(), number(), lambda);
            emitted.add(ray && crossing(w, ray->ray) > 0 ? double(ray->power[1]) : 0);
            const V3d p = w.corner + w.a * random.uniformDouble() + w.b * random.uniformDouble();
            const auto sample = light->sample(p, number(), lambda);
            const double cosine = sample ? -toDouble(sample->wi).dot(n) : 0;
            found.add(cosine > 0 ? double(sample->l[1] / sample->pdf) * cosine * area : 0);
        }
        EXPECT_GT(emitted.mean(), 0);
        EXPECT_LT(std::abs(emitted.mean() - found.mean()),
                  4.5 * std::sqrt(emitted.varianceOfMean() + found.varianceOfMean()))
            << emitted.mean() << " emitted, " << found.mean() << " found";
        EXPECT_LT(std::sqrt(emitted.varianceOfMean()), 0.05 * emitted.mean()) << "too few rays for a test";
    }
}

TEST_P(Emission, AddsUpToThePower) {
    const LightPtr light = GetParam().light();
    light->preprocess(V3d(0.5, 0.3, -0.2), 4);
    RandomStream random(701, 2);
    Estimate power;
    for (int i = 0; i < 100000; ++i) {
        const auto ray =
            light->emit(V2f(random.uniform(), random.uniform()), V2f(random.uniform(), random.uniform()), lambda);
        power.add(ray ? double(ray->power[2]) : 0);
        if (ray) {
            EXPECT_NEAR(ray->ray.d.length(), 1, 1e-6);
        }
    }
    const double expected = light->power(lambda)[2];
    EXPECT_NEAR(power.mean(), expected, 4.5 * std::sqrt(power.varianceOfMean()) + 1e-5 * expected);
}

Transform scaled(double x, double y, double z) {
    return Transform(M44d(x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0.3, 0.2, 0.1, 1));
}

LightPtr skyOfTwoColours() {
    Image image{16, 16, 3, {}};
    for (int i = 0; i < 256; ++i)
        for (int c = 0; c < 3; ++c)
            image.pixels.push_back(0.2f + 0.1f * float((i * 7 + i / 16 * 5) % 11));
    return ImageInfiniteLight::create(Transform(), image, {});
}

const std::vector<Window> around{{V3d(-1, -1, 2), V3d(2, 0, 0), V3d(0, 2, 0)},
                                 {V3d(1.5, -1, -1), V3d(0, 2, 0), V3d(0, 0, 2)}};
const std::vector<Window> ahead{{V3d(-1, -1, 2), V3d(2, 0, 0), V3d(0, 2, 0)}};

INSTANTIATE_TEST_SUITE_P(
    Lights, Emission,
    testing::Values(Case{"point", [] { return std::make_shared<PointLight>(V3d(0.1, 0, 0), one); }, around},
                    Case{"spot",
                         [] {
                             return std::make_shared<SpotLight>(scaled(1, 1, 1), one, SpotLight::Cone{50, 40});
                         },
                         ahead},
                    Case{"distant", [] { return std::make_shared<DistantLight>(V3d(-0.3, -0.4, -1), one); }, around},
                    Case{"sky", [] { return std::make_shared<ConstantInfiniteLight>(one); }, around},
                    Case{"image", [] { return skyOfTwoColours(); }, around},
                    Case{"disk",
                         [] {
                             return std::make_shared<AreaLight>(
                                 std::make_shared<Disk>(scaled(1, 1, 1), false, 0, 0.7, 0, 360), one, false);
                         },
                         ahead},
                    Case{"twosided",
                         [] {
                             return std::make_shared<AreaLight>(
                                 std::make_shared<Disk>(scaled(1, 1, 1), true, 0, 0.7, 0, 360), one, true);
                         },
                         ahead},
                    Case{"sphere",
                         [] {
                             return std::make_shared<AreaLight>(
                                 std::make_shared<Sphere>(scaled(1, 1, 1), false, 0.4, -0.4, 0.4, 360), one, false);
                         },
                         around}),
    [](const auto& c) { return std::string(c.param.name); });

TEST(SpotLight, EmitsWhatItShinesAlsoUnderScales) {
    // Its power is an estimate then; the flux is not.
    const SpotLight light(scaled(1, 2, 1.5), one, {50, 20});
    const Window window{V3d(-1, -1, 2), V3d(2, 0, 0), V3d(0, 2, 0)};
    RandomStream random(701, 3);
    Estimate emitted, found;
    for (int i = 0; i < 200000; ++i) {
        const auto ray = light.emit(V2f(), V2f(random.uniform(), random.uniform()), lambda);
        emitted.add(ray && crossing(window, ray->ray) > 0 ? double(ray->power[1]) : 0);
        const V3d p = window.corner + window.a * random.uniformDouble() + window.b * random.uniformDouble();
        const auto sample = light.sample(p, V2f(), lambda);
        found.add(sample ? double(sample->l[1] * -sample->wi.z) * 4 : 0);
    }
    EXPECT_LT(std::abs(emitted.mean() - found.mean()),
              4.5 * std::sqrt(emitted.varianceOfMean() + found.varianceOfMean()));
}

} // namespace
} // namespace vitrine
