// Cameras. Raster space: x to the right, y down, (0,0) the corner of the top left pixel of the full resolution.
// Camera space is pbrt's, left-handed: x right, y up, z forward.
#pragma once

#include "core/ray.h"
#include "core/transform.h"

#include <memory>
#include <optional>
#include <vector>

namespace vitrine {

struct CameraSample {
    V2d raster; ///< pixels
    V2f lens;   ///< uniform in the unit square
    double time = 0;
};

struct CameraRay {
    Ray ray;          ///< world space, unit direction
    float weight = 1; ///< importance over density
};

/// A connection from a point of the scene to the camera, for light tracing.
struct CameraConnection {
    V3f wi;        ///< unit, from the point to the camera
    V3d pLens;     ///< where on the lens
    V2d raster;    ///< the pixel it lands on
    float we = 0;  ///< importance of the ray: a mean over the whole picture, so its integral over lens, directions and
                   ///< cosine at the lens is 1; the point adds throughput we / pdf to that mean
    float pdf = 0; ///< per solid angle at the point
};

class Camera {
  public:
    virtual ~Camera() = default;
    /// The ray of a sample; empty when nothing can come from there.
    virtual std::optional<CameraRay> generate(const CameraSample& sample) const = 0;
    /// Densities with which generate() makes this ray when raster and lens are uniform: per lens area and per solid
    /// angle; zero for rays it cannot make.
    struct Density {
        float position = 0, direction = 0;
        float we = 0;
        V2d raster;
    };
    /// \pre the ray starts on the lens (or film, or point)
    virtual Density density(const Ray& ray) const = 0;
    /// A point on the lens that sees p. Empty when p lies further than `margin` pixels beyond the picture's edge:
    /// filters reach over it.
    virtual std::optional<CameraConnection> connect(const V3d& p, const V2f& u, const V2f& margin = V2f(0),
                                                    double time = 0) const = 0;
    /// Raster points outside of the picture, within the margin, whose rays are that of `raster` too: pictures of all
    /// directions close upon themselves.
    virtual std::vector<V2d> repeated(const V2d& raster, const V2f& margin) const {
        return (void)raster, (void)margin, std::vector<V2d>();
    }
    /// Middle of the lens, world space (the interior that the camera stands in is looked for from here).
    virtual V3d position() const = 0;
    /// Whether rays start at position() or, on a lens, near it: then all start in the solids that lie there.
    virtual bool startsAtPosition() const { return true; }
    /// Whether it moves: position() is where it starts.
    virtual bool moves() const = 0;
};

} // namespace vitrine
