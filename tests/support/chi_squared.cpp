#include "support/chi_squared.h"

#include <fmt/format.h>

namespace vitrine::test {

namespace {

constexpr int gaussPoints = 5;
constexpr double gaussNodes[gaussPoints] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                            0.9061798459386640};
constexpr double gaussWeights[gaussPoints] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                              0.4786286704993665, 0.2369268850561891};
constexpr double absoluteTolerance = 2e-8, relativeTolerance = 1e-4;
constexpr int minDepth = 1, maxDepth = 10; // the least, so that a peak between the first nodes is not missed

using Plane = std::function<double(double, double)>;

double gauss(const Plane& f, const V2d& low, const V2d& high) {
    const V2d centre = (low + high) / 2, half = (high - low) / 2;
    double sum = 0;
    for (int i = 0; i < gaussPoints; ++i)
        for (int j = 0; j < gaussPoints; ++j)
            sum += gaussWeights[i] * gaussWeights[j] *
                   f(centre.x + half.x * gaussNodes[i], centre.y + half.y * gaussNodes[j]);
    return sum * half.x * half.y;
}

double refine(const Plane& f, const V2d& low, const V2d& high, double whole, int depth) {
    const V2d centre = (low + high) / 2;
    const V2d lows[4] = {low, V2d(centre.x, low.y), V2d(low.x, centre.y), centre};
    const V2d highs[4] = {centre, V2d(high.x, centre.y), V2d(centre.x, high.y), high};
    double parts[4], sum = 0;
    for (int i = 0; i < 4; ++i)
        sum += parts[i] = gauss(f, lows[i], highs[i]);
    const double tolerance = std::max(absoluteTolerance, relativeTolerance * std::abs(sum));
    const bool fine = depth >= minDepth && std::abs(sum - whole) <= tolerance;
    if (fine || depth == maxDepth || !std::isfinite(sum)) return sum;
    sum = 0;
    for (int i = 0; i < 4; ++i)
        sum += refine(f, lows[i], highs[i], parts[i], depth + 1);
    return sum;
}

/// Q(a, x) by its series below a + 1 and its continued fraction above (Abramowitz & Stegun 6.5.29, 6.5.31).
double upperGamma(double a, double x) {
    if (!(x > 0)) return 1;
    const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a, sum = term;
        for (int n = 1; n < 100000 && term > sum * 1e-16; ++n)
            sum += term *= x / (a + n);
        return std::max(0., 1 - scale * sum);
    }
    // Lentz's method.
    constexpr double tiny = 1e-300;
    double b = x + 1 - a, c = 1 / tiny, d = 1 / b, h = d;
    for (int n = 1; n < 100000; ++n) {
        const double an = -n * (n - a);
        b += 2;
        d = an * d + b;
        d = 1 / (std::abs(d) < tiny ? tiny : d);
        c = b + an / c;
        if (std::abs(c) < tiny) c = tiny;
        h *= d * c;
        if (std::abs(d * c - 1) < 1e-15) break;
    }
    return std::min(1., scale * h);
}

struct Cell {
    double expected;
    std::size_t observed;
};

/// P(X >= observed) of a Poisson variable.
double poissonTail(std::size_t observed, double mean) {
    return observed == 0 ? 1 : 1 - upperGamma(double(observed), mean);
}

/// Cells that expect fewer than minExpected become one; if that one is still small it joins the smallest of the others.
std::vector<Cell> merged(std::vector<Cell> cells, double minExpected) {
    std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.expected < b.expected; });
    std::vector<Cell> result;
    Cell pool{0, 0};
    for (const Cell& cell : cells) {
        if (pool.expected < minExpected || cell.expected < minExpected) {
            pool.expected += cell.expected;
            pool.observed += cell.observed;
        } else {
            result.push_back(cell);
        }
    }
    result.push_back(pool);
    return result;
}

ChiSquaredResult evaluate(const std::vector<Cell>& cells, ChiSquaredResult result, const ChiSquaredSettings& settings) {
    // Where next to nothing is expected Pearson's statistic hardly minds a sample: judged apart, by Poisson's law.
    double rareExpected = 0;
    std::size_t rareObserved = 0;
    for (const Cell& cell : cells) {
        if (cell.expected >= 1e-2) continue;
        rareExpected += cell.expected;
        rareObserved += cell.observed;
    }
    const double rounding = double(settings.samples) * 1e-6; // directions rounded to float may cross into such a cell
    const double rareP = poissonTail(rareObserved, rareExpected + rounding);

    const std::vector<Cell> kept = merged(cells, settings.minExpected);
    for (const Cell& cell : kept)
        if (cell.expected > 0) result.statistic += sqr(double(cell.observed) - cell.expected) / cell.expected;
    result.dof = int(kept.size()) - 1;
    const double p = chiSquaredPValue(result.statistic, result.dof);
    result.pValue = std::min(1., 2 * std::min(p, rareP)); // two tests: Bonferroni
    result.report = fmt::format("chi^2 {:.1f} with {} degrees of freedom, p {:.3g}; {} samples where {:.3g} were "
                                "expected in cells next to empty, p {:.3g}; mass {:.6f}, {} of {} draws missing",
                                result.statistic, result.dof, p, rareObserved, rareExpected, rareP, result.mass,
                                result.missing, settings.samples);
    return result;
}

/// The test on a rectangle. `place` maps a drawn sample to coordinates in it, empty for a failure.
ChiSquaredResult chiSquared(const std::function<std::optional<V2d>(RandomStream&)>& place, const Plane& pdf,
                            const V2d& low, const V2d& high, const ChiSquaredSettings& settings) {
    ChiSquaredResult result;
    const V2d size((high.x - low.x) / settings.columns, (high.y - low.y) / settings.rows);
    std::vector<Cell> cells;
    bool valid = true;
    const Plane checked = [&](double x, double y) {
        const double density = pdf(x, y);
        valid = valid && density >= 0 && std::isfinite(density);
        return density;
    };
    for (int row = 0; row < settings.rows; ++row)
        for (int column = 0; column < settings.columns; ++column) {
            const V2d corner(low.x + column * size.x, low.y + row * size.y);
            const double mass = integrateRectangle(checked, corner, corner + size);
            result.mass += mass;
            cells.push_back({mass * double(settings.samples), 0});
        }
    if (!valid || result.mass > 1 + 1e-3) {
        result.report = fmt::format("the density is negative, not finite, or too much: mass {:.6f}", result.mass);
        return result;
    }
    RandomStream random(settings.seed);
    for (std::size_t i = 0; i < settings.samples; ++i) {
        const std::optional<V2d> p = place(random);
        if (!p) {
            ++result.missing;
            continue;
        }
        if (!std::isfinite(p->x) || !std::isfinite(p->y)) {
            result.report = "a sample is not finite";
            return result;
        }
        const int column = std::clamp(int((p->x - low.x) / size.x), 0, settings.columns - 1);
        const int row = std::clamp(int((p->y - low.y) / size.y), 0, settings.rows - 1);
        ++cells[std::size_t(row * settings.columns + column)].observed;
    }
    cells.push_back({std::max(0., 1 - result.mass) * double(settings.samples), result.missing});
    return evaluate(cells, result, settings);
}

/// A density on the sphere as one over (phi, theta).
Plane overAngles(const SphereDensity& f) {
    return [&f](double phi, double theta) {
        const double r = std::sin(theta);
        return r * f(V3f(float(r * std::cos(phi)), float(r * std::sin(phi)), float(std::cos(theta))));
    };
}

} // namespace

double integrateRectangle(const Plane& f, const V2d& low, const V2d& high) {
    return refine(f, low, high, gauss(f, low, high), 0);
}

double integrateSphere(const SphereDensity& f, int rows, int columns) {
    const Plane plane = overAngles(f);
    const V2d size(2 * piD / columns, piD / rows);
    double sum = 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const V2d corner(column * size.x - piD, row * size.y);
            sum += integrateRectangle(plane, corner, corner + size);
        }
    return sum;
}

ChiSquaredResult chiSquaredSphere(const SphereSampler& sample, const SphereDensity& pdf,
                                  const ChiSquaredSettings& settings) {
    const auto place = [&](RandomStream& random) -> std::optional<V2d> {
        const std::optional<V3f> w = sample(random);
        if (!w) return {};
        return V2d(std::atan2(double(w->y), double(w->x)), std::atan2(std::hypot(w->x, w->y), double(w->z)));
    };
    return chiSquared(place, overAngles(pdf), V2d(-piD, 0), V2d(piD, piD), settings);
}

ChiSquaredResult chiSquaredSquare(const SquareSampler& sample, const SquareDensity& pdf,
                                  const ChiSquaredSettings& settings) {
    const auto place = [&](RandomStream& random) -> std::optional<V2d> {
        const std::optional<V2f> p = sample(random);
        if (!p) return {};
        return V2d(p->x, p->y);
    };
    return chiSquared(
        place, [&](double x, double y) { return pdf(V2f(float(x), float(y))); }, V2d(0, 0), V2d(1, 1), settings);
}

double chiSquaredPValue(double statistic, int dof) {
    if (dof <= 0) return 1;
    return upperGamma(dof / 2., statistic / 2);
}

double sidakThreshold(double significance, int tests) {
    return -std::expm1(std::log1p(-significance) / tests);
}

double normalPValue(double z) {
    return std::erfc(std::abs(z) / std::sqrt(2.));
}

} // namespace vitrine::test
