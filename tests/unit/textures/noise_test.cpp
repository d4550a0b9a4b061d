#include "core/random.h"
#include "support/texture_points.h"
#include "textures/fbm.h"
#include "textures/noise.h"
#include "textures/windy.h"
#include "textures/wrinkled.h"

namespace vitrine {
namespace {

constexpr SpacePoint still(const V3d& p) {
    return {p};
}

/// pbrt-v4's answers in single precision: unfiltered with roughness 0.5; with roughness 0.6 for a footprint of 0.03 by 0.01.
struct Known {
    V3d p;
    float noise, fbm, filteredFbm, turbulence, filteredTurbulence;
};
const Known known[] = {
    {{0.300000012, 0.400000006, 0.699999988}, -0.0597669f, 0.01135266f, -0.010815322f, 0.29653367f, 0.4263868f},
    {{-1.25, 2.5999999, 0.100000001}, 0.12814653f, 0.096412778f, 0.069180235f, 0.18934214f, 0.26943478f},
    {{17.8999996, -3.0999999, 100.199997}, 0.066455558f, -0.1395606f, -0.16714269f, 0.40773752f, 0.56903851f},
    {{255.5, 256.75, -256.25}, -0.059418201f, 0.22604662f, 0.3356314f, 0.42385891f, 0.53678977f},
    {{1.10000002, 1.20000005, 1.29999995}, -0.15826839f, -0.37383556f, -0.46166512f, 0.38317847f, 0.54398704f},
    {{-0.00999999978, 0.0199999996, -0.0299999993},
     -0.040059846f,
     -0.16563104f,
     -0.20839506f,
     0.18025628f,
     0.29071701f}};

TEST(Noise, IsPbrts) {
    for (const Known& k : known) {
        // Single precision there: coordinates up to 256 times 1.99^7 are good to some 1e-3 in the finest octave, whose
        // amplitude is 0.5^7 and slope about 1.5.
        const double size = std::max(1., maxAbs(k.p));
        EXPECT_NEAR(noise(k.p), k.noise, 2e-7 * size + 3e-7);
        EXPECT_NEAR(fbm(still(k.p), Octaves(8, 0.5f)), k.fbm, 2e-6 * size);
        EXPECT_NEAR(turbulence(still(k.p), Octaves(8, 0.5f)), k.turbulence, 2e-6 * size);
        const SpacePoint seen{k.p, {0.03, 0, 0}, {0, 0.01, 0}};
        EXPECT_NEAR(fbm(seen, Octaves(8, 0.6f)), k.filteredFbm, 2e-6 * size);
        EXPECT_NEAR(turbulence(seen, Octaves(8, 0.6f)), k.filteredTurbulence, 2e-6 * size);
    }
}

TEST(Noise, IsZeroOnTheLatticeAndRepeats) {
    RandomStream random(3);
    for (int i = 0; i < 500; ++i) {
        const V3d lattice(std::floor(random.uniform(-500, 500)), std::floor(random.uniform(-500, 500)),
                          std::floor(random.uniform(-500, 500)));
        EXPECT_EQ(noise(lattice), 0);
        // Eighths are exact wherever they lie.
        const V3d p = lattice + V3d(0.125, 0.375, 0.75);
        EXPECT_EQ(noise(p), noise(p + V3d(256, -512, 1024)));
    }
}

TEST(Noise, IsBoundedAndContinuous) {
    RandomStream random(5);
    const double h = 1e-7;
    for (int i = 0; i < 5000; ++i) {
        V3d p(random.uniform(-300, 300), random.uniform(-300, 300), random.uniform(-300, 300));
        p[i % 3] = std::round(p[i % 3]); // on a face between two cubes
        EXPECT_LE(std::abs(noise(p)), 1.1f);
        V3d before = p, after = p;
        before[i % 3] -= h;
        after[i % 3] += h;
        EXPECT_NEAR(noise(before), noise(after), 2e-6);
    }
}

TEST(Noise, IsFiniteForEveryPoint) {
    for (const double x : {0., -0., 1e-320, -1e-20, 1e9, -1e17, 1e300})
        for (const double y : {0.5, -1e-20, 1e300}) {
            EXPECT_LE(std::abs(noise({x, y, x})), 2);
            EXPECT_TRUE(std::isfinite(fbm(still(V3d(x, y, 0.5)), Octaves(20, 0.5f))));
        }
}

TEST(Octaves, AreSoManyThatCoordinatesDoNotOverflow) {
    EXPECT_THROW(Octaves(-1, 0.5f), std::invalid_argument);
    EXPECT_THROW(Octaves(101, 0.5f), std::invalid_argument);
    EXPECT_TRUE(std::isfinite(fbm(still(V3d(1e38, -1e38, 3)), Octaves(100, 0.5f))));
}

TEST(Fbm, IsTheSumOfItsOctaves) {
    const V3d p(0.3, -1.7, 5.2);
    double sum = 0;
    for (int i = 0; i < 4; ++i)
        sum += std::pow(0.7, i) * noise(p * std::pow(1.99, i));
    EXPECT_NEAR(FbmTexture(TextureSpace(), Octaves(4, 0.7f)).evaluate(pointAt(p)), sum, 1e-6);
    EXPECT_EQ(fbm(still(p), Octaves(0, 0.7f)), 0);
    const Transform twice(M44d(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1));
    EXPECT_EQ(FbmTexture(TextureSpace(twice), Octaves(4, 0.7f)).evaluate(pointAt(p * 2.)),
              FbmTexture(TextureSpace(), Octaves(4, 0.7f)).evaluate(pointAt(p)));
}

TEST(Fbm, LosesTheOctavesThatTheFootprintHides) {
    const V3d p(0.3, -1.7, 5.2);
    const FbmTexture texture(TextureSpace(), Octaves(8, 0.5f));
    EXPECT_TRUE(texture.isFiltered());
    // log2: a footprint of 2^-(1+n) leaves n whole octaves.
    for (int n = 0; n <= 8; ++n)
        EXPECT_NEAR(texture.evaluate(pointAt(p, V3f(0, float(std::exp2(-1 - n)), 0))),
                    FbmTexture(TextureSpace(), Octaves(n, 0.5f)).evaluate(pointAt(p)), 1e-6);
    EXPECT_EQ(texture.evaluate(pointAt(p, V3f(1e30f))), 0);
    // Without jumps in between.
    float last = texture.evaluate(pointAt(p, V3f(1e-3f, 0, 0)));
    for (double size = 1e-3; size < 1; size *= 1.001) {
        const float value = texture.evaluate(pointAt(p, V3f(float(size), 0, 0)));
        EXPECT_NEAR(value, last, 0.01);
        last = value;
    }
}

TEST(Wrinkled, BecomesItsMeanFarAway) {
    const WrinkledTexture texture(TextureSpace(), Octaves(5, 0.5f));
    const V3d p(0.3, -1.7, 5.2);
    // pbrt-v4's sum: 0.2 for each octave, for the first of those that are not seen twice.
    const double far = 0.2 * (1 + 1 + 0.5 + 0.25 + 0.125 + 0.0625);
    EXPECT_NEAR(texture.evaluate(pointAt(p, V3f(10))), far, 1e-6);
    double sum = 0.2 * std::pow(0.5, 5);
    for (int i = 0; i < 5; ++i)
        sum += std::pow(0.5, i) * std::abs(noise(p * std::pow(1.99, i)));
    EXPECT_NEAR(texture.evaluate(pointAt(p)), sum, 1e-6);
}

TEST(Windy, IsWindTimesWaves) {
    const V3d p(3.3, -1.7, 5.2);
    const float expected = std::abs(fbm(still(p * 0.1), Octaves(3, 0.5f))) * fbm(still(p), Octaves(6, 0.5f));
    EXPECT_NEAR(WindyTexture(TextureSpace()).evaluate(pointAt(p)), expected, 1e-7);
    EXPECT_EQ(WindyTexture(TextureSpace()).evaluate(pointAt(p, V3f(1e6f))), 0);
}

} // namespace
} // namespace vitrine
