#include "cameras/camera_space.h"

namespace vitrine {

CameraSpace::CameraSpace(const Transform& worldFromCamera)
    : worldFromCamera_(worldFromCamera), cameraFromWorld_(worldFromCamera.inverse()) {
    const V3d x = worldFromCamera.vector(V3d(1, 0, 0));
    const V3d y = worldFromCamera.vector(V3d(0, 1, 0));
    const V3d z = worldFromCamera.vector(V3d(0, 0, 1));
    const V3d cross = x.cross(y);
    determinant_ = std::abs(cross.dot(z));
    planeArea_ = cross.length();
    normal_ = cross.normalized();
}

Ray CameraSpace::toWorld(const V3d& o, const V3d& d, double time) const {
    return Ray{worldFromCamera_.point(o), worldFromCamera_.vector(d).normalized(), infinityD, time};
}

double CameraSpace::solidAngleRatio(const V3d& d) const {
    const double length = worldFromCamera_.vector(d).length();
    return length * length * length / determinant_;
}

} // namespace vitrine
