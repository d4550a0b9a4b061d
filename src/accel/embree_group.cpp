#include "accel/embree_group.h"

#include "accel/embree_hit.h"

namespace vitrine::embree {

namespace {

/// Meshes of at least this many faces keep their own buffers, which Embree shares without a copy.
constexpr unsigned largeMesh = 1000;
/// Embree takes coordinates beyond 1.8e18 for invalid.
constexpr double largestCoordinate = 1e18;

bool isMesh(const Shape& shape) {
    return shape.kind() == GeometryKind::Triangles || shape.kind() == GeometryKind::Quads;
}

float floatBelow(double x) {
    const float f = float(x);
    return f > x ? std::nextafter(f, -infinity) : f;
}

float floatAbove(double x) {
    return -floatBelow(-x);
}

} // namespace

Extent extentOf(const Box3d& box) {
    Extent extent;
    if (box.isEmpty()) return extent;
    const double half = maxAbs(box.size()) / 2;
    for (int k = 0; k < 3; ++k) {
        const double middle = (box.min[k] + box.max[k]) / 2;
        // Beyond eight times the size, differences from the middle are exact in single precision (Sterbenz).
        if (std::abs(middle) > 8 * half) extent.center[k] = float(middle);
    }
    extent.reach = std::max(maxAbs(box.min - extent.center), maxAbs(box.max - extent.center));
    return extent;
}

/// Faces of small meshes with their corners copied, all as quads or all as triangles: Embree keeps one hierarchy a
/// type, and every type that a scene has costs each ray a traversal.
struct Group::Merged {
    explicit Merged(bool asQuads) : perFace(asQuads ? 4 : 3) {}

    unsigned perFace;
    std::vector<V3f> corners;
    std::vector<std::uint32_t> indices;
    std::vector<PrimitiveRef> table;
    std::optional<CoincidentFaces> coincident;
    bool anyCutout = false;

    void add(const Group& group, const CasterShape& entry) {
        const Shape& shape = *entry.shape;
        const unsigned from = shape.kind() == GeometryKind::Quads ? 4 : 3;
        anyCutout |= entry.cutout != nullptr;
        for (unsigned prim = 0; prim < shape.primitiveCount(); ++prim) {
            const std::uint32_t* v = shape.indices() + std::size_t(prim) * from;
            const auto addFace = [&](std::initializer_list<int> order, bool farHalf) {
                for (const int k : order) {
                    indices.push_back(std::uint32_t(corners.size()));
                    corners.push_back(group.moved(shape.vertices() + 3 * std::size_t(v[k])));
                }
                table.push_back(PrimitiveRef{&shape, entry.id, prim, farHalf, 0, entry.cutout.get()});
            };
            if (perFace == 4 && from == 4)
                addFace({0, 1, 2, 3}, false);
            else if (perFace == 4)
                addFace({0, 1, 2, 2}, false); // Embree's own way to say triangle; (u,v) keep their meaning
            else if (from == 3)
                addFace({0, 1, 2}, false);
            else {
                addFace({0, 1, 3}, false);
                addFace({2, 3, 1}, true);
            }
        }
    }
};

struct Group::Analytic {
    std::vector<PrimitiveRef> table;
    V3d center;
    double pad = 0;

    static void bounds(const RTCBoundsFunctionArguments* args) {
        const auto& self = *static_cast<const Analytic*>(args->geometryUserPtr);
        const PrimitiveRef& ref = self.table[args->primID];
        const Box3d box = ref.shape->bounds(ref.prim);
        const V3d low = box.min - self.center - V3d(self.pad), high = box.max - self.center + V3d(self.pad);
        RTCBounds& out = *args->bounds_o;
        out.lower_x = floatBelow(low.x);
        out.lower_y = floatBelow(low.y);
        out.lower_z = floatBelow(low.z);
        out.upper_x = floatAbove(high.x);
        out.upper_y = floatAbove(high.y);
        out.upper_z = floatAbove(high.z);
    }

    static void intersect(const RTCIntersectFunctionNArguments* args) {
        if (!args->valid[0]) return;
        const PrimitiveRef& ref = static_cast<const Analytic*>(args->geometryUserPtr)->table[args->primID];
        Query& query = *reinterpret_cast<Query*>(args->context);
        auto& rayHit = *reinterpret_cast<RTCRayHit*>(args->rayhit);
        const std::uint32_t instance = query.instanceOf(args->context->instID[0]);
        const double sMax = std::min(query.ray->tMax, query.upperEnd(rayHit.ray.tfar));
        if (!tryPrimitive(candidate(ref), castRay(query, instance), sMax, *query.best)) return;
        const float far = query.farEnd(query.best->s);
        if (!(far < rayHit.ray.tfar)) return;
        // Nearer by more than rounding: a mesh hit so far is out, Embree need not keep it.
        rayHit.ray.tfar = far;
        rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    }

    static void occluded(const RTCOccludedFunctionNArguments* args) {
        if (!args->valid[0]) return;
        const PrimitiveRef& ref = static_cast<const Analytic*>(args->geometryUserPtr)->table[args->primID];
        Query& query = *reinterpret_cast<Query*>(args->context);
        if (occludes(candidate(ref), castRay(query, query.instanceOf(args->context->instID[0]))))
            reinterpret_cast<RTCRay*>(args->ray)->tfar = -infinity;
    }
};

Group::Group(const std::vector<CasterShape>& shapes, const Extent& extent, double pad)
    : extent_(extent), pad_(pad), scene_(newScene()) {
    const bool anyLargeTriangles = std::any_of(shapes.begin(), shapes.end(), [](const CasterShape& entry) {
        return entry.shape->kind() == GeometryKind::Triangles && entry.shape->primitiveCount() >= largeMesh;
    });
    for (const bool castsShadow : {false, true}) {
        auto merged = std::make_unique<Merged>(!anyLargeTriangles);
        auto analytic = std::make_unique<Analytic>();
        for (const CasterShape& entry : shapes) {
            if (entry.castsShadow != castsShadow || entry.shape->primitiveCount() == 0) continue;
            shapes_.push_back(entry.shape);
            if (entry.cutout) cutouts_.push_back(entry.cutout);
            const bool bounded = entry.shape->kind() != GeometryKind::Unbounded;
            const Box3d box = bounded ? entry.shape->bounds() : Box3d();
            if (!bounded || !(std::max(maxAbs(box.min), maxAbs(box.max)) < largestCoordinate))
                unbounded_.push_back(entry);
            else if (isMesh(*entry.shape) && entry.shape->primitiveCount() >= largeMesh)
                addLargeMesh(entry);
            else if (isMesh(*entry.shape))
                merged->add(*this, entry);
            else
                for (unsigned prim = 0; prim < entry.shape->primitiveCount(); ++prim)
                    analytic->table.push_back(
                        PrimitiveRef{entry.shape.get(), entry.id, prim, 0, 0, entry.cutout.get()});
        }
        if (!merged->table.empty()) addMerged(std::move(merged), castsShadow);
        if (!analytic->table.empty()) addAnalytic(std::move(analytic), castsShadow);
    }
}

Group::~Group() = default;

V3f Group::moved(const float* vertex) const {
    return toFloat(V3d(vertex[0], vertex[1], vertex[2]) - extent_.center);
}

void Group::addLargeMesh(const CasterShape& entry) {
    const Shape& shape = *entry.shape;
    const bool quads = shape.kind() == GeometryKind::Quads;
    GeometryPtr geometry = newGeometry(quads ? RTC_GEOMETRY_TYPE_QUAD : RTC_GEOMETRY_TYPE_TRIANGLE);
    if (extent_.center == V3d(0, 0, 0)) {
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, shape.vertices(), 0,
                                   3 * sizeof(float), shape.vertexCount());
    } else {
        auto* out = static_cast<V3f*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                                              RTC_FORMAT_FLOAT3, sizeof(V3f), shape.vertexCount()));
        throwIfFailed();
        for (std::size_t i = 0; i < shape.vertexCount(); ++i)
            out[i] = moved(shape.vertices() + 3 * i);
    }
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, quads ? RTC_FORMAT_UINT4 : RTC_FORMAT_UINT3,
                               shape.indices(), 0, (quads ? 4 : 3) * sizeof(std::uint32_t), shape.primitiveCount());
    attachMesh(std::move(geometry), entry.castsShadow,
               Geometry{&shape, entry.id, nullptr, nullptr, entry.cutout.get(), entry.cutout != nullptr});
}

void Group::addMerged(std::unique_ptr<Merged> merged, bool castsShadow) {
    const bool quads = merged->perFace == 4;
    const std::size_t count = merged->corners.size();
    merged->coincident.emplace(merged->table);
    merged->corners.emplace_back(0.f, 0.f, 0.f); // Embree reads 16 bytes at the last vertex
    GeometryPtr geometry = newGeometry(quads ? RTC_GEOMETRY_TYPE_QUAD : RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, merged->corners.data(), 0,
                               sizeof(V3f), count);
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, quads ? RTC_FORMAT_UINT4 : RTC_FORMAT_UINT3,
                               merged->indices.data(), 0, merged->perFace * sizeof(std::uint32_t),
                               merged->table.size());
    attachMesh(std::move(geometry), castsShadow,
               Geometry{nullptr, 0, &merged->table, &*merged->coincident, nullptr, merged->anyCutout});
    merged_.push_back(std::move(merged));
}

void Group::addAnalytic(std::unique_ptr<Analytic> analytic, bool castsShadow) {
    analytic->center = extent_.center;
    analytic->pad = pad_;
    GeometryPtr geometry = newGeometry(RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry.get(), unsigned(analytic->table.size()));
    rtcSetGeometryUserData(geometry.get(), analytic.get());
    rtcSetGeometryBoundsFunction(geometry.get(), Analytic::bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), Analytic::intersect);
    rtcSetGeometryOccludedFunction(geometry.get(), Analytic::occluded);
    attach(std::move(geometry), castsShadow, Geometry{nullptr, 0, &analytic->table, nullptr, nullptr, false});
    analytic_.push_back(std::move(analytic));
}

namespace {

/// Takes back what Embree met near a shadow ray's end if in double it does not lie before it.
void keepOccluder(const RTCFilterFunctionNArguments* args) {
    Query& query = *reinterpret_cast<Query*>(args->context);
    const auto& ray32 = *reinterpret_cast<const RTCRay*>(args->ray);
    const auto& hit = *reinterpret_cast<const RTCHit*>(args->hit);
    const V3f n(hit.Ng_x, hit.Ng_y, hit.Ng_z), d(ray32.dir_x, ray32.dir_y, ray32.dir_z);
    // Along a surface a distance is as wrong as across it, over the cosine.
    if ((query.end - ray32.tfar) * std::abs(n.dot(d)) > query.endSlack * std::sqrt(n.length2() * d.length2())) return;
    const PrimitiveRef ref = static_cast<const Group*>(args->geometryUserPtr)->find(hit.geomID, hit.primID);
    const Ray& ray = query.rayIn(query.instanceOf(hit.instID[0]));
    if (!ref.shape->occludes(ref.prim, ray, 0, query.ray->tMax)) args->valid[0] = 0;
}

/// Whether the face that Embree reports is there; true also of those without holes.
bool isFaceThere(const RTCFilterFunctionNArguments* args, const PrimitiveRef& ref, double sMax) {
    if (!ref.cutout) return true;
    Query& query = *reinterpret_cast<Query*>(args->context);
    const auto& found = *reinterpret_cast<const RTCHit*>(args->hit);
    const CastRay ray = castRay(query, query.instanceOf(found.instID[0]));
    PrimitiveHit hit;
    return solveFound(ref, ray.local, found.u, found.v, hit) && hit.s < sMax && isThere(candidate(ref), ray, hit, 0);
}

PrimitiveRef faceOf(const RTCFilterFunctionNArguments* args) {
    const auto& hit = *reinterpret_cast<const RTCHit*>(args->hit);
    return static_cast<const Group*>(args->geometryUserPtr)->find(hit.geomID, hit.primID);
}

/// Takes back what is not there of meshes some of which have holes.
void keepCrossing(const RTCFilterFunctionNArguments* args) {
    if (!isFaceThere(args, faceOf(args), infinityD)) args->valid[0] = 0;
}

/// The same for shadow rays.
void keepOccluderThere(const RTCFilterFunctionNArguments* args) {
    const Query& query = *reinterpret_cast<const Query*>(args->context);
    const PrimitiveRef ref = faceOf(args);
    if (!ref.cutout)
        keepOccluder(args);
    else if (!isFaceThere(args, ref, query.ray->tMax))
        args->valid[0] = 0;
}

} // namespace

void Group::attachMesh(GeometryPtr geometry, bool castsShadow, Geometry record) {
    rtcSetGeometryUserData(geometry.get(), this);
    if (record.anyCutout) rtcSetGeometryIntersectFilterFunction(geometry.get(), keepCrossing);
    if (castsShadow)
        rtcSetGeometryOccludedFilterFunction(geometry.get(), record.anyCutout ? keepOccluderThere : keepOccluder);
    attach(std::move(geometry), castsShadow, record);
}

void Group::attach(GeometryPtr geometry, bool castsShadow, Geometry record) {
    rtcSetGeometryMask(geometry.get(), castsShadow ? maskAll | maskShadow : maskAll);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(scene_.get(), geometry.get(), geometryCount_++);
    geometries_.push_back(record);
    throwIfFailed();
}

void Group::commit() {
    rtcCommitScene(scene_.get());
    throwIfFailed();
}

std::size_t Group::memoryBytes() const {
    std::size_t bytes = sizeof(*this) + geometries_.capacity() * sizeof(Geometry);
    for (const auto& merged : merged_)
        bytes += merged->corners.capacity() * sizeof(V3f) + merged->indices.capacity() * sizeof(std::uint32_t) +
                 merged->table.capacity() * sizeof(PrimitiveRef);
    for (const auto& analytic : analytic_)
        bytes += analytic->table.capacity() * sizeof(PrimitiveRef);
    return bytes;
}

} // namespace vitrine::embree
