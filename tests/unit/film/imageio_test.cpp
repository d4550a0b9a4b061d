#include "core/errors.h"
#include "core/random.h"
#include "film/imageio.h"
#include "film/srgb.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <chrono>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>

namespace vitrine {
namespace {

using testing::HasSubstr;
using testing::Not;

Image randomImage(int width, int height, int channels, std::uint64_t seed = 1, float scale = 1) {
    Image image{width, height, channels, {}};
    RandomStream random(seed);
    for (int i = 0; i < width * height * channels; ++i)
        image.pixels.push_back(scale * random.uniform());
    return image;
}

std::string contents(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A fresh file: cutting an old one to nothing makes some file systems write it to the disk at once, which takes long.
void overwrite(const std::string& path, const std::string& bytes) {
    std::filesystem::remove(path);
    std::ofstream(path, std::ios::binary) << bytes;
}

std::string writeError(const std::string& path, const Image& image = randomImage(4, 3, 3)) {
    try {
        writeImage(path, image);
    } catch (const FileError& error) {
        return error.what();
    }
    return "no error";
}

TEST(ImageIo, FloatFormatsKeepEveryBit) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a.exr", "a.pfm", "A.EXR"})
        for (int channels : {1, 3}) {
            Image image = randomImage(33, 17, channels, 2, 100);
            image.pixels[0] = -3.5f;
            image.pixels[1] = 1e-30f;
            image.pixels[2] = infinity;
            writeImage(folder.file(name), image);
            const Image back = readImage(folder.file(name));
            EXPECT_EQ(V3f(back.width, back.height, back.channels), V3f(33, 17, channels)) << name;
            EXPECT_EQ(back.pixels, image.pixels) << name;
        }
}

TEST(ImageIo, ExrTakesNamedChannels) {
    const test::TemporaryFolder folder;
    const Image image = randomImage(8, 8, 5);
    ImageMetadata metadata;
    EXPECT_THROW(writeImage(folder.file("a.exr"), image), FileError); // five channels have no names of their own
    metadata.channelNames = {"R", "G", "B", "Albedo.R", "Depth.Z"};
    writeImage(folder.file("a.exr"), image, metadata);
    ImageMetadata back;
    const Image read = readImage(folder.file("a.exr"), &back);
    ASSERT_EQ(back.channelNames.size(), 5u);
    for (std::size_t c = 0; c < 5; ++c) {
        const auto at = std::find(back.channelNames.begin(), back.channelNames.end(), metadata.channelNames[c]);
        ASSERT_NE(at, back.channelNames.end());
        EXPECT_EQ(read.at(3, 5, int(at - back.channelNames.begin())), image.at(3, 5, int(c)));
    }
}

TEST(ImageIo, EightBitFormatsHoldTheNearestCode) {
    const test::TemporaryFolder folder;
    Image image = randomImage(40, 30, 3, 3, 1.2f);
    image.pixels[0] = -1;
    image.pixels[1] = std::nanf("");
    image.pixels[2] = infinity;
    for (const char* name : {"a.png", "a.ppm"}) {
        writeImage(folder.file(name), image);
        const Image back = readImage(folder.file(name));
        ASSERT_EQ(back.pixels.size(), image.pixels.size());
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            ASSERT_EQ(back.pixels[i], float(linearFromSrgb(srgbByte(image.pixels[i]) / 255.))) << name << " " << i;
    }
    writeImage(folder.file("grey.png"), randomImage(5, 5, 1));
    EXPECT_EQ(readImage(folder.file("grey.png")).channels, 1);
}

TEST(ImageIo, PpmIsBinary) {
    const test::TemporaryFolder folder;
    writeImage(folder.file("a.ppm"), Image{2, 1, 3, {0, 0, 0, 1, 1, 1}});
    EXPECT_EQ(contents(folder.file("a.ppm")), std::string("P6\n2 1\n255\n\0\0\0\xff\xff\xff", 17));
}

TEST(ImageIo, JpegIsNear) {
    const test::TemporaryFolder folder;
    Image image{64, 64, 3, {}};
    for (int i = 0; i < 64 * 64; ++i)
        image.pixels.insert(image.pixels.end(), {i % 64 / 64.f, i / 64 / 64.f, 0.3f});
    for (const char* name : {"a.jpg", "a.jpeg"}) {
        writeImage(folder.file(name), image);
        const Image back = readImage(folder.file(name));
        ASSERT_EQ(back.pixels.size(), image.pixels.size());
        double squares = 0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            squares += sqr(srgbFromLinear(double(back.pixels[i])) - srgbFromLinear(double(image.pixels[i])));
        EXPECT_LT(std::sqrt(squares / double(image.pixels.size())), 0.01) << name;
    }
}

TEST(ImageIo, HdrRoundsToSharedExponents) {
    const test::TemporaryFolder folder;
    Image image = randomImage(50, 20, 3, 4);
    RandomStream random(9);
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
        const float scale = std::exp2(40 * random.uniform() - 20);
        for (std::size_t c = 0; c < 3; ++c)
            image.pixels[i + c] *= scale;
    }
    image.pixels[0] = 255.9f, image.pixels[1] = 127.3f; // rounds up to 256, where steps are twice as wide
    image.pixels[3] = -1, image.pixels[4] = std::nanf(""), image.pixels[5] = 2;
    image.pixels[6] = infinity;
    writeImage(folder.file("a.hdr"), image);
    const Image back = readImage(folder.file("a.hdr"));
    ASSERT_EQ(back.pixels.size(), image.pixels.size());
    EXPECT_EQ(back.pixels[3], 0);
    EXPECT_EQ(back.pixels[4], 0);
    EXPECT_EQ(back.pixels[5], 2);
    EXPECT_GT(back.pixels[6], 1e37f);
    double bias = 0;
    for (std::size_t i = 9; i < image.pixels.size(); i += 3) {
        const float largest = std::max({image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]});
        for (std::size_t c = i; c < i + 3; ++c) {
            ASSERT_LE(std::abs(back.pixels[c] - image.pixels[c]), largest / 256) << c;
            bias += double((back.pixels[c] - image.pixels[c]) / largest);
        }
    }
    // Cutting instead of rounding would give about -0.0027 on average.
    EXPECT_NEAR(bias / double(image.pixels.size()), 0, 0.0003);
    EXPECT_EQ(back.pixels[0], 256);
    EXPECT_NEAR(back.pixels[1], 127.3f, 1);
    writeImage(folder.file("grey.hdr"), randomImage(5, 5, 1));
    EXPECT_EQ(readImage(folder.file("grey.hdr")).channels, 3);
}

TEST(ImageIo, ExrMetadataSurvives) {
    const test::TemporaryFolder folder;
    ImageMetadata metadata;
    metadata.numbers = {{"samplesPerPixel", 64}, {"MSE", 0.125}};
    metadata.strings = {{"integrator", "path"}};
    M44d matrix;
    for (int i = 0; i < 16; ++i)
        matrix[i / 4][i % 4] = i + 0.5;
    metadata.matrices = {{"worldToCamera", matrix}, {"worldToNDC", matrix.transposed()}};
    metadata.fullResolution = V2i(100, 80);
    metadata.offset = V2i(30, 20);
    const float rec2020[8] = {0.708f, 0.292f, 0.17f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.329f};
    std::copy_n(rec2020, 8, metadata.chromaticities);
    const Image image = randomImage(8, 6, 3);
    writeImage(folder.file("a.exr"), image, metadata);

    ImageMetadata back;
    EXPECT_EQ(readImage(folder.file("a.exr"), &back).pixels, image.pixels);
    EXPECT_EQ(back.numbers["samplesPerPixel"], 64);
    EXPECT_EQ(back.numbers["MSE"], 0.125);
    EXPECT_EQ(back.strings["integrator"], "path");
    EXPECT_EQ(back.fullResolution, metadata.fullResolution);
    EXPECT_EQ(back.offset, metadata.offset);
    EXPECT_EQ(back.channelNames, (std::vector<std::string>{"R", "G", "B"}));
    for (int i = 0; i < 8; ++i)
        EXPECT_EQ(back.chromaticities[i], rec2020[i]);
    EXPECT_EQ(back.matrices["worldToCamera"], matrix);
    EXPECT_EQ(back.matrices["worldToNDC"], matrix.transposed());
    // The names in the file are OpenEXR's and pbrt-v4's.
    const std::string bytes = contents(folder.file("a.exr"));
    for (const char* name : {"worldToCamera", "worldToNDC", "samplesPerPixel", "MSE", "chromaticities"})
        EXPECT_THAT(bytes, HasSubstr(std::string(name) + '\0')) << name;
}

TEST(ImageIo, FilesAreTheSameWhenWrittenLater) {
    const test::TemporaryFolder folder;
    const Image image = randomImage(20, 20, 3);
    const std::vector<std::string> extensions = {"exr", "png", "ppm", "hdr", "pfm", "jpg"};
    for (const auto& e : extensions)
        writeImage(folder.file("first." + e), image);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // dates in files are given to the second
    for (const auto& e : extensions) {
        writeImage(folder.file("second." + e), image);
        EXPECT_EQ(contents(folder.file("first." + e)), contents(folder.file("second." + e))) << e;
        for (const char* word : {"Date", "capDate", "OpenImageIO", "Software"})
            EXPECT_THAT(contents(folder.file("first." + e)), Not(HasSubstr(word))) << e;
    }
}

TEST(ImageIo, WritingErrorsAreClear) {
    const test::TemporaryFolder folder;
    EXPECT_THAT(writeError(folder.file("a.pngg")),
                HasSubstr("\".pngg\" is no image format that can be written (exr, hdr, "
                          "jpeg, jpg, pfm, png, ppm); did you mean \"png\"?"));
    EXPECT_THAT(writeError(folder.file("a.d/noext")), HasSubstr("has no extension"));
    EXPECT_THAT(writeError(folder.file("missing/a.png")), HasSubstr("No such file or directory"));
    EXPECT_THAT(writeError(folder.file("a.png"), randomImage(2, 2, 4)), HasSubstr("takes one channel or three, not 4"));
    EXPECT_THAT(writeError(folder.file("a.exr"), Image{}), HasSubstr("without pixels"));
    EXPECT_EQ(folder.count(), 0u);
    EXPECT_THROW(checkImageName("a.gif"), FileError);
    EXPECT_NO_THROW(checkImageName("a.b/c.EXR"));
}

TEST(ImageIo, AFullDiskLeavesTheOldPicture) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a.exr", "a.png", "a.hdr", "a.jpg", "a.ppm", "a.pfm"}) {
        std::filesystem::create_symlink("/dev/full", folder.file(name));
        EXPECT_THAT(writeError(folder.file(name)), HasSubstr("No space left on device")) << name;
    }
}

TEST(ImageIo, ReadingErrorsAreFileErrors) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(readImage(folder.file("none.exr")), FileError);
    EXPECT_THROW(readImage(folder.file(".")), FileError);
    for (const char* name : {"a.exr", "a.png", "a.hdr", "a.jpg", "a.ppm", "a.pfm", "a.txt"}) {
        for (const char* text : {"", "P", "this is no picture, and it is a little longer than any magic number"}) {
            overwrite(folder.file(name), text);
            EXPECT_THROW(readImage(folder.file(name)), FileError) << name << " \"" << text << '"';
        }
    }
}

/// Every prefix of a file either fails or, when only trailing bytes are lost, gives the whole picture.
TEST(ImageIo, CutFilesAreFileErrors) {
    const test::TemporaryFolder folder;
    const Image image = randomImage(24, 19, 3);
    for (const std::string extension : {"exr", "png", "hdr", "ppm", "pfm", "jpg"}) {
        const std::string path = folder.file("whole." + extension), cutPath = folder.file("cut." + extension);
        writeImage(path, image);
        const std::string whole = contents(path);
        const Image expected = readImage(path);
        int failures = 0;
        for (std::size_t size = 0; size < whole.size(); size += 1 + size / 40) {
            overwrite(cutPath, whole.substr(0, size));
            try {
                EXPECT_EQ(readImage(cutPath).pixels, expected.pixels) << extension << " cut at " << size;
            } catch (const FileError&) {
                ++failures;
            }
        }
        EXPECT_GT(failures, 30) << extension;
    }
}

TEST(ImageIo, FlippedBytesNeverCrash) {
    const test::TemporaryFolder folder;
    const Image image = randomImage(16, 12, 3);
    RandomStream random(12);
    for (const std::string extension : {"exr", "png", "hdr", "ppm", "pfm", "jpg"}) {
        const std::string path = folder.file("a." + extension);
        writeImage(path, image);
        const std::string whole = contents(path);
        for (int i = 0; i < 300; ++i) {
            std::string changed = whole;
            // Mostly in the header, where it hurts.
            const double at =
                random.uniformDouble() * (i % 3 ? std::min<double>(400, double(whole.size())) : double(whole.size()));
            changed[std::size_t(at)] = char(random.bits());
            overwrite(path, changed);
            try {
                readImage(path);
            } catch (const FileError&) {
            }
        }
    }
}

TEST(ImageIo, HugeDeclaredSizesAreRefused) {
    const test::TemporaryFolder folder;
    const std::string pfm = folder.file("a.pfm"), ppm = folder.file("a.ppm"), hdr = folder.file("a.hdr");
    overwrite(pfm, "PF\n100000 100000\n-1.0\nabc");
    EXPECT_THROW(readImage(pfm), FileError);
    overwrite(pfm, "PF\n2000000000 2000000000\n-1.0\nabc");
    EXPECT_THROW(readImage(pfm), FileError);
    overwrite(ppm, "P6\n60000 60000\n255\nabc");
    EXPECT_THROW(readImage(ppm), FileError);
    overwrite(ppm, "P6\n-3 7\n255\nabc");
    EXPECT_THROW(readImage(ppm), FileError);
    overwrite(hdr, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 30000 +X 30000\nabc");
    EXPECT_THROW(readImage(hdr), FileError);
}

std::string bigEndian(std::uint32_t x) {
    return {char(x >> 24), char(x >> 16), char(x >> 8), char(x)};
}

TEST(ImageIo, HugeSizesPatchedIntoHeadersAreRefused) {
    const test::TemporaryFolder folder;
    const std::string exr = folder.file("a.exr"), png = folder.file("a.png");
    writeImage(exr, randomImage(16, 12, 3));
    std::string bytes = contents(exr);
    const std::size_t window = bytes.find("dataWindow") + std::string("dataWindow_box2i_").size() + 4;
    for (int size : {40000, 1 << 30, -1}) {
        std::memcpy(&bytes[window + 8], &size, 4);
        std::memcpy(&bytes[window + 12], &size, 4);
        overwrite(exr, bytes);
        EXPECT_THROW(readImage(exr), FileError) << size;
    }

    writeImage(png, randomImage(16, 12, 3));
    bytes = contents(png);
    for (char interlace : {0, 1}) {
        bytes.replace(16, 8, bigEndian(60000) + bigEndian(60000));
        bytes[28] = interlace;
        const auto crc = crc32(0, reinterpret_cast<const Bytef*>(&bytes[12]), 17);
        bytes.replace(29, 4, bigEndian(std::uint32_t(crc)));
        overwrite(png, bytes);
        EXPECT_THROW(readImage(png), FileError) << int(interlace);
    }
}

} // namespace
} // namespace vitrine
