// Camera "perspective".
#pragma once

#include "cameras/thin_lens.h"

namespace vitrine {

/// Camera "perspective": pinhole or thin lens, looking along +z of camera space.
///
/// | name             | type     | unit        | default               | meaning |
/// |------------------|----------|-------------|-----------------------|---------|
/// | fov              | float    | degrees     | 90                    | angle that screen space [-1, 1] spans: the picture's narrower side |
/// | lensradius       | float    | scene units | 0                     | radius of the lens; 0: a pinhole, everything is sharp |
/// | focaldistance    | float    | scene units | 1e6                   | distance of the plane that is sharp |
/// | frameaspectratio | float    |             | width / height        | width over height of the default screenwindow |
/// | screenwindow     | float[4] |             | from frameaspectratio | xmin xmax ymin ymax of the picture in screen space |
class PerspectiveCamera final : public Camera {
  public:
    struct Settings {
        ScreenWindow window;
        double fov = 90; ///< degrees
        double lensRadius = 0;
        double focalDistance = 1e6;
    };
    /// \throws std::invalid_argument unless 0 < fov < 180, and as RasterWindow and ThinLens do
    PerspectiveCamera(const Transform& worldFromCamera, const V2i& resolution, const Settings& settings);

    std::optional<CameraRay> generate(const CameraSample& sample) const override { return lens_.generate(sample); }
    /// A pinhole's position has density 1. Rays are taken to start on the lens.
    Density density(const Ray& ray) const override { return lens_.density(ray); }
    std::optional<CameraConnection> connect(const V3d& p, const V2f& u, const V2f& margin = V2f(0)) const override {
        return lens_.connect(p, u, margin);
    }
    V3d position() const override { return lens_.position(); }

  private:
    ThinLens lens_;
};

} // namespace vitrine
