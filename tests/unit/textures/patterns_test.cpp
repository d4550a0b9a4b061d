// Textures that choose between others, and those that stand alone.
#include "spectrum/colorspace.h"
#include "support/texture_points.h"
#include "textures/bilerp.h"
#include "textures/checkerboard.h"
#include "textures/constant.h"
#include "textures/direction_mix.h"
#include "textures/dots.h"
#include "textures/marble.h"
#include "textures/mix.h"
#include "textures/scale.h"

namespace vitrine {
namespace {

const MappingPtr uv = std::make_shared<UvMapping>();
const SampledWavelengths lambda = SampledWavelengths::uniform(0.3f);

SpectrumPtr ramp() {
    return std::make_shared<PiecewiseLinearSpectrum>(std::vector<float>{360, 830}, std::vector<float>{0, 0.94f});
}

SpectrumPtr flat(float value) {
    return std::make_shared<ConstantSpectrum>(value);
}

void expectNear(const SampledSpectrum& found, const SampledSpectrum& expected) {
    for (int i = 0; i < spectrumSamples; ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-6);
}

/// Fails the test when it is asked.
class Untouched final : public FloatTexture {
  public:
    float evaluate(const TexturePoint&) const override {
        ADD_FAILURE() << "a texture without weight was looked up";
        return 0;
    }
};

TEST(ConstantTexture, IsTheSameEverywhere) {
    EXPECT_EQ(ConstantTexture<FloatInput>(0.7f).evaluate(uvAt({3, -2})), 0.7f);
    expectNear(ConstantTexture<SpectrumInput>(ramp()).evaluate(uvAt({3, -2}), lambda), ramp()->sample(lambda));
    EXPECT_FALSE(ConstantTexture<FloatInput>(0.7f).isFiltered());
}

TEST(ScaleTexture, Multiplies) {
    const FloatTexturePtr half = std::make_shared<ConstantTexture<FloatInput>>(0.5f);
    EXPECT_EQ(ScaleTexture<FloatInput>(half, -3.f).evaluate({}), -1.5f);
    expectNear(ScaleTexture<SpectrumInput>(ramp(), half).evaluate({}, lambda), ramp()->sample(lambda) * 0.5f);
    EXPECT_EQ(ScaleTexture<FloatInput>(FloatTexturePtr(std::make_shared<Untouched>()), 0.f).evaluate({}), 0);
    EXPECT_TRUE(ScaleTexture<SpectrumInput>(ramp(), 0.f).evaluate({}, lambda).isBlack());
}

TEST(MixTexture, GoesFromOneToTheOther) {
    EXPECT_EQ(MixTexture<FloatInput>(2.f, 6.f, 0.25f).evaluate({}), 3);
    expectNear(MixTexture<SpectrumInput>(flat(1), ramp(), 0.25f).evaluate({}, lambda),
               SampledSpectrum(0.75f) + 0.25f * ramp()->sample(lambda));
    const FloatTexturePtr untouched = std::make_shared<Untouched>();
    EXPECT_EQ(MixTexture<FloatInput>(2.f, untouched, 0.f).evaluate({}), 2);
    EXPECT_EQ(MixTexture<FloatInput>(untouched, 6.f, 1.f).evaluate({}), 6);
    EXPECT_EQ(MixTexture<FloatInput>(2.f, 6.f, 1.5f).evaluate({}), 8) << "it goes on beyond, as in pbrt-v4";
}

TEST(MixTexture, IsFilteredWhenAnyPartIs) {
    const FloatTexturePtr squares = std::make_shared<SquaresWeight>(uv);
    EXPECT_FALSE(MixTexture<FloatInput>(1.f, 2.f, 0.5f).isFiltered());
    EXPECT_TRUE(MixTexture<FloatInput>(squares, 2.f, 0.5f).isFiltered());
    EXPECT_TRUE(MixTexture<FloatInput>(1.f, squares, 0.5f).isFiltered());
    EXPECT_TRUE(MixTexture<FloatInput>(1.f, 2.f, squares).isFiltered());
    EXPECT_TRUE(MixTexture<SpectrumInput>(ramp(), ramp(), squares).isFiltered());
    EXPECT_TRUE(ScaleTexture<SpectrumInput>(ramp(), squares).isFiltered());
    EXPECT_FALSE(ScaleTexture<SpectrumInput>(ramp(), 1.f).isFiltered());
}

TEST(DirectionWeight, IsTheAbsoluteCosine) {
    TexturePoint at;
    const auto share = [&](const V3f& ng, const V3d& direction, const Transform& worldFromTexture = {}) {
        at.ng = ng.normalized();
        return DirectionWeight(worldFromTexture, direction).evaluate(at);
    };
    EXPECT_NEAR(share({0, 1, 0}, {0, 5, 0}), 0, 1e-6);
    EXPECT_NEAR(share({0, -1, 0}, {0, 5, 0}), 0, 1e-6);
    EXPECT_NEAR(share({1, 0, 0}, {0, 5, 0}), 1, 1e-6);
    EXPECT_NEAR(share({0, 1, 1}, {0, 1, 0}), 1 - std::sqrt(0.5), 1e-6);
    const Transform quarter(M44d(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 7, 7, 7, 1)); // x -> y
    EXPECT_NEAR(share({0, 1, 0}, {1, 0, 0}, quarter), 0, 1e-6);
    EXPECT_THROW(DirectionWeight({}, {0, 0, 0}), std::invalid_argument);
}

TEST(BilerpTexture, MeetsItsCorners) {
    const BilerpTexture<FloatInput> texture(uv, {1.f, 2.f, 3.f, 8.f});
    EXPECT_EQ(texture.evaluate(uvAt({0, 0})), 1);
    EXPECT_EQ(texture.evaluate(uvAt({0, 1})), 2);
    EXPECT_EQ(texture.evaluate(uvAt({1, 0})), 3);
    EXPECT_EQ(texture.evaluate(uvAt({1, 1})), 8);
    EXPECT_NEAR(texture.evaluate(uvAt({0.25f, 0.5f})), 0.75 * 1.5 + 0.25 * 5.5, 1e-6);
    EXPECT_NEAR(texture.evaluate(uvAt({2, 0})), 5, 1e-6);
    EXPECT_FALSE(texture.isFiltered());
    const BilerpTexture<SpectrumInput> spectral(uv, {flat(0), flat(1), ramp(), ramp()});
    expectNear(spectral.evaluate(uvAt({0, 1}), lambda), SampledSpectrum(1.f));
    expectNear(spectral.evaluate(uvAt({0.5f, 0.5f}), lambda), SampledSpectrum(0.25f) + 0.5f * ramp()->sample(lambda));
}

/// Which cells around (s, t), s from -8 to 7 and t from -3 to 8, have a dot in pbrt-v4.
TEST(DotsWeight, HasPbrtsDots) {
    const char* rows[] = {"#.#.....#....#..", "#.#..##..##...#.", ".##.#..#.##...##", "..#..........#.#",
                          "#.##.#..#.......", "#..##..#######.#", "....#...#####..#", "...##.#...##.###",
                          "##..#..#.#######", "...#####.#.###.#", "#.#.##...#.....#", "..#.......#...##"};
    const DotsWeight weight(uv);
    for (int t = -3; t < 9; ++t)
        for (int s = -8; s < 8; ++s)
            EXPECT_EQ(weight.evaluate(uvAt({float(s), float(t)})), rows[t + 3][s + 8] == '#' ? 1 : 0) << s << " " << t;
}

TEST(DotsWeight, DotsAreDisksWithinTheirCells) {
    const DotsWeight weight(uv);
    // Around (0, 3): its area is that of a disk of radius 0.35, and nothing lies on the border of the cell.
    const int n = 1000;
    int inside = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            inside += weight.evaluate(uvAt({(float(i) + 0.5f) / n - 0.5f, (float(j) + 0.5f) / n + 2.5f})) == 1;
    // Squares of side 1/1000 cut by the circle: about 2.2 n of them, of random share.
    EXPECT_NEAR(double(inside) / (n * n), piD * 0.35 * 0.35, 2e-4);
    for (int i = 0; i < n; ++i)
        EXPECT_EQ(weight.evaluate(uvAt({-0.499999f, float(i) / n + 2.5f})), 0);
}

TEST(MarbleTexture, HasItsColours) {
    const auto colour = [&](double y, float variation = 0, float scale = 1) {
        return MarbleTexture(TextureSpace(), Octaves(8, 0.5f), scale, variation)
            .evaluate(pointAt({0.3, y, 0.7}), lambda);
    };
    const auto albedo = [&](float r, float g, float b) {
        return RgbAlbedoSpectrum(RgbColorSpace::srgb(), Rgb(r, g, b)).sample(lambda);
    };
    // sin(y) = -1, 1 and 0: the ends of the first and last curve, the beginning of the fourth. (The uplift's table is
    // smooth: single precision of the angle moves it by some 1e-6.)
    const SampledSpectrum ends = albedo(0.87f, 0.87f, 0.9f), middle = albedo(0.75f, 0.75f, 0.75f);
    for (int i = 0; i < spectrumSamples; ++i) {
        EXPECT_NEAR(colour(-piD / 2)[i], ends[i], 1e-4);
        EXPECT_NEAR(colour(piD / 2)[i], ends[i], 1e-4);
        EXPECT_NEAR(colour(0)[i], middle[i], 1e-4);
        EXPECT_NEAR(colour(piD / 4, 0, 2)[i], ends[i], 1e-4);
    }
    // Noise shifts the phase.
    const float shift = 3 * fbm(SpacePoint{V3d(0.3, 1.2, 0.7)}, Octaves(8, 0.5f));
    expectNear(
        colour(1.2, 3),
        MarbleTexture(TextureSpace(), Octaves(8, 0.5f), 1, 0).evaluate(pointAt({0, 1.2 + double(shift), 0}), lambda));
}

TEST(MarbleTexture, IsAReflectance) {
    const MarbleTexture marble(TextureSpace(), Octaves(8, 0.5f), 3, 1);
    for (int i = 0; i < 2000; ++i) {
        const SampledSpectrum s = marble.evaluate(pointAt({i * 0.011, i * 0.023, -i * 0.005}), lambda);
        EXPECT_GT(s.min(), 0.1f);
        EXPECT_LT(s.max(), 0.95f);
    }
}

} // namespace
} // namespace vitrine
