#include "scene/integrator_builder.h"

#include "integrators/light_tracing.h"
#include "integrators/path.h"
#include "integrators/photon_mapping.h"
#include "scene/registry.h"

#include <fmt/format.h>

namespace vitrine {

namespace {

/// The scene's sampler, whether its seed is the command line's, and where to say what is odd.
struct Sampling {
    SamplerSettings settings;
    bool seedIsOverride;
    Diagnostics& diagnostics;
};

/// Of photon integrators: with a seed of their own, if they have one. The command line's comes first.
SamplerSettings withOwnSeed(const ParameterSet& p, const Sampling& sampling) {
    SamplerSettings settings = sampling.settings;
    const auto seed = p.findInteger("seed");
    if (seed && !sampling.seedIsOverride) settings.seed = std::uint64_t(*seed);
    return settings;
}

int maxDepth(const ParameterSet& p, int otherwise) {
    const int depth = p.getInteger("maxdepth", otherwise);
    if (depth < 0) p.error("maxdepth", "\"maxdepth\" must not be negative");
    return depth;
}

/// How lights are chosen. pbrt-v4's "exhaustive" weighs every light as its "bvh" weighs groups of them: the tree serves.
LightSampler::Choice lightChoice(const ParameterSet& p) {
    if (!p.has("lightsampler")) return LightSampler::Choice::Fitting;
    const std::string name = p.getChoice("lightsampler", "bvh", {"uniform", "power", "bvh", "exhaustive"});
    if (name == "uniform") return LightSampler::Choice::Uniform;
    return name == "power" ? LightSampler::Choice::Power : LightSampler::Choice::Tree;
}

/// Of an integrator that only starts paths at lights: no tree.
LightSampler::Choice startChoice(const ParameterSet& p) {
    return lightChoice(p) == LightSampler::Choice::Uniform ? LightSampler::Choice::Uniform
                                                           : LightSampler::Choice::Power;
}

/// Of photon integrators, if the scene gives them.
std::optional<std::uint64_t> passes(const ParameterSet& p) {
    const auto count = p.findInteger("iterations");
    if (!count) return {};
    if (*count < 1) p.error("iterations", "\"iterations\" must be at least 1");
    return std::uint64_t(*count);
}

IntegratorPlan path(const ParameterSet& p, const Sampling& sampling) {
    PathSettings s;
    s.maxDepth = maxDepth(p, s.maxDepth);
    s.rrDepth = p.getInteger("rrdepth", s.rrDepth);
    s.regularize = p.getBool("regularize", s.regularize);
    s.nee = p.getBool("nee", s.nee);
    if (s.rrDepth < 0) p.error("rrdepth", "\"rrdepth\" must not be negative");
    return {std::make_unique<PathIntegrator>(s, sampling.settings), {lightChoice(p), false, {}}, {}};
}

std::int64_t pathsPerPass(const ParameterSet& p) {
    const int paths = p.getInteger("photonsperiteration", -1);
    if (paths == 0 || paths < -1)
        p.error("photonsperiteration", "\"photonsperiteration\" must be positive, or -1 for as many as pixels");
    return paths;
}

PhotonMappingSettings photonMapping(const ParameterSet& p, const Sampling& sampling) {
    PhotonMappingSettings s;
    s.eye.maxDepth = maxDepth(p, s.eye.maxDepth);
    if (constexpr int deepest = Photon::maxDepth + 1; s.eye.maxDepth > deepest)
        sampling.diagnostics.warning(
            p.place("maxdepth"),
            fmt::format("paths of photons end after {} scattering events: light that needs more is missing", deepest));
    s.photonsPerPass = pathsPerPass(p);
    s.rule = p.getChoice("radiusrule", "shared", {"shared", "perpoint"}) == "shared" ? RadiusRule::Shared
                                                                                     : RadiusRule::PerPoint;
    s.alpha = p.getFloat("alpha", float(s.alpha));
    if (!(s.alpha > 0 && s.alpha <= 1)) p.error("alpha", "\"alpha\" must be above 0 and at most 1");
    s.eye.radius = p.getFloat("radius", -1);
    if (p.has("radius") && !(s.eye.radius > 0 || s.eye.radius == -1))
        p.error("radius", "\"radius\" must be positive, or -1 for a number of pixels");
    s.eye.radiusInPixels = p.getFloat("radiuspixels", s.eye.radiusInPixels);
    if (!(s.eye.radiusInPixels > 0)) p.error("radiuspixels", "\"radiuspixels\" must be positive");
    s.eye.directByPhotons = p.getBool("directbyphotons", false);
    s.kernel = p.getChoice("kernel", "epanechnikov", {"constant", "epanechnikov"}) == "constant" ? Kernel::Constant
                                                                                                 : Kernel::Epanechnikov;
    return s;
}

IntegratorPlan lightPath(const ParameterSet& p, const Sampling& sampling) {
    LightTracingSettings s;
    s.maxDepth = maxDepth(p, s.maxDepth);
    s.pathsPerPass = pathsPerPass(p);
    return {
        std::make_unique<LightTracingIntegrator>(s, withOwnSeed(p, sampling)), {startChoice(p), true, {}}, passes(p)};
}

IntegratorPlan sppm(const ParameterSet& p, const Sampling& sampling) {
    PhotonMappingSettings s = photonMapping(p, sampling);
    s.search = p.getChoice("lookup", "grid", {"grid", "naive"}) == "grid" ? PhotonSearch::Grid : PhotonSearch::Naive;
    return {
        std::make_unique<PhotonMappingIntegrator>(s, withOwnSeed(p, sampling)), {lightChoice(p), true, {}}, passes(p)};
}

IntegratorPlan ppm(const ParameterSet& p, const Sampling& sampling) {
    PhotonMappingSettings s = photonMapping(p, sampling);
    s.fixedEyePaths = s.eye.branch = true;
    s.eyePathsPerPixel = p.getInteger("hitpointsperpixel", 4);
    if (s.eyePathsPerPixel < 1 || s.eyePathsPerPixel > 4096)
        p.error("hitpointsperpixel", "\"hitpointsperpixel\" must lie between 1 and 4096");
    const std::string lookup = p.getChoice("lookup", "grid", {"grid", "kdtree", "naive"});
    s.search = lookup == "grid" ? PhotonSearch::Grid : lookup == "kdtree" ? PhotonSearch::Tree : PhotonSearch::Naive;
    return {
        std::make_unique<PhotonMappingIntegrator>(s, withOwnSeed(p, sampling)), {lightChoice(p), true, {}}, passes(p)};
}

using IntegratorBuilder = IntegratorPlan (*)(const ParameterSet&, const Sampling&);
constexpr RegistryEntry<IntegratorBuilder> integratorTypes[] = {{"path", path},
                                                                {"volpath", path},
                                                                {"lightpath", lightPath},
                                                                {"ppm", ppm},
                                                                {"sppm", sppm},
                                                                {"bdpt"},
                                                                {"vcm"},
                                                                {"hybrid"},
                                                                {"mlt"},
                                                                {"ambientocclusion"},
                                                                {"function"},
                                                                {"randomwalk"},
                                                                {"simplepath"},
                                                                {"simplevolpath"}};

} // namespace

IntegratorPlan buildIntegrator(BuildContext& context, const Overrides& overrides, const SamplerSettings& sampler) {
    const Node& written = context.nodes().integrator;
    const Sampling sampling{sampler, overrides.seed.has_value(), context.diagnostics()};
    if (overrides.integrator.empty() || overrides.integrator == written.type)
        return context.guarded(written, [&] {
            auto plan =
                findBuilder<IntegratorBuilder>(integratorTypes, written, "integrator")(written.parameters, sampling);
            plan.lights.integrator = written.typePlace ? written.typePlace : written.place;
            return plan;
        });

    // The command line's type keeps the scene's parameters that it knows and names those that it drops.
    Node node = written;
    node.type = overrides.integrator;
    node.typePlace = node.place = Place{};
    return context.guarded(node, [&] {
        auto plan = findBuilder<IntegratorBuilder>(integratorTypes, node, "integrator")(node.parameters, sampling);
        written.parameters.takeReadsFrom(node.parameters);
        for (const std::string& name : node.parameters.names())
            if (node.parameters.isUnused(name)) {
                context.diagnostics().warning(
                    written.parameters.place(name),
                    fmt::format("integrator \"{}\" has no parameter \"{}\": dropped", node.type, name));
                node.parameters.remove(name);
            }
        return plan;
    });
}

} // namespace vitrine
