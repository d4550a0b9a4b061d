// A scene file, read and built: everything a render needs.
#pragma once

#include "core/errors.h"
#include "film/film.h"
#include "film/imageio.h"
#include "integrators/integrator.h"
#include "paths/world.h"
#include "scene/overrides.h"

namespace vitrine {

struct Scene {
    std::string name; ///< of the file, as given
    World world;
    std::unique_ptr<Integrator> integrator;
    FilmSettings film;
    std::uint64_t samplesPerPixel = 16; ///< passes
    std::string outputFile;             ///< as the scene names it; else the scene's own name with .exr, or vitrine.exr
    ImageMetadata metadata;             ///< camera and window, for pictures
    std::vector<Diagnostic> warnings;
    /// Of all texts and files and settings that change the picture: partial renders of other scenes do not merge.
    std::uint64_t fingerprint = 0;
    std::vector<std::string> files; ///< everything that was read, for --watch

    /// Counts for `vitrine info`.
    std::map<std::string, int> shapeTypes, lightTypes, materialTypes;
    std::size_t primitives = 0, instances = 0;
    std::string cameraType, integratorType, samplerType;
};

/// \throws SceneError with everything that is wrong, FileError for files that cannot be read
Scene loadScene(const std::string& file, const Overrides& overrides = {});
Scene loadSceneString(const std::string& text, const std::string& name = "<string>", const Overrides& overrides = {},
                      const std::string& baseDirectory = {});

} // namespace vitrine
