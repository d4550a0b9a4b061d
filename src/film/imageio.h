// Pictures in and out of files, through OpenImageIO.
#pragma once

#include "core/image.h"

#include <map>
#include <string>
#include <vector>

namespace vitrine {

/// What pbrt-v4 writes beside the pixels of an EXR, where known. Other formats carry none of it.
struct ImageMetadata {
    /// EXR channel names; empty: Y, YA, RGB or RGBA by the number of channels.
    std::vector<std::string> channelNames;
    std::map<std::string, double> numbers; ///< e.g. samplesPerPixel, MSE; whole numbers are written as integers
    std::map<std::string, std::string> strings;
    /// By OpenEXR's names: worldToCamera, worldToNDC. Row vectors (v' = v M), as OpenEXR has it; pbrt-v4 writes the
    /// transposed matrices.
    std::map<std::string, M44d> matrices;
    V2i fullResolution{0, 0};      ///< display window; (0,0): the image itself
    V2i offset{0, 0};              ///< where the image lies in it
    float chromaticities[8] = {0}; ///< r g b w, x and y; all zero: Rec.709
};

/// By extension: EXR (float32, zip, no time or host name), PFM, HDR linear; PNG, PPM, JPEG by the sRGB curve, clamped
/// to [0, 1], NaN as 0. All but EXR take one channel or three. HDR holds no negative values: they become 0. Written
/// beside and renamed, so that a full disk or a kill never leaves half a file under the name. \throws FileError
void writeImage(const std::string& path, const Image& image, const ImageMetadata& metadata = {});

/// \throws FileError unless writeImage knows the path's extension, so that hours of rendering do not end in one
void checkImageName(const std::string& path);

/// Linear floats whatever the file holds (integer formats through the inverse sRGB curve, alpha excepted); the channels
/// that the file has, alpha not multiplied in. \throws FileError
Image readImage(const std::string& path, ImageMetadata* metadata = nullptr);

/// The channels named R, G and B; of one or two channels the first, and of more without names the first three.
/// \throws std::invalid_argument for three channels or more that have other names: they may be anything
Image colourChannels(const Image& image, const std::vector<std::string>& names);

/// The colours of a picture, one channel or three, in the file's own primaries. \throws FileError as readImage, and
/// for pictures without
Image readColours(const std::string& path, ImageMetadata& metadata);

} // namespace vitrine
