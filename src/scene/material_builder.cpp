#include "bsdfs/coatedconductor_material.h"
#include "bsdfs/coateddiffuse_material.h"
#include "bsdfs/conductor_material.h"
#include "bsdfs/detailed_material.h"
#include "bsdfs/dielectric_material.h"
#include "bsdfs/diffuse_material.h"
#include "bsdfs/diffusetransmission_material.h"
#include "bsdfs/interface_material.h"
#include "bsdfs/mix_material.h"
#include "bsdfs/thindielectric_material.h"
#include "scene/registry.h"
#include "scene/surface_detail_builder.h"
#include "scene/world_builder.h"

namespace vitrine {

namespace {

struct Roughness {
    FloatInput u, v;
};

/// \param prefix of the parameters' names
Roughness roughness(BuildContext& context, const ParameterSet& p, const std::string& prefix = "") {
    const FloatInput both = findFloatInput(context, p, prefix + "roughness").value_or(0);
    return {findFloatInput(context, p, prefix + "uroughness").value_or(both),
            findFloatInput(context, p, prefix + "vroughness").value_or(both)};
}

bool remapsRoughness(const ParameterSet& p) {
    return p.getBool("remaproughness", true);
}

/// pbrt-v4 takes an index of refraction as a float or as a spectrum.
SpectrumPtr indexOfRefraction(BuildContext& context, const ParameterSet& p, const std::string& prefix = "") {
    return findSpectrum(context, p, prefix + "eta", SpectrumUse::Unbounded);
}

/// Empty when it is not given or wrong (then recorded).
std::optional<MetalIndex> metalIndex(BuildContext& context, const ParameterSet& p, const std::string& prefix = "") {
    const std::string eta = prefix + "eta", k = prefix + "k";
    if (!p.has("reflectance"))
        return MetalIndex(findSpectrumInput(context, p, eta, SpectrumUse::Unbounded),
                          findSpectrumInput(context, p, k, SpectrumUse::Unbounded), prefix);
    if (p.has(eta) || p.has(k))
        throw SceneError(p.place("reflectance"),
                         "a conductor takes \"reflectance\" or \"" + eta + "\" and \"" + k + "\", not both");
    const auto reflectance = findSpectrumInput(context, p, "reflectance", SpectrumUse::Albedo);
    return reflectance ? std::optional(MetalIndex::ofReflectance(reflectance)) : std::nullopt;
}

MaterialPtr diffuse(BuildContext& context, const ParameterSet& p) {
    return std::make_shared<DiffuseMaterial>(findSpectrumInput(context, p, "reflectance", SpectrumUse::Albedo));
}

MaterialPtr conductor(BuildContext& context, const ParameterSet& p) {
    const Roughness r = roughness(context, p);
    const bool remap = remapsRoughness(p);
    const auto index = metalIndex(context, p);
    return index ? std::make_shared<ConductorMaterial>(*index, r.u, r.v, remap) : nullptr;
}

MaterialPtr dielectric(BuildContext& context, const ParameterSet& p) {
    Interior interior;
    interior.eta = indexOfRefraction(context, p);
    interior.absorption = findSpectrum(context, p, "absorption", SpectrumUse::Unbounded);
    interior.priority = p.findInteger("priority");
    const Roughness r = roughness(context, p);
    return std::make_shared<DielectricMaterial>(std::move(interior), r.u, r.v, remapsRoughness(p));
}

MaterialPtr thinDielectric(BuildContext& context, const ParameterSet& p) {
    return std::make_shared<ThinDielectricMaterial>(indexOfRefraction(context, p));
}

MaterialPtr interface(BuildContext&, const ParameterSet&) {
    return std::make_shared<InterfaceMaterial>();
}

/// \param prefix of the names that are the coat's own
CoatParameters coat(BuildContext& context, const ParameterSet& p, const std::string& prefix = "") {
    CoatParameters coat;
    const Roughness r = roughness(context, p, prefix);
    coat.eta = indexOfRefraction(context, p, prefix);
    coat.uroughness = r.u;
    coat.vroughness = r.v;
    coat.remaproughness = remapsRoughness(p);
    coat.thickness = findFloatInput(context, p, "thickness").value_or(coat.thickness);
    coat.albedo = findSpectrumInput(context, p, "albedo", SpectrumUse::Albedo);
    coat.g = findFloatInput(context, p, "g").value_or(coat.g);
    coat.maxdepth = p.getInteger("maxdepth", coat.maxdepth);
    coat.nsamples = p.getInteger("nsamples", coat.nsamples);
    return coat;
}

MaterialPtr coatedDiffuse(BuildContext& context, const ParameterSet& p) {
    return std::make_shared<CoatedDiffuseMaterial>(findSpectrumInput(context, p, "reflectance", SpectrumUse::Albedo),
                                                   coat(context, p));
}

MaterialPtr coatedConductor(BuildContext& context, const ParameterSet& p) {
    const Roughness r = roughness(context, p, "conductor.");
    const CoatParameters over = coat(context, p, "interface.");
    const auto index = metalIndex(context, p, "conductor.");
    return index ? std::make_shared<CoatedConductorMaterial>(*index, r.u, r.v, over) : nullptr;
}

MaterialPtr diffuseTransmission(BuildContext& context, const ParameterSet& p) {
    return std::make_shared<DiffuseTransmissionMaterial>(
        findSpectrumInput(context, p, "reflectance", SpectrumUse::Albedo),
        findSpectrumInput(context, p, "transmittance", SpectrumUse::Albedo), float(p.getFloat("scale", 1)));
}

using MaterialBuilder = MaterialPtr (*)(BuildContext&, const ParameterSet&);
/// Mixes are built by the library, which finds their parts.
constexpr RegistryEntry<MaterialBuilder> materialTypes[] = {{"diffuse", diffuse},
                                                            {"conductor", conductor},
                                                            {"dielectric", dielectric},
                                                            {"thindielectric", thinDielectric},
                                                            {"interface", interface},
                                                            {"coatedconductor", coatedConductor},
                                                            {"coateddiffuse", coatedDiffuse},
                                                            {"diffusetransmission", diffuseTransmission},
                                                            {"hair"},
                                                            {"measured"},
                                                            {"mix"},
                                                            {"subsurface"}};

/// The materials of a scene; a mix may name one that stands behind it.
class MaterialLibrary {
  public:
    explicit MaterialLibrary(BuildContext& context)
        : context_(context), nodes_(context.nodes().materials), entries_(nodes_.size()) {}

    MaterialPtr find(std::size_t index) {
        Entry& entry = entries_[index];
        if (entry.state == State::Built) return entry.material;
        entry.state = State::UnderWay;
        entry.material = context_.guarded(nodes_[index], [&] { return build(index); });
        entry.state = State::Built;
        return entry.material;
    }

  private:
    enum class State { Unbuilt, UnderWay, Built };
    struct Entry {
        MaterialPtr material; ///< null: it is wrong (then recorded)
        State state = State::Unbuilt;
    };

    MaterialPtr build(std::size_t index) {
        const MaterialNode& node = nodes_[index];
        // pbrt-v4's other spelling of "interface".
        if (node.type.empty() || node.type == "none") return std::make_shared<InterfaceMaterial>();
        if (node.type == "mix") return mix(index);
        MaterialPtr material = findBuilder<MaterialBuilder>(materialTypes, node, "material")(context_, node.parameters);
        if (!material || material->isInterface()) return material;
        const SurfaceDetailPtr detail = findSurfaceDetail(context_, node.parameters);
        return detail ? std::make_shared<DetailedMaterial>(std::move(material), detail) : material;
    }

    MaterialPtr mix(std::size_t index) {
        const ParameterSet& p = nodes_[index].parameters;
        const FloatInput amount = findFloatInput(context_, p, "amount").value_or(0.5f);
        const auto names = p.getStrings("materials");
        if (names.size() != 2)
            throw SceneError(p.place("materials"), "a mix takes the names of two materials: \"string materials\"");
        const MaterialPtr first = part(p, names, 0), second = part(p, names, 1);
        return first && second ? std::make_shared<MixMaterial>(first, second, amount, index) : nullptr;
    }

    /// Null when there is none of the name, or it is wrong; then recorded.
    MaterialPtr part(const ParameterSet& p, const std::vector<std::string>& names, std::size_t i) {
        const auto& known = context_.nodes().namedMaterials;
        const auto named = known.find(names[i]);
        if (named == known.end()) {
            std::vector<std::string> all;
            for (const auto& [name, index] : known)
                all.push_back(name);
            p.errorAtValue("materials", i, "no material \"" + names[i] + "\"", didYouMean(names[i], all));
            return nullptr;
        }
        if (entries_[std::size_t(named->second)].state == State::UnderWay) {
            p.errorAtValue("materials", i, "material \"" + names[i] + "\" is a part of itself");
            return nullptr;
        }
        return find(std::size_t(named->second));
    }

    BuildContext& context_;
    const std::vector<MaterialNode>& nodes_;
    std::vector<Entry> entries_;
};

} // namespace

std::vector<MaterialPtr> buildMaterials(BuildContext& context) {
    MaterialLibrary library(context);
    std::vector<MaterialPtr> materials;
    for (std::size_t i = 0; i < context.nodes().materials.size(); ++i)
        materials.push_back(library.find(i));
    return materials;
}

} // namespace vitrine
