// Short ways to built scenes and their errors.
#pragma once

#include "scene/scene.h"

#include <gtest/gtest.h>

namespace vitrine {

inline Scene built(const std::string& text, const Overrides& overrides = {}) {
    return loadSceneString(text, "scene.pbrt", overrides);
}

/// First line of every error of a text, without the file's name: "2:3: error: ...", or nothing when it is right.
inline std::vector<std::string> errorsOf(const std::string& text, const Overrides& overrides = {}) {
    std::vector<std::string> lines;
    try {
        built(text, overrides);
    } catch (const SceneError& error) {
        for (const Diagnostic& d : error.diagnostics()) {
            const std::string full = d.toString(), name = "scene.pbrt:";
            const std::string first = full.substr(0, full.find('\n'));
            lines.push_back(first.starts_with(name) ? first.substr(name.size()) : first);
        }
    }
    return lines;
}

using Lines = std::vector<std::string>;

} // namespace vitrine
