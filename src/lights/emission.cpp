#include "lights/emission.h"

#include "shapes/parameters.h"
#include "spectrum/colorspace.h"

namespace vitrine {

double emissionScale(double scale, double target, double unit) {
    if (requireFinite("scale", scale) < 0) throw std::invalid_argument("a light's \"scale\" must not be negative");
    if (!std::isfinite(target)) throw std::invalid_argument("a light's power or illuminance must be finite");
    if (!(target > 0)) return scale;
    if (!(unit > 0) || !std::isfinite(unit))
        throw std::invalid_argument("no scale gives this light the power or illuminance asked for");
    return scale * target / unit;
}

SpectrumPtr scaledEmission(const SpectrumPtr& spectrum, double scale, double target, double unit) {
    if (!spectrum) throw std::invalid_argument("a light needs a spectrum");
    const double factor = emissionScale(scale, target, unit);
    const double nits = photometric(*spectrum);
    if (!(nits >= 0) || !std::isfinite(nits))
        throw std::invalid_argument("a light's spectrum must be finite and not negative");
    if (nits == 0) return std::make_shared<ConstantSpectrum>(0.f);
    return std::make_shared<DenseSpectrum>(ScaledSpectrum(spectrum, float(factor / nits)));
}

} // namespace vitrine
