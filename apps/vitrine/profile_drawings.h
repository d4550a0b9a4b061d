// What `vitrine profile` draws: the profiles of a scene or the outlines of an SVG file.
#pragma once

#include "core/errors.h"
#include "plot/profile_figure.h"

#include <functional>

/// One thing to be drawn and the names it is chosen by.
struct FoundProfile {
    std::vector<std::string> names; ///< id and label in an SVG file
    bool hidden = false;            ///< drawn only when chosen by name
    /// What is to be drawn; adds what is odd about it to the warnings. \throws vitrine::SceneError
    std::function<vitrine::plot::ProfileDrawing(std::vector<vitrine::Diagnostic>&)> draw;
};

/// More would be a blot, and take minutes.
inline constexpr std::size_t mostSegmentsInFigure = 2000;

struct FoundProfiles {
    std::vector<FoundProfile> profiles; ///< in the order of the file
    std::vector<vitrine::Diagnostic> warnings;
};

/// Every shape "revolution" once.
/// \param ray in world space; a shape of several instances is drawn as the instance that it meets first
/// \throws vitrine::SceneError, vitrine::FileError
FoundProfiles profilesOfScene(const std::string& file, const std::optional<vitrine::Ray>& ray);

/// Every outline; one that cannot be turned is drawn too, with a warning, but one that cannot be read only warned of.
/// \param settings parameters of a revolution that say where its axis is in the drawing, as for --set
/// \param ray in the profile's own space
/// \throws vitrine::SceneError, vitrine::FileError
FoundProfiles profilesOfSvg(const std::string& file, const std::vector<std::string>& settings,
                            const std::optional<vitrine::Ray>& ray);

/// \throws vitrine::SceneError for too many
void checkSegments(std::size_t count, const vitrine::Place& place);

/// "closed: 8 segments of degree 3, ...", for the subtitle.
std::string describeProfile(const vitrine::plot::ProfileDrawing& drawing);

/// How a ray was given, for the figure.
std::string describeRay(const std::string& space, const vitrine::Ray& ray);
