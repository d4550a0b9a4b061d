// Materials: what the scene file says about a surface; they make the BSDF of a point.
#pragma once

#include "bsdfs/bsdf.h"
#include "core/random.h"
#include "textures/surface_detail.h"

#include <bit>
#include <memory>
#include <optional>

namespace vitrine {

/// Where a material is asked for its BSDF.
struct MaterialPoint : TexturePoint {
    /// Index of refraction, at the hero wavelength, of what lies on the outside of the surface.
    float etaOutside = 1;
    V3f wo{0, 0, 1}; ///< unit, world, back along the path: a mix chooses by it
};

/// A number of its own for each way on which a path sees a point: different in each pass, as its wavelengths are.
inline std::uint64_t chanceKey(const MaterialPoint& at, const SampledWavelengths& lambda) {
    const auto bits = [](float a, float b) {
        return std::uint64_t(std::bit_cast<std::uint32_t>(a)) << 32 | std::bit_cast<std::uint32_t>(b);
    };
    return streamKey(std::bit_cast<std::uint64_t>(at.p.x), std::bit_cast<std::uint64_t>(at.p.y),
                     std::bit_cast<std::uint64_t>(at.p.z), bits(at.wo.x, at.wo.y), bits(at.wo.z, lambda.hero()));
}

/// What fills the solid that a dielectric surface bounds.
struct Interior {
    SpectrumPtr eta;
    SpectrumPtr absorption; ///< per scene unit; null: clear
    /// Nested dielectrics: where solids overlap the higher priority is there (Schmidt & Budge 2002). Empty: the surface
    /// is an interface of relative index eta whatever lies around it, as in pbrt-v4.
    std::optional<int> priority;
};

class Material {
  public:
    virtual ~Material() = default;
    /// The BSDF at a point. Ends the secondary wavelengths when the answer depends on wavelength through an angle.
    virtual Bsdf bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const = 0;
    /// What is there: another material than this where it is a mix.
    virtual const Material& resolve(const MaterialPoint&, const SampledWavelengths&) const { return *this; }
    /// The relief that it is shaded with, of a resolved material; null: none.
    virtual const SurfaceDetail* detail() const { return nullptr; }
    /// Whether it, or a part of a mix, has any.
    virtual bool hasDetail() const { return false; }
    /// Not null for a surface that bounds a dielectric solid.
    virtual const Interior* interior() const { return nullptr; }
    /// A surface that light passes as if it were not there (pbrt's "interface").
    virtual bool isInterface() const { return false; }
    /// Whether it has delta lobes only, wherever it is asked: photons never count there.
    virtual bool isPolished() const { return false; }
    /// Whether it has a texture that asks for the pixel's footprint.
    virtual bool filtersTextures() const { return false; }
};

using MaterialPtr = std::shared_ptr<const Material>;

} // namespace vitrine
