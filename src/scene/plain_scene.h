// A scene as every program that knows pbrt-v4's format can read it: turned profiles as meshes, nothing that is ours alone.
#pragma once

#include "nodes/nodes.h"
#include "shapes/mesh.h"

#include <optional>

namespace vitrine {

class Revolution;

struct MeshOptions {
    double tolerance = 1e-4; ///< largest distance from the exact surface, in parts of its diameter or height
    std::optional<std::uint64_t> triangles; ///< instead: as fine as so many a shape allow
    bool onlyRevolutions = false;           ///< everything else stays, what is ours alone included
};

struct PlainScene {
    /// A mesh to be written. Shapes with the same profile share one.
    struct Mesh {
        std::string fileName; ///< relative to the scene's text
        std::shared_ptr<const Revolution> shape;
        double tolerance;            ///< in units of the profile
        std::uint64_t triangles = 0; ///< how many it will have

        /// In object space, with the shape's (u, v).
        MeshInput make() const;
    };
    /// A file that the scene reads.
    struct Copy {
        std::string from, to; ///< to: relative to the scene's text
    };

    SceneNodes nodes; ///< file names are those of the copies and meshes
    std::vector<Mesh> meshes;
    std::vector<Copy> copies;
    std::vector<Diagnostic> warnings; ///< what pbrt-v4 cannot say
};

/// \throws SceneError for what is wrong with the scene or cannot be taken to pbrt-v4, FileError for files that cannot be
/// read
PlainScene makePlainScene(const std::string& file, const MeshOptions& options = {});

} // namespace vitrine
