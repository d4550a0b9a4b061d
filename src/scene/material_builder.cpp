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

#include <fmt/format.h>

namespace vitrine {

namespace {

/// The materials of a scene, each built when it is first asked for: a mix may name one that stands behind it.
class MaterialLibrary {
  public:
    explicit MaterialLibrary(BuildContext& context)
        : context_(context), nodes_(context.nodes().materials), entries_(nodes_.size()) {}

    BuildContext& context() { return context_; }
    /// Null when it is wrong (then recorded).
    MaterialPtr find(std::size_t index);
    /// The material that a value of "materials" names. Null when there is none, or it is wrong (then recorded).
    MaterialPtr part(const ParameterSet& p, const std::vector<std::string>& names, std::size_t i);
    /// Another number for each material that is being built.
    std::uint64_t nextSalt() { return ++salts_; }

  private:
    enum class State { Unbuilt, UnderWay, Built };
    struct Entry {
        MaterialPtr material;
        State state = State::Unbuilt;
    };

    MaterialPtr build(const MaterialNode& node);

    BuildContext& context_;
    const std::vector<MaterialNode>& nodes_;
    std::vector<Entry> entries_;
    std::uint64_t salts_ = 0;
};

struct Roughness {
    FloatInput u, v;

    /// \param both for what is not given
    Roughness(const std::optional<FloatInput>& both, const std::optional<FloatInput>& alongU,
              const std::optional<FloatInput>& alongV)
        : u(alongU.value_or(both.value_or(0))), v(alongV.value_or(both.value_or(0))) {}
};

Roughness roughness(BuildContext& context, const ParameterSet& p) {
    return {findFloatInput(context, p, "roughness"), findFloatInput(context, p, "uroughness"),
            findFloatInput(context, p, "vroughness")};
}

bool remapsRoughness(const ParameterSet& p) {
    return p.getBool("remaproughness", true);
}

/// pbrt-v4 takes an index of refraction as a float or as a spectrum.
SpectrumPtr indexOfRefraction(BuildContext& context, const ParameterSet& p) {
    return findSpectrum(context, p, "eta", SpectrumUse::Unbounded);
}

/// Empty when it is wrong (then recorded). \param prefix of the names of eta and k
std::optional<MetalIndex> metalIndex(BuildContext& context, const ParameterSet& p, SpectrumInput eta, SpectrumInput k,
                                     const std::string& prefix = "") {
    if (!p.has("reflectance")) return MetalIndex(std::move(eta), std::move(k), prefix);
    if (eta || k)
        throw SceneError(p.place("reflectance"), fmt::format("a conductor takes \"reflectance\" or \"{0}eta\" and "
                                                             "\"{0}k\", not both",
                                                             prefix));
    const auto reflectance = findSpectrumInput(context, p, "reflectance", SpectrumUse::Albedo);
    return reflectance ? std::optional(MetalIndex::ofReflectance(reflectance)) : std::nullopt;
}

MaterialPtr diffuse(BuildContext& context, const ParameterSet& p) {
    return std::make_shared<DiffuseMaterial>(findSpectrumInput(context, p, "reflectance", SpectrumUse::Albedo));
}

MaterialPtr conductor(BuildContext& context, const ParameterSet& p) {
    const Roughness r = roughness(context, p);
    const bool remap = remapsRoughness(p);
    const auto index = metalIndex(context, p, findSpectrumInput(context, p, "eta", SpectrumUse::Unbounded),
                                  findSpectrumInput(context, p, "k", SpectrumUse::Unbounded));
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

CoatParameters coat(BuildContext& context, const ParameterSet& p, SpectrumPtr eta, const Roughness& r) {
    CoatParameters coat;
    coat.eta = std::move(eta);
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
    return std::make_shared<CoatedDiffuseMaterial>(
        findSpectrumInput(context, p, "reflectance", SpectrumUse::Albedo),
        coat(context, p, indexOfRefraction(context, p), roughness(context, p)));
}

MaterialPtr coatedConductor(BuildContext& context, const ParameterSet& p) {
    const Roughness metal(findFloatInput(context, p, "conductor.roughness"),
                          findFloatInput(context, p, "conductor.uroughness"),
                          findFloatInput(context, p, "conductor.vroughness"));
    const Roughness interface(findFloatInput(context, p, "interface.roughness"),
                              findFloatInput(context, p, "interface.uroughness"),
                              findFloatInput(context, p, "interface.vroughness"));
    const CoatParameters over =
        coat(context, p, findSpectrum(context, p, "interface.eta", SpectrumUse::Unbounded), interface);
    const auto index = metalIndex(context, p, findSpectrumInput(context, p, "conductor.eta", SpectrumUse::Unbounded),
                                  findSpectrumInput(context, p, "conductor.k", SpectrumUse::Unbounded), "conductor.");
    return index ? std::make_shared<CoatedConductorMaterial>(*index, metal.u, metal.v, over) : nullptr;
}

MaterialPtr diffuseTransmission(BuildContext& context, const ParameterSet& p) {
    return std::make_shared<DiffuseTransmissionMaterial>(
        findSpectrumInput(context, p, "reflectance", SpectrumUse::Albedo),
        findSpectrumInput(context, p, "transmittance", SpectrumUse::Albedo), float(p.getFloat("scale", 1)));
}

MaterialPtr mix(MaterialLibrary& library, const ParameterSet& p) {
    BuildContext& context = library.context();
    const FloatInput amount = findFloatInput(context, p, "amount").value_or(0.5f);
    const auto names = p.getStrings("materials");
    if (names.size() != 2)
        throw SceneError(p.place("materials"), "a mix takes the names of two materials: \"string materials\"");
    const MaterialPtr first = library.part(p, names, 0), second = library.part(p, names, 1);
    return first && second ? std::make_shared<MixMaterial>(first, second, amount, library.nextSalt()) : nullptr;
}

/// Of a material that knows no others.
template <MaterialPtr (*build)(BuildContext&, const ParameterSet&)>
MaterialPtr alone(MaterialLibrary& library, const ParameterSet& p) {
    return build(library.context(), p);
}

using MaterialBuilder = MaterialPtr (*)(MaterialLibrary&, const ParameterSet&);
constexpr RegistryEntry<MaterialBuilder> materialTypes[] = {{"diffuse", alone<diffuse>},
                                                            {"conductor", alone<conductor>},
                                                            {"dielectric", alone<dielectric>},
                                                            {"thindielectric", alone<thinDielectric>},
                                                            {"interface", alone<interface>},
                                                            {"coatedconductor", alone<coatedConductor>},
                                                            {"coateddiffuse", alone<coatedDiffuse>},
                                                            {"diffusetransmission", alone<diffuseTransmission>},
                                                            {"mix", mix},
                                                            {"hair"},
                                                            {"measured"},
                                                            {"subsurface"}};

MaterialPtr MaterialLibrary::find(std::size_t index) {
    Entry& entry = entries_[index];
    if (entry.state == State::Built) return entry.material;
    entry.state = State::UnderWay;
    entry.material = context_.guarded(nodes_[index], [&] { return build(nodes_[index]); });
    entry.state = State::Built;
    return entry.material;
}

MaterialPtr MaterialLibrary::part(const ParameterSet& p, const std::vector<std::string>& names, std::size_t i) {
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

MaterialPtr MaterialLibrary::build(const MaterialNode& node) {
    // pbrt-v4's other spelling of "interface".
    if (node.type.empty() || node.type == "none") return std::make_shared<InterfaceMaterial>();
    MaterialPtr material = findBuilder<MaterialBuilder>(materialTypes, node, "material")(*this, node.parameters);
    // A mix is shaded with the relief of what is there.
    if (!material || material->isInterface() || node.type == "mix") return material;
    const SurfaceDetailPtr detail = findSurfaceDetail(context_, node.parameters);
    return detail ? std::make_shared<DetailedMaterial>(std::move(material), detail) : material;
}

} // namespace

std::vector<MaterialPtr> buildMaterials(BuildContext& context) {
    MaterialLibrary library(context);
    std::vector<MaterialPtr> materials;
    for (std::size_t i = 0; i < context.nodes().materials.size(); ++i)
        materials.push_back(library.find(i));
    return materials;
}

} // namespace vitrine
