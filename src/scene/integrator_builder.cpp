#include "scene/integrator_builder.h"

#include "integrators/path.h"
#include "scene/registry.h"

#include <fmt/format.h>

namespace vitrine {

namespace {

std::unique_ptr<Integrator> path(const ParameterSet& p, const SamplerSettings& sampler) {
    PathSettings s;
    s.maxDepth = p.getInteger("maxdepth", s.maxDepth);
    s.rrDepth = p.getInteger("rrdepth", s.rrDepth);
    s.regularize = p.getBool("regularize", s.regularize);
    s.nee = p.getBool("nee", s.nee);
    p.getChoice("lightsampler", "power", {"uniform", "power", "bvh", "exhaustive"});
    if (s.maxDepth < 0) p.error("maxdepth", "\"maxdepth\" must not be negative");
    if (s.rrDepth < 0) p.error("rrdepth", "\"rrdepth\" must not be negative");
    return std::make_unique<PathIntegrator>(s, sampler);
}

using IntegratorBuilder = std::unique_ptr<Integrator> (*)(const ParameterSet&, const SamplerSettings&);
constexpr RegistryEntry<IntegratorBuilder> integratorTypes[] = {
    {"path", path}, {"volpath", path}, {"lightpath"},  {"ppm"},          {"sppm"},
    {"bdpt"},       {"vcm"},           {"hybrid"},     {"mlt"},          {"ambientocclusion"},
    {"function"},   {"randomwalk"},    {"simplepath"}, {"simplevolpath"}};

} // namespace

std::unique_ptr<Integrator> buildIntegrator(BuildContext& context, const Overrides& overrides,
                                            const SamplerSettings& sampler) {
    const Node& written = context.nodes().integrator;
    if (overrides.integrator.empty() || overrides.integrator == written.type)
        return context.guarded(written, [&] {
            return findBuilder<IntegratorBuilder>(integratorTypes, written, "integrator")(written.parameters, sampler);
        });

    // The command line's type keeps the scene's parameters that it knows and names those that it drops.
    Node node = written;
    node.type = overrides.integrator;
    node.typePlace = node.place = Place{};
    return context.guarded(node, [&] {
        auto integrator = findBuilder<IntegratorBuilder>(integratorTypes, node, "integrator")(node.parameters, sampler);
        for (const std::string& name : node.parameters.names())
            if (!node.parameters.wasRead(name)) {
                context.diagnostics().warning(
                    written.parameters.place(name),
                    fmt::format("integrator \"{}\" has no parameter \"{}\": dropped", node.type, name));
                node.parameters.remove(name);
            }
        return integrator;
    });
}

} // namespace vitrine
