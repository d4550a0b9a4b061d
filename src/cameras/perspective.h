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
/// | aperture         | string   |             | "circular"            | shape of the lens: "circular", "pentagon" (a corner is up), "square" (stands on a side), "star" (five points), each with its corners on the lens's circle, or an image file whose brightness over the square round the circle says how much light passes. None makes the picture brighter or darker. Not in pbrt-v4 |
/// | apertureblades   | integer  |             | 0                     | in place of "aperture": a regular polygon with so many corners, one of them up. Not in pbrt-v4 |
/// | aperturerotation | float    | degrees     | 0                     | turns the aperture, counterclockwise as the camera looks out. Not in pbrt-v4 |
/// | frameaspectratio | float    |             | width / height        | width over height of the default screenwindow |
/// | screenwindow     | float[4] |             | from frameaspectratio | xmin xmax ymin ymax of the picture in screen space |
class PerspectiveCamera final : public Camera {
  public:
    struct Settings {
        ScreenWindow window;
        double fov = 90; ///< degrees
        double lensRadius = 0;
        double focalDistance = 1e6;
        AperturePtr aperture = nullptr; ///< null: the full circle
    };
    /// \throws std::invalid_argument unless 0 < fov < 180, and as RasterWindow and ThinLens do
    PerspectiveCamera(const Motion& worldFromCamera, const V2i& resolution, const Settings& settings);

    std::optional<CameraRay> generate(const CameraSample& sample) const override { return lens_.generate(sample); }
    /// A pinhole's position has density 1. Rays are taken to start on the lens.
    Density density(const Ray& ray) const override { return lens_.density(ray); }
    std::optional<CameraConnection> connect(const V3d& p, const V2f& u, const V2f& margin = V2f(0),
                                            double time = 0) const override {
        return lens_.connect(p, u, margin, time);
    }
    V3d position() const override { return lens_.position(); }
    bool moves() const override { return lens_.moves(); }

  private:
    ThinLens lens_;
};

} // namespace vitrine
