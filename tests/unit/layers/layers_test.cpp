// The layers of src/: each folder may include only those before it in this list (docs/architecture.md).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> layers = {
    "core",    "spectrum", "nodes", "shapes", "plot",   "accel",       "textures", "bsdfs", "lights",
    "cameras", "media",    "film",  "paths",  "photons", "integrators", "denoise",  "scene", "render"};

std::ptrdiff_t layerOf(const std::string& folder) {
    return std::find(layers.begin(), layers.end(), folder) - layers.begin();
}

} // namespace

TEST(Layers, EachIncludesOnlyThoseAbove) {
    const fs::path source = fs::path(VITRINE_SOURCE_DIR) / "src";
    const std::regex include(R"re(^\s*#include "([a-z]+)/[^"]*")re");
    int files = 0, includes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(source)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp") continue;
        const std::string folder = (*fs::relative(entry.path(), source).begin()).string();
        if (folder == "pch.h") continue;
        ASSERT_LT(layerOf(folder), std::ptrdiff_t(layers.size())) << folder << " is in no layer";
        ++files;
        std::ifstream in(entry.path());
        std::string line;
        while (std::getline(in, line)) {
            std::smatch match;
            if (!std::regex_search(line, match, include)) continue;
            ++includes;
            EXPECT_LE(layerOf(match[1]), layerOf(folder)) << entry.path() << " includes " << match[1];
        }
    }
    EXPECT_GT(files, 50);
    EXPECT_GT(includes, 100);
}

TEST(Layers, OnlyTheApplicationsPrintOrExit) {
    const std::regex forbidden(R"(std::(cout|cerr|exit|abort|terminate)\b|\b(f?printf|puts)\(|fmt::print)");
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(VITRINE_SOURCE_DIR) / "src")) {
        const std::string path = entry.path().string();
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
        if (path.find("/tools/") != std::string::npos) continue; // programs that run while building
        std::ifstream in(entry.path());
        std::string line;
        for (int number = 1; std::getline(in, line); ++number) {
            const std::string code = line.substr(0, line.find("//"));
            EXPECT_FALSE(std::regex_search(code, forbidden)) << path << ":" << number << ": " << line;
        }
    }
}
