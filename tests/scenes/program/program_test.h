// What tests of the program share: a folder of their own, and a small scene.
#pragma once

#include "film/imageio.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace vitrine::test {

class ProgramTest : public testing::Test {
  protected:
    using Arguments = std::vector<std::string>;

    std::string path(const std::string& name) const { return folder_.file(name); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
        return path(name);
    }
    std::string read(const std::string& name) const {
        std::ifstream in(path(name), std::ios::binary);
        EXPECT_TRUE(in.good()) << name << " is not there";
        std::stringstream text;
        text << in.rdbuf();
        return text.str();
    }
    bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

    /// `vitrine ARGUMENTS...` in the test's folder.
    ProgramResult run(const Arguments& arguments, double timeout = 60) const {
        return runVitrine(arguments, {.folder = folder_.file(""), .timeout = timeout});
    }
    /// The same, which must end well and say nothing on standard error.
    void succeed(const Arguments& arguments) const {
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.describe();
        EXPECT_EQ(result.err, "");
    }
    /// The same, which must end with this exit code and exactly this on standard error.
    void fail(const Arguments& arguments, int exitCode, const std::string& message) const {
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, exitCode) << result.describe();
        EXPECT_EQ(result.err, message + "\n");
        EXPECT_EQ(result.out, "");
    }

    /// A lit room of a few pixels, called "scene.pbrt".
    std::string writeScene(const std::string& header = "", const std::string& world = "") const {
        return write("scene.pbrt",
                     "LookAt 0 1 4  0 .6 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
                     "Film \"rgb\" \"integer xresolution\" 24 \"integer yresolution\" 16\n"
                     "Sampler \"zsobol\" \"integer pixelsamples\" 4\n"
                     "Integrator \"path\" \"integer maxdepth\" 8\n" +
                         header +
                         "WorldBegin\nLightSource \"infinite\" \"rgb L\" [ .4 .5 .6 ]\n"
                         "AttributeBegin Rotate -90 1 0 0 Shape \"disk\" \"float radius\" 20 AttributeEnd\n"
                         "AttributeBegin\n  Translate 0 .6 0\n  Material \"dielectric\"\n"
                         "  Shape \"sphere\" \"float radius\" .6\nAttributeEnd\n" +
                         world);
    }

    TemporaryFolder folder_;
};

} // namespace vitrine::test
