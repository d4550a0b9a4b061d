#include "commands.h"
#include "console.h"
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

std::string asText(const Scene& s) {
    const V2i crop = s.film.cropSize();
    const auto line = [](const char* name, const std::string& text) { return fmt::format("{:<12}{}\n", name, text); };
    std::string film = fmt::format("{} x {}", s.film.resolution.x, s.film.resolution.y);
    if (crop != s.film.resolution) film += fmt::format(", cropped to {} x {}", crop.x, crop.y);
    return line("scene", s.name) +
           line("shapes", fmt::format("{} ({} primitives)", counted(s.shapeTypes), s.primitives)) +
           (s.instances ? line("instances", fmt::format("{}", s.instances)) : "") +
           line("materials", counted(s.materialTypes)) + line("lights", counted(s.lightTypes)) +
           line("bounds", box(s.world.caster->bounds())) + line("camera", s.cameraType) +
           line("film", film + " -> " + s.outputFile) +
           line("integrator",
                fmt::format("{}, {} samples a pixel, sampler {}", s.integratorType, s.samplesPerPixel, s.samplerType)) +
           line("memory",
                fmt::format("{:.1f} MB ray casting, {:.1f} MB film", double(s.world.caster->memoryBytes()) / 1e6,
                            double(crop.x) * crop.y * double(Film::bytesPerPixel) / 1e6));
}

std::string asJson(const Scene& s) {
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
    return json.dump(2) + "\n";
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
            tellLine("{}", warning.toString());
        printOut(*json ? asJson(scene) : asText(scene));
    });
}
