// Pictures in and out of files, through OpenImageIO.
#pragma once

#include "core/image.h"

#include <map>
#include <string>

namespace vitrine {

/// What pbrt-v4 writes beside the pixels of an EXR, where known.
struct ImageMetadata {
    std::string channelPrefix;
    std::map<std::string, double> numbers;       ///< e.g. samplesPerPixel, MSE
    std::map<std::string, std::string> strings;
    std::map<std::string, M44d> matrices;        ///< worldFromCamera, NDCFromWorld ...
    V2i fullResolution{0, 0};                    ///< display window; (0,0): the image itself
    V2i offset{0, 0};                            ///< where the image lies in it
    float chromaticities[8] = {0};               ///< r g b w, x and y; all zero: Rec.709
};

/// By extension: EXR (float32, no time or host name), PFM, HDR linear; PNG, PPM, JPEG by the sRGB curve, clamped.
/// Written beside and renamed, so that a full disk or a kill never leaves half a file under the name.
/// \throws FileError
void writeImage(const std::string& path, const Image& image, const ImageMetadata& metadata = {});

/// Linear floats whatever the file holds (8-bit formats through the inverse sRGB curve). \throws FileError
Image readImage(const std::string& path, ImageMetadata* metadata = nullptr);

} // namespace vitrine
