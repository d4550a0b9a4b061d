#include "arguments.h"
#include "commands.h"
#include "film/imageio.h"
#include "interrupts.h"
#include "progress.h"
#include "render/session.h"
#include "scene/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using namespace vitrine;

constexpr int stoppedBySignal = 3;
/// When only time or error ends a render: more samples than the samplers tell apart.
constexpr std::uint64_t unlimitedPasses = std::uint64_t(1) << 32;

struct RenderArguments {
    std::string scene;
    std::vector<std::string> outputs;
    Overrides overrides;
    std::string spp, passes, resolution, cropWindow, pixelBounds, progress = "auto", seed;
    double time = 0, error = 0, checkpointEvery = 60;
    int threads = 0;
    std::string checkpoint, partial, stats;
    bool resume = false, watch = false, denoise = false;
    std::string aov, displayServer;
};

std::uint64_t wholeNumber(const std::string& text, const std::string& flag) {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    if (const auto read = std::from_chars(text.data(), end, number); read.ec != std::errc() || read.ptr != end)
        throw std::invalid_argument(fmt::format("{} takes a whole number, not \"{}\"", flag, text));
    return number;
}

/// The passes that the flags ask for, if they do.
std::optional<PassRange> askedPasses(const RenderArguments& a) {
    if (!a.spp.empty() && !a.passes.empty()) throw std::invalid_argument("--spp and --passes are the same: give one");
    const std::string text = a.spp + a.passes;
    const std::string flag = a.spp.empty() ? "--passes" : "--spp";
    if (text.empty()) return {};
    PassRange range;
    if (const auto colon = text.find(':'); colon != std::string::npos && a.spp.empty()) {
        range = {wholeNumber(text.substr(0, colon), flag), wholeNumber(text.substr(colon + 1), flag)};
    } else {
        range = {0, wholeNumber(text, flag)};
    }
    if (range.begin >= range.end || range.end > unlimitedPasses)
        throw std::invalid_argument(fmt::format("{} {}: an empty range, or past {}", flag, text, unlimitedPasses));
    return range;
}

void readOverrides(RenderArguments& a) {
    Overrides& o = a.overrides;
    if (!a.resolution.empty()) {
        const auto r = numbers<int>(a.resolution, 'x', 2, "--resolution");
        o.resolution = V2i(r[0], r[1]);
    }
    if (!a.cropWindow.empty()) {
        const auto w = numbers<double>(a.cropWindow, ',', 4, "--cropwindow");
        o.cropWindow = {w[0], w[1], w[2], w[3]};
    }
    if (!a.pixelBounds.empty()) {
        const auto b = numbers<int>(a.pixelBounds, ',', 4, "--pixelbounds");
        o.pixelBounds = {b[0], b[1], b[2], b[3]};
    }
    if (!a.seed.empty()) o.seed = wholeNumber(a.seed, "--seed");
    if (!(a.time >= 0) || !std::isfinite(a.time)) throw std::invalid_argument("--time takes seconds");
    if (!(a.error >= 0)) throw std::invalid_argument("--error takes a relMSE");
    if (a.threads < 0 || a.threads > 4096) throw std::invalid_argument("--nthreads takes a count of threads");
    if (a.denoise) throw NotYetSupported("--denoise is not yet supported");
    if (!a.aov.empty()) throw NotYetSupported("--aov is not yet supported");
    if (!a.displayServer.empty()) throw NotYetSupported("--display-server is not yet supported");
    if (!a.partial.empty() && !a.outputs.empty())
        throw std::invalid_argument("--partial writes sums and no picture: leave --outfile out");
    if (!a.partial.empty() && (a.resume || !a.checkpoint.empty()))
        throw std::invalid_argument("--partial is its own checkpoint: leave --checkpoint and --resume out");
}

/// Finds out before hours of rendering, not after, that a picture could not be written.
void checkOutput(const std::string& file) {
    try {
        checkImageName(file);
    } catch (const FileError& e) {
        throw std::invalid_argument(e.what()); // the argument is wrong, no file has been touched
    }
    const fs::path folder = fs::absolute(file).parent_path();
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) throw FileError(file, "there is no folder " + folder.string());
    if (fs::is_directory(file, ignored)) throw FileError(file, "is a folder");
    if (access(folder.c_str(), W_OK) != 0) throw FileError(file, "its folder cannot be written to");
}

/// A film that memory does not hold must fail at once, not when the machine is out of it.
void checkMemory(const FilmSettings& film) {
    const double pixels = double(film.cropSize().x) * double(film.cropSize().y);
    const double bytes = pixels * double(Film::bytesPerPixel);
    const double memory = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
    if (bytes > 0.8 * memory)
        throw std::invalid_argument(fmt::format("a film of {} x {} pixels needs {:.1f} GB, this machine has {:.1f} GB",
                                                film.cropSize().x, film.cropSize().y, bytes / 1e9, memory / 1e9));
}

void writeStats(const std::string& file, const Scene& scene, const Film& film, const PartialRender& state,
                std::uint64_t samples, double seconds) {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double error = film.estimatedRelMse();
    nlohmann::ordered_json stats{{"scene", scene.name},
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
    std::ofstream out(file);
    out << stats.dump(2) << "\n";
    out.flush();
    if (!out) throw FileError(file, "cannot be written");
}

void printWarnings(const Scene& scene) {
    for (const auto& warning : scene.warnings)
        fmt::print(stderr, "{}\n", warning.toString());
}

/// What earlier sessions left in the checkpoint, if there is one.
void resume(const std::string& checkpoint, const Scene& scene, Film& film, PartialRender& state) {
    if (!fs::exists(checkpoint)) return;
    LoadedPartial loaded = readPartial(checkpoint);
    if (loaded.state.fingerprint != scene.fingerprint)
        throw std::invalid_argument(checkpoint + " is a checkpoint of another scene or of other settings");
    film.merge(loaded.film);
    state = std::move(loaded.state);
}

/// One render from scene to files. Returns the exit code.
int renderOnce(const RenderArguments& a, std::vector<std::string>* watched) {
    const auto asked = askedPasses(a);
    Overrides overrides = a.overrides;
    if (asked) overrides.samplesPerPixel = asked->end;
    const Scene scene = loadScene(a.scene, overrides);
    if (watched) *watched = scene.files;
    printWarnings(scene);
    checkMemory(scene.film);

    const std::vector<std::string> outputs =
        !a.partial.empty() ? std::vector<std::string>{}
                           : (a.outputs.empty() ? std::vector<std::string>{scene.outputFile} : a.outputs);
    for (const auto& output : outputs)
        checkOutput(output);
    const std::string defaultCheckpoint = outputs.empty() ? a.partial : outputs.front() + ".checkpoint";
    const std::string checkpoint = a.checkpoint.empty() && a.resume ? defaultCheckpoint : a.checkpoint;

    SessionOptions options;
    options.passes = asked.value_or(PassRange{0, scene.samplesPerPixel});
    options.timeLimit = a.time;
    options.errorLimit = a.error;
    if (!asked && (a.time > 0 || a.error > 0)) options.passes.end = unlimitedPasses;
    options.threads = a.threads;
    options.checkpointFile = checkpoint;
    options.checkpointInterval = a.checkpointEvery;

    Film film(scene.film);
    PartialRender state;
    state.fingerprint = scene.fingerprint;
    state.sceneName = scene.name;
    state.matrices = scene.metadata.matrices;
    if (a.resume) resume(checkpoint, scene, film, state);

    ProgressReport report(progressStyle(a.progress), state.seconds);
    const double before = state.seconds;
    SessionProgress last;
    Session session(scene.world, *scene.integrator, film, state);
    const SessionEnd end = session.run(
        options,
        [&](const SessionProgress& progress) {
            last = progress;
            report.show(progress);
        },
        interrupted);
    report.finish();

    if (const auto bad = film.firstBadPixel())
        fmt::print(stderr,
                   "vitrine: warning: {} samples were not finite (left out) or too bright for the film's sums (held at "
                   "their end), first in pixel {},{}\n",
                   film.badSamples(), bad->x, bad->y);
    // A few come from rounding at edges.
    if (last.lostExits * 1000 > last.samples)
        fmt::print(
            stderr,
            "vitrine: warning: {} times a path lost track of the solids it was in: solids with a priority that touch "
            "must overlap, and each must be closed\n",
            last.lostExits);
    if (!a.partial.empty()) writePartial(a.partial, state, film);
    ImageMetadata metadata = scene.metadata;
    metadata.numbers["samplesPerPixel"] = double(state.passes.size());
    for (const auto& output : outputs)
        writeImage(output, film.image(), metadata);
    if (!a.stats.empty()) writeStats(a.stats, scene, film, state, last.samples, state.seconds - before);
    if (end != SessionEnd::Interrupted) return 0;
    if (checkpoint.empty() && a.partial.empty()) writePartial(defaultCheckpoint, state, film);
    fmt::print(stderr, "vitrine: stopped after {} passes; go on with --resume --checkpoint {}\n", state.passes.size(),
               checkpoint.empty() ? defaultCheckpoint : checkpoint);
    return stoppedBySignal;
}

/// Newest time of change of the files; files that are gone count as oldest.
fs::file_time_type newestChange(const std::vector<std::string>& files) {
    fs::file_time_type newest = fs::file_time_type::min();
    for (const auto& file : files) {
        std::error_code error;
        const auto time = fs::last_write_time(file, error);
        if (!error) newest = std::max(newest, time);
    }
    return newest;
}

/// Renders whenever the scene's files change, until interrupted. Errors are shown and waited out.
int renderAndWatch(const RenderArguments& a) {
    std::vector<std::string> files{a.scene};
    while (!interrupted()) {
        const auto before = newestChange(files);
        try {
            renderOnce(a, &files);
        } catch (const SceneError& e) {
            fmt::print(stderr, "{}\n", e.what());
        } catch (const FileError& e) {
            fmt::print(stderr, "vitrine: {}\n", e.what());
        } catch (const std::invalid_argument& e) {
            fmt::print(stderr, "vitrine: {}\n", e.what());
        }
        fmt::print(stderr, "vitrine: watching {}; Ctrl-C ends\n", a.scene);
        // Files that the last reading added count from now on.
        auto last = std::max(before, newestChange(files));
        while (!interrupted() && newestChange(files) <= last)
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
    }
    return stoppedBySignal;
}

} // namespace

void registerRender(CLI::App& app, int& exitCode) {
    auto* command = app.add_subcommand("render", "Render a scene to pictures");
    auto a = std::make_shared<RenderArguments>();
    command->add_option("scene", a->scene, "Scene file, pbrt-v4's format")->required();
    command
        ->add_option("-o,--outfile", a->outputs,
                     "Picture to write (.exr .png .ppm .hdr .jpg), several times for several")
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--integrator", a->overrides.integrator, "Integrator in place of the scene's");
    command->add_option("--spp", a->spp, "Samples a pixel (the same as --passes)");
    command->add_option("--passes", a->passes, "Passes: N, or A:B for those from A up to B");
    command->add_option("--time", a->time, "Stop after so many seconds (without --spp: as many samples as fit)");
    command->add_option("--error", a->error,
                        "Stop at this estimated relMSE (without --spp: as many samples as it takes)");
    command->add_option("--seed", a->seed, "Seed of all random numbers");
    command->add_option("--nthreads", a->threads, "Threads; 0: all. The picture does not depend on it");
    command->add_option("--resolution", a->resolution, "WxH in place of the scene's");
    command->add_option("--cropwindow", a->cropWindow, "X0,X1,Y0,Y1 in [0,1]: render this part only");
    command->add_option("--pixelbounds", a->pixelBounds, "X0,X1,Y0,Y1 in pixels: render this part only");
    command->add_flag("--quick", a->overrides.quick, "A quarter of the resolution, one sample a pixel");
    command->add_option("--set", a->overrides.settings, "key=value: any integrator, film or sampler parameter")
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--checkpoint", a->checkpoint, "File to save the state in, now and then and at the end");
    command->add_option("--checkpoint-every", a->checkpointEvery, "Seconds between checkpoints");
    command->add_flag("--resume", a->resume, "Go on from the checkpoint, if there is one");
    command->add_option("--partial", a->partial,
                        "Write the sums of these passes for \"vitrine merge\", and no picture");
    command->add_option("--progress", a->progress, "auto, bar, json or none");
    command->add_option("--stats", a->stats, "Write figures about the render to this JSON file");
    command->add_flag("--watch", a->watch, "Render again whenever the scene's files change");
    command->add_flag("--denoise", a->denoise, "Not yet supported");
    command->add_option("--aov", a->aov, "Not yet supported");
    command->add_option("--display-server", a->displayServer, "Not yet supported");
    command->callback([a, &exitCode] {
        readOverrides(*a);
        progressStyle(a->progress);
        catchInterrupts();
        exitCode = a->watch ? renderAndWatch(*a) : renderOnce(*a, nullptr);
    });
}
