#include "shapes/revolution/root_finder.h"

namespace vitrine {

void Ring::extendBy(const Ring& other) {
    rMin = std::min(rMin, other.rMin);
    rMax = std::max(rMax, other.rMax);
    yMin = std::min(yMin, other.yMin);
    yMax = std::max(yMax, other.yMax);
}

double Ring::surface() const {
    return 8 * rMax * (rMax + yMax - yMin); // of the box about it
}

namespace {

/// The ray beside rings, with all rounding put into one margin.
class RingTest {
  public:
    RingTest(const HitCollector& hits, double size) : hits_(hits), ray_(hits.ray()) {
        margin_ = 0x1p-44 * (ray_.reach + size);
        // For a horizontal ray any height outside the slab is infinitely far.
        inverseV_ = std::abs(ray_.v) > 1e-300 ? 1 / ray_.v : 1e300;
        eLow2_ = sqr(std::max(0., ray_.e - margin_));
        eHigh2_ = sqr(ray_.e + margin_);
    }

    bool misses(const Ring& ring) const {
        double a = (ring.yMin - ray_.oy - margin_) * inverseV_, b = (ring.yMax - ray_.oy + margin_) * inverseV_;
        if (a > b) std::swap(a, b);
        const double lMargin = margin_;
        const double lo = std::max(a, hits_.lengthMin() - lMargin), hi = std::min(b, hits_.lengthMax() + lMargin);
        if (lo > hi) return true;
        // r^2 = e^2 + g^2 is convex along the ray.
        const double ga = ray_.q + ray_.h * lo, gb = ray_.q + ray_.h * hi;
        const double near = ga <= 0 && gb >= 0 ? 0 : std::max(0., std::min(std::abs(ga), std::abs(gb)) - margin_);
        if (near * near + eLow2_ > sqr(ring.rMax + margin_)) return true;
        const double far = std::max(std::abs(ga), std::abs(gb)) + margin_;
        return ring.rMin > margin_ && far * far + eHigh2_ < sqr(ring.rMin - margin_);
    }

  private:
    const HitCollector& hits_;
    const AxialRay& ray_;
    double margin_, inverseV_, eLow2_, eHigh2_;
};

/// Parts are monotone: their ends bound them, up to rounding.
Ring ringAbout(const BezierCurve& curve, double size) {
    const double slack = 1e-13 * size;
    const V2d &a = curve.first(), &b = curve.last();
    return {std::max(0., std::min(a.x, b.x) - slack), std::max(a.x, b.x) + slack, std::min(a.y, b.y) - slack,
            std::max(a.y, b.y) + slack};
}

} // namespace

RootFinder::RootFinder(const Profile& profile) : size_(profile.size()) {
    std::vector<Ring> rings;
    for (const ProfilePart& part : profile.parts()) {
        rings.push_back(ringAbout(part.curve, size_));
        parts_.emplace_back(part.curve, unsigned(parts_.size()));
    }
    build(0, unsigned(parts_.size()), rings, 0);
    cheapestGroups(0, groups_);
}

namespace {

/// Where to divide rings into two runs so that boxes about them, weighted by what they hold, are smallest.
unsigned bestCut(std::span<const Ring> rings) {
    std::vector<double> tail(rings.size());
    Ring ring;
    for (std::size_t i = rings.size(); i-- > 0;) {
        ring.extendBy(rings[i]);
        tail[i] = ring.surface() * double(rings.size() - i);
    }
    ring = Ring{};
    unsigned best = 1;
    double least = infinityD;
    for (unsigned i = 1; i < rings.size(); ++i) {
        ring.extendBy(rings[i - 1]);
        const double cost = ring.surface() * i + tail[i];
        if (cost < least) least = cost, best = i;
    }
    return best;
}

} // namespace

unsigned RootFinder::build(unsigned first, unsigned count, const std::vector<Ring>& rings, int depth) {
    const unsigned index = unsigned(nodes_.size());
    nodes_.push_back({Ring{}, first, count});
    for (unsigned i = first; i < first + count; ++i)
        nodes_[index].ring.extendBy(rings[i]);
    if (count > 1) {
        // Halving from some depth on keeps the tree's depth, and with it the stack of a search, within bounds.
        const unsigned cut = depth < maxTreeDepth - 32 ? bestCut(std::span(rings).subspan(first, count)) : count / 2;
        build(first, cut, rings, depth + 1);
        const unsigned right = build(first + cut, count - cut, rings, depth + 1);
        nodes_[index].right = right;
    }
    return index;
}

double RootFinder::cheapestGroups(unsigned node, std::vector<unsigned>& groups) const {
    // A ray that meets the box pays for the call and for the way down the tree; measured in calls.
    constexpr double levelCost = 0.2;
    const Node& n = nodes_[node];
    const double whole = n.ring.surface() * (1 + levelCost * std::log2(double(n.count)));
    if (n.right != 0) {
        std::vector<unsigned> apart;
        const double cost = cheapestGroups(node + 1, apart) + cheapestGroups(n.right, apart);
        if (cost < whole) {
            groups.insert(groups.end(), apart.begin(), apart.end());
            return cost;
        }
    }
    groups.push_back(node);
    return whole;
}

std::vector<Ring> RootFinder::rings(unsigned group) const {
    std::vector<Ring> result;
    const Node& root = nodes_[groups_[group]];
    for (const Node& node : nodes_)
        if (node.count == 1 && node.first >= root.first && node.first < root.first + root.count)
            result.push_back(node.ring);
    return result;
}

void RootFinder::search(unsigned group, HitCollector& hits) const {
    const RingTest test(hits, size_);
    unsigned stack[maxTreeDepth + 2];
    int depth = 0;
    stack[depth++] = groups_[group];
    while (depth > 0) {
        const unsigned index = stack[--depth];
        const Node& node = nodes_[index];
        if (test.misses(node.ring)) continue;
        if (node.right == 0) {
            parts_[node.first].solve(hits);
            if (hits.done()) return;
            continue;
        }
        stack[depth++] = node.right;
        stack[depth++] = index + 1;
    }
}

std::vector<ProfileHit> RootFinder::allHits(const AxialRay& ray, const PhiRange& phi, double sMin, double sMax) const {
    if (!ray.valid()) return {};
    HitCollector hits(ray, phi, sMin, sMax, HitCollector::Mode::All);
    for (unsigned i = 0; i < groupCount(); ++i)
        search(i, hits);
    std::vector<ProfileHit> all = std::move(hits.all());
    std::sort(all.begin(), all.end(), [](const ProfileHit& a, const ProfileHit& b) { return a.s < b.s; });
    return all;
}

std::size_t RootFinder::memoryBytes() const {
    std::size_t bytes = sizeof(*this) + nodes_.size() * sizeof(Node) + groups_.size() * sizeof(unsigned);
    for (const PartSolver& part : parts_)
        bytes += part.memoryBytes();
    return bytes;
}

} // namespace vitrine
