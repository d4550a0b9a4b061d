// An image at full and at ever halved resolution, in tiles in a file.
#pragma once

#include "textures/texel_file.h"

#include <vector>

namespace vitrine {

/// Texels as they lie in the file. Halves are exact to 1/4096 of their value: enough for 8 bits.
enum class TexelFormat { Half, Float };

struct ImagePyramid {
    static constexpr int tileSize = 64; ///< texels along a side; tiles over the edge are filled up with zeros

    /// Tiles row by row, in them texels row by row, in these channels.
    struct Level {
        int width = 0, height = 0;
        std::uint64_t offset = 0;

        int tilesAcross() const { return (width + tileSize - 1) / tileSize; }
        int tilesDown() const { return (height + tileSize - 1) / tileSize; }
    };

    int channels = 0; ///< at most 4
    TexelFormat format = TexelFormat::Float;
    std::vector<Level> levels; ///< the first is the image, the last is 1 x 1

    std::size_t texelBytes() const { return std::size_t(channels) * (format == TexelFormat::Half ? 2 : 4); }
    std::size_t tileBytes() const { return texelBytes() * tileSize * tileSize; }
};

/// Takes an image row by row, so that a large one is never in memory as a whole. Each level is the one before at half the
/// resolution, rounded down, every texel the mean of the area that it covers: so the mean of the image stays.
class PyramidWriter {
  public:
    /// \pre width, height > 0, 1 <= channels <= 4
    PyramidWriter(TexelFile& file, int width, int height, int channels, TexelFormat format);
    ~PyramidWriter();

    /// The next row from the top, finite values, channels interleaved. \throws FileError
    void addRow(const float* row) { addRow(0, row); }
    /// \pre as many rows as the image has were added
    const ImagePyramid& pyramid() const { return pyramid_; }

  private:
    struct Strip;
    void addRow(std::size_t level, const float* row);
    void store(std::size_t level, const float* row);

    TexelFile& file_;
    ImagePyramid pyramid_;
    std::vector<Strip> strips_;
};

} // namespace vitrine
