// What the colours of a parameter stand for.
#pragma once

namespace vitrine {

/// It decides how an RGB triple becomes a spectrum (pbrt-v4's SpectrumType).
enum class SpectrumUse { Albedo, Unbounded, Illuminant };

} // namespace vitrine
