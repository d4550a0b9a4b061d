#include "nodes/transforms.h"

#include <stdexcept>

namespace vitrine {

namespace {

M44d affine(const V3d& x, const V3d& y, const V3d& z, const V3d& origin) {
    return M44d(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, origin.x, origin.y, origin.z, 1);
}

/// Unit vector, also of vectors whose length over- or underflows.
V3d unit(const V3d& v, const char* zeroMessage) {
    const double scale = maxAbs(v);
    if (scale == 0) throw std::domain_error(zeroMessage);
    return (v / scale).normalized();
}

/// Volume of the unit vectors along rows or columns, the larger: 0 for a singular matrix however it is scaled.
double independence(const M44d& m) {
    const auto volume = [](V3d a, V3d b, V3d c) {
        for (V3d* v : {&a, &b, &c}) {
            const double scale = maxAbs(*v);
            if (scale == 0) return 0.;
            *v = (*v / scale).normalized();
        }
        return std::abs(a.dot(b.cross(c)));
    };
    const V3d r0(m[0][0], m[0][1], m[0][2]), r1(m[1][0], m[1][1], m[1][2]), r2(m[2][0], m[2][1], m[2][2]);
    return std::max(volume(r0, r1, r2), volume(V3d(r0.x, r1.x, r2.x), V3d(r0.y, r1.y, r2.y), V3d(r0.z, r1.z, r2.z)));
}

} // namespace

double sinDegrees(double angle) {
    const double r = std::fmod(angle, 360);
    if (std::fmod(r, 90) != 0) return std::sin(radians(r));
    const int quarter = (int(r / 90) + 4) % 4;
    return quarter == 1 ? 1 : quarter == 3 ? -1 : 0;
}

double cosDegrees(double angle) {
    const double r = std::fmod(angle, 360);
    if (std::fmod(r, 90) != 0) return std::cos(radians(r));
    const int quarter = (int(r / 90) + 4) % 4;
    return quarter == 0 ? 1 : quarter == 2 ? -1 : 0;
}

Transform translation(const V3d& offset) {
    M44d forward, back;
    forward.setTranslation(offset);
    back.setTranslation(-offset);
    return Transform(forward, back);
}

Transform scaling(const V3d& factors) {
    if (factors.x == 0 || factors.y == 0 || factors.z == 0) throw std::domain_error("a scale factor must not be zero");
    M44d forward, back;
    forward.setScale(factors);
    back.setScale(V3d(1 / factors.x, 1 / factors.y, 1 / factors.z));
    if (!isFinite(back)) throw std::domain_error("a scale factor is too small");
    return Transform(forward, back);
}

Transform rotation(double angle, const V3d& axis) {
    const V3d a = unit(axis, "the axis must not be zero");
    const double s = sinDegrees(angle), c = cosDegrees(angle);
    // Rodrigues' formula: the images of the unit vectors are the rows.
    const auto image = [&](const V3d& v) { return v * c + a.cross(v) * s + a * (a.dot(v) * (1 - c)); };
    const M44d forward = affine(image(V3d(1, 0, 0)), image(V3d(0, 1, 0)), image(V3d(0, 0, 1)), V3d(0));
    return Transform(forward, forward.transposed());
}

Transform lookAt(const V3d& eye, const V3d& target, const V3d& up) {
    const V3d z = unit(target - eye, "the eye and the point it looks at must differ");
    const V3d across = unit(up, "the up vector must not be zero").cross(z);
    if (across.length() < 1e-12) throw std::domain_error("the up vector must not be parallel to the viewing direction");
    const V3d x = across.normalized(), y = z.cross(x);
    const M44d worldFromCamera = affine(x, y, z, eye);
    const M44d cameraFromWorld =
        affine(V3d(x.x, y.x, z.x), V3d(x.y, y.y, z.y), V3d(x.z, y.z, z.z), V3d(-eye.dot(x), -eye.dot(y), -eye.dot(z)));
    return Transform(cameraFromWorld, worldFromCamera);
}

Transform fromNumbers(std::span<const double, 16> numbers) {
    M44d m;
    for (int i = 0; i < 16; ++i)
        m[i / 4][i % 4] = numbers[std::size_t(i)];
    // Exporters write 0 and 1 through float arithmetic.
    constexpr double tolerance = 1e-6;
    for (int i = 0; i < 4; ++i) {
        const double wanted = i == 3 ? 1 : 0;
        if (std::abs(m[i][3] - wanted) > tolerance)
            throw std::domain_error(
                "a projective transformation is not supported: its 4th, 8th and 12th number must be 0, "
                "its 16th 1");
        m[i][3] = wanted;
    }
    if (independence(m) < 1e-14) throw std::domain_error("the matrix is singular");
    const Transform transform(m);
    if (!isFinite(transform.inverse().matrix())) throw std::domain_error("the matrix is singular");
    return transform;
}

Transform compose(const Transform& inner, const Transform& outer) {
    const Transform both = inner.then(outer);
    if (!isFinite(both.matrix()) || !isFinite(both.inverse().matrix()))
        throw std::domain_error("the current transformation grows beyond all numbers");
    return both;
}

} // namespace vitrine
