#include "core/motion.h"

#include <ImathMatrixAlgo.h>
#include <ImathQuat.h>

#include <stdexcept>

namespace vitrine {

namespace {

using M33d = Imath::M33d;
using Quatd = Imath::Quatd;

M33d linearPart(const M44d& m) {
    return M33d(m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]);
}

V3d translationPart(const M44d& m) {
    return V3d(m[3][0], m[3][1], m[3][2]);
}

double norm(const M33d& m) {
    double sum = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            sum += sqr(m[i][j]);
    return std::sqrt(sum);
}

/// The rotation nearest to a linear map that does not mirror: the limit of averaging it with its inverse transpose
/// (Higham 1986, "Computing the polar decomposition"), scaled so that it starts near 1.
M33d nearestRotation(const M33d& linear) {
    M33d r = linear * (1 / std::cbrt(linear.determinant()));
    for (int i = 0; i < 100; ++i) {
        const M33d next = (r + r.inverse().transposed()) * 0.5;
        const double change = norm(next - r);
        r = next;
        if (change < 1e-15) break;
    }
    return r;
}

M44d affine(const M33d& linear, const V3d& translation) {
    return M44d(linear, translation);
}

/// No stretch at all differs from 1 by the rounding of its rotation.
constexpr double sameStretch = 1e-14;

} // namespace

struct Motion::Path {
    struct Pose {
        V3d translation;
        M33d stretch;
        Quatd rotation;
    };
    Pose start, end;
    M33d inverseStretch; ///< of the start
    bool stretches;      ///< the stretch changes
    double angle;        ///< that the rotation goes through, radians
    Transform before;    ///< what comes first

    /// A map that mirrors is a rotation after a stretch by -1.
    static Pose split(const Transform& transform) {
        const M33d linear = linearPart(transform.matrix());
        const double sign = linear.determinant() < 0 ? -1 : 1;
        const M33d rotation = nearestRotation(linear * sign);
        return {translationPart(transform.matrix()), linear * rotation.transposed(),
                Imath::extractQuat(affine(rotation, V3d(0, 0, 0))).normalized()};
    }
};

Motion::Motion(const Transform& start, double startTime, const Transform& end, double endTime)
    : start_(start), end_(end), startTime_(startTime), endTime_(endTime) {
    if (start.matrix() == end.matrix()) return;
    if (start.swapsHandedness() != end.swapsHandedness())
        throw std::domain_error("the transformation mirrors at one of its ends alone: between them it would be flat");
    auto path = std::make_shared<Path>();
    path->start = Path::split(start);
    path->end = Path::split(end);
    if ((path->start.rotation ^ path->end.rotation) < 0) path->end.rotation = -path->end.rotation;
    path->inverseStretch = path->start.stretch.inverse();
    path->stretches = norm(path->end.stretch - path->start.stretch) > sameStretch * norm(path->start.stretch);
    path->angle = 2 * std::acos(std::min(1., path->start.rotation ^ path->end.rotation));
    path_ = std::move(path);
}

Motion Motion::sinceStart() const {
    Motion since = *this;
    const Transform back = start_.inverse();
    since.start_ = Transform();
    since.end_ = back.then(end_);
    if (path_) {
        auto path = std::make_shared<Path>(*path_);
        path->before = back;
        since.path_ = std::move(path);
    }
    return since;
}

double Motion::fraction(double time) const {
    // Where both times are one the poses follow each other at once.
    if (!(time > startTime_)) return 0;
    if (!(time < endTime_)) return 1;
    return (time - startTime_) / (endTime_ - startTime_);
}

Transform Motion::at(double time) const {
    return moves() ? between(fraction(time)) : start_;
}

Transform Motion::between(double u) const {
    if (u == 0) return start_;
    if (u == 1) return end_;
    const Path& path = *path_;
    const V3d translation = path.start.translation * (1 - u) + path.end.translation * u;
    const M33d rotation = Imath::slerpShortestArc(path.start.rotation, path.end.rotation, u).toMatrix33();
    const M33d stretch = path.stretches ? path.start.stretch * (1 - u) + path.end.stretch * u : path.start.stretch;
    const M33d inverse = rotation.transposed() * (path.stretches ? stretch.inverse() : path.inverseStretch);
    const Transform pose(affine(stretch * rotation, translation), affine(inverse, -translation * inverse));
    return path.before.isIdentity() ? pose : path.before.then(pose);
}

Box3d Motion::sweep(const Box3d& box, const Shutter& times) const {
    if (!moves()) return start_.box(box);
    if (box.isEmpty()) return box;
    const double from = fraction(times.open), to = fraction(times.close);
    const Path& path = *path_;
    // Of p(u) = q S(u) R(u) + T(u), with S and T linear, |p''| <= (2 |S'| w + |S| w^2) |q|: from its chord over a step h it
    // is away by h^2 / 8 times that.
    const int steps = to > from ? 1 + std::min(64, int(16 * path.angle * (to - from))) : 0;
    double reach = 0;
    for (int i = 0; i < 8; ++i)
        reach = std::max(reach, path.before
                                    .point(V3d(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                                               i & 4 ? box.max.z : box.min.z))
                                    .length());
    const double stretch = std::max(norm(path.start.stretch), norm(path.end.stretch));
    const double bend = (2 * norm(path.end.stretch - path.start.stretch) + stretch * path.angle) * path.angle * reach;
    const double step = steps > 0 ? (to - from) / steps : 0;
    Box3d swept;
    for (int i = 0; i <= steps; ++i)
        swept.extendBy(between(i == steps ? to : from + step * i).box(box));
    const V3d pad(sqr(step) / 8 * bend + 1e-12 * std::max(maxAbs(swept.min), maxAbs(swept.max)));
    return Box3d(swept.min - pad, swept.max + pad);
}

} // namespace vitrine
