#include "accel/moving_shape.h"

#include "accel/instance.h"

namespace vitrine {

namespace {

/// From so many faces on a caster is quicker than all their boxes, which are large where a shape turns.
constexpr unsigned manyFaces = 16;

/// Solid angle in the shape's space per solid angle in the world about the direction d of the world: |L d|^3 / |det L| the
/// other way round, with L the linear part.
double solidAngleRatio(const Transform& shapeFromWorld, const V3d& d) {
    const double growth = d.length() / shapeFromWorld.vector(d).length();
    return std::abs(linearDeterminant(shapeFromWorld.matrix())) * growth * growth * growth;
}

void toWorld(const Transform& pose, SurfacePoint& point) {
    // Its own space knows the normal that matters where derivatives are not set.
    if (!(point.ns.length2() > 0)) point.ns = point.ng;
    Placed({0, pose}).toWorld(point);
    // A pose between two is put together from parts: its inverse is that but for as much rounding again.
    point.error *= 2;
}

} // namespace

MovingShape::MovingShape(ShapePtr shape, const Motion& worldFromShape, const Shutter& shutter,
                         std::shared_ptr<const Caster> inside)
    : shape_(std::move(shape)), worldFromShape_(worldFromShape), shutter_(shutter), inside_(std::move(inside)) {}

std::shared_ptr<const Caster> MovingShape::casterFor(const ShapePtr& shape) {
    const bool isMesh = shape->kind() == GeometryKind::Triangles || shape->kind() == GeometryKind::Quads;
    if (!isMesh || shape->primitiveCount() < manyFaces) return nullptr;
    CasterInput input;
    input.shapes.push_back({shape});
    return makeCaster(std::move(input));
}

Box3d MovingShape::bounds(unsigned prim) const {
    return worldFromShape_.sweep(inside_ ? shape_->bounds() : shape_->bounds(prim), shutter_);
}

bool MovingShape::intersectEach(const Ray& local, double sMin, double sMax, PrimitiveHit& hit) const {
    bool any = false;
    PrimitiveHit here;
    for (unsigned face = 0; face < shape_->primitiveCount(); ++face)
        if (shape_->intersect(face, local, sMin, sMax, here)) {
            any = true;
            sMax = here.s;
            hit = here;
        }
    return any;
}

bool MovingShape::intersect(unsigned prim, const Ray& ray, double sMin, double sMax, PrimitiveHit& hit) const {
    Ray local = worldFromShape_.at(ray.time).inverse().ray(ray);
    if (!inside_) return shape_->intersect(prim, local, sMin, sMax, hit);
    // A second crossing: only those who look through holes ask for it.
    if (sMin > 0) return intersectEach(local, sMin, sMax, hit);
    local.tMax = sMax;
    CasterHit found;
    if (!inside_->intersect(local, found)) return false;
    hit = found.primitive;
    hit.s = found.s;
    return true;
}

bool MovingShape::occludes(unsigned prim, const Ray& ray, double sMin, double sMax) const {
    Ray local = worldFromShape_.at(ray.time).inverse().ray(ray);
    if (!inside_) return shape_->occludes(prim, local, sMin, sMax);
    PrimitiveHit hit;
    if (sMin > 0) return intersectEach(local, sMin, sMax, hit);
    local.tMax = sMax;
    return inside_->occluded(local);
}

SurfacePoint MovingShape::pointAt(const Ray& ray, const PrimitiveHit& hit) const {
    const Transform pose = worldFromShape_.at(ray.time);
    SurfacePoint point = shape_->pointAt(pose.inverse().ray(ray), hit);
    toWorld(pose, point);
    return point;
}

double MovingShape::area() const {
    // In its own space the shape has this area; what a pose makes of it depends on which way it faces, but for a pose that
    // stretches all ways alike.
    const double scale = std::cbrt(std::abs(linearDeterminant(worldFromShape_.start().matrix())));
    return shape_->area() * sqr(scale);
}

std::optional<ShapeSample> MovingShape::sampleAt(double time, const V2f& u) const {
    auto sample = shape_->sample(u);
    if (!sample) return {};
    const Transform pose = worldFromShape_.at(time);
    // An area with the unit normal n becomes |det L| |n L^-T| times as large.
    const double growth = std::abs(linearDeterminant(pose.matrix())) * pose.normal(toDouble(sample->point.ng)).length();
    sample->pdf = float(sample->pdf / growth);
    toWorld(pose, sample->point);
    return sample;
}

std::optional<ShapeSample> MovingShape::sampleAt(double time, const V3d& from, const V2f& u) const {
    const Transform pose = worldFromShape_.at(time), back = pose.inverse();
    auto sample = shape_->sample(back.point(from), u);
    if (!sample) return {};
    toWorld(pose, sample->point);
    sample->pdf = float(sample->pdf * solidAngleRatio(back, sample->point.p - from));
    return sample;
}

float MovingShape::pdfAt(double time, const V3d& from, const PrimitiveHit& hit, const SurfacePoint& point) const {
    const Transform pose = worldFromShape_.at(time), back = pose.inverse();
    SurfacePoint local = point;
    Placed({0, back}).toWorld(local);
    return float(shape_->pdf(back.point(from), hit, local) * solidAngleRatio(back, point.p - from));
}

} // namespace vitrine
