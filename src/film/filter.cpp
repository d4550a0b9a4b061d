#include "film/filter.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace vitrine {

namespace {

double gaussian(double x, double sigma) {
    return std::exp(-sqr(x / sigma) / 2) / (std::sqrt(2 * piD) * sigma);
}

double sinc(double x) {
    const double t = piD * x;
    return std::abs(t) < 1e-5 ? 1 - t * t / 6 : std::sin(t) / t;
}

/// Mitchell & Netravali 1988, eq. 8, on [-2, 2].
double mitchell(double x, double b, double c) {
    x = std::abs(x);
    if (x >= 2) return 0;
    if (x >= 1) return (((-b - 6 * c) * x + (6 * b + 30 * c)) * x + (-12 * b - 48 * c)) * x / 6 + (8 * b + 24 * c) / 6;
    return ((12 - 9 * b - 6 * c) * x + (-18 + 12 * b + 6 * c)) * x * x / 6 + (6 - 2 * b) / 6;
}

template <class F>
double gaussLegendre5(double begin, double end, const F& f) {
    const double middle = (begin + end) / 2, half = (end - begin) / 2;
    double sum = 128. / 225 * f(middle);
    constexpr double inner = 0.53846931010568309104, outer = 0.90617984593866399280;
    sum += 0.47862867049936646804 * (f(middle - half * inner) + f(middle + half * inner));
    sum += 0.23692688505618908751 * (f(middle - half * outer) + f(middle + half * outer));
    return half * sum;
}

void require(bool condition, const char* message) {
    if (!condition) throw std::invalid_argument(message);
}

void check(const Filter::Settings& s) {
    for (float r : {s.radius.x, s.radius.y})
        require(r > 0 && r <= Filter::maxRadius, "a pixel filter's radius must be above 0 and at most 1000 pixels");
    switch (s.kind) {
    case FilterKind::Gaussian:
        require(s.sigma > 0 && std::isfinite(s.sigma), "the gaussian filter's sigma must be positive and finite");
        // With a wider one rounding eats what is left after subtracting the value at the radius.
        require(s.sigma <= 1000 * std::min(s.radius.x, s.radius.y),
                "the gaussian filter is flat within its radius: its sigma is too large");
        break;
    case FilterKind::Mitchell:
        require(std::abs(s.b) <= 1000 && std::abs(s.c) <= 1000,
                "the mitchell filter's B and C must be from -1000 to 1000");
        break;
    case FilterKind::Sinc:
        require(s.tau > 0 && std::isfinite(s.tau), "the sinc filter's tau must be positive and finite");
        break;
    case FilterKind::Box:
    case FilterKind::Triangle:
        break;
    }
}

} // namespace

Filter::Settings Filter::Settings::defaults(FilterKind kind) {
    Settings settings;
    settings.kind = kind;
    const float radius = kind == FilterKind::Box        ? 0.5f
                         : kind == FilterKind::Gaussian ? 1.5f
                         : kind == FilterKind::Sinc     ? 4
                                                        : 2;
    settings.radius = V2f(radius);
    return settings;
}

Filter::Filter(const Settings& settings) : settings_(settings) {
    check(settings_);
    x_ = makeAxis(settings_.radius.x);
    y_ = makeAxis(settings_.radius.y);
}

Filter::Axis Filter::makeAxis(double radius) const {
    Axis axis;
    if (settings_.kind == FilterKind::Box) {
        axis.integral = 2 * radius;
        return axis;
    }
    if (settings_.kind == FilterKind::Triangle) {
        axis.integral = sqr(radius);
        return axis;
    }
    // A multiple of four: mitchell's pieces join at cell borders.
    const int count = std::clamp(4 * int(std::ceil(8 * radius)), 32, 4096);
    const double width = 2 * radius / count;
    std::vector<double> integrals;
    double absSum = 0;
    for (int i = 0; i < count; ++i) {
        // The left half is made as the mirror image of the right one, so that no rounding shifts the picture.
        const int right = std::max(i, count - 1 - i) - count / 2;
        integrals.push_back(cellIntegral(right * width, (right + 1) * width, radius));
        absSum += std::abs(integrals.back());
    }
    axis.integral = std::accumulate(integrals.begin(), integrals.end(), 0.);
    require(axis.integral > 1e-6 * absSum, "the pixel filter's integral is not positive");

    double cdf = 0;
    for (int i = 0; i < count; ++i) {
        const double integral = integrals[std::size_t(i)], probability = std::abs(integral) / absSum;
        if (probability == 0) continue;
        const double weight = std::copysign(absSum / axis.integral, integral);
        axis.cells.push_back({cdf, -radius + i * width, width / probability, float(weight)});
        cdf += probability;
    }
    axis.guide.resize(std::size_t(2 * count));
    std::size_t cell = 0;
    for (std::size_t slice = 0; slice < axis.guide.size(); ++slice) {
        const double u = double(slice) / double(axis.guide.size());
        while (cell + 1 < axis.cells.size() && axis.cells[cell + 1].cdf <= u)
            ++cell;
        axis.guide[slice] = int(cell);
    }
    return axis;
}

double Filter::cellIntegral(double begin, double end, double radius) const {
    if (settings_.kind == FilterKind::Gaussian) {
        const double scale = settings_.sigma * std::sqrt(2.);
        const double whole = (std::erfc(begin / scale) - std::erfc(end / scale)) / 2;
        return std::max(0., whole - (end - begin) * gaussian(radius, settings_.sigma));
    }
    // Pieces short against the waves of a windowed sinc.
    const double wave = settings_.kind == FilterKind::Sinc ? std::min(1.f, settings_.tau) : 1.;
    const int pieces = std::clamp(int(std::ceil(4 * (end - begin) / wave)), 1, 64);
    double sum = 0;
    for (int i = 0; i < pieces; ++i) {
        const double width = (end - begin) / pieces, low = begin + i * width;
        sum += gaussLegendre5(low, low + width, [&](double x) { return factor(x, radius); });
    }
    return sum;
}

double Filter::factor(double x, double radius) const {
    if (!(std::abs(x) <= radius)) return 0;
    switch (settings_.kind) {
    case FilterKind::Box:
        return 1;
    case FilterKind::Triangle:
        return radius - std::abs(x);
    case FilterKind::Gaussian:
        return std::max(0., gaussian(x, settings_.sigma) - gaussian(radius, settings_.sigma));
    case FilterKind::Mitchell:
        return mitchell(2 * x / radius, settings_.b, settings_.c);
    case FilterKind::Sinc:
        return sinc(x) * sinc(x / settings_.tau);
    }
    return 0;
}

float Filter::operator()(const V2f& p) const {
    return float(factor(p.x, settings_.radius.x) * factor(p.y, settings_.radius.y) / (x_.integral * y_.integral));
}

Filter::Offset Filter::sampleAxis(const Axis& axis, float radius, float u) const {
    switch (settings_.kind) {
    case FilterKind::Box:
        return {radius * (2 * u - 1), 1};
    case FilterKind::Triangle:
        return {u < 0.5f ? radius * (std::sqrt(2 * u) - 1) : radius * (1 - std::sqrt(2 * (1 - u))), 1};
    default:
        break;
    }
    auto cell = std::size_t(axis.guide[std::size_t(u * float(axis.guide.size()))]);
    while (cell + 1 < axis.cells.size() && axis.cells[cell + 1].cdf <= double(u))
        ++cell;
    const Cell& c = axis.cells[cell];
    return {std::clamp(float(c.left + c.scale * (double(u) - c.cdf)), -radius, radius), c.weight};
}

Filter::Sample Filter::sample(const V2f& u) const {
    const Offset x = sampleAxis(x_, settings_.radius.x, u.x), y = sampleAxis(y_, settings_.radius.y, u.y);
    return {V2f(x.x, y.x), x.weight * y.weight};
}

} // namespace vitrine
