#include "commands.h"
#include "film/imageio.h"
#include "interrupts.h"
#include "progress.h"
#include "render_arguments.h"
#include "render_output.h"

#include <filesystem>
#include <thread>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using namespace vitrine;

constexpr int fileTrouble = 2, stoppedBySignal = 3;

/// A film that memory does not hold must fail at once, not when the machine is out of it.
void checkMemory(const FilmSettings& film) {
    const double pixels = double(film.cropSize().x) * double(film.cropSize().y);
    const double bytes = pixels * double(Film::bytesPerPixel);
    const double memory = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
    if (bytes > 0.8 * memory)
        throw std::invalid_argument(fmt::format("a film of {} x {} pixels needs {:.1f} GB, this machine has {:.1f} GB",
                                                film.cropSize().x, film.cropSize().y, bytes / 1e9, memory / 1e9));
}

void printWarnings(const Scene& scene) {
    for (const auto& warning : scene.warnings)
        tellLine("{}", warning.toString());
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

/// Where a render goes.
struct Destinations {
    std::vector<std::string> pictures;
    std::string checkpoint;        ///< empty: none was asked for
    std::string defaultCheckpoint; ///< of renders that are stopped
};

/// \throws FileError, std::invalid_argument for what could not be written
Destinations destinations(const RenderArguments& a, const Scene& scene) {
    Destinations to;
    if (a.partial.empty()) to.pictures = a.outputs.empty() ? std::vector{scene.outputFile} : a.outputs;
    to.defaultCheckpoint = to.pictures.empty() ? a.partial : to.pictures.front() + ".checkpoint";
    to.checkpoint = a.checkpoint.empty() && a.resume ? to.defaultCheckpoint : a.checkpoint;
    for (const auto& picture : to.pictures)
        checkPicture(picture);
    for (const auto& file : {a.partial, to.checkpoint, a.stats})
        if (!file.empty()) checkWritable(file);
    return to;
}

SessionOptions sessionOptions(const RenderArguments& a, const Scene& scene, const std::optional<PassRange>& asked,
                              const std::string& checkpoint) {
    SessionOptions options;
    options.passes = asked.value_or(PassRange{0, scene.samplesPerPixel});
    options.timeLimit = a.time;
    options.errorLimit = a.error;
    if (!asked && (a.time > 0 || a.error > 0)) options.passes.end = unlimitedPasses;
    options.threads = a.threads;
    options.checkpointFile = checkpoint;
    options.checkpointInterval = a.checkpointEvery;
    options.checkpointFailed = [told = false](const FileError& e) mutable {
        if (!told) tellLine("vitrine: warning: {}; the render goes on and tries again", e.what());
        told = true;
    };
    return options;
}

/// What may be wrong with the picture.
void warnOfPicture(const Film& film, const RenderCounters& counters) {
    if (const auto bad = film.firstBadPixel())
        tellLine("vitrine: warning: {} samples were not finite (left out) or too bright for the film's sums (held at "
                 "their end), first in pixel {},{}",
                 film.badSamples(), bad->x, bad->y);
    // A few come from rounding at edges.
    if (counters.lostExits * 1000 > counters.samples)
        tellLine("vitrine: warning: {} times a path lost track of the solids it was in: solids with a priority that "
                 "touch must overlap, and each must be closed",
                 counters.lostExits.load());
    // Where few paths leave photons nearly all light may be direct, which they do not carry; and few say nothing.
    constexpr std::uint64_t enough = 1000, leastShare = 100;
    if (counters.photons >= std::max(enough, counters.photonPaths / leastShare) && counters.gatherPoints > 0 &&
        counters.gathered == 0)
        tellLine("vitrine: warning: photons never reach what the camera sees: of {} none lies near the {} points where "
                 "its paths end",
                 counters.photons.load(), counters.gatherPoints.load());
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
    if (!a.partial.empty() && !scene.integrator->passesAreIndependent())
        throw std::invalid_argument("--partial: with these settings each pass builds on those before it, so that parts "
                                    "cannot be merged: use --checkpoint");
    const Destinations to = destinations(a, scene);

    Film film(scene.film);
    PartialRender state;
    state.fingerprint = scene.fingerprint;
    state.sceneName = scene.name;
    state.matrices = scene.metadata.matrices;
    if (a.resume) resume(to.checkpoint, scene, film, state);

    ProgressReport report(progressStyle(a.progress), state.seconds);
    const double before = state.seconds;
    Session session(scene.world, *scene.integrator, film, state);
    const SessionEnd end = session.run(
        sessionOptions(a, scene, asked, to.checkpoint), [&](const SessionProgress& progress) { report.show(progress); },
        interrupted);
    report.finish();
    warnOfPicture(film, session.counters());

    FileWriter files;
    bool saved = !session.saveError();
    if (!saved) files.fail(*session.saveError());
    if (!a.partial.empty()) saved = files.attempt([&] { writePartial(a.partial, state, film); });
    ImageMetadata metadata = scene.metadata;
    metadata.numbers["samplesPerPixel"] = double(state.passes.size());
    for (const auto& picture : to.pictures)
        files.attempt([&] { writeImage(picture, film.image(), metadata); });
    if (!a.stats.empty())
        files.attempt([&] { writeStats(a.stats, scene, film, state, session.counters(), state.seconds - before); });
    if (end == SessionEnd::Interrupted) {
        if (to.checkpoint.empty() && a.partial.empty())
            saved = files.attempt([&] { writePartial(to.defaultCheckpoint, state, film); });
        if (saved)
            tellLine("vitrine: stopped after {} passes; go on with --resume --checkpoint {}", state.passes.size(),
                     to.checkpoint.empty() ? to.defaultCheckpoint : to.checkpoint);
    }
    return files.failed() ? fileTrouble : end == SessionEnd::Interrupted ? stoppedBySignal : 0;
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
            tellLine("{}", e.what());
        } catch (const FileError& e) {
            tellLine("vitrine: {}", e.what());
        } catch (const std::invalid_argument& e) {
            tellLine("vitrine: {}", e.what());
        }
        tellLine("vitrine: watching {}; Ctrl-C ends", a.scene);
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
    addRenderFlags(*command, *a);
    command->callback([a, &exitCode] {
        readOverrides(*a);
        progressStyle(a->progress);
        catchInterrupts();
        exitCode = a->watch ? renderAndWatch(*a) : renderOnce(*a, nullptr);
    });
}
