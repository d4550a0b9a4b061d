// Embree finds candidates in single precision; what is reported is solved in double from the double ray.
#include "accel/embree_group.h"
#include "accel/embree_hit.h"
#include "shapes/facet.h"

namespace vitrine {

namespace {

using namespace embree;

/// How far rounding may move a ray that Embree hands to an instance: Embree inverts the matrix in single precision
/// (hence the condition number) and transforms the origin, four roundings a coordinate and as many in the matrix.
struct InstanceRounding {
    double base = 0, slope = 0; ///< in instance space: base + slope * max |world coordinate after the move|

    InstanceRounding(const Placed& placed, const V3d& worldCenter, const V3d& groupCenter) {
        const double condition = std::max(1., placed.stretch() * placed.inverseStretch() / 3);
        const V3d shift = placed.instanceFromWorld().point(worldCenter) - groupCenter;
        base = 8 * 0x1p-24 * condition * maxAbs(shift);
        slope = 8 * 0x1p-24 * condition * placed.inverseStretch();
    }
};

/// A ray may start this many times the world's reach from its middle before its origin is brought nearer.
constexpr double originReach = 2;

/// Sixteen roundings of the largest coordinates that boxes and origins have: Embree's box test is a few of them off.
double boxPad(double reach) {
    return 16 * 0x1p-24 * (1 + originReach) * reach;
}

class EmbreeCaster final : public Caster {
  public:
    explicit EmbreeCaster(CasterInput input);

    bool intersect(const Ray& ray, CasterHit& hit) const override;
    bool occluded(const Ray& ray) const override;
    Box3d bounds() const override { return bounds_; }
    std::size_t memoryBytes() const override { return bytes_; }

  private:
    void buildGroups(const CasterInput& input, const std::vector<Extent>& extents);
    void attachInstances(const std::vector<Extent>& extents);
    bool begin(const Ray& ray, Query& query, RTCRay& out) const;
    bool beginFarAway(const Ray& ray, Query& query) const;
    void intersectUnbounded(const Ray& ray, CasterHit& best) const;
    bool unboundedOcclude(const Ray& ray) const;
    bool takeMeshHit(Query& query, const RTCRayHit& found) const;
    void describe(const Ray& ray, CasterHit& hit) const;

    std::vector<Placed> placed_;
    std::vector<InstanceRounding> rounding_;
    std::vector<std::unique_ptr<Group>> groups_;
    std::unique_ptr<Group> world_;
    Extent extent_;
    Box3d bounds_;
    bool anyUnbounded_ = false, anyBounded_ = false;
    std::size_t bytes_ = 0;
};

EmbreeCaster::EmbreeCaster(CasterInput input) {
    const std::size_t before = bytesInUse();
    std::vector<Extent> extents;
    std::vector<Box3d> boxes;
    for (const auto& shapes : input.groups) {
        boxes.push_back(boundsOf(shapes));
        extents.push_back(extentOf(boxes.back()));
    }
    bounds_ = boundsOf(input.shapes);
    for (const CasterInstance& instance : input.instances) {
        placed_.emplace_back(instance);
        bounds_.extendBy(instance.worldFromInstance.box(boxes.at(instance.group)));
    }
    extent_ = extentOf(bounds_);
    for (const Placed& placed : placed_)
        rounding_.emplace_back(placed, extent_.center, extents[placed.group()].center);
    buildGroups(input, extents);
    world_ = std::make_unique<Group>(input.shapes, extent_, boxPad(extent_.reach));
    attachInstances(extents);
    world_->commit();
    anyBounded_ = !world_->empty() || !placed_.empty();
    anyUnbounded_ = !world_->unbounded().empty();
    bytes_ = sizeof(*this) + world_->memoryBytes() + bytesInUse() - std::min(before, bytesInUse());
    bytes_ += memoryOf(input.shapes);
    for (const auto& shapes : input.groups)
        bytes_ += memoryOf(shapes);
    for (const auto& group : groups_) {
        anyUnbounded_ |= !group->unbounded().empty();
        bytes_ += group->memoryBytes();
    }
}

void EmbreeCaster::buildGroups(const CasterInput& input, const std::vector<Extent>& extents) {
    for (std::size_t i = 0; i < input.groups.size(); ++i) {
        double pad = boxPad(extents[i].reach);
        for (std::size_t k = 0; k < placed_.size(); ++k)
            if (placed_[k].group() == i)
                pad = std::max(pad, 2 * (rounding_[k].base + rounding_[k].slope * originReach * extent_.reach) +
                                        boxPad(extents[i].reach));
        groups_.push_back(std::make_unique<Group>(input.groups[i], extents[i], pad));
        groups_.back()->commit();
    }
}

void EmbreeCaster::attachInstances(const std::vector<Extent>& extents) {
    for (std::size_t k = 0; k < placed_.size(); ++k) {
        const std::uint32_t group = placed_[k].group();
        GeometryPtr geometry = newGeometry(RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(geometry.get(), groups_[group]->scene());
        const M44d& m = placed_[k].worldFromInstance().matrix();
        const V3d shift = placed_[k].worldFromInstance().point(extents[group].center) - extent_.center;
        // Column-major, column vectors: row i of ours is column i of Embree's.
        float columns[12];
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 3; ++j)
                columns[3 * i + j] = float(i < 3 ? m[i][j] : shift[j]);
        rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
        rtcSetGeometryMask(geometry.get(), maskAll | maskShadow);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometryByID(world_->scene(), geometry.get(), world_->geometryCount() + unsigned(k));
        throwIfFailed();
    }
}

/// A far origin is brought to the cube around everything, in double. False when the ray misses the cube.
[[gnu::noinline]] bool EmbreeCaster::beginFarAway(const Ray& ray, Query& query) const {
    const V3d o = ray.o - extent_.center;
    const double half = 1.5 * extent_.reach;
    double enter = 0, leave = infinityD;
    for (int k = 0; k < 3; ++k) {
        if (ray.d[k] == 0) {
            if (std::abs(o[k]) > half) return false;
            continue;
        }
        const double a = (-half - o[k]) / ray.d[k], b = (half - o[k]) / ray.d[k];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    query.start = enter;
    return enter <= leave && std::isfinite(enter) && enter < ray.tMax;
}

bool EmbreeCaster::begin(const Ray& ray, Query& query, RTCRay& out) const {
    rtcInitIntersectContext(&query.context);
    query.ray = &ray;
    query.placed = placed_;
    query.firstInstance = world_->geometryCount();
    V3d o = ray.o - extent_.center, d = ray.d;
    if (!(maxAbs(o) <= originReach * extent_.reach)) {
        if (!beginFarAway(ray, query)) return false;
        o += ray.d * query.start;
        // From so far away that double rounds by more than everything's size, no ray can be aimed.
        if (!(maxAbs(o) <= originReach * extent_.reach)) return false;
    }
    const double largest = maxAbs(d);
    if (!(largest > 0x1p-10 && largest < 0x1p10)) {
        query.scale = largest;
        d /= largest;
    }
    query.originSlack = 0x1p-22 * maxAbs(o);
    out.org_x = float(o.x);
    out.org_y = float(o.y);
    out.org_z = float(o.z);
    out.dir_x = float(d.x);
    out.dir_y = float(d.y);
    out.dir_z = float(d.z);
    out.tnear = 0;
    out.time = 0;
    out.id = 0;
    out.flags = 0;
    return true;
}

bool EmbreeCaster::intersect(const Ray& ray, CasterHit& hit) const {
    hit.s = infinityD;
    hit.shape = nullptr;
    hit.instance = CasterHit::noInstance;
    if (!canHit(ray)) return false;
    if (anyUnbounded_) intersectUnbounded(ray, hit);
    Query query;
    RTCRayHit found;
    if (anyBounded_ && begin(ray, query, found.ray)) {
        query.best = &hit;
        found.ray.mask = maskAll;
        bool again = true;
        while (again) {
            found.ray.tfar = query.farEnd(std::min(hit.s, ray.tMax));
            found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(world_->scene(), &query.context, &found);
            again = found.hit.geomID != RTC_INVALID_GEOMETRY_ID && !takeMeshHit(query, found);
            // Embree takes denormal numbers for 0 and would find a crossing at 0 for ever.
            const float next = std::nextafter(found.ray.tfar, infinity);
            const float least = 2 * std::max(found.ray.tnear, std::numeric_limits<float>::min());
            found.ray.tnear = next > found.ray.tnear && next >= std::numeric_limits<float>::min() ? next : least;
        }
    }
    if (!hit.shape) return false;
    describe(ray, hit);
    return true;
}

void keepIfFirst(const PrimitiveRef& ref, std::uint32_t instance, const PrimitiveHit& hit, const Query& query) {
    if (hit.s < query.ray->tMax) vitrine::keepIfFirst(*ref.shape, ref.id, instance, hit, *query.best);
}

/// Weighs Embree's hit against the best so far, both in double. False when in double it lies behind the origin: then
/// Embree has to go on from there. (A face with holes was asked whether it is there before, by keepCrossing.)
bool EmbreeCaster::takeMeshHit(Query& query, const RTCRayHit& found) const {
    const std::uint32_t instance = query.instanceOf(found.hit.instID[0]);
    const Group& group = instance == CasterHit::noInstance ? *world_ : *groups_[placed_[instance].group()];
    const PrimitiveRef ref = group.find(found.hit.geomID, found.hit.primID);
    const Ray& ray = query.rayIn(instance);
    PrimitiveHit hit;
    if (!solveFound(ref, ray, found.hit.u, found.hit.v, hit)) return false;
    keepIfFirst(ref, instance, hit, query);
    if (ref.rivals)
        for (const PrimitiveRef& rival : group.rivalsOf(ref, found.hit.geomID))
            if (rival.shape->intersect(rival.prim, ray, 0, infinityD, hit) &&
                rival.shape->solve(rival.prim, ray, hit) &&
                (!rival.cutout || isThere(candidate(rival), castRay(query, instance), hit, 0)))
                keepIfFirst(rival, instance, hit, query);
    return true;
}

void EmbreeCaster::describe(const Ray& ray, CasterHit& hit) const {
    const bool isMesh = hit.shape->kind() == GeometryKind::Triangles || hit.shape->kind() == GeometryKind::Quads;
    if (hit.instance == CasterHit::noInstance) {
        fillPoint(hit.point, *hit.shape, ray, hit.primitive);
        // Embree saw the mesh and the origin moved by -center: that is the origin it rounds.
        if (isMesh && extent_.center != V3d(0, 0, 0))
            hit.point.error += originError(hit.point.p - extent_.center) - originError(hit.point.p);
        return;
    }
    const Placed& placed = placed_[hit.instance];
    fillPoint(hit.point, *hit.shape, placed.toInstance(ray), hit.primitive);
    placed.toWorld(hit.point);
    if (isMesh) {
        const InstanceRounding& rounding = rounding_[hit.instance];
        const V3d p = hit.point.p - extent_.center;
        hit.point.error += placed.stretch() * (rounding.base + rounding.slope * maxAbs(p)) + originError(p);
    }
}

void EmbreeCaster::intersectUnbounded(const Ray& ray, CasterHit& best) const {
    const auto tryAll = [&](const Group& group, const CastRay& castRay) {
        for (const CasterShape& entry : group.unbounded())
            for (unsigned prim = 0; prim < entry.shape->primitiveCount(); ++prim)
                tryPrimitive({entry, prim}, castRay, ray.tMax, best);
    };
    tryAll(*world_, CastRay(ray));
    for (std::uint32_t i = 0; i < placed_.size(); ++i)
        if (const Group& group = *groups_[placed_[i].group()]; !group.unbounded().empty())
            tryAll(group, CastRay(ray, placed_[i].toInstance(ray), i, placed_[i]));
}

bool EmbreeCaster::unboundedOcclude(const Ray& ray) const {
    const auto anyOccludes = [&](const Group& group, const CastRay& castRay) {
        for (const CasterShape& entry : group.unbounded())
            for (unsigned prim = 0; entry.castsShadow && prim < entry.shape->primitiveCount(); ++prim)
                if (occludes({entry, prim}, castRay)) return true;
        return false;
    };
    if (anyOccludes(*world_, CastRay(ray))) return true;
    for (std::uint32_t i = 0; i < placed_.size(); ++i)
        if (const Group& group = *groups_[placed_[i].group()];
            !group.unbounded().empty() && anyOccludes(group, CastRay(ray, placed_[i].toInstance(ray), i, placed_[i])))
            return true;
    return false;
}

bool EmbreeCaster::occluded(const Ray& ray) const {
    if (!canHit(ray)) return false;
    if (anyUnbounded_ && unboundedOcclude(ray)) return true;
    Query query;
    RTCRay shadow;
    if (!anyBounded_ || !begin(ray, query, shadow)) return false;
    shadow.mask = maskShadow;
    // Near the ray's end, where it may be a lamp that is met, meshes are asked again in double.
    const V3d o(shadow.org_x, shadow.org_y, shadow.org_z), d(shadow.dir_x, shadow.dir_y, shadow.dir_z);
    query.end = float((ray.tMax - query.start) * query.scale);
    query.endSlack = float(distanceSlack * (maxAbs(o) + 2 * extent_.reach) / maxAbs(d));
    shadow.tfar = query.farEnd(ray.tMax);
    rtcOccluded1(world_->scene(), &query.context, &shadow);
    return shadow.tfar < 0;
}

} // namespace

std::unique_ptr<Caster> makeEmbreeCaster(CasterInput input) {
    return std::make_unique<EmbreeCaster>(std::move(input));
}

} // namespace vitrine
