// The turned profiles whose speed is measured, their cameras and their rays: fixed by seeds, the same in every run.
#pragma once

#include "shapes/revolution/revolution.h"
#include "support/revolution_cases.h"

namespace vitrine::bench {

/// A pinhole camera with a square window.
struct Pinhole {
    V3d eye, target;
    double tanHalf; ///< half the window's side at distance 1

    /// Through the window at x, y in [-1,1], y upwards.
    Ray ray(double x, double y) const {
        const V3d forward = (target - eye).normalized(), right = forward.cross(V3d(0, 1, 0)).normalized();
        const V3d d = forward + (right * x + right.cross(forward) * y) * tanHalf;
        return Ray{eye, d.normalized()};
    }
};

struct Subject {
    std::string name;
    test::ProfilePoints points;
    V3d middle, half; ///< of the box about it
    Pinhole camera;   ///< the box's height fills nine tenths of the window

    Subject(std::string subjectName, test::ProfilePoints profilePoints, const V3d& eyeFromMiddle)
        : name(std::move(subjectName)), points(std::move(profilePoints)) {
        const Box3d box = shape()->bounds();
        middle = (box.min + box.max) * 0.5;
        half = box.max - middle;
        camera = {middle + eyeFromMiddle, middle, half.y / (0.9 * eyeFromMiddle.length())};
    }
    int degree() const { return int(points[0].size()) - 1; }
    Profile profile() const { return Profile(test::joined(points), degree()); }
    std::shared_ptr<const Revolution> shape() const {
        return std::make_shared<Revolution>(Transform(), false, profile());
    }
};

/// The reference scenes' goblet and vase (the vase a fortieth as large), seen as there.
inline std::vector<Subject> subjects() {
    return {{"goblet", test::gobletProfile(), V3d(0.3, 0.59, 3.6)},
            {"vase", test::vaseProfile(), V3d(3.375, 0.05, 6.125)}};
}

enum class RaySource {
    Camera, ///< a picture, row by row
    Random, ///< from anywhere in a box twice as large, outside the shape's own, to anywhere in that
    Surface ///< from anywhere on the surface to anywhere in the box: what a path does next
};
inline constexpr RaySource raySources[] = {RaySource::Camera, RaySource::Random, RaySource::Surface};

inline const char* toString(RaySource source) {
    return source == RaySource::Camera ? "camera" : source == RaySource::Random ? "random" : "surface";
}

inline std::vector<Ray> makeRays(const Subject& subject, RaySource source, int side) {
    std::vector<Ray> rays;
    RandomStream random(4711, int(source));
    const std::shared_ptr<const Revolution> shape = subject.shape();
    const auto any = [&](double scale) {
        return subject.middle +
               V3d(random.uniform(-scale, scale), random.uniform(-scale, scale), random.uniform(-scale, scale)) *
                   subject.half;
    };
    const auto isInside = [&](const V3d& p) {
        const V3d d = p - subject.middle;
        return std::abs(d.x) < subject.half.x && std::abs(d.y) < subject.half.y && std::abs(d.z) < subject.half.z;
    };
    for (int i = 0; i < side * side; ++i) {
        if (source == RaySource::Camera) {
            rays.push_back(subject.camera.ray((2 * (i % side) + 1.) / side - 1, 1 - (2 * (i / side) + 1.) / side));
            continue;
        }
        Ray ray;
        const V3d target = any(1);
        if (source == RaySource::Random) {
            do
                ray.o = any(2);
            while (isInside(ray.o));
        } else {
            const double u = random.uniform(), v = random.uniform();
            const SurfacePoint point = shape->sample(V2f(float(u), float(v)))->point;
            ray.o = offsetOrigin(point, toFloat(target - point.p));
        }
        ray.d = (target - ray.o).normalized();
        rays.push_back(ray);
    }
    return rays;
}

} // namespace vitrine::bench
