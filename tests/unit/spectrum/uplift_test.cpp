// RGB to spectrum and back, the optimiser behind it, and its table.
#include "core/random.h"
#include "spectrum/colorspace.h"
#include "spectrum/uplift_solver.h"
#include "spectrum/uplift_table.h"

namespace vitrine {
namespace {

/// The colour of a reflectance under the space's white.
Rgb colourOf(const RgbColorSpace& space, const SigmoidPolynomial& p) {
    V3d xyz(0);
    for (int i = 0; i <= 470; ++i) {
        const float lambda = 360 + float(i);
        const double light = double(p(lambda)) * double(space.illuminant()(lambda)) / double(cieYIntegral);
        xyz += V3d(cieX()(lambda), cieY()(lambda), cieZ()(lambda)) * light;
    }
    return space.fromXyz(toFloat(xyz));
}

float worstComponent(const Rgb& a, const Rgb& b) {
    const Rgb d = a - b;
    return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
}

TEST(Uplift, GreysAreExactlyConstant) {
    for (const auto* name : {"srgb", "rec2020", "aces2065-1", "dci-p3"})
        for (const float v : {0.f, 1e-6f, 0.001f, 0.18f, 0.5f, 0.73f, 0.999f, 1.f}) {
            const SigmoidPolynomial p = RgbColorSpace::named(name)->sigmoid(Rgb(v));
            for (const float lambda : {360.f, 555.f, 830.f})
                if (v == 0 || v == 0.5f || v == 1)
                    EXPECT_EQ(p(lambda), v);
                else
                    EXPECT_NEAR(p(lambda) / v, 1, 1e-6f) << v;
        }
}

TEST(Uplift, ComponentsAreClampedToTheUnitInterval) {
    const RgbColorSpace& srgb = RgbColorSpace::srgb();
    const auto expectSame = [&](const Rgb& a, const Rgb& b) {
        const SigmoidPolynomial p = srgb.sigmoid(a), q = srgb.sigmoid(b);
        EXPECT_TRUE(p.c0 == q.c0 && p.c1 == q.c1 && p.c2 == q.c2) << a << " " << b;
    };
    expectSame(Rgb(2, 0.5f, 0.25f), Rgb(1, 0.5f, 0.25f));
    expectSame(Rgb(-1, 0.5f, 0.25f), Rgb(0, 0.5f, 0.25f));
    expectSame(Rgb(7, 8, 9), Rgb(1));
    expectSame(Rgb(NAN, 0.5f, 0.25f), Rgb(0, 0.5f, 0.25f));
    expectSame(Rgb(infinity, 0.5f, -infinity), Rgb(1, 0.5f, 0));
}

TEST(Uplift, SrgbColoursComeBack) {
    const RgbColorSpace& srgb = RgbColorSpace::srgb();
    double sum = 0;
    int count = 0;
    constexpr int n = 15; // not a divisor of the table's grid: most colours fall between its nodes
    for (int r = 0; r <= n; ++r)
        for (int g = 0; g <= n; ++g)
            for (int b = 0; b <= n; ++b) {
                const Rgb rgb = Rgb(float(r), float(g), float(b)) / float(n);
                const float error = worstComponent(colourOf(srgb, srgb.sigmoid(rgb)), rgb);
                ASSERT_LT(error, 2e-3f) << rgb;
                sum += double(error);
                ++count;
            }
    EXPECT_LT(sum / count, 5e-4);
}

TEST(Uplift, DarkAndNearlyWhiteSrgbColoursComeBack) {
    const RgbColorSpace& srgb = RgbColorSpace::srgb();
    RandomStream random(1);
    for (int i = 0; i < 2000; ++i) {
        const float scale = std::pow(10.f, -4 * random.uniform());
        Rgb dark(random.uniform(), random.uniform(), random.uniform());
        dark[i % 3] = 0; // fully saturated
        EXPECT_LT(worstComponent(colourOf(srgb, srgb.sigmoid(dark * scale)), dark * scale), 2e-3f) << dark * scale;
        // Between the last nodes the coefficients turn quickly, and interpolation costs a hundredth or two.
        const Rgb light = Rgb(1) - Rgb(random.uniform(), random.uniform(), random.uniform()) * scale;
        EXPECT_LT(worstComponent(colourOf(srgb, srgb.sigmoid(light)), light), 2e-2f) << light;
    }
}

TEST(Uplift, ReflectancesLieInTheUnitInterval) {
    RandomStream random(2);
    for (const auto* name : {"srgb", "rec2020", "aces2065-1", "dci-p3"}) {
        const RgbColorSpace& space = *RgbColorSpace::named(name);
        for (int i = 0; i < 300; ++i) {
            Rgb rgb(random.uniform(), random.uniform(), random.uniform());
            if (i % 3 == 0) rgb[i % 2] = 0;
            if (i % 5 == 0) rgb[2] = 1;
            const SigmoidPolynomial p = space.sigmoid(rgb);
            for (float lambda = 360; lambda <= 830; lambda += 5) {
                ASSERT_GE(p(lambda), 0) << name << rgb;
                ASSERT_LE(p(lambda), 1) << name << rgb;
            }
        }
    }
}

TEST(Uplift, NeighbouringColoursHaveNeighbouringSpectra) {
    const RgbColorSpace& srgb = RgbColorSpace::srgb();
    RandomStream random(3);
    for (int line = 0; line < 50; ++line) {
        // Inside the gamut, where no coefficient is large: along straight lines, through nodes and changes of the largest
        // component, but not through grey, where the table gives way to the exact constant.
        Rgb a, b;
        for (int k = 0; k < 3; ++k) {
            a[k] = 0.05f + 0.9f * random.uniform();
            b[k] = 0.05f + 0.9f * random.uniform();
        }
        constexpr int steps = 400;
        SigmoidPolynomial last = srgb.sigmoid(a);
        for (int i = 1; i <= steps; ++i) {
            const Rgb rgb = a + (b - a) * (float(i) / steps);
            const SigmoidPolynomial next = srgb.sigmoid(rgb);
            for (float lambda = 400; lambda <= 700; lambda += 20)
                ASSERT_NEAR(next(lambda), last(lambda), 15 * (b - a).length() / steps + 1e-4f) << rgb << " " << lambda;
            last = next;
        }
    }
}

TEST(Uplift, BrighterColoursHaveMoreLuminance) {
    const RgbColorSpace& srgb = RgbColorSpace::srgb();
    RandomStream random(4);
    for (int line = 0; line < 50; ++line) {
        Rgb hue(random.uniform(), random.uniform(), random.uniform());
        hue /= std::max({hue.x, hue.y, hue.z});
        double last = -1;
        for (int i = 0; i <= 100; ++i) {
            const RgbAlbedoSpectrum s(srgb, hue * (float(i) / 100));
            double luminance = 0;
            for (int lambda = 360; lambda <= 830; lambda += 2)
                luminance += double(s(float(lambda)) * srgb.illuminant()(float(lambda)) * cieY()(float(lambda)));
            ASSERT_GT(luminance, last) << hue << " " << i;
            last = luminance;
        }
    }
}

TEST(Uplift, TableAgreesWithPbrts) {
    // Coefficients out of the table that pbrt-v4's rgb2spec_opt computes (64^3, sRGB), at [largest][z][y][x].
    const struct {
        int largest, z, y, x;
        SigmoidPolynomial polynomial;
    } cells[] = {{0, 32, 10, 50, {-6.22507869e-05f, 0.0739397481f, -21.9662304f}},
                 {0, 20, 60, 3, {0.000203334013f, -0.218698874f, 55.7924957f}},
                 {0, 50, 30, 30, {8.67445779e-05f, -0.0861709788f, 21.1442051f}},
                 {0, 63, 20, 20, {0.000119245757f, -0.118534818f, 28.8057079f}},
                 {1, 16, 5, 40, {-0.000168819708f, 0.173811793f, -46.3177071f}},
                 {1, 32, 63, 0, {-0.000174270041f, 0.199826881f, -57.0297279f}},
                 {1, 45, 22, 41, {-0.00015660486f, 0.164358616f, -42.0109138f}},
                 {1, 56, 50, 9, {-0.000264794478f, 0.298252434f, -81.9281082f}},
                 {2, 24, 0, 63, {0.00021851575f, -0.234811112f, 60.5244598f}},
                 {2, 32, 1, 1, {-0.000129394844f, 0.0985630825f, -18.1269016f}},
                 {2, 40, 33, 60, {0.000102773272f, -0.111130707f, 29.8711071f}},
                 {2, 58, 61, 59, {0.000260067347f, -0.311662883f, 95.2393265f}}};
    for (const auto& cell : cells) {
        const float* const c = UpliftTable::srgb().coefficients[cell.largest][cell.z][cell.y][cell.x];
        const SigmoidPolynomial ours{c[0], c[1], c[2]};
        for (float lambda = 360; lambda <= 830; lambda += 5)
            ASSERT_NEAR(ours(lambda), cell.polynomial(lambda), 5e-5f)
                << cell.largest << " " << cell.z << ", " << lambda;
    }
}

TEST(Uplift, TableHoldsAtItsNodes) {
    const UpliftTable& table = UpliftTable::srgb();
    EXPECT_EQ(table.nodes[0], 0);
    EXPECT_EQ(table.nodes[63], 1);
    for (int k = 1; k < 64; ++k)
        EXPECT_GT(table.nodes[k], table.nodes[k - 1]);
    RandomStream random(5);
    for (int i = 0; i < 2000; ++i) {
        const auto pick = [&](int n) { return int(random.uniform(0, n)); };
        const int largest = pick(3), k = pick(64), j = pick(64), l = pick(64);
        const float* const c = table.coefficients[largest][k][j][l];
        Rgb rgb;
        rgb[largest] = table.nodes[k];
        rgb[(largest + 1) % 3] = table.nodes[k] * float(l) / 63;
        rgb[(largest + 2) % 3] = table.nodes[k] * float(j) / 63;
        const Rgb found = colourOf(RgbColorSpace::srgb(), {c[0], c[1], c[2]});
        // The optimiser's matrix of six digits and 5 nm tables against the renderer's sums.
        ASSERT_LT(worstComponent(found, rgb), 1.5e-3f) << rgb;
    }
}

/// Mixtures of reflectances are reflectances: colours that certainly can be reached, in any space.
TEST(Uplift, ColoursOfRealReflectancesAreReachedInWideGamuts) {
    RandomStream random(6);
    for (const auto* name : {"rec2020", "aces2065-1", "dci-p3"}) {
        const RgbColorSpace& space = *RgbColorSpace::named(name);
        for (int i = 0; i < 200; ++i) {
            // Reflectances of sRGB colours, seen in the wide space.
            const Rgb narrow(random.uniform(), random.uniform(), random.uniform());
            const Rgb wide = colourOf(space, RgbColorSpace::srgb().sigmoid(narrow));
            if (std::min({wide.x, wide.y, wide.z}) < 0) continue;
            ASSERT_LT(worstComponent(colourOf(space, space.sigmoid(wide)), wide), 1e-3f) << name << wide;
        }
    }
}

TEST(Uplift, ColoursThatNoReflectanceHasGetTheNearest) {
    // The primaries of wide gamuts: too pure to be so bright. The result keeps the hue's largest and smallest component.
    for (const auto* name : {"rec2020", "aces2065-1"})
        for (int i = 0; i < 3; ++i) {
            Rgb primary(0);
            primary[i] = 1;
            const RgbColorSpace& space = *RgbColorSpace::named(name);
            const Rgb found = colourOf(space, space.sigmoid(primary));
            EXPECT_TRUE(found[i] > found[(i + 1) % 3] && found[i] > found[(i + 2) % 3]) << name << found;
        }
}

TEST(UpliftSolver, ReachesSrgbColoursFromGrey) {
    std::vector<float> power;
    for (int lambda = 360; lambda <= 830; lambda += 5)
        power.push_back((*namedSpectrum("stdillum-D65"))(float(lambda)));
    const UpliftSolver solver(
        {{{0.412453, 0.357580, 0.180423}, {0.212671, 0.715160, 0.072169}, {0.019334, 0.119193, 0.950227}}}, power);
    RandomStream random(7);
    for (int i = 0; i < 500; ++i) {
        const UpliftSolver::Triple rgb{random.uniform(0, 0.98), random.uniform(0, 0.98), random.uniform(0, 0.98)};
        auto coefficients = solver.solve(rgb);
        const auto before = coefficients;
        EXPECT_LT(solver.improve(rgb, coefficients), 1e-6) << rgb[0] << " " << rgb[1] << " " << rgb[2];
        // It had converged: a further call moves nothing visible.
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(coefficients[k], before[k], 1e-4 * (1 + std::abs(before[k])));
    }
}

} // namespace
} // namespace vitrine
