#include "scene/film_builder.h"

#include "scene/registry.h"

#include <fmt/format.h>

namespace vitrine {

namespace {

/// Half-open pixel interval clipped to [0, size]; empty ones are errors.
void cut(const Node& film, const std::string& what, double low, double high, int size, int& min, int& max) {
    if (!(low < high)) throw SceneError(film.place, what + " is empty or inverted");
    min = int(std::clamp(low, 0., double(size)));
    max = int(std::clamp(high, 0., double(size)));
    if (min >= max) throw SceneError(film.place, what + " lies outside the picture");
}

void applyBounds(const Node& film, FilmSettings& s, const std::array<int, 4>& b) {
    cut(film, "\"pixelbounds\"", b[0], b[1], s.resolution.x, s.cropMin.x, s.cropMax.x);
    cut(film, "\"pixelbounds\"", b[2], b[3], s.resolution.y, s.cropMin.y, s.cropMax.y);
}

void applyWindow(const Node& film, FilmSettings& s, const std::array<double, 4>& w) {
    for (const double x : w)
        if (!(x >= 0 && x <= 1)) throw SceneError(film.place, "\"cropwindow\" values must lie in [0, 1]");
    cut(film, "\"cropwindow\"", std::ceil(w[0] * s.resolution.x), std::ceil(w[1] * s.resolution.x), s.resolution.x,
        s.cropMin.x, s.cropMax.x);
    cut(film, "\"cropwindow\"", std::ceil(w[2] * s.resolution.y), std::ceil(w[3] * s.resolution.y), s.resolution.y,
        s.cropMin.y, s.cropMax.y);
}

/// What part of the picture is rendered; the command line before the scene, the window before the bounds (pbrt-v4).
void cropFilm(const Node& film, FilmSettings& s, const Overrides& overrides) {
    s.cropMin = V2i(0, 0);
    s.cropMax = s.resolution;
    const auto bounds = film.parameters.getIntegers("pixelbounds");
    const auto window = film.parameters.getFloats("cropwindow");
    if (!bounds.empty() && bounds.size() != 4)
        film.parameters.error("pixelbounds", "\"pixelbounds\" takes four values: x0 x1 y0 y1");
    if (!window.empty() && window.size() != 4)
        film.parameters.error("cropwindow", "\"cropwindow\" takes four values: x0 x1 y0 y1");
    if (overrides.cropWindow)
        applyWindow(film, s, *overrides.cropWindow);
    else if (overrides.pixelBounds)
        applyBounds(film, s, *overrides.pixelBounds);
    else if (window.size() == 4)
        applyWindow(film, s, {window[0], window[1], window[2], window[3]});
    else if (bounds.size() == 4)
        applyBounds(film, s, {bounds[0], bounds[1], bounds[2], bounds[3]});
}

Filter::Settings boxFilter(const ParameterSet& p) {
    Filter::Settings s;
    s.kind = FilterKind::Box;
    s.radius = V2f(float(p.getFloat("xradius", 0.5)), float(p.getFloat("yradius", 0.5)));
    return s;
}

Filter::Settings gaussianFilter(const ParameterSet& p) {
    Filter::Settings s;
    s.kind = FilterKind::Gaussian;
    s.radius = V2f(float(p.getFloat("xradius", 1.5)), float(p.getFloat("yradius", 1.5)));
    s.sigma = float(p.getFloat("sigma", 0.5));
    return s;
}

Filter::Settings mitchellFilter(const ParameterSet& p) {
    Filter::Settings s;
    s.kind = FilterKind::Mitchell;
    s.radius = V2f(float(p.getFloat("xradius", 2)), float(p.getFloat("yradius", 2)));
    s.b = float(p.getFloat("B", 1. / 3));
    s.c = float(p.getFloat("C", 1. / 3));
    return s;
}

Filter::Settings sincFilter(const ParameterSet& p) {
    Filter::Settings s;
    s.kind = FilterKind::Sinc;
    s.radius = V2f(float(p.getFloat("xradius", 4)), float(p.getFloat("yradius", 4)));
    s.tau = float(p.getFloat("tau", 3));
    return s;
}

Filter::Settings triangleFilter(const ParameterSet& p) {
    Filter::Settings s;
    s.kind = FilterKind::Triangle;
    s.radius = V2f(float(p.getFloat("xradius", 2)), float(p.getFloat("yradius", 2)));
    return s;
}

using FilterBuilder = Filter::Settings (*)(const ParameterSet&);
constexpr RegistryEntry<FilterBuilder> filterTypes[] = {{"box", boxFilter},
                                                        {"gaussian", gaussianFilter},
                                                        {"mitchell", mitchellFilter},
                                                        {"sinc", sincFilter},
                                                        {"triangle", triangleFilter}};

FilmPlan rgbFilm(BuildContext& context, const Overrides& overrides) {
    const Node& node = context.nodes().film;
    const ParameterSet& p = node.parameters;
    FilmPlan plan;
    FilmSettings& s = plan.settings;
    s.resolution = V2i(p.getInteger("xresolution", 1280), p.getInteger("yresolution", 720));
    if (overrides.resolution) s.resolution = *overrides.resolution;
    if (overrides.quick) s.resolution = V2i(std::max(1, s.resolution.x / 4), std::max(1, s.resolution.y / 4));
    if (s.resolution.x <= 0 || s.resolution.y <= 0)
        throw SceneError(node.place,
                         fmt::format("a picture of {} x {} pixels has none", s.resolution.x, s.resolution.y));
    cropFilm(node, s, overrides);

    s.colorSpace = RgbColorSpace::named(p.colorSpace());
    s.maxComponentValue = float(p.getFloat("maxcomponentvalue", infinity));
    if (!(s.maxComponentValue > 0)) p.error("maxcomponentvalue", "\"maxcomponentvalue\" must be positive");
    const double iso = p.getFloat("iso", 100);
    if (!(iso > 0)) p.error("iso", "\"iso\" must be positive");
    const ParameterSet& camera = context.nodes().camera.parameters;
    const double exposure = camera.getFloat("shutterclose", 1) - camera.getFloat("shutteropen", 0);
    if (!(exposure > 0))
        throw SceneError(context.nodes().camera.place, "the shutter closes before it opens: nothing is exposed");
    s.imagingRatio = float(exposure * iso / 100);
    if (!(s.imagingRatio > 0 && std::isfinite(s.imagingRatio)) && iso > 0)
        throw SceneError(node.place, fmt::format("exposed for {:g} s at ISO {:g}, no picture is left", exposure, iso));

    if (const std::string sensor = p.getString("sensor", "cie1931"); sensor != "cie1931")
        p.error("sensor", fmt::format("sensor \"{}\" is not yet supported", sensor), "\"cie1931\" is");
    if (p.getFloat("whitebalance", 0) != 0) refuse(p, {"whitebalance"});
    acceptWithoutEffect(p, {"diagonal", "savefp16"}); // for lenses that are not here yet; EXRs are always float32
    plan.fileName = p.getString("filename", "");

    const Node& filter = context.nodes().filter;
    s.filter = context.guarded(filter, [&] {
        const auto settings = findBuilder<FilterBuilder>(filterTypes, filter, "pixel filter")(filter.parameters);
        Filter checked(settings); // throws on nonsense, at the filter's own place
        return settings;
    });
    return plan;
}

using FilmBuilder = FilmPlan (*)(BuildContext&, const Overrides&);
constexpr RegistryEntry<FilmBuilder> filmTypes[] = {{"rgb", rgbFilm}, {"gbuffer"}, {"spectral"}};

SamplerKind kindOf(const Node& node) {
    if (node.type == "independent") return SamplerKind::Independent;
    return node.type == "stratified" ? SamplerKind::Stratified : SamplerKind::Sobol;
}

} // namespace

FilmPlan buildFilm(BuildContext& context, const Overrides& overrides) {
    const Node& node = context.nodes().film;
    return context.guarded(node, [&] { return findBuilder<FilmBuilder>(filmTypes, node, "film")(context, overrides); });
}

SamplerPlan buildSampler(BuildContext& context, const Overrides& overrides) {
    const Node& node = context.nodes().sampler;
    return context.guarded(node, [&] {
        // All of pbrt-v4's low-discrepancy samplers are one here: padded Owen-scrambled Sobol sequences.
        static const std::vector<std::string> names = {"halton", "independent", "paddedsobol", "pmj02bn",
                                                       "sobol",  "stratified",  "zsobol"};
        if (std::find(names.begin(), names.end(), node.type) == names.end()) throw unknownType(node, "sampler", names);

        const ParameterSet& p = node.parameters;
        SamplerPlan plan;
        plan.settings.kind = kindOf(node);
        std::int64_t samples = 16;
        if (plan.settings.kind == SamplerKind::Stratified) {
            plan.settings.jitter = p.getBool("jitter", true);
            plan.settings.xSamples = p.getInteger("xsamples", 4);
            plan.settings.ySamples = p.getInteger("ysamples", 4);
            checkSamplerSettings(plan.settings);
            samples = std::int64_t(plan.settings.xSamples) * plan.settings.ySamples;
        } else {
            samples = p.getInteger("pixelsamples", 16);
        }
        if (samples < 1) p.error("pixelsamples", "\"pixelsamples\" must be at least 1");
        if (p.getString("randomization", "fastowen") == "none")
            p.error("randomization", "\"randomization\" \"none\" is not yet supported");
        const auto& options = context.nodes().options;
        const auto seedOption = options.find("seed");
        const int fileSeed = seedOption == options.end() ? 0 : std::get<int>(seedOption->second.value);
        plan.settings.seed = overrides.seed.value_or(std::uint64_t(p.getInteger("seed", fileSeed)));

        plan.samplesPerPixel = overrides.quick ? 1 : std::uint64_t(std::max<std::int64_t>(1, samples));
        if (overrides.samplesPerPixel) plan.samplesPerPixel = *overrides.samplesPerPixel;
        return plan;
    });
}

} // namespace vitrine
