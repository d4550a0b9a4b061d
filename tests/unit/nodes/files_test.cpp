// Scenes in files: Include, Import, compressed files, .spd.
#include "nodes/source.h"
#include "nodes/spd.h"
#include "scene_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <zlib.h>

#include <sys/stat.h>

namespace vitrine {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string fileErrors(const std::string& fileName) {
    try {
        parseSceneFile(fileName);
        return {};
    } catch (const SceneError& error) {
        return error.what();
    }
}

TEST(Files, IncludeContinuesTheText) {
    const ScratchDirectory directory;
    directory.write("parts/inner.pbrt", "Shape \"disk\"\nTranslate 1 0 0\nAttributeEnd\n");
    const auto main = directory.write(
        "scene.pbrt", "WorldBegin\nAttributeBegin\nTranslate 0 1 0\nInclude \"parts/inner.pbrt\"\nShape \"sphere\"\n");
    const SceneNodes scene = parseSceneFile(main);
    ASSERT_EQ(scene.shapes.size(), 2u);
    EXPECT_EQ(scene.shapes[0].worldFromObject->start.point(V3d(0)), V3d(0, 1, 0));
    EXPECT_TRUE(scene.shapes[1].worldFromObject->start.isIdentity()) << "AttributeEnd in the included file counts";
    EXPECT_EQ(scene.shapes[0].place.file->name, directory.file("parts/inner.pbrt"));
}

TEST(Files, NamesAreRelativeToTheSceneThenToTheIncludedFile) {
    const ScratchDirectory directory;
    directory.write("parts/a.pbrt", "Include \"parts/b.pbrt\"\nInclude \"c.pbrt\"\nInclude \"both.pbrt\"\n");
    directory.write("parts/b.pbrt", "Shape \"b\"\n");
    directory.write("parts/c.pbrt", "Shape \"c\"\n");
    directory.write("parts/both.pbrt", "Shape \"beside\"\n");
    directory.write("both.pbrt", "Shape \"base\"\n");
    const SceneNodes scene = parseSceneFile(directory.write("scene.pbrt", "WorldBegin\nInclude \"parts/a.pbrt\"\n"));
    ASSERT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(scene.shapes[0].type, "b");
    EXPECT_EQ(scene.shapes[1].type, "c");
    EXPECT_EQ(scene.shapes[2].type, "base");
    EXPECT_EQ(resolveFile(scene, scene.shapes[1].place, "c.pbrt"), directory.file("parts/c.pbrt"));
    EXPECT_EQ(resolveFile(scene, scene.shapes[1].place, "none.ply"), directory.file("none.ply"));
    EXPECT_EQ(resolveFile(scene, scene.shapes[1].place, "/etc/none.ply"), "/etc/none.ply");
}

TEST(Files, ImportKeepsItsStateToItself) {
    const ScratchDirectory directory;
    directory.write("part.pbrt", "Shape \"first\"\nTranslate 1 0 0\nReverseOrientation\nMaterial \"conductor\"\n"
                                 "CoordinateSystem \"inner\"\nMakeNamedMaterial \"m\" \"string type\" \"diffuse\"\n"
                                 "ColorSpace \"rec2020\"\nShape \"second\"\n");
    const auto main =
        directory.write("scene.pbrt", "WorldBegin\nTranslate 0 1 0\nImport \"part.pbrt\"\nNamedMaterial \"m\"\n"
                                      "Shape \"third\"\n");
    const SceneNodes scene = parseSceneFile(main);
    ASSERT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(scene.shapes[0].worldFromObject->start.point(V3d(0)), V3d(0, 1, 0)) << "the state goes in";
    EXPECT_EQ(scene.shapes[1].worldFromObject->start.point(V3d(0)), V3d(1, 1, 0));
    EXPECT_EQ(scene.shapes[2].worldFromObject->start.point(V3d(0)), V3d(0, 1, 0)) << "and does not come out";
    EXPECT_FALSE(scene.shapes[2].reverseOrientation);
    EXPECT_EQ(scene.shapes[2].parameters.colorSpace(), "srgb");
    EXPECT_EQ(scene.materials[std::size_t(scene.shapes[2].material)].name, "m") << "definitions do";
    const auto leaking =
        directory.write("leak.pbrt", "WorldBegin\nImport \"part.pbrt\"\nCoordSysTransform \"inner\"\n");
    EXPECT_THAT(fileErrors(leaking), HasSubstr("there is no coordinate system \"inner\""));
}

TEST(Files, ImportedBlocksEndInTheirFile) {
    const ScratchDirectory directory;
    directory.write("open.pbrt", "AttributeBegin\n");
    directory.write("close.pbrt", "AttributeEnd\n");
    directory.write("objectend.pbrt", "ObjectEnd\n");
    directory.write("part.pbrt", "Shape \"sphere\"\n");
    const auto errors = [&](const std::string& text) { return fileErrors(directory.write("scene.pbrt", text)); };
    EXPECT_THAT(errors("WorldBegin\nImport \"open.pbrt\"\n"), HasSubstr("this AttributeBegin has no AttributeEnd"));
    EXPECT_THAT(errors("WorldBegin\nAttributeBegin\nImport \"close.pbrt\"\nAttributeEnd\n"),
                HasSubstr("AttributeEnd closes nothing"));
    EXPECT_THAT(errors("WorldBegin\nObjectBegin \"a\"\nImport \"objectend.pbrt\"\nObjectEnd\n"),
                HasSubstr("ObjectEnd closes nothing"));
    EXPECT_THAT(errors("Import \"part.pbrt\"\nWorldBegin\n"), HasSubstr("Import must stand after WorldBegin"));
    const SceneNodes scene = parseSceneFile(
        directory.write("scene.pbrt", "WorldBegin\nObjectBegin \"a\"\nImport \"part.pbrt\"\nObjectEnd\n"));
    EXPECT_EQ(scene.objects.at(0).shapes.size(), 1u) << "imported into the definition";
}

TEST(Files, ErrorsNameTheIncludeChain) {
    const ScratchDirectory directory;
    directory.write("b.pbrt", "\nShape \"sphere\" \"float radius\" x\n");
    directory.write("a.pbrt", "Include \"b.pbrt\"\n");
    const auto main = directory.write("scene.pbrt", "WorldBegin\n\nInclude \"a.pbrt\"\n");
    EXPECT_EQ(fileErrors(main),
              directory.file("b.pbrt") + ":2:31: error: \"float radius\": expected a number, got \"x\"\n" +
                  "    Shape \"sphere\" \"float radius\" x\n" + "                                  ^\n" + //
                  "    included from " + directory.file("a.pbrt") + ":1\n" +                              //
                  "    included from " + directory.file("scene.pbrt") + ":3");
}

TEST(Files, WhatCannotBeIncluded) {
    const ScratchDirectory directory;
    const auto errors = [&](const std::string& text) { return fileErrors(directory.write("scene.pbrt", text)); };
    EXPECT_EQ(errors("WorldBegin\nInclude \"none.pbrt\"\n"),
              directory.file("scene.pbrt") + ":2:9: error: " + directory.file("none.pbrt") + ": no such file\n" +
                  "    Include \"none.pbrt\"\n" + "            ^^^^^^^^^^^");
    EXPECT_THAT(errors("Include \"scene.pbrt\"\nWorldBegin\n"), HasSubstr("\"scene.pbrt\" includes itself"));
    EXPECT_THAT(errors("Include \"\"\nWorldBegin\n"), HasSubstr("the file name is empty"));
    EXPECT_THAT(errors("Include \".\"\nWorldBegin\n"), HasSubstr("is a directory"));
    EXPECT_THAT(errors("Include \"/dev/zero\"\nWorldBegin\n"), HasSubstr("is not a regular file"));
    EXPECT_THAT(errors("Include 3\nWorldBegin\n"), HasSubstr("expected the name of a file, got \"3\""));
    ASSERT_EQ(mkfifo(directory.file("pipe").c_str(), 0600), 0);
    EXPECT_THAT(errors("Include \"pipe\"\nWorldBegin\n"), HasSubstr("is not a regular file"));
    directory.write("x.pbrt", "Include \"y.pbrt\"\n");
    directory.write("y.pbrt", "Include \"./sub/../x.pbrt\"\n");
    std::filesystem::create_directories(directory.file("sub"));
    EXPECT_THAT(errors("Include \"x.pbrt\"\nWorldBegin\n"), HasSubstr("includes itself"));
}

TEST(Files, DepthAndNumberOfFilesAreBounded) {
    const ScratchDirectory directory;
    for (int i = 0; i < 150; ++i) {
        directory.write(fmt::format("f{}.pbrt", i), fmt::format("Include \"f{}.pbrt\"\n", i + 1));
    }
    EXPECT_THAT(fileErrors(directory.file("f0.pbrt")), HasSubstr("files include each other more than 100 deep"));
    // Every file includes the next twice: 2^25 readings if nothing stopped them.
    for (int i = 0; i < 25; ++i) {
        directory.write(fmt::format("g{}.pbrt", i),
                        fmt::format("Include \"g{0}.pbrt\"\nInclude \"g{0}.pbrt\"\n", i + 1));
    }
    directory.write("g25.pbrt", "");
    EXPECT_THAT(fileErrors(directory.file("g0.pbrt")), HasSubstr("the scene includes more than"));
}

TEST(Files, TheSceneItselfMustBeReadable) {
    const ScratchDirectory directory;
    EXPECT_THROW(parseSceneFile(directory.file("none.pbrt")), FileError);
    EXPECT_THROW(parseSceneFile(directory.file("")), FileError);
    EXPECT_THROW(parseSceneFile("/dev/zero"), FileError);
}

std::string gzip(const ScratchDirectory& directory, const std::string& name, const std::string& text) {
    const std::string file = directory.file(name);
    const gzFile out = gzopen(file.c_str(), "wb");
    gzwrite(out, text.data(), unsigned(text.size()));
    gzclose(out);
    return file;
}

TEST(Files, Compressed) {
    const ScratchDirectory directory;
    gzip(directory, "part.pbrt.gz", "Shape \"disk\"\n");
    const auto main = gzip(directory, "scene.pbrt.gz", "WorldBegin\nInclude \"part.pbrt.gz\"\nShape \"sphere\"\n");
    EXPECT_EQ(parseSceneFile(main).shapes.size(), 2u);
}

TEST(Files, CutOffCompressedFileIsAFileError) {
    const ScratchDirectory directory;
    std::string text = "WorldBegin\n";
    for (int i = 0; i < 5000; ++i)
        text += "Translate " + std::to_string(i * 7919 % 1000) + " 0 0\n";
    const auto file = gzip(directory, "scene.pbrt.gz", text);
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    EXPECT_THROW(parseSceneFile(file), FileError);
}

TEST(Files, SmallOnesMustNotBecomeBoundlessText) {
    const ScratchDirectory directory;
    // 64 KiB of text in some hundred bytes.
    const auto packed = gzip(directory, "packed.pbrt.gz", std::string(65536, '#'));
    const auto plain = directory.write("plain.pbrt", std::string(65536, '#'));
    const auto spent = [] {
        TextBudget budget;
        budget.text = TextBudget::freeBytes - 20000;
        return budget;
    };
    TextBudget budget = spent();
    EXPECT_THROW(readWholeFile(packed, budget), FileError);
    budget = spent();
    EXPECT_EQ(readWholeFile(plain, budget).size(), 65536u) << "what lies in files is never too much";
    // It is counted once as lying there, and each time as text.
    int more = 0;
    while (more < 100)
        try {
            readWholeFile(plain, budget);
            ++more;
        } catch (const FileError& e) {
            EXPECT_EQ(std::string(e.what()), plain + ": with it the scene has more than 256 MiB of text and 32 times "
                                                     "what lies in its files: they are packed, or included again and "
                                                     "again");
            break;
        }
    EXPECT_EQ(more, int(TextBudget::packing) - 1);
}

TEST(Files, EverySceneOfTheRepositoryIsRead) {
    int scenes = 0;
    for (const char* folder : {"/scenes", "/tests/images"})
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(VITRINE_SOURCE_DIR + std::string(folder))) {
            if (entry.path().extension() != ".pbrt") continue;
            std::ifstream in(entry.path());
            const std::string text{std::istreambuf_iterator<char>(in), {}};
            if (text.find("WorldBegin") == std::string::npos) continue; // a part that a scene includes
            EXPECT_EQ(fileErrors(entry.path().string()), "");
            ++scenes;
        }
    EXPECT_GE(scenes, 3) << "vase, goblet, cornell";
}

TEST(Spd, ReadsPairsAndComments) {
    const ScratchDirectory directory;
    const SpdSamples samples = readSpd(directory.write("a.spd", "# measured\n400 .5\n\t500 0.75 # green\n700 1e-2"));
    EXPECT_THAT(samples.wavelengths, ElementsAre(400, 500, 700));
    EXPECT_THAT(samples.values, ElementsAre(.5, .75, .01));
}

TEST(Spd, ErrorsHavePlaces) {
    const ScratchDirectory directory;
    const auto error = [&](const std::string& text) -> std::string {
        try {
            readSpd(directory.write("a.spd", text));
            return {};
        } catch (const SceneError& e) {
            const auto& d = e.diagnostics().at(0);
            return std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " + d.message;
        }
    };
    EXPECT_EQ(error(""), "0:0 the file holds no spectrum");
    EXPECT_EQ(error("400 1\n500"), "2:1 the last wavelength lacks its value");
    EXPECT_EQ(error("400 1\n400 2"), "2:1 wavelengths must increase");
    EXPECT_EQ(error("400 1\nred 2"), "2:1 expected a number, got \"red\"");
    EXPECT_EQ(error("400 nan"), "1:5 numbers must be finite, got \"nan\"");
    EXPECT_EQ(error("-4 1"), "1:1 wavelengths (nm) must be positive");
    EXPECT_EQ(error("400 [1]"), "1:5 expected a number, got \"[\"");
    EXPECT_THROW(readSpd(directory.file("none.spd")), FileError);
}

} // namespace
} // namespace vitrine
