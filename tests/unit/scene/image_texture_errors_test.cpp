// Texture "imagemap": what is said of files that are none, and of wrong parameters.
#include "scene_text.h"
#include "support/image_files.h"
#include "support/temporary_folder.h"

#include <fmt/format.h>

#include <fstream>

namespace vitrine {
namespace {

using test::TemporaryFolder;

class ImageErrors : public testing::Test {
  protected:
    /// What is said of a texture of this file in the folder.
    Lines said(const std::string& name, const std::string& parameters = "") const {
        return errorsOf(fmt::format("WorldBegin\nTexture \"t\" \"float\" \"imagemap\" \"string filename\" \"{}\" {}\n",
                                    folder_.file(name), parameters));
    }
    /// The one line of it that starts at the name, without the place and the path.
    std::string saidOfFile(const std::string& name) const {
        const Lines lines = said(name);
        if (lines.size() != 1) return fmt::format("{} errors", lines.size());
        const std::string start = "2:50: error: " + folder_.file(name) + ": cannot be read: ";
        return lines[0].starts_with(start) ? lines[0].substr(start.size()) : lines[0];
    }
    void write(const std::string& name, const std::string& content) const {
        std::ofstream(folder_.file(name), std::ios::binary) << content;
    }
    /// A file that does not compress well, so that its end is missed when it is cut.
    void writeImageFile(const std::string& name, OIIO::TypeDesc type = OIIO::TypeUInt8, int tile = 0) const {
        OIIO::ImageSpec spec(100, 80, 3, type);
        spec.tile_width = spec.tile_height = tile;
        std::vector<float> values;
        for (std::uint32_t i = 0; i < 100 * 80 * 3; ++i)
            values.push_back(float((i * 2654435761u) >> 24) / 255);
        test::writeFile(folder_.file(name), spec, values);
    }

    TemporaryFolder folder_;
};

TEST_F(ImageErrors, FilesThatAreNoImages) {
    EXPECT_EQ(saidOfFile("none.png"), "no such file");
    std::filesystem::create_directory(folder_.file("folder.png"));
    EXPECT_EQ(saidOfFile("folder.png"), "is a directory");
    write("empty.png", "");
    EXPECT_EQ(saidOfFile("empty.png"), "Not a PNG file");
    write("text.png", "This is a text and no picture.\n");
    EXPECT_EQ(saidOfFile("text.png"), "Not a PNG file");
    write("text.exr", "This is a text and no picture.\n");
    EXPECT_EQ(saidOfFile("text.exr"), "\"" + folder_.file("text.exr") + "\" is not an OpenEXR file");
    write("text.txt", "This is a text and no picture.\n");
    EXPECT_EQ(saidOfFile("text.txt"), "OpenImageIO could not find a format reader for \"" + folder_.file("text.txt") +
                                          "\". Is it a file format that OpenImageIO doesn't know about?");
}

TEST_F(ImageErrors, FilesThatEndTooSoon) {
    for (const std::string name :
         {"a.png", "a.tif", "a.exr", "a.jpg", "a.hdr", "a.tga", "a.bmp", "tiled.tif", "tiled.exr"}) {
        const int tile = name.starts_with("tiled") ? 32 : 0;
        const OIIO::TypeDesc type = name.ends_with("exr") ? OIIO::TypeHalf : OIIO::TypeUInt8;
        writeImageFile(name, type, tile);
        EXPECT_EQ(said(name), Lines{}) << name;
        for (const double share : {0.95, 0.6, 0.1}) {
            writeImageFile(name, type, tile);
            test::cut(folder_.file(name), share);
            const Lines lines = said(name);
            ASSERT_EQ(lines.size(), 1u) << name << ' ' << share;
            EXPECT_TRUE(lines[0].starts_with("2:50: error: " + folder_.file(name) + ": cannot be read: ")) << lines[0];
        }
    }
}

TEST_F(ImageErrors, Parameters) {
    writeImageFile("a.png");
    EXPECT_EQ(errorsOf("WorldBegin\nTexture \"t\" \"spectrum\" \"imagemap\"\n"),
              Lines{"2:1: error: an imagemap needs \"string filename\""});
    EXPECT_EQ(said("a.png", "\"string filter\" \"gauss\""), Lines{"2:99: error: \"filter\" cannot be \"gauss\""});
    EXPECT_EQ(said("a.png", "\"string wrap\" \"mirror\""), Lines{"2:97: error: \"wrap\" cannot be \"mirror\""});
    EXPECT_EQ(said("a.png", "\"string wrap\" \"octahedralsphere\""),
              Lines{"2:83: error: \"wrap\" \"octahedralsphere\" is not yet supported"});
    EXPECT_EQ(said("a.png", "\"float maxanisotropy\" .5"),
              Lines{"2:83: error: \"maxanisotropy\" must lie in [1, 256]"});
    const std::string encoding =
        "2:83: error: \"encoding\" must be \"sRGB\", \"linear\" or \"gamma\" with a positive number, not ";
    EXPECT_EQ(said("a.png", "\"string encoding\" \"srgb\""), Lines{encoding + "\"srgb\""});
    EXPECT_EQ(said("a.png", "\"string encoding\" \"gamma\""), Lines{encoding + "\"gamma\""});
    EXPECT_EQ(said("a.png", "\"string encoding\" \"gamma 0\""), Lines{encoding + "\"gamma 0\""});
    EXPECT_EQ(said("a.png", "\"string encoding\" \"gamma 1e999\""), Lines{encoding + "\"gamma 1e999\""});
    EXPECT_EQ(said("a.png", "\"string mapping\" \"cubic\""), Lines{"2:100: error: \"mapping\" cannot be \"cubic\""});
    EXPECT_EQ(said("a.png", "\"float gain\" 2"), Lines{"2:83: error: unused parameter \"gain\""});
}

TEST_F(ImageErrors, ChannelsWithoutColours) {
    OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeFloat);
    spec.channelnames = {"X", "Y", "Z"};
    test::writeFile(folder_.file("a.exr"), spec, {1, 2, 3});
    EXPECT_EQ(saidOfFile("a.exr"), "there are no channels R, G and B, but X, Y, Z");
}

TEST_F(ImageErrors, NoRoomForTexels) {
    writeImageFile("a.png");
    ASSERT_EQ(::setenv("TMPDIR", folder_.file("nowhere").c_str(), 1), 0);
    const Lines lines = said("a.png");
    ::unsetenv("TMPDIR");
    EXPECT_EQ(lines,
              Lines{"2:50: error: " + folder_.file("nowhere") +
                    ": no temporary file for textures can be made here (TMPDIR chooses the folder): No such file or "
                    "directory"});
}

} // namespace
} // namespace vitrine
