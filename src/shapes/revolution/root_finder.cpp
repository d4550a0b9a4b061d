#include "shapes/revolution/root_finder.h"

namespace vitrine {

namespace {

/// Parts are monotone: their ends bound them, up to rounding.
Ring ringAbout(const BezierCurve& curve, double size) {
    const double slack = 1e-13 * size;
    const V2d &a = curve.first(), &b = curve.last();
    return {std::max(0., std::min(a.x, b.x) - slack), std::max(a.x, b.x) + slack, std::min(a.y, b.y) - slack,
            std::max(a.y, b.y) + slack};
}

std::vector<Ring> ringsAbout(const Profile& profile) {
    std::vector<Ring> rings;
    for (const ProfilePart& part : profile.parts())
        rings.push_back(ringAbout(part.curve, profile.size()));
    return rings;
}

} // namespace

RootFinder::RootFinder(const Profile& profile) : tree_(ringsAbout(profile)), size_(profile.size()) {
    for (const ProfilePart& part : profile.parts())
        parts_.emplace_back(part.curve, unsigned(parts_.size()));
}

void RootFinder::search(unsigned group, HitCollector& hits) const {
    tree_.search(group, hits, [&](unsigned part) {
        parts_[part].solve(hits);
        return hits.done();
    });
}

std::vector<ProfileHit> RootFinder::allHits(const AxialRay& ray, const PhiRange& phi, double sMin, double sMax) const {
    if (!ray.valid()) return {};
    HitCollector hits(ray, phi, size_, sMin, sMax, HitCollector::Mode::All);
    for (unsigned i = 0; i < groupCount(); ++i)
        search(i, hits);
    std::vector<ProfileHit> all = std::move(hits.all());
    std::sort(all.begin(), all.end(), [](const ProfileHit& a, const ProfileHit& b) { return a.s < b.s; });
    return all;
}

std::size_t RootFinder::memoryBytes() const {
    std::size_t bytes = sizeof(*this) + tree_.memoryBytes();
    for (const PartSolver& part : parts_)
        bytes += part.memoryBytes();
    return bytes;
}

} // namespace vitrine
