#include "spectrum/colorspace.h"

#include "spectrum/uplift_solver.h"
#include "spectrum/uplift_table.h"

#include <ImathMatrix.h>

#include <cctype>
#include <optional>

namespace vitrine {

namespace {

using Imath::M33d;

std::string lowerCase(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        c = char(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

/// XYZ of luminance 1 with the chromaticity xy.
V3d xyzOf(const V2f& xy) {
    const double x = double(xy.x), y = double(xy.y);
    return V3d(x / y, 1, (1 - x - y) / y);
}

V3d xyzOf(const Spectrum& spectrum) {
    return V3d(innerProduct(cieX(), spectrum), innerProduct(cieY(), spectrum), innerProduct(cieZ(), spectrum)) /
           double(cieYIntegral);
}

/// Row vectors: xyz = rgb M. The rows are the primaries, scaled so that 1, 1, 1 gives `white`.
M33d xyzFromRgb(const V2f& red, const V2f& green, const V2f& blue, const V3d& white) {
    const V3d r = xyzOf(red), g = xyzOf(green), b = xyzOf(blue);
    const M33d primaries(r.x, r.y, r.z, g.x, g.y, g.z, b.x, b.y, b.z);
    const V3d scale = white * primaries.inverse();
    return M33d(scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z) * primaries;
}

UpliftSolver makeSolver(const M33d& xyzFromRgb, const DenseSpectrum& illuminant) {
    UpliftSolver::Matrix matrix;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            matrix[std::size_t(row)][std::size_t(column)] = xyzFromRgb[column][row];
    std::vector<float> power;
    for (int lambda = 360; lambda <= 830; lambda += 5)
        power.push_back(illuminant(float(lambda)));
    return UpliftSolver(matrix, power);
}

/// Trilinear in the coefficients, as pbrt-v4. Components in [0,1], not all equal.
SigmoidPolynomial lookUp(const UpliftTable& table, const Rgb& rgb) {
    constexpr int resolution = UpliftTable::resolution;
    const int largest = rgb.x > rgb.y ? (rgb.x > rgb.z ? 0 : 2) : (rgb.y > rgb.z ? 1 : 2);
    const float z = rgb[largest];
    const float x = rgb[(largest + 1) % 3] * (resolution - 1) / z;
    const float y = rgb[(largest + 2) % 3] * (resolution - 1) / z;

    const float* const above = std::lower_bound(table.nodes, table.nodes + resolution, z);
    const int k = std::clamp(int(above - table.nodes) - 1, 0, resolution - 2);
    const int i = std::min(int(x), resolution - 2), j = std::min(int(y), resolution - 2);
    const float dx = x - float(i), dy = y - float(j);
    const float dz = (z - table.nodes[k]) / (table.nodes[k + 1] - table.nodes[k]);

    float c[3];
    for (int n = 0; n < 3; ++n) {
        const auto alongX = [&](int kk, int jj) {
            const auto& row = table.coefficients[largest][kk][jj];
            return lerp(dx, row[i][n], row[i + 1][n]);
        };
        c[n] = lerp(dz, lerp(dy, alongX(k, j), alongX(k, j + 1)), lerp(dy, alongX(k + 1, j), alongX(k + 1, j + 1)));
    }
    return {c[0], c[1], c[2]};
}

Rgb multiply(const V3f& v, const M33d& m) {
    return toFloat(toDouble(v) * m);
}

} // namespace

struct RgbColorSpace::Data {
    std::string name;
    DenseSpectrum illuminant;
    std::array<V2f, 4> chromaticities;
    M33d xyzFromRgb, rgbFromXyz;
    std::optional<UpliftSolver> solver; ///< for the spaces without a table

    Data(std::string spaceName, V2f red, V2f green, V2f blue, const char* white, bool hasTable)
        : name(std::move(spaceName)), illuminant(*namedSpectrum(white)) {
        const V3d whiteXyz = xyzOf(illuminant);
        const double sum = whiteXyz.x + whiteXyz.y + whiteXyz.z;
        chromaticities = {red, green, blue, V2f(float(whiteXyz.x / sum), float(whiteXyz.y / sum))};
        xyzFromRgb = vitrine::xyzFromRgb(red, green, blue, whiteXyz);
        rgbFromXyz = xyzFromRgb.inverse();
        if (!hasTable) solver = makeSolver(xyzFromRgb, illuminant);
    }
};

/// The spaces that scene files can name.
struct RgbColorSpaces {
    // ITU-R BT.709; SMPTE RP 431-2 primaries with the white of displays; ITU-R BT.2020; SMPTE ST 2065-1.
    RgbColorSpace::Data data[4] = {
        {"srgb", V2f(.64f, .33f), V2f(.3f, .6f), V2f(.15f, .06f), "stdillum-D65", true},
        {"dci-p3", V2f(.68f, .32f), V2f(.265f, .690f), V2f(.15f, .06f), "stdillum-D65", false},
        {"rec2020", V2f(.708f, .292f), V2f(.170f, .797f), V2f(.131f, .046f), "stdillum-D65", false},
        {"aces2065-1", V2f(.7347f, .2653f), V2f(0, 1), V2f(.0001f, -.077f), "illum-acesD60", false}};
    RgbColorSpace spaces[4] = {RgbColorSpace(data[0]), RgbColorSpace(data[1]), RgbColorSpace(data[2]),
                               RgbColorSpace(data[3])};

    static const RgbColorSpaces& all() {
        static const RgbColorSpaces instance;
        return instance;
    }
};

float SigmoidPolynomial::maxValue() const {
    float result = std::max((*this)(lambdaMin), (*this)(lambdaMax));
    const float extremum = -c1 / (2 * c0);
    if (extremum >= lambdaMin && extremum <= lambdaMax) result = std::max(result, (*this)(extremum));
    return result;
}

const RgbColorSpace* RgbColorSpace::named(std::string_view name) {
    for (const RgbColorSpace& space : RgbColorSpaces::all().spaces)
        if (space.name() == lowerCase(name)) return &space;
    return nullptr;
}

const RgbColorSpace& RgbColorSpace::srgb() {
    return RgbColorSpaces::all().spaces[0];
}

const RgbColorSpace* RgbColorSpace::withChromaticities(std::span<const float, 8> xy) {
    constexpr float tolerance = 1e-3f;
    for (const RgbColorSpace& space : RgbColorSpaces::all().spaces) {
        bool same = true;
        for (std::size_t i = 0; i < xy.size(); ++i)
            same &= std::abs(space.chromaticities()[i / 2][int(i % 2)] - xy[i]) < tolerance;
        if (same) return &space;
    }
    return nullptr;
}

Rgb RgbColorSpace::fromXyz(const Xyz& xyz) const {
    return multiply(xyz, data_->rgbFromXyz);
}

Xyz RgbColorSpace::toXyz(const Rgb& rgb) const {
    return multiply(rgb, data_->xyzFromRgb);
}

SigmoidPolynomial RgbColorSpace::sigmoid(const Rgb& rgb) const {
    Rgb c;
    for (int i = 0; i < 3; ++i)
        c[i] = rgb[i] > 0 ? std::min(rgb[i], 1.f) : 0.f;
    // Greys are constant; 0 and 1 by an infinite c2.
    if (c.x == c.y && c.y == c.z) return {0, 0, (c.x - 0.5f) / std::sqrt(c.x * (1 - c.x))};
    if (!data_->solver) return lookUp(UpliftTable::srgb(), c);
    const auto found = UpliftSolver::inNanometres(data_->solver->solve({double(c.x), double(c.y), double(c.z)}));
    return {found[0], found[1], found[2]};
}

const DenseSpectrum& RgbColorSpace::illuminant() const {
    return data_->illuminant;
}

const std::string& RgbColorSpace::name() const {
    return data_->name;
}

const std::array<V2f, 4>& RgbColorSpace::chromaticities() const {
    return data_->chromaticities;
}

RgbUnboundedSpectrum::RgbUnboundedSpectrum(const RgbColorSpace& space, const Rgb& rgb)
    : scale_(2 * std::max({rgb.x, rgb.y, rgb.z, 0.f})), polynomial_(space.sigmoid(scale_ > 0 ? rgb / scale_ : Rgb(0))) {
}

RgbIlluminantSpectrum::RgbIlluminantSpectrum(const RgbColorSpace& space, const Rgb& rgb)
    : scale_(2 * std::max({rgb.x, rgb.y, rgb.z, 0.f})), polynomial_(space.sigmoid(scale_ > 0 ? rgb / scale_ : Rgb(0))),
      illuminant_(&space.illuminant()) {}

} // namespace vitrine
