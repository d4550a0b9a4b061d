// A handful of primitives: no tree and no single precision. Their boxes are tested four at a time, and the shapes asked
// where the ray meets them.
#include "accel/candidate.h"
#include "core/slabs.h"

#include <array>
#include <bit>
#include <stdexcept>

namespace vitrine {

namespace {

constexpr unsigned laneCount = 4;
using Lanes [[gnu::vector_size(laneCount * sizeof(double))]] = double;
using LaneBits [[gnu::vector_size(laneCount * sizeof(std::int64_t))]] = std::int64_t;

Lanes allLanes(double x) {
    return Lanes{x, x, x, x};
}
/// b where they do not compare.
Lanes largerOf(Lanes a, Lanes b) {
    return a > b ? a : b;
}
Lanes smallerOf(Lanes a, Lanes b) {
    return a < b ? a : b;
}
std::uint32_t unionOf(LaneBits bits) {
    return std::uint32_t(bits[0] | bits[1] | bits[2] | bits[3]);
}

/// A vector in each lane.
struct V3Lanes {
    Lanes x{}, y{}, z{};

    V3Lanes() = default;
    V3Lanes(Lanes a, Lanes b, Lanes c) : x(a), y(b), z(c) {}
    explicit V3Lanes(const V3d& v) : x(allLanes(v.x)), y(allLanes(v.y)), z(allLanes(v.z)) {}

    void set(unsigned lane, const V3d& v) {
        x[lane] = v.x;
        y[lane] = v.y;
        z[lane] = v.z;
    }
    V3Lanes operator-(const V3Lanes& o) const { return {x - o.x, y - o.y, z - o.z}; }
    V3Lanes operator+(const V3Lanes& o) const { return {x + o.x, y + o.y, z + o.z}; }
    V3Lanes operator*(const V3Lanes& o) const { return {x * o.x, y * o.y, z * o.z}; }
};

/// By how much boxes are larger than what is in them. For their own size: the corners of flat quads are rounded to single
/// precision, a few 2^-24. For the scene's reach: what the test of a box rounds is far less for rays from within
/// farReach.
constexpr double ownPad = 0x1p-20, reachPad = 0x1p-30, farReach = 0x1p12;

/// Every primitive is solved by its shape, as by the oracle, but only where the ray meets its box.
class FlatCaster final : public Caster {
  public:
    explicit FlatCaster(const CasterInput& input);

    bool intersect(const Ray& ray, CasterHit& hit) const override;
    bool occluded(const Ray& ray) const override;
    Box3d bounds() const override { return bounds_; }
    std::size_t memoryBytes() const override {
        return sizeof(*this) + primitives_.capacity() * sizeof(Primitive) + boxes_.capacity() * sizeof(Boxes) +
               shapeBytes_;
    }

  private:
    struct Primitive {
        ShapePtr shape;
        std::uint32_t id = 0;
        unsigned prim = 0;
        CutoutPtr cutout;

        Candidate candidate() const { return {*shape, id, prim, cutout.get()}; }
    };
    struct Boxes {
        V3Lanes center, half;
        LaneBits bit{}; ///< of Crossed::boxes; an empty lane has none
    };
    /// Boxes that a ray meets, bit by bit, and the distances at which it enters them.
    struct Crossed {
        std::uint32_t boxes = 0;
        std::array<Lanes, (maxFlatPrimitives + laneCount - 1) / laneCount> enter;

        double enterOf(unsigned i) const { return enter[i / laneCount][i % laneCount]; }
    };
    void add(const CasterShape& entry, unsigned prim);
    /// False for what is no ray.
    bool cross(const Ray& ray, Crossed& crossed) const;
    const Primitive& lowest(std::uint32_t bits) const { return primitives_[unsigned(std::countr_zero(bits))]; }

    std::vector<Primitive> primitives_;
    std::vector<Boxes> boxes_;
    std::uint32_t castShadow_ = 0; ///< bits of those that do
    double reach_ = 0;             ///< largest coordinate of all boxes
    Box3d bounds_;
    std::size_t shapeBytes_;
};

FlatCaster::FlatCaster(const CasterInput& input)
    : bounds_(boundsOf(input.shapes)), shapeBytes_(memoryOf(input.shapes)) {
    if (!bounds_.isEmpty()) reach_ = std::max(maxAbs(bounds_.min), maxAbs(bounds_.max));
    // Meshes first: they are quick, and what lies behind them need not be solved.
    for (const bool user : {false, true})
        for (const CasterShape& entry : input.shapes) {
            const GeometryKind kind = entry.shape->kind();
            if ((kind == GeometryKind::User || kind == GeometryKind::Unbounded) != user) continue;
            for (unsigned prim = 0; prim < entry.shape->primitiveCount(); ++prim)
                add(entry, prim);
        }
}

void FlatCaster::add(const CasterShape& entry, unsigned prim) {
    const unsigned index = unsigned(primitives_.size()), lane = index % laneCount;
    if (lane == 0) boxes_.emplace_back();
    Boxes& boxes = boxes_.back();
    boxes.half.set(lane, V3d(infinityD));
    if (entry.shape->kind() != GeometryKind::Unbounded) {
        const Box3d box = entry.shape->bounds(prim);
        boxes.center.set(lane, (box.min + box.max) / 2);
        boxes.half.set(lane, box.size() / 2 + V3d(ownPad * maxAbs(box.size()) + reachPad * reach_));
    }
    boxes.bit[lane] = std::int64_t(1) << index;
    castShadow_ |= std::uint32_t(entry.castsShadow) << index;
    primitives_.push_back({entry.shape, entry.id, prim, entry.cutout});
}

/// The slabs of Kay & Kajiya 1986.
bool FlatCaster::cross(const Ray& ray, Crossed& crossed) const {
    const auto sumAbs = [](const V3d& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
    const double length = sumAbs(ray.d);
    if (!(sumAbs(ray.o) <= farReach * reach_ && length > 0x1p-500 && length < infinityD && ray.tMax > 0)) {
        if (!canHit(ray)) return false;
        // Rounding may do anything to this one: all are tried.
        crossed.boxes = primitives_.empty() ? 0 : ~0u >> (maxFlatPrimitives - primitives_.size());
        crossed.enter.fill(Lanes{});
        return true;
    }
    const V3d inverted = slabInverse(ray.d);
    const V3Lanes origin(ray.o), perLength(inverted);
    const V3Lanes perSize(V3d(std::abs(inverted.x), std::abs(inverted.y), std::abs(inverted.z)));
    const Lanes end = allLanes(ray.tMax);
    LaneBits met{};
    auto enter = crossed.enter.begin();
    for (const Boxes& boxes : boxes_) {
        const V3Lanes middle = (boxes.center - origin) * perLength, half = boxes.half * perSize;
        const V3Lanes in = middle - half, out = middle + half;
        *enter = largerOf(largerOf(in.x, in.y), largerOf(in.z, Lanes{}));
        const Lanes leave = smallerOf(smallerOf(out.x, out.y), smallerOf(out.z, end));
        met |= (*enter++ <= leave) & boxes.bit;
    }
    crossed.boxes = unionOf(met);
    return true;
}

bool FlatCaster::intersect(const Ray& ray, CasterHit& hit) const {
    hit.s = infinityD;
    hit.shape = nullptr;
    hit.instance = CasterHit::noInstance;
    Crossed crossed;
    if (!cross(ray, crossed)) return false;
    for (std::uint32_t rest = crossed.boxes; rest; rest &= rest - 1) {
        if (crossed.enterOf(unsigned(std::countr_zero(rest))) > hit.s) continue;
        tryPrimitive(lowest(rest).candidate(), CastRay(ray), ray.tMax, hit);
    }
    if (!hit.shape) return false;
    fillPoint(hit.point, *hit.shape, ray, hit.primitive);
    return true;
}

bool FlatCaster::occluded(const Ray& ray) const {
    Crossed crossed;
    if (!cross(ray, crossed)) return false;
    for (std::uint32_t rest = crossed.boxes & castShadow_; rest; rest &= rest - 1)
        if (occludes(lowest(rest).candidate(), CastRay(ray))) return true;
    return false;
}

bool isFlat(const CasterInput& input) {
    std::size_t primitives = 0;
    for (const CasterShape& entry : input.shapes)
        primitives += entry.shape->primitiveCount();
    return input.instances.empty() && primitives <= maxFlatPrimitives;
}

} // namespace

std::unique_ptr<Caster> makeFlatCaster(const CasterInput& input) {
    if (!isFlat(input)) throw std::invalid_argument("more than the flat caster takes");
    return std::make_unique<FlatCaster>(input);
}

std::unique_ptr<Caster> makeCaster(CasterInput input) {
    return isFlat(input) ? makeFlatCaster(input) : makeEmbreeCaster(std::move(input));
}

} // namespace vitrine
