#include "render_output.h"

#include "core/replace_file.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <sys/resource.h>

namespace fs = std::filesystem;
using namespace vitrine;
using Json = nlohmann::ordered_json;

namespace {

double ratio(std::uint64_t a, std::uint64_t b) {
    return b > 0 ? double(a) / double(b) : 0;
}

/// Of photon integrators; what does not apply to one is left out.
Json photonFigures(const RenderCounters& counters, double seconds) {
    const std::uint64_t paths = counters.photonPaths, points = counters.gatherPoints;
    Json figures{{"paths", paths}, {"pathsPerSecond", seconds > 0 ? double(paths) / seconds : 0}};
    if (points == 0) return figures;
    figures["landedShare"] = ratio(counters.landedPaths, paths);
    figures["kept"] = counters.photons.load();
    figures["gatherPoints"] = points;
    figures["foundPerPoint"] = ratio(counters.gathered, points);
    figures["bytes"] = counters.photonBytes.load();
    figures["smallestRadius"] = counters.smallestRadius.load();
    figures["largestRadius"] = counters.largestRadius.load();
    const auto inSeconds = [](std::uint64_t nanoseconds) { return double(nanoseconds) * 1e-9; };
    figures["seconds"] = Json{{"photons", inSeconds(counters.photonNanoseconds)},
                              {"sorting", inSeconds(counters.sortNanoseconds)},
                              {"eyePaths", inSeconds(counters.eyeNanoseconds)},
                              {"gathering", inSeconds(counters.gatherNanoseconds)}};
    return figures;
}

} // namespace

void checkWritable(const std::string& file) {
    const fs::path folder = fs::absolute(file).parent_path();
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) throw FileError(file, "there is no folder " + folder.string());
    if (fs::is_directory(file, ignored)) throw FileError(file, "is a folder");
    checkReplaceable(file);
}

void checkPicture(const std::string& file) {
    try {
        checkImageName(file);
    } catch (const FileError& e) {
        throw std::invalid_argument(e.what()); // the argument is wrong, no file has been touched
    }
    checkWritable(file);
}

void writeStats(const std::string& file, const Scene& scene, const Film& film, const PartialRender& state,
                const RenderCounters& counters, double seconds) {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double error = film.estimatedRelMse();
    const std::uint64_t samples = counters.samples;
    Json stats{{"scene", scene.name},
               {"integrator", scene.integratorType},
               {"width", film.settings().cropSize().x},
               {"height", film.settings().cropSize().y},
               {"passes", state.passes.size()},
               {"samples", samples},
               {"seconds", seconds},
               {"samplesPerSecond", seconds > 0 ? double(samples) / seconds : 0},
               {"badSamples", film.badSamples()},
               {"casterBytes", scene.world.caster->memoryBytes()},
               {"peakMemoryBytes", std::uint64_t(usage.ru_maxrss) * 1024}};
    if (std::isfinite(error)) stats["estimatedRelMSE"] = error;
    if (counters.photonPaths > 0) stats["photons"] = photonFigures(counters, seconds);
    const std::string text = stats.dump(2) + "\n";
    replaceFile(file, {std::as_bytes(std::span(text))});
}
