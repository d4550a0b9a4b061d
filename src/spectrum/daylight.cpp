#include "spectrum/spectrum.h"

#include <stdexcept>

namespace vitrine {

namespace {

#include "spectrum/data/daylight.inc"

} // namespace

DenseSpectrum daylightSpectrum(float kelvin) {
    if (!(kelvin > 0) || !std::isfinite(kelvin))
        throw std::invalid_argument("the colour temperature of daylight must be positive and finite, in kelvin");
    // The D illuminants are named on the scale of 1931, with the second radiation constant 1.4380 cm K, since revised.
    const double t = double(kelvin) * (1.4388 / 1.4380);
    if (t < 4000) return DenseSpectrum(BlackbodySpectrum(float(t)));

    // Chromaticity on the daylight locus, then the weights of the two components (CIE 015, section 4.1.2).
    const double x = t <= 7000 ? ((-4.6070e9 / t + 2.9678e6) / t + 0.09911e3) / t + 0.244063
                               : ((-2.0064e9 / t + 1.9018e6) / t + 0.24748e3) / t + 0.237040;
    const double y = (-3 * x + 2.870) * x - 0.275;
    const double m = 0.0241 + 0.2562 * x - 0.7341 * y;
    const double m1 = (-1.3515 - 1.7703 * x + 5.9114 * y) / m;
    const double m2 = (0.0300 - 31.4424 * x + 30.0717 * y) / m;

    std::vector<float> lambdas, values;
    for (std::size_t i = 0; i < std::size(daylightS0); ++i) {
        lambdas.push_back(300 + 5 * float(i));
        values.push_back(
            float(0.01 * (double(daylightS0[i]) + m1 * double(daylightS1[i]) + m2 * double(daylightS2[i]))));
    }
    return DenseSpectrum(PiecewiseLinearSpectrum(std::move(lambdas), std::move(values)));
}

} // namespace vitrine
