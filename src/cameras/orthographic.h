// Camera "orthographic".
#pragma once

#include "cameras/thin_lens.h"

#include <variant>

namespace vitrine {

/// Camera "orthographic": parallel rays along +z from the screen window in the plane z = 0 of camera space.
///
/// | name             | type     | unit        | default               | meaning |
/// |------------------|----------|-------------|-----------------------|---------|
/// | lensradius       | float    | scene units | 0                     | 0: parallel rays; else see below |
/// | focaldistance    | float    | scene units | 1e6                   | distance of the plane that is sharp |
/// | aperture         | string   |             | "circular"            | shape of the lens, as of Camera "perspective". Not in pbrt-v4 |
/// | apertureblades   | integer  |             | 0                     | likewise. Not in pbrt-v4 |
/// | aperturerotation | float    | degrees     | 0                     | likewise. Not in pbrt-v4 |
/// | frameaspectratio | float    |             | width / height        | width over height of the default screenwindow |
/// | screenwindow     | float[4] | scene units | from frameaspectratio | xmin xmax ymin ymax of the picture |
///
/// With a lens, pbrt-v4 lets every ray start on one disk about camera space's origin and aim at its picture point in
/// the plane of focus: lines of sight are parallel no longer, only the plane of focus shows as without a lens. The same
/// scene shall give the same picture, so it is so here too: a ThinLens whose picture in the plane of focus is the
/// window.
class OrthographicCamera final : public Camera {
  public:
    struct Settings {
        ScreenWindow window;
        double lensRadius = 0;
        double focalDistance = 1e6;
        AperturePtr aperture = nullptr; ///< null: the full circle
    };
    /// \throws std::invalid_argument as RasterWindow and ThinLens do
    OrthographicCamera(const Motion& worldFromCamera, const V2i& resolution, const Settings& settings);

    std::optional<CameraRay> generate(const CameraSample& sample) const override;
    /// Without a lens the direction is the delta: it counts as density 1 where a ray is parallel to the axis (within
    /// 1e-6), as a pinhole's position does for perspective cameras.
    Density density(const Ray& ray) const override;
    /// Without a lens the only direction: pdf 1, and we / pdf is the importance per area across the rays.
    std::optional<CameraConnection> connect(const V3d& p, const V2f& u, const V2f& margin = V2f(0),
                                            double time = 0) const override;
    V3d position() const override;
    bool startsAtPosition() const override { return !std::holds_alternative<Parallel>(projection_); }
    bool moves() const override;

  private:
    /// Parallel rays over a rectangle.
    struct Parallel {
        CameraMotion space;
        RasterWindow window;

        Density densityAt(const CameraSpace& at, const V3d& cameraPoint, const V2f& margin) const;
    };
    static std::variant<Parallel, ThinLens> project(const Motion& worldFromCamera, const V2i& resolution,
                                                    const Settings& settings);

    std::variant<Parallel, ThinLens> projection_;
};

} // namespace vitrine
