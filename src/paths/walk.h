// One random walk for eye and light: from surface to surface, through solids, in either transport mode.
#pragma once

#include "cameras/pixel_footprint.h"
#include "core/frame.h"
#include "core/sampler.h"
#include "paths/world.h"

namespace vitrine {

/// A point where a path meets a surface that scatters or shines.
struct Vertex {
    CasterHit hit;
    const Surface* surface = nullptr;
    V3f wo; ///< unit, world, back along the path
    double time = 0;
    Frame frame;
    InteriorStack::Crossing crossing; ///< what lies on the other sides of a solid's surface
    bool scatters = true;             ///< false: it only shines (an interface material, or overruled by another solid)

    const SurfacePoint& point() const { return hit.point; }
};

/// What the walk did at a vertex.
struct Scattered {
    V3f wi;        ///< world
    float pdf = 0; ///< per solid angle; of specular scattering the lobe's probability
    bool specular = false;
    bool transmission = false;
};

/// State of one path. Radiance mode starts at the camera, importance mode at a light; they differ by the eta^2 factor
/// at refraction (in the BSDFs) and by the shading-normal correction (Veach 1997, sec. 5.3.2), which is made here.
class Walk {
  public:
    Walk(const World& world, TransportMode mode, const SampledWavelengths& lambda, const InteriorStack& interior)
        : world_(world), mode_(mode), lambda_(lambda), interior_(interior) {}

    Ray ray;
    SampledSpectrum beta{1.f}; ///< throughput; after dispersion the hero's, times the number of wavelengths
    float etaScale = 1;        ///< product of eta^2 over refractions: what radiance lost to compression (for roulette)

    /// Of a path that begins at the camera: what a pixel sees, for filtering textures and for the size of gathering disks.
    PixelFootprint footprint;

    const SampledWavelengths& lambda() const { return lambda_; }
    /// Side of what a pixel sees at the last surface met (world units); 0 without a footprint.
    double pixelSide() const { return footprint.at(distance_); }
    const InteriorStack& interior() const { return interior_; }
    /// Solids with a priority that were left without having been entered (InteriorStack::Crossing::isLost), or that the path
    /// escaped in.
    int lostExits() const { return lostExits_; }

    /// Goes on along `ray` to the next surface that scatters or shines, passing interface materials and overruled
    /// surfaces, and loses what the solids on the way absorb. False: the path escapes along `ray`.
    bool advance(Vertex& vertex);

    /// Goes on behind a vertex that does not scatter.
    void passThrough(const Vertex& vertex);

    /// The BSDF at a vertex. If it disperses, the path keeps its hero wavelength.
    Bsdf bsdfAt(const Vertex& vertex);

    /// Chooses a direction by the BSDF and turns `ray`, `beta` and the interior to it. Empty: the path ends.
    std::optional<Scattered> scatter(const Vertex& vertex, const Bsdf& bsdf, float uc, const V2f& u);

  private:
    MaterialPoint materialPoint(const Vertex& vertex) const;
    void addDetail(Vertex& vertex) const;

    const World& world_;
    TransportMode mode_;
    SampledWavelengths lambda_;
    InteriorStack interior_;
    int lostExits_ = 0;
    double distance_ = 0; ///< along the path
};

/// A walk in radiance mode along a ray of the camera, in the solids that the ray starts in.
Walk eyeWalk(const World& world, const Ray& ray, const SampledWavelengths& lambda,
             const PixelFootprint& footprint = {});

/// Veach 1997, eq. 5.19: what importance is to be multiplied by where shading and geometric normal differ.
float shadingNormalCorrection(const SurfacePoint& point, const V3f& wo, const V3f& wi);

/// exp(-absorption distance); 1 in vacuum and in clear solids.
SampledSpectrum transmittance(const Interior* interior, double distance, const SampledWavelengths& lambda);

/// Transmittance of LightSample::shadow from a vertex: 0 where something blocks.
SampledSpectrum shadowTransmittance(const World& world, const Vertex& vertex, const Ray& toLight, const V3f& wi,
                                    const InteriorStack& interior, const SampledWavelengths& lambda);

} // namespace vitrine
