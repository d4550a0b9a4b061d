#include "film/ssim.h"

#include "film/compare.h"

#include <array>

namespace vitrine {

namespace {

constexpr int window = 11;

/// The window's weights along one axis: Gaussian of standard deviation 1.5, of sum 1 (section III-B).
std::array<double, window> windowWeights() {
    std::array<double, window> weights;
    double sum = 0;
    for (int i = 0; i < window; ++i)
        sum += weights[std::size_t(i)] = std::exp(-sqr((i - window / 2) / 1.5) / 2);
    for (double& w : weights)
        w /= sum;
    return weights;
}

/// A plane of doubles and its windowed means, made one axis after the other.
struct Plane {
    int width, height;
    std::vector<double> values;

    double at(int x, int y) const { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }

    Plane windowMeans() const {
        static const auto weights = windowWeights();
        Plane rows{width - window + 1, height, {}};
        for (int y = 0; y < rows.height; ++y)
            for (int x = 0; x < rows.width; ++x) {
                double sum = 0;
                for (int i = 0; i < window; ++i)
                    sum += weights[std::size_t(i)] * at(x + i, y);
                rows.values.push_back(sum);
            }
        Plane means{rows.width, height - window + 1, {}};
        for (int y = 0; y < means.height; ++y)
            for (int x = 0; x < means.width; ++x) {
                double sum = 0;
                for (int i = 0; i < window; ++i)
                    sum += weights[std::size_t(i)] * rows.at(x, y + i);
                means.values.push_back(sum);
            }
        return means;
    }
};

template <class F>
Plane windowMeansOf(const Plane& a, const Plane& b, const F& f) {
    Plane plane{a.width, a.height, {}};
    for (std::size_t i = 0; i < a.values.size(); ++i)
        plane.values.push_back(f(a.values[i], b.values[i]));
    return plane.windowMeans();
}

Plane luminancePlane(const Image& image) {
    Plane plane{image.width, image.height, {}};
    for (std::size_t i = 0; i < std::size_t(image.width) * std::size_t(image.height); ++i)
        plane.values.push_back(double(luminance(image, i)));
    return plane;
}

} // namespace

std::optional<double> meanSsim(const Image& a, const Image& b, double range) {
    if (a.width < window || a.height < window) return std::nullopt;
    const Plane x = luminancePlane(a), y = luminancePlane(b);
    const Plane meanX = x.windowMeans(), meanY = y.windowMeans();
    const Plane meanXX = windowMeansOf(x, y, [](double p, double) { return p * p; });
    const Plane meanYY = windowMeansOf(x, y, [](double, double q) { return q * q; });
    const Plane meanXY = windowMeansOf(x, y, [](double p, double q) { return p * q; });

    const double c1 = sqr(0.01 * range), c2 = sqr(0.03 * range); // eq. 13 and below
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < meanX.values.size(); ++i) {
        const double mx = meanX.values[i], my = meanY.values[i];
        const double varianceX = meanXX.values[i] - mx * mx, varianceY = meanYY.values[i] - my * my;
        const double covariance = meanXY.values[i] - mx * my;
        const double similarity =
            (2 * mx * my + c1) * (2 * covariance + c2) / ((mx * mx + my * my + c1) * (varianceX + varianceY + c2));
        if (!std::isfinite(similarity)) continue; // a NaN or infinity lies in the window
        sum += similarity;
        ++count;
    }
    if (count == 0) return std::nullopt;
    return sum / double(count);
}

} // namespace vitrine
