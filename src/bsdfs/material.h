// Materials: what the scene file says about a surface; they make the BSDF of a point.
#pragma once

#include "bsdfs/bsdf.h"
#include "textures/texture.h"

#include <memory>
#include <optional>

namespace vitrine {

/// Where a material is asked for its BSDF.
struct MaterialPoint : TexturePoint {
    /// Index of refraction, at the hero wavelength, of what lies on the outside of the surface.
    float etaOutside = 1;
};

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
    /// Not null for a surface that bounds a dielectric solid.
    virtual const Interior* interior() const { return nullptr; }
    /// A surface that light passes as if it were not there (pbrt's "interface").
    virtual bool isInterface() const { return false; }
    /// Whether it has a texture that asks for the pixel's footprint.
    virtual bool filtersTextures() const { return false; }
};

using MaterialPtr = std::shared_ptr<const Material>;

} // namespace vitrine
