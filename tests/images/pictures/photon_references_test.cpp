// Photon mapping of the reference scenes against pictures made by pbrt-v4's path tracer (tests/images/references/README.md):
// that it comes to the same picture, and as fast as theory says.
#include "film/compare.h"
#include "photons/radius_schedule.h"
#include "reference_picture.h"
#include "support/estimate.h"
#include "support/long_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace vitrine {
namespace {

constexpr std::uint64_t counts[] = {8, 32, 128};
/// The references have twice as many pixels a side.
constexpr int side = 64;

/// A smaller reference: every pixel the mean of `factor` x `factor`.
ReferencePicture reduced(const ReferencePicture& full, int factor) {
    ReferencePicture small{full.width / factor, full.height / factor, {}, {}};
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const auto over = [&](auto&& at) {
                    return meanOf(x * factor, y * factor, (x + 1) * factor, (y + 1) * factor, at);
                };
                small.means.push_back(over([&](int i, int j) { return full.mean(i, j, c); }));
                small.variances.push_back(over([&](int i, int j) { return full.variance(i, j, c); }) /
                                          double(factor * factor));
            }
    return small;
}

/// Compares pictures with a reference where that can be judged.
class Judge {
  public:
    /// Leaves out pixels in which or beside which a lamp or its mirror image is seen: their edges are the eye paths' noise,
    /// a thousand times as strong as all other light. And one in 200 pixels, where fireflies fell into the reference.
    explicit Judge(const ReferencePicture& reference) : reference_(reference) {
        std::vector<std::pair<double, std::size_t>> noise;
        std::vector<V2i> candidates;
        for (int y = 0; y < reference.height; ++y)
            for (int x = 0; x < reference.width; ++x)
                if (!nearLamp(x, y)) {
                    double sum = 0;
                    for (int c = 0; c < 3; ++c)
                        sum += reference.variance(x, y, c) * weight(x, y, c);
                    noise.emplace_back(sum, candidates.size());
                    candidates.emplace_back(x, y);
                }
        std::sort(noise.begin(), noise.end());
        noise.resize(noise.size() - noise.size() / 200);
        for (const auto& [sum, i] : noise)
            pixels_.push_back(candidates[i]);
    }

    /// Mean of product(difference a, difference b) - the reference's variance, as parts of the reference as in relMSE. With
    /// a == b: relMSE without the reference's own noise. With independent a and b: their common squared error.
    double gap(const Image& a, const Image& b) const {
        return mean([&](int x, int y, int c) {
            const double m = reference_.mean(x, y, c);
            return ((double(a.at(x, y, c)) - m) * (double(b.at(x, y, c)) - m) - reference_.variance(x, y, c)) *
                   weight(x, y, c);
        });
    }
    /// Mean of a channel as a part of the reference's.
    double ratio(const Image& image, int channel) const {
        double ours = 0, theirs = 0;
        for (const V2i& p : pixels_) {
            ours += double(image.at(p.x, p.y, channel));
            theirs += reference_.mean(p.x, p.y, channel);
        }
        return ours / theirs;
    }
    /// Standard error of the reference's mean as a part of it.
    double referenceError(int channel) const {
        double variance = 0, theirs = 0;
        for (const V2i& p : pixels_) {
            variance += reference_.variance(p.x, p.y, channel);
            theirs += reference_.mean(p.x, p.y, channel);
        }
        return std::sqrt(variance) / theirs;
    }

  private:
    static constexpr double lamp = 4;

    bool nearLamp(int x, int y) const {
        for (int j = std::max(0, y - 1); j <= std::min(reference_.height - 1, y + 1); ++j)
            for (int i = std::max(0, x - 1); i <= std::min(reference_.width - 1, x + 1); ++i)
                for (int c = 0; c < 3; ++c)
                    if (reference_.mean(i, j, c) > lamp) return true;
        return false;
    }
    double weight(int x, int y, int c) const {
        const double m = reference_.mean(x, y, c);
        return 1 / (m * m + 0.01);
    }
    template <class At>
    double mean(At&& at) const {
        double sum = 0;
        for (const V2i& p : pixels_)
            for (int c = 0; c < 3; ++c)
                sum += at(p.x, p.y, c);
        return sum / double(3 * pixels_.size());
    }

    ReferencePicture reference_;
    std::vector<V2i> pixels_;
};

struct Method {
    const char* scene;
    const char* integrator;
    bool perPoint, directByPhotons;
    int hitPoints = 1;

    bool isPpm() const { return std::string(integrator) == "ppm"; }
};

std::string nameOf(const testing::TestParamInfo<Method>& info) {
    const Method& m = info.param;
    return fmt::format("{}_{}{}{}", m.scene, m.integrator, m.perPoint ? "PerPoint" : "",
                       m.directByPhotons ? "AllByPhotons" : "");
}

/// At half the references' size. \param photons a pass  \param radius in these larger pixels
Overrides overridesFor(const Method& method, std::uint64_t seed, int photons, double radius) {
    Overrides overrides;
    overrides.integrator = method.integrator;
    overrides.resolution = V2i(side, side);
    overrides.seed = seed;
    overrides.settings = {fmt::format("photonsperiteration={}", photons), fmt::format("radiuspixels={}", radius),
                          fmt::format("radiusrule={}", method.perPoint ? "perpoint" : "shared"),
                          fmt::format("directbyphotons={}", method.directByPhotons)};
    if (method.isPpm()) overrides.settings.push_back(fmt::format("hitpointsperpixel={}", method.hitPoints));
    return overrides;
}

/// Mean of the disks' radii over the passes of the shared rule, as a part of the first one's.
double meanFactor(std::uint64_t passes) {
    double sum = 0;
    for (std::uint64_t pass = 0; pass < passes; ++pass)
        sum += double(sharedRadiusFactor(pass, 2. / 3));
    return sum / double(passes);
}

/// Variance of the mean of so many passes, as a part of the first pass's: each has one inversely as its disks' area.
double varianceAfter(std::uint64_t passes) {
    double sum = 0;
    for (std::uint64_t pass = 0; pass < passes; ++pass)
        sum += std::pow(double(sharedRadiusFactor(pass, 2. / 3)), -2);
    return sum / double(passes * passes);
}

class PhotonReference : public testing::TestWithParam<Method> {};

// Knaus & Zwicker 2011, section 5: after N passes the variance falls as N^-alpha and the squared bias as N^(-2 (1 - alpha)),
// at alpha = 2/3 both as N^(-2/3). Light that needs no photons (direct light; what eye paths of a pixel differ by) falls as
// 1 / N. How far disks alone are from theory tests/statistical/scene/photon_disks_test.cpp measures; here are whole scenes.
TEST_P(PhotonReference, GapShrinksAsTheorySays) {
    const Method& method = GetParam();
    const Judge judge(reduced(readReference(method.scene), 2));
    // A quarter of the pixels, a quarter of the photons that the references' size would have, disks of its default size.
    const auto imagesOf = [&](std::uint64_t seed) {
        return renderReference(method.scene, overridesFor(method, seed, 4096, 1.5),
                               {std::begin(counts), std::end(counts)});
    };
    const std::vector<Image> a = imagesOf(1), b = imagesOf(2);
    std::vector<double> gap, theory;
    for (std::size_t i = 0; i < std::size(counts); ++i) {
        gap.push_back((judge.gap(a[i], a[i]) + judge.gap(b[i], b[i])) / 2);
        theory.push_back(varianceAfter(counts[i]));
    }
    // What the gap loses in one step over what it loses in the next does not know the floor that fixed eye paths leave.
    // Photons alone make it 2.6, what needs no photons 4; 3.6 when three quarters of the noise after the first count are
    // such: disks that do not shrink would make all of it 4. The figure itself is known to 5 %, so the lower end is three
    // times that lower.
    const double steps = (gap[0] - gap[1]) / (gap[1] - gap[2]);
    const double alone = (theory[0] - theory[1]) / (theory[1] - theory[2]);
    EXPECT_GT(steps, 0.85 * alone);
    EXPECT_LT(steps, 3.6);
    RecordProperty("gaps", fmt::format("{:.5f} {:.5f} {:.5f}", gap[0], gap[1], gap[2]));
    RecordProperty("steps", fmt::format("{:.3f}, photons alone {:.3f}", steps, alone));
    if (method.isPpm()) return;
    // New eye paths in each pass: no floor. At slowest as photons alone, again with 15 %.
    EXPECT_LT(gap[2] / gap[0], 1.15 * theory[2] / theory[0]);
    // Squared error that two independent pictures share: bias alone. A hundredth of what is left of the noise, and what the
    // product of two noises leaves by chance: a few 1e-4.
    const double common = judge.gap(a[2], b[2]);
    EXPECT_LT(std::abs(common), 1e-3);
    RecordProperty("common", fmt::format("{:.5f}", common));
}

INSTANTIATE_TEST_SUITE_P(Methods, PhotonReference,
                         testing::Values(Method{"box", "sppm", false, false}, Method{"box", "sppm", true, true},
                                         Method{"box", "ppm", false, true}, Method{"box", "ppm", true, false},
                                         Method{"caustic", "sppm", false, true}, Method{"caustic", "sppm", true, false},
                                         Method{"caustic", "ppm", false, false}, Method{"caustic", "ppm", true, true},
                                         Method{"dof", "sppm", false, false}, Method{"dof", "sppm", true, true},
                                         Method{"dof", "ppm", false, true}, Method{"dof", "ppm", true, false},
                                         Method{"goblet", "sppm", false, true}, Method{"goblet", "sppm", true, false},
                                         Method{"goblet", "ppm", false, false}, Method{"goblet", "ppm", true, true},
                                         Method{"vase", "sppm", false, false}, Method{"vase", "sppm", true, true},
                                         Method{"vase", "ppm", false, true}, Method{"vase", "ppm", true, false}),
                         nameOf);

class PhotonMeans : public testing::TestWithParam<Method> {};

TEST_P(PhotonMeans, AgreeWithinTheDisksLoss) {
    const Method& method = GetParam();
    const Judge judge(reduced(readReference(method.scene), 2));
    constexpr std::uint64_t passes = 32;
    constexpr double radius = 0.5;
    test::Estimate ratios[3];
    for (std::uint64_t seed = 1; seed <= std::uint64_t(8 * test::longRun()); ++seed) {
        const auto images = renderReference(method.scene, overridesFor(method, seed, 8192, radius), {passes});
        for (int c = 0; c < 3; ++c)
            ratios[c].add(judge.ratio(images.front(), c));
    }
    // Of light that falls beside an edge of two surfaces a disk of radius r loses half of the kernel's mean distance from
    // a line through its middle, 0.17 r, on both sides (Epanechnikov). The edges of the rooms are about four times as long
    // as the picture's side. By points disks shrink at most as fast, and not where they find nothing.
    const double meanRadius = radius * (method.perPoint ? 1 : meanFactor(passes));
    const double loss = 4 * 2 * 0.17 * meanRadius / side;
    for (int c = 0; c < 3; ++c) {
        const double error = std::sqrt(ratios[c].varianceOfMean() + sqr(judge.referenceError(c)));
        EXPECT_NEAR(ratios[c].mean(), 1, loss + 4 * error) << "channel " << c;
        EXPECT_LT(error, 0.004) << "too noisy for a test";
        RecordProperty("ratio" + std::to_string(c),
                       fmt::format("{:.4f} +- {:.4f}, loss up to {:.4f}", ratios[c].mean(), error, loss));
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, PhotonMeans,
                         testing::Values(Method{"box", "sppm", false, false}, Method{"dof", "sppm", false, true},
                                         Method{"goblet", "sppm", false, false}, Method{"vase", "sppm", false, true},
                                         Method{"caustic", "sppm", false, false}, Method{"caustic", "sppm", true, true},
                                         Method{"caustic", "ppm", false, false, 4}),
                         nameOf);

TEST(PhotonError, CausticAfter512Passes) {
    Overrides overrides;
    overrides.integrator = "sppm";
    overrides.seed = 1;
    overrides.settings = {"photonsperiteration=16384"};
    const ReferencePicture reference = readReference("caustic");
    const Image ours = renderReference("caustic", overrides, {512}).front();
    const auto imageOf = [&](const std::vector<double>& values) {
        return Image{reference.width, reference.height, 3, std::vector<float>(values.begin(), values.end())};
    };
    const Image variance = imageOf(reference.variances);
    const double error = compareImages(ours, imageOf(reference.means), &variance).relMse;
    // What issue 5 asks for, by the measure of `vitrine diff`.
    EXPECT_LT(error, 0.0015);
    RecordProperty("relMse", fmt::format("{:.5f}", error));
}

TEST(PpmFloor, FallsWithMoreHitPoints) {
    // Eye paths that stay leave the error of so many samples a pixel (the references' sampler is independent): as 1 / their
    // number. The rest, the photons' noise, is nearly the same for all.
    const Judge judge(reduced(readReference("box"), 2));
    double gap[3] = {0, 0, 0};
    for (int i = 0; i < 3; ++i)
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            const Method method{"box", "ppm", false, false, 1 << 2 * i};
            const Image image = renderReference("box", overridesFor(method, seed, 16384, 1.5), {16}).front();
            gap[i] += judge.gap(image, image) / 2;
        }
    RecordProperty("gaps", fmt::format("{:.5f} {:.5f} {:.5f}", gap[0], gap[1], gap[2]));
    // From 1 to 4 hit points three quarters of the floor go, from 4 to 16 three sixteenths. Each gap is known to about 4 %,
    // their smaller difference to 10 %: a band of three times that.
    const double steps = (gap[0] - gap[1]) / (gap[1] - gap[2]);
    EXPECT_GT(steps, 4 * 0.7);
    EXPECT_LT(steps, 4 / 0.7);
}

} // namespace
} // namespace vitrine
