// What all readers of image files have in common.
#pragma once

#include "film/imageio.h"

#include <OpenImageIO/imageio.h>

namespace vitrine {

/// Opens an image file whose header makes sense; alpha is not multiplied in.
/// \throws FileError for what is no such file, as far as that shows before pixels are read
std::unique_ptr<OIIO::ImageInput> openImage(const std::string& path);

/// \throws FileError: the path, "cannot be read", and the first line of `what` if there is one
[[noreturn]] void failToRead(const std::string& path, const std::string& what);

/// Whether the values are those of light. Integer formats hold the sRGB curve unless the file says otherwise.
bool isLinear(const OIIO::ImageSpec& spec);

void readMetadata(const OIIO::ImageSpec& spec, ImageMetadata& metadata);

/// "W x H pixels of C channels"
std::string describeSize(const OIIO::ImageSpec& spec);

/// Which channels are red, green and blue: those of these names; of one or two channels the first, and of more without
/// names the first three. \throws std::invalid_argument for three channels or more that have other names: they may be anything
std::vector<int> colourChannelIndices(int channels, const std::vector<std::string>& names);

} // namespace vitrine
