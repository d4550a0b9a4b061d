// Affine maps with their inverse, in Imath's row-vector convention: v' = v M.
#pragma once

#include "core/ray.h"
#include "core/vec.h"

namespace vitrine {

bool isFinite(const M44d& m);
/// Determinant of the linear part.
double linearDeterminant(const M44d& m);
/// Frobenius norm of the linear part: at least its largest stretch of a vector, at most sqrt(3) times that.
double linearNorm(const M44d& m);

/// An invertible affine map between two named spaces, as in `worldFromObject`.
class Transform {
  public:
    Transform() = default;
    /// \throws std::domain_error when `matrix` is singular or not finite.
    explicit Transform(const M44d& matrix);
    Transform(const M44d& matrix, const M44d& inverse) : matrix_(matrix), inverse_(inverse) {}

    const M44d& matrix() const { return matrix_; }
    Transform inverse() const { return Transform(inverse_, matrix_); }
    bool isIdentity() const { return matrix_ == M44d(); }
    bool swapsHandedness() const;

    V3d point(const V3d& p) const {
        const auto& m = matrix_;
        return V3d(p.x * m[0][0] + p.y * m[1][0] + p.z * m[2][0] + m[3][0],
                   p.x * m[0][1] + p.y * m[1][1] + p.z * m[2][1] + m[3][1],
                   p.x * m[0][2] + p.y * m[1][2] + p.z * m[2][2] + m[3][2]);
    }
    V3d vector(const V3d& v) const {
        const auto& m = matrix_;
        return V3d(v.x * m[0][0] + v.y * m[1][0] + v.z * m[2][0], v.x * m[0][1] + v.y * m[1][1] + v.z * m[2][1],
                   v.x * m[0][2] + v.y * m[1][2] + v.z * m[2][2]);
    }
    /// Normals go by the inverse transpose; the result is not normalised.
    V3d normal(const V3d& n) const {
        const auto& m = inverse_;
        return V3d(n.x * m[0][0] + n.y * m[0][1] + n.z * m[0][2], n.x * m[1][0] + n.y * m[1][1] + n.z * m[1][2],
                   n.x * m[2][0] + n.y * m[2][1] + n.z * m[2][2]);
    }
    Ray ray(const Ray& r) const { return Ray{point(r.o), vector(r.d), r.tMax, r.time}; }
    /// The box of the eight corners.
    Box3d box(const Box3d& b) const;

    /// First this, then `next` (row vectors: p A B).
    Transform then(const Transform& next) const;

  private:
    M44d matrix_, inverse_;
};

} // namespace vitrine
