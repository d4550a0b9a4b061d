#include "render_arguments.h"

#include "arguments.h"
#include "commands.h"
#include "scene/texture_images.h"

#include <fmt/format.h>

#include <charconv>

using namespace vitrine;

namespace {

std::uint64_t wholeNumber(const std::string& text, const std::string& flag) {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    if (const auto read = std::from_chars(text.data(), end, number); read.ec != std::errc() || read.ptr != end)
        throw std::invalid_argument(fmt::format("{} takes a whole number, not \"{}\"", flag, text));
    return number;
}

} // namespace

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
    if (a.textureCache && (*a.textureCache < 1 || *a.textureCache > TextureImages::mostMegabytes))
        throw std::invalid_argument("--texture-cache takes megabytes");
    o.textureCacheMegabytes = a.textureCache;
    if (a.denoise) throw NotYetSupported("--denoise is not yet supported");
    if (!a.aov.empty()) throw NotYetSupported("--aov is not yet supported");
    if (!a.displayServer.empty()) throw NotYetSupported("--display-server is not yet supported");
    if (!a.partial.empty() && !a.outputs.empty())
        throw std::invalid_argument("--partial writes sums and no picture: leave --outfile out");
    if (!a.partial.empty() && (a.resume || !a.checkpoint.empty()))
        throw std::invalid_argument("--partial is its own checkpoint: leave --checkpoint and --resume out");
}

void addRenderFlags(CLI::App& command, RenderArguments& a) {
    command.add_option("scene", a.scene, "Scene file, pbrt-v4's format")->required();
    command
        .add_option("-o,--outfile", a.outputs, "Picture to write (.exr .png .ppm .hdr .jpg), several times for several")
        ->take_all()
        ->allow_extra_args(false);
    command.add_option("--integrator", a.overrides.integrator, "Integrator in place of the scene's");
    command.add_option("--spp", a.spp, "Samples a pixel (the same as --passes)");
    command.add_option("--passes", a.passes, "Passes: N, or A:B for those from A up to B");
    command.add_option("--time", a.time, "Stop after so many seconds (without --spp: as many samples as fit)");
    command.add_option("--error", a.error,
                       "Stop at this estimated relMSE (without --spp: as many samples as it takes)");
    command.add_option("--seed", a.seed, "Seed of all random numbers");
    command.add_option("--nthreads", a.threads, "Threads; 0: all. The picture does not depend on it");
    command.add_option("--texture-cache", a.textureCache,
                       "Megabytes of image textures in memory (1024). The picture does not depend on it");
    command.add_option("--resolution", a.resolution, "WxH in place of the scene's");
    command.add_option("--cropwindow", a.cropWindow, "X0,X1,Y0,Y1 in [0,1]: render this part only");
    command.add_option("--pixelbounds", a.pixelBounds, "X0,X1,Y0,Y1 in pixels: render this part only");
    command.add_flag("--quick", a.overrides.quick, "A quarter of the resolution, one sample a pixel");
    command.add_option("--set", a.overrides.settings, "key=value: any integrator, film or sampler parameter")
        ->take_all()
        ->allow_extra_args(false);
    command.add_option("--checkpoint", a.checkpoint, "File to save the state in, now and then and at the end");
    command.add_option("--checkpoint-every", a.checkpointEvery, "Seconds between checkpoints");
    command.add_flag("--resume", a.resume, "Go on from the checkpoint, if there is one");
    command.add_option("--partial", a.partial, "Write the sums of these passes for \"vitrine merge\", and no picture");
    command.add_option("--progress", a.progress, "auto, bar, json or none");
    command.add_option("--stats", a.stats, "Write figures about the render to this JSON file");
    command.add_flag("--watch", a.watch, "Render again whenever the scene's files change");
    command.add_flag("--denoise", a.denoise, "Not yet supported");
    command.add_option("--aov", a.aov, "Not yet supported");
    command.add_option("--display-server", a.displayServer, "Not yet supported");
}
