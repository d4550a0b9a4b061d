#include "core/transform.h"

#include <stdexcept>

namespace vitrine {

bool isFinite(const M44d& m) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            if (!std::isfinite(m[i][j])) return false;
    return true;
}

double linearDeterminant(const M44d& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

double linearNorm(const M44d& m) {
    double sum = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            sum += sqr(m[i][j]);
    return std::sqrt(sum);
}

Transform::Transform(const M44d& matrix) : matrix_(matrix) {
    if (!isFinite(matrix)) throw std::domain_error("the transformation is not finite");
    try {
        inverse_ = matrix.gjInverse(true);
    } catch (const std::exception&) {
        throw std::domain_error("the transformation is singular");
    }
    if (!isFinite(inverse_)) throw std::domain_error("the transformation is singular");
}

bool Transform::swapsHandedness() const {
    return linearDeterminant(matrix_) < 0;
}

Box3d Transform::box(const Box3d& b) const {
    Box3d result;
    if (b.isEmpty()) return result;
    for (int i = 0; i < 8; ++i)
        result.extendBy(point(V3d(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z)));
    return result;
}

Transform Transform::then(const Transform& next) const {
    return Transform(matrix_ * next.matrix_, next.inverse_ * inverse_);
}

} // namespace vitrine
