// Lights: emitted radiance, and how to choose directions towards them.
#pragma once

#include "accel/cutout.h"
#include "accel/moving_shape.h"
#include "lights/light_bounds.h"
#include "lights/light_receiver.h"
#include "spectrum/spectrum.h"

#include <memory>
#include <optional>

namespace vitrine {

/// A direction towards a light from a point.
struct LightSample {
    V3f wi;               ///< unit, from the point to the light
    SampledSpectrum l;    ///< radiance arriving from there, unoccluded; for delta lights intensity / distance^2 (or
                          ///< irradiance); to be divided by pdf
    float pdf = 0;        ///< per solid angle at the point; for delta lights 1
    Ray shadow;           ///< o unset; d = light point - p and tMax just short of 1 (shadowTo), or wi and infinity
    bool isDelta = false; ///< cannot be hit by a ray: no MIS
};

/// The shadow ray from p to a point of a light. It stops short of the target, which may lie on a surface, by 2^-36 of the
/// coordinates: crossings near a ray's end are solved in double, to some 2^-50 of them across the surface, and so to less
/// along a ray that makes more than 2^-14 with it. A target on a surface that is known less exactly must lie off it,
/// towards p, by its error.
inline Ray shadowTo(const V3d& target, const V3d& p) {
    const V3d d = target - p;
    return Ray{V3d(0, 0, 0), d, 1 - 0x1p-36 * (maxAbs(p) + maxAbs(target)) / maxAbs(d)};
}

/// A ray as it leaves a light: where paths of photons begin.
struct LightEmission {
    Ray ray;               ///< unit direction; starts off a shining surface by its error
    SampledSpectrum power; ///< radiance times cosine over density: what all rays carry if each is like this one
};

struct SceneSphere;

class Light {
  public:
    virtual ~Light() = default;
    /// Emitted power of all directions (W, at the wavelengths); of lights at infinity, into the scene's sphere.
    virtual SampledSpectrum power(const SampledWavelengths& lambda) const = 0;
    /// The same with another sphere to shine into, for choosing lights.
    virtual SampledSpectrum powerInto(const SceneSphere& sphere, const SampledWavelengths& lambda) const {
        return (void)sphere, power(lambda);
    }
    /// Where it lies; empty for lights at infinity.
    virtual Box3d bounds() const { return {}; }
    /// A direction from the receiver, chosen by what arrives. Empty when nothing does.
    virtual std::optional<LightSample> sample(const LightReceiver& at, const V2f& u,
                                              const SampledWavelengths& lambda) const = 0;

    /// Into how many parts the choice of lights may divide it, each to be asked by itself.
    virtual unsigned partCount() const { return 1; }
    /// What one part sends out when the whole light emits 1 W; by default, to all sides alike. Not of lights at infinity or
    /// of infinite area.
    virtual LightBounds partBounds(unsigned part) const {
        return (void)part, LightBounds{bounds(), {}, -1, false, 1 / (4 * piD)};
    }
    /// As sample(), from one part alone.
    virtual std::optional<LightSample> samplePart(unsigned part, const LightReceiver& at, const V2f& u,
                                                  const SampledWavelengths& lambda) const {
        return (void)part, sample(at, u, lambda);
    }
    /// A ray of what the light emits (from lights at infinity: into the scene's bounding sphere), chosen by what it carries.
    /// The expectation of its power is power(), save where that is an estimate. Empty when nothing is emitted there, and
    /// always for shapes of infinite area.
    virtual std::optional<LightEmission> emit(const V2f& uPosition, const V2f& uDirection,
                                              const SampledWavelengths& lambda, double time = 0) const = 0;
    virtual bool isDelta() const { return false; }

    /// Radiance that escaping rays of direction w meet; lights at infinity only.
    virtual SampledSpectrum escaped(const V3f& w, const SampledWavelengths& lambda) const {
        return (void)w, (void)lambda, SampledSpectrum(0);
    }
    /// Density of sample(p, ...) to give direction w, per solid angle; lights at infinity only.
    virtual float pdf(const V3f& w) const { return (void)w, 0.f; }
    virtual bool isInfinite() const { return false; }
    /// Called once with the sphere that emit() is to cover.
    virtual void preprocess(const V3d& center, double radius) { (void)center, (void)radius; }
};

using LightPtr = std::shared_ptr<Light>;

/// AreaLightSource "diffuse": a shape that shines with the same radiance everywhere and in all directions.
///
/// | name     | type     | unit | default              | meaning |
/// |----------|----------|------|----------------------|---------|
/// | L        | spectrum | nit  | colour space's white | emitted radiance |
/// | scale    | float    |      | 1                    | multiplies L |
/// | power    | float    | lm   | -1                   | if positive: what the whole shape emits, on both sides if twosided |
/// | twosided | bool     |      | false                | shines from both sides, else from that of the normal alone |
///
/// A shape of infinite area shines, but is never chosen by light sampling.
///
/// Where the shape's "alpha" stops a share of the rays, it shines with that share of L; "power" is meant without alpha. A
/// shape whose alpha is 0 throughout is not to be seen, and shines whole (pbrt-v4's invisible lights).
class AreaLight final : public Light {
  public:
    struct Parameters {
        SpectrumPtr l;
        double scale = 1;
        double power = -1;
        bool twoSided = false;
        CutoutPtr cutout = nullptr; ///< holes of the shape; null: none
        bool isUnseen = false;      ///< rays do not meet the shape
    };
    /// By pbrt's rule (lights/emission.h); `unit` for the power is pi area, twice that for two sides.
    /// \throws std::invalid_argument as scaledEmission does
    static std::shared_ptr<AreaLight> create(ShapePtr shape, const Parameters& parameters);

    /// \param l emitted radiance (already scaled). \param twoSided shines from both sides of the shape
    AreaLight(ShapePtr shape, SpectrumPtr l, bool twoSided, CutoutPtr cutout = nullptr, bool isUnseen = false);

    SampledSpectrum power(const SampledWavelengths& lambda) const override;
    Box3d bounds() const override { return shape_->bounds(); }
    std::optional<LightSample> sample(const LightReceiver& at, const V2f& u,
                                      const SampledWavelengths& lambda) const override;
    unsigned partCount() const override { return shape_->partCount(); }
    LightBounds partBounds(unsigned part) const override;
    std::optional<LightSample> samplePart(unsigned part, const LightReceiver& at, const V2f& u,
                                          const SampledWavelengths& lambda) const override;
    std::optional<LightEmission> emit(const V2f& uPosition, const V2f& uDirection, const SampledWavelengths& lambda,
                                      double time = 0) const override;
    bool isDelta() const override { return isUnseen_; }
    /// Radiance leaving `point` towards w, where the shape is there.
    SampledSpectrum emitted(const SurfacePoint& point, const V3f& w, const SampledWavelengths& lambda) const {
        return twoSided_ || w.dot(point.ng) > 0 ? l_->sample(lambda) : SampledSpectrum(0);
    }
    /// Density of sample(at, ...) to give the point of a hit, per solid angle at the receiver.
    float pdf(const LightReceiver& at, const PrimitiveHit& hit, const SurfacePoint& point) const {
        return moving_ ? moving_->pdfAt(at.time, at.p, hit, point) : shape_->pdf(at.p, hit, point);
    }
    /// Of samplePart(part of the hit, at, ...).
    float partPdf(const LightReceiver& at, const PrimitiveHit& hit, const SurfacePoint& point) const {
        return moving_ ? moving_->pdfAt(at.time, at.p, hit, point) : shape_->partPdf(at.p, hit, point);
    }
    using Light::pdf;
    const Shape& shape() const { return *shape_; }

  private:
    std::optional<LightSample> lightFrom(const std::optional<ShapeSample>& onShape, const LightReceiver& at,
                                         const SampledWavelengths& lambda) const;

    /// Of a shape with holes.
    float opacity(const SurfacePoint& point) const { return std::clamp(cutout_->opacity(point), 0.f, 1.f); }

    ShapePtr shape_;
    const MovingShape* moving_; ///< the shape, if it moves
    SpectrumPtr l_;
    bool twoSided_;
    CutoutPtr cutout_;
    bool isUnseen_;
    float meanOpacity_ = 1; ///< over the area, estimated; above 0
};

} // namespace vitrine
