// From the numbers of a scene file to spectra of light.
#pragma once

#include "spectrum/spectrum.h"

namespace vitrine {

/// pbrt-v4's rule for the emission of every light: the spectrum is divided by its photometric(), so that its luminance
/// is one nit (or its intensity one candela) whatever its shape, and multiplied by `scale` (RGB spectra keep the
/// luminance of their RGB: photometric() counts their white alone). If a `target` in photometric units is above zero it
/// multiplies too, divided by `unit`, what the light would reach at one nit: pi for the illuminance under a constant
/// sky, 4 pi for the power of a point light ...
///
/// The result holds one value a nanometre, as pbrt's lights do. A black spectrum stays black.
/// \param target not above zero: none was asked for (pbrt's default is -1)
/// \throws std::invalid_argument for a missing, negative or infinite spectrum, and as emissionScale
SpectrumPtr scaledEmission(const SpectrumPtr& spectrum, double scale, double target, double unit);

/// The factor of that rule without the spectrum's: scale, times target / unit if there is a target.
/// \throws std::invalid_argument for a scale that is negative or not finite, a target that is not finite, and a target
/// that
///         no scale can reach as `unit` is zero or infinite
double emissionScale(double scale, double target, double unit);

} // namespace vitrine
