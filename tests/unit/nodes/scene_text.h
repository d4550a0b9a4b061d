// Short ways to scene texts, their nodes and their errors.
#pragma once

#include "nodes/parser.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace vitrine {

/// All errors of a text called "scene.pbrt", or "" when it has none.
inline std::string errorsOf(const std::string& text) {
    try {
        parseSceneString(text, "scene.pbrt");
        return {};
    } catch (const SceneError& error) {
        return error.what();
    }
}

/// How many errors a text has.
inline std::size_t errorCount(const std::string& text) {
    try {
        parseSceneString(text, "scene.pbrt");
        return 0;
    } catch (const SceneError& error) {
        return error.diagnostics().size();
    }
}

/// Nodes of a world block's text.
inline SceneNodes world(const std::string& text) {
    return parseSceneString("WorldBegin\n" + text, "scene.pbrt");
}

/// A directory for a test's files, removed at the end.
class ScratchDirectory {
  public:
    ScratchDirectory() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        path_ = std::filesystem::temp_directory_path() /
                ("vitrine_" + std::string(test->test_suite_name()) + "_" + test->name() + std::to_string(getpid()));
        std::filesystem::create_directories(path_);
    }
    ~ScratchDirectory() { std::filesystem::remove_all(path_); }
    ScratchDirectory(const ScratchDirectory&) = delete;
    ScratchDirectory& operator=(const ScratchDirectory&) = delete;

    std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << text;
        return file(name);
    }

  private:
    std::filesystem::path path_;
};

} // namespace vitrine
