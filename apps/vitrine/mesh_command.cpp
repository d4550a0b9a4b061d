#include "commands.h"
#include "console.h"
#include "core/errors.h"
#include "core/replace_file.h"
#include "nodes/scene_writer.h"
#include "scene/plain_scene.h"
#include "shapes/ply_writer.h"

#include <fmt/format.h>

#include <filesystem>

namespace {

using namespace vitrine;
namespace fs = std::filesystem;

struct MeshArguments {
    std::string scene, folder;
    MeshOptions options;
};

void checkArguments(const MeshArguments& a) {
    if (a.scene == "-") throw std::invalid_argument("mesh reads a scene file, not standard input");
    if (!(a.options.tolerance > 0) || !std::isfinite(a.options.tolerance))
        throw std::invalid_argument(
            fmt::format("--tolerance must be positive and finite, not {:g}", a.options.tolerance));
    if (a.options.triangles && *a.options.triangles == 0) throw std::invalid_argument("--triangles must be positive");
}

void makeFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder.string(), "cannot be made: " + error.message());
    if (!fs::is_directory(folder)) throw FileError(folder.string(), "is no folder");
}

/// A run may write over what an earlier one wrote, but over nothing that this one reads.
void refuseOverwriting(const PlainScene& scene, const fs::path& folder, const fs::path& text) {
    std::vector<fs::path> read, written{text};
    for (const auto& source : scene.nodes.sources)
        read.emplace_back(source->name);
    for (const auto& copy : scene.copies)
        read.emplace_back(copy.from), written.push_back(folder / copy.to);
    for (const auto& mesh : scene.meshes)
        written.push_back(folder / mesh.fileName);
    std::error_code ignored;
    for (const fs::path& to : written)
        for (const fs::path& from : read)
            if (fs::equivalent(to, from, ignored))
                throw std::invalid_argument(
                    fmt::format("mesh would write over {}, which it reads: choose another folder", from.string()));
}

void copyFile(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
    if (error)
        throw FileError(to.string(), fmt::format("cannot be copied from {}: {}", from.string(), error.message()));
}

std::string textName(const std::string& scene) {
    fs::path name = fs::path(scene).filename();
    if (name.extension() == ".gz") name = name.stem();
    return name.replace_extension(".pbrt").string();
}

void mesh(const MeshArguments& a) {
    checkArguments(a);
    const PlainScene scene = makePlainScene(a.scene, a.options);
    for (const auto& warning : scene.warnings)
        tellLine("{}", warning.toString());

    const fs::path folder(a.folder), text = folder / textName(a.scene);
    refuseOverwriting(scene, folder, text);
    makeFolder(folder);
    if (!scene.meshes.empty()) makeFolder(folder / "meshes");
    if (!scene.copies.empty()) makeFolder(folder / "resources");
    for (const auto& copy : scene.copies)
        copyFile(copy.from, folder / copy.to);
    std::string report;
    for (const auto& each : scene.meshes) {
        writePly((folder / each.fileName).string(), each.make(),
                 fmt::format("surface of revolution within {:g} by vitrine " VITRINE_VERSION, each.tolerance));
        report += fmt::format("{}: {} triangles, within {:g}\n", each.fileName, each.triangles, each.tolerance);
    }
    const std::string plain = writeScene(scene.nodes, {fmt::format("{} in plain pbrt-v4, written by vitrine mesh.",
                                                                   fs::path(a.scene).filename().string())});
    replaceFile(text.string(), {std::as_bytes(std::span(plain))});
    printOut(report + text.string() + "\n");
}

} // namespace

void registerMesh(CLI::App& app) {
    auto* command = app.add_subcommand("mesh", "Write a scene as plain pbrt-v4, turned profiles as PLY meshes");
    auto a = std::make_shared<MeshArguments>();
    command->add_option("scene", a->scene, "Scene file")->required();
    command->add_option("-o,--outfile", a->folder, "Folder for the scene, its meshes and resources")->required();
    auto* tolerance = command
                          ->add_option("--tolerance", a->options.tolerance,
                                       "Largest distance between mesh and exact surface, in parts of the shape's "
                                       "diameter or height, whichever is larger")
                          ->capture_default_str();
    command->add_option("--triangles", a->options.triangles, "As fine as so many triangles a shape allow")
        ->excludes(tolerance);
    command->add_flag("--only-revolutions", a->options.onlyRevolutions,
                      "Keep everything else as it is, also what pbrt-v4 does not know");
    command->callback([a] { mesh(*a); });
}
