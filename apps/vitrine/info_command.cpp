#include "commands.h"
#include "core/errors.h"
#include "scene/scene.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace {

using namespace vitrine;

std::string counted(const std::map<std::string, int>& types) {
    std::string text;
    for (const auto& [type, count] : types)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, type.empty() ? "interface" : type);
    return text.empty() ? "none" : text;
}

std::string box(const Box3d& b) {
    if (b.isEmpty()) return "empty";
    return fmt::format("({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g})", b.min.x, b.min.y, b.min.z, b.max.x, b.max.y,
                       b.max.z);
}

void printText(const Scene& s) {
    const V2i crop = s.film.cropSize();
    fmt::print("scene       {}\n", s.name);
    fmt::print("shapes      {} ({} primitives)\n", counted(s.shapeTypes), s.primitives);
    if (s.instances) fmt::print("instances   {}\n", s.instances);
    fmt::print("materials   {}\n", counted(s.materialTypes));
    fmt::print("lights      {}\n", counted(s.lightTypes));
    fmt::print("bounds      {}\n", box(s.world.caster->bounds()));
    fmt::print("camera      {}\n", s.cameraType);
    fmt::print("film        {} x {}", s.film.resolution.x, s.film.resolution.y);
    if (crop != s.film.resolution) fmt::print(", cropped to {} x {}", crop.x, crop.y);
    fmt::print(" -> {}\n", s.outputFile);
    fmt::print("integrator  {}, {} samples a pixel, sampler {}\n", s.integratorType, s.samplesPerPixel, s.samplerType);
    fmt::print("memory      {:.1f} MB ray casting, {:.1f} MB film\n", double(s.world.caster->memoryBytes()) / 1e6,
               double(crop.x) * crop.y * double(Film::bytesPerPixel) / 1e6);
}

void printJson(const Scene& s) {
    const Box3d b = s.world.caster->bounds();
    nlohmann::ordered_json json{{"scene", s.name},
                                {"shapes", s.shapeTypes},
                                {"primitives", s.primitives},
                                {"instances", s.instances},
                                {"materials", s.materialTypes},
                                {"lights", s.lightTypes},
                                {"camera", s.cameraType},
                                {"resolution", {s.film.resolution.x, s.film.resolution.y}},
                                {"integrator", s.integratorType},
                                {"samplesPerPixel", s.samplesPerPixel},
                                {"sampler", s.samplerType},
                                {"outputFile", s.outputFile},
                                {"casterBytes", s.world.caster->memoryBytes()},
                                {"files", s.files}};
    if (!b.isEmpty()) json["bounds"] = {{b.min.x, b.min.y, b.min.z}, {b.max.x, b.max.y, b.max.z}};
    fmt::print("{}\n", json.dump(2));
}

} // namespace

void registerInfo(CLI::App& app) {
    auto* command = app.add_subcommand("info", "Tell what is in a scene");
    auto file = std::make_shared<std::string>();
    auto json = std::make_shared<bool>(false);
    command->add_option("scene", *file, "Scene file")->required();
    command->add_flag("--json", *json, "As JSON");
    command->callback([file, json] {
        const Scene scene = loadScene(*file);
        for (const auto& warning : scene.warnings)
            fmt::print(stderr, "{}\n", warning.toString());
        if (*json)
            printJson(scene);
        else
            printText(scene);
    });
}
