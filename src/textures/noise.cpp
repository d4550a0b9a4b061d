#include "textures/noise.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace vitrine {

namespace {

/// The permutation of Perlin's reference implementation.
constexpr std::array<std::uint8_t, 256> permutation = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103, 30,  69,  142,
    8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,  197, 62,  94,  252, 219, 203,
    117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174, 20,  125, 136, 171, 168, 68,  175, 74,  165,
    71,  134, 139, 48,  27,  166, 77,  146, 158, 231, 83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,
    55,  46,  245, 40,  244, 102, 143, 54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,
    18,  169, 200, 196, 135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250,
    124, 123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,  182, 189,
    28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,
    129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104, 218, 246, 97,  228, 251, 34,
    242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,  51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,
    181, 199, 106, 157, 184, 84,  204, 176, 115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114,
    67,  29,  24,  72,  243, 141, 128, 195, 78,  66,  215, 61,  156, 180};

/// Towards the edges of a cube, four of them twice: Perlin's twelve, and pbrt-v4's choice (not quite his) of the four that fill
/// up to sixteen.
constexpr signed char gradients[16][3] = {{1, 1, 0},  {-1, 1, 0},  {1, -1, 0}, {-1, -1, 0}, {1, 0, 1},  {-1, 0, 1},
                                          {1, 0, -1}, {-1, 0, -1}, {0, 1, 1},  {0, -1, 1},  {0, 1, -1}, {0, -1, -1},
                                          {1, 1, 0},  {-1, 1, 0},  {0, 1, -1}, {0, -1, -1}};

/// One coordinate: the lattice points beside it and its place between them.
struct LatticeCoordinate {
    unsigned cell[2];
    float offset; ///< from the lower one, in [0, 1]
    float fade;   ///< 6 t^5 - 15 t^4 + 10 t^3 (Perlin 2002)

    explicit LatticeCoordinate(double x) {
        // Exact for every finite x: no integer type holds them all.
        const double wrapped = x - 256 * std::floor(x / 256), lower = std::floor(wrapped);
        cell[0] = unsigned(lower) & 255;
        cell[1] = (cell[0] + 1) & 255;
        offset = float(wrapped - lower);
        fade = offset * offset * offset * (offset * (offset * 6 - 15) + 10);
    }
};

float smoothStep(float x, float a, float b) {
    const float t = std::clamp((x - a) / (b - a), 0.f, 1.f);
    return t * t * (3 - 2 * t);
}

/// How many octaves the footprint lets through: the finest has a period of at least two footprints.
float visibleOctaves(const SpacePoint& at, int count) {
    const double footprint2 = std::max(at.dpdx.length2(), at.dpdy.length2());
    return float(std::clamp(-1 - std::log2(footprint2) / 2, 0., double(count)));
}

/// Calls add(amplitude, noise, share) for each octave that is seen; share < 1 for the last, which may be 0. Returns the
/// number of whole ones.
template <class Add>
int forOctaves(const SpacePoint& at, const Octaves& octaves, Add&& add) {
    const float visible = visibleOctaves(at, octaves.count);
    const int whole = int(visible);
    double frequency = 1;
    float amplitude = 1;
    for (int i = 0; i < whole; ++i) {
        add(amplitude, noise(at.p * frequency), 1.f);
        frequency *= 1.99;
        amplitude *= octaves.roughness;
    }
    add(amplitude, noise(at.p * frequency), smoothStep(visible - float(whole), 0.3f, 0.7f));
    return whole;
}

} // namespace

float noise(const V3d& p) {
    const LatticeCoordinate x(p.x), y(p.y), z(p.z);
    float alongZ[2];
    for (int k = 0; k < 2; ++k) {
        float alongY[2];
        for (int j = 0; j < 2; ++j) {
            float alongX[2];
            for (int i = 0; i < 2; ++i) {
                const unsigned xy = (permutation[x.cell[i]] + y.cell[j]) & 255;
                const auto& g = gradients[permutation[(permutation[xy] + z.cell[k]) & 255] & 15];
                alongX[i] = float(g[0]) * (x.offset - float(i)) + float(g[1]) * (y.offset - float(j)) +
                            float(g[2]) * (z.offset - float(k));
            }
            alongY[j] = lerp(x.fade, alongX[0], alongX[1]);
        }
        alongZ[k] = lerp(y.fade, alongY[0], alongY[1]);
    }
    return lerp(z.fade, alongZ[0], alongZ[1]);
}

Octaves::Octaves(int n, float r) : count(n), roughness(r) {
    constexpr int most = 100;
    if (n < 0 || n > most) throw std::invalid_argument(fmt::format("\"octaves\" is {}, must lie in [0, {}]", n, most));
}

float fbm(const SpacePoint& at, const Octaves& octaves) {
    float sum = 0;
    forOctaves(at, octaves, [&](float amplitude, float value, float share) { sum += amplitude * share * value; });
    return sum;
}

float turbulence(const SpacePoint& at, const Octaves& octaves) {
    constexpr float mean = 0.2f;
    float sum = 0, last = 1;
    const int whole = forOctaves(at, octaves, [&](float amplitude, float value, float share) {
        sum += amplitude * lerp(share, mean, std::abs(value));
        last = amplitude;
    });
    // The faded octave counts here again, as in pbrt-v4.
    for (int i = whole; i < octaves.count; ++i, last *= octaves.roughness)
        sum += last * mean;
    return sum;
}

SpacePoint scaled(const SpacePoint& at, double scale) {
    return {at.p * scale, at.dpdx * scale, at.dpdy * scale};
}

} // namespace vitrine
