// A shape that moves while the shutter is open.
#pragma once

#include "accel/caster.h"
#include "core/motion.h"

namespace vitrine {

/// A ray meets the shape where it is at the ray's time: the ray is taken there and back in double, so that all casters get
/// the same answer. Bounds hold the shape at all times of the shutter.
///
/// Meshes of many faces are one primitive, with a caster inside; PrimitiveHit::prim is the face all the same.
class MovingShape final : public Shape {
  public:
    /// \param worldFromShape of the shape as it is made: it may lie in the world where it starts
    /// \param inside of the same shape; null: its primitives are tried one by one, each in its own bounds
    MovingShape(ShapePtr shape, const Motion& worldFromShape, const Shutter& shutter,
                std::shared_ptr<const Caster> inside = nullptr);
    /// A caster for `inside` where it is worth it; several movements of one shape may share it. \throws as makeCaster
    static std::shared_ptr<const Caster> casterFor(const ShapePtr& shape);

    GeometryKind kind() const override {
        return shape_->kind() == GeometryKind::Unbounded ? GeometryKind::Unbounded : GeometryKind::User;
    }
    unsigned primitiveCount() const override { return inside_ ? 1 : shape_->primitiveCount(); }
    Box3d bounds(unsigned prim) const override;
    using Shape::bounds;
    bool intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const override;
    bool occludes(unsigned prim, const Ray& ray, double sMin, double sMax) const override;
    SurfacePoint pointAt(const Ray& ray, const PrimitiveHit& hit) const override;

    /// Where it starts.
    double area() const override;
    std::optional<ShapeSample> sample(const V2f& u) const override { return sampleAt(shutter_.open, u); }
    std::optional<ShapeSample> sample(const V3d& from, const V2f& u) const override {
        return sampleAt(shutter_.open, from, u);
    }
    float pdf(const V3d& from, const PrimitiveHit& hit, const SurfacePoint& point) const override {
        return pdfAt(shutter_.open, from, hit, point);
    }
    using Shape::pdf;

    // As sample and pdf, where the shape is at a time.
    std::optional<ShapeSample> sampleAt(double time, const V2f& u) const;
    std::optional<ShapeSample> sampleAt(double time, const V3d& from, const V2f& u) const;
    float pdfAt(double time, const V3d& from, const PrimitiveHit& hit, const SurfacePoint& point) const;

    bool isClosed() const override { return shape_->isClosed(); }
    std::size_t memoryBytes() const override {
        return sizeof(*this) + (inside_ ? inside_->memoryBytes() : shape_->memoryBytes());
    }

  private:
    bool intersectEach(const Ray& local, double sMin, double sMax, PrimitiveHit& hit) const;

    ShapePtr shape_;
    Motion worldFromShape_;
    Shutter shutter_;
    std::shared_ptr<const Caster> inside_;
};

} // namespace vitrine
