#include "bsdfs/conductor_material.h"
#include "bsdfs/dielectric_material.h"
#include "bsdfs/diffuse_material.h"
#include "bsdfs/interface_material.h"
#include "bsdfs/thindielectric_material.h"
#include "scene/registry.h"
#include "scene/world_builder.h"

namespace vitrine {

namespace {

struct Roughness {
    FloatInput u, v;
    bool remap = true;
};

Roughness roughness(BuildContext& context, const ParameterSet& p) {
    const FloatInput both = findFloatInput(context, p, "roughness").value_or(0);
    return {findFloatInput(context, p, "uroughness").value_or(both),
            findFloatInput(context, p, "vroughness").value_or(both), p.getBool("remaproughness", true)};
}

/// pbrt-v4 takes an index of refraction as a float or as a spectrum.
SpectrumPtr indexOfRefraction(BuildContext& context, const ParameterSet& p) {
    return findSpectrum(context, p, "eta", SpectrumUse::Unbounded);
}

MaterialPtr diffuse(BuildContext& context, const ParameterSet& p) {
    return std::make_shared<DiffuseMaterial>(findSpectrumInput(context, p, "reflectance", SpectrumUse::Albedo));
}

MaterialPtr conductor(BuildContext& context, const ParameterSet& p) {
    const Roughness r = roughness(context, p);
    if (p.has("reflectance")) {
        if (p.has("eta") || p.has("k"))
            throw SceneError(p.place("reflectance"),
                             "a conductor takes \"reflectance\" or \"eta\" and \"k\", not both");
        const auto reflectance = findSpectrumInput(context, p, "reflectance", SpectrumUse::Albedo);
        return reflectance ? std::make_shared<ConductorMaterial>(
                                 ConductorMaterial::fromReflectance(reflectance, r.u, r.v, r.remap))
                           : nullptr;
    }
    return std::make_shared<ConductorMaterial>(findSpectrumInput(context, p, "eta", SpectrumUse::Unbounded),
                                               findSpectrumInput(context, p, "k", SpectrumUse::Unbounded), r.u, r.v,
                                               r.remap);
}

MaterialPtr dielectric(BuildContext& context, const ParameterSet& p) {
    Interior interior;
    interior.eta = indexOfRefraction(context, p);
    interior.absorption = findSpectrum(context, p, "absorption", SpectrumUse::Unbounded);
    interior.priority = p.findInteger("priority");
    const Roughness r = roughness(context, p);
    return std::make_shared<DielectricMaterial>(std::move(interior), r.u, r.v, r.remap);
}

MaterialPtr thinDielectric(BuildContext& context, const ParameterSet& p) {
    return std::make_shared<ThinDielectricMaterial>(indexOfRefraction(context, p));
}

MaterialPtr interface(BuildContext&, const ParameterSet&) {
    return std::make_shared<InterfaceMaterial>();
}

using MaterialBuilder = MaterialPtr (*)(BuildContext&, const ParameterSet&);
constexpr RegistryEntry<MaterialBuilder> materialTypes[] = {{"diffuse", diffuse},
                                                            {"conductor", conductor},
                                                            {"dielectric", dielectric},
                                                            {"thindielectric", thinDielectric},
                                                            {"interface", interface},
                                                            {"coatedconductor"},
                                                            {"coateddiffuse"},
                                                            {"diffusetransmission"},
                                                            {"hair"},
                                                            {"measured"},
                                                            {"mix"},
                                                            {"subsurface"}};

} // namespace

MaterialPtr buildMaterial(BuildContext& context, const MaterialNode& node) {
    return context.guarded(node, [&]() -> MaterialPtr {
        // pbrt-v4's other spelling of "interface".
        if (node.type.empty() || node.type == "none") return std::make_shared<InterfaceMaterial>();
        const auto build = findBuilder<MaterialBuilder>(materialTypes, node, "material");
        refuse(node.parameters, {"displacement", "normalmap"});
        return build(context, node.parameters);
    });
}

} // namespace vitrine
