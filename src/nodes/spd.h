// Spectra in files: wavelength (nm) and value on each line, '#' starts a comment (pbrt-v4's .spd).
#pragma once

#include <string>
#include <vector>

namespace vitrine {

struct SpdSamples {
    std::vector<double> wavelengths; ///< nm, strictly increasing
    std::vector<double> values;
};

/// \throws FileError when the file cannot be read, SceneError with a place in it when it is not a spectrum.
SpdSamples readSpd(const std::string& fileName);

} // namespace vitrine
