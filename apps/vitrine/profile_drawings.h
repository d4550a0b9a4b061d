// What `vitrine profile` draws: the profiles of a scene or the outlines of an SVG file.
#pragma once

#include "core/errors.h"
#include "plot/profile_figure.h"

/// One thing to be drawn and the names it is chosen by.
struct FoundProfile {
    std::string id; ///< in an SVG file; or empty
    vitrine::plot::ProfileDrawing drawing;
};

struct FoundProfiles {
    std::vector<FoundProfile> profiles; ///< in the order of the file
    std::vector<vitrine::Diagnostic> warnings;
};

/// Every shape "revolution" once.
/// \param ray in world space; a shape of several instances is drawn as the instance that it meets first
/// \throws vitrine::SceneError, vitrine::FileError
FoundProfiles profilesOfScene(const std::string& file, const std::optional<vitrine::Ray>& ray);
