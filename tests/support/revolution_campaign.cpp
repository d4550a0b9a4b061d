#include "support/revolution_campaign.h"

#include "shapes/revolution/revolution.h"
#include "support/revolution_band.h"
#include "support/revolution_exact.h"
#include "support/revolution_slow.h"

#include <optional>
#include <sstream>

namespace vitrine::test {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <class Array>
void addEach(Array& to, const Array& from) {
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] += from[i];
}

std::vector<OracleHit> allHits(const Revolution& shape, const Ray& ray, double count) {
    const HalfPlaneRay half(ray);
    std::vector<OracleHit> result;
    for (const PrimitiveHit& hit : shape.allHits(ray, -infinityD, infinityD)) {
        const double position = hit.v * count;
        const int segment = std::min(int(position), int(count) - 1);
        result.push_back({hit.s, segment, position - segment, half.q + half.h * half.length * hit.s >= 0});
    }
    return result;
}

/// One to one at all but the same places, whatever the order among equals: no need to look closer.
bool alike(const std::vector<OracleHit>& a, const std::vector<OracleHit>& b, double length, double size) {
    if (a.size() != b.size()) return false;
    std::vector<bool> taken(b.size(), false);
    for (const OracleHit& hit : a) {
        std::size_t k = 0;
        while (k < b.size() && (taken[k] || !(std::abs(hit.s - b[k].s) * length <= 1e-6 * size) ||
                                std::abs(hit.segment + hit.t - b[k].segment - b[k].t) > 1e-3))
            ++k;
        if (k == b.size()) return false;
        taken[k] = true;
    }
    return true;
}

std::vector<OracleHit> surelyInSector(const std::vector<OracleHit>& all, const Ray& ray, double phiMax, double band) {
    std::vector<OracleHit> result;
    for (const OracleHit& hit : all)
        if (inSector(ray, hit.s, phiMax, band) > 0) result.push_back(hit);
    return result;
}

long double distanceFromProfile(const std::vector<SlowCurve>& curves, const OracleHit& hit, long double r,
                                long double y) {
    return distanceFromCurve(curves[std::size_t(hit.segment)], hit.t, r, y);
}

} // namespace

void CampaignTally::add(const CampaignTally& other) {
    for (const auto member :
         {&CampaignTally::pairs, &CampaignTally::pairsWithHits, &CampaignTally::crossings, &CampaignTally::judged,
          &CampaignTally::excused, &CampaignTally::noisyTouches, &CampaignTally::overruled, &CampaignTally::missed,
          &CampaignTally::spurious, &CampaignTally::wrongPairs, &CampaignTally::offSurface, &CampaignTally::intervals,
          &CampaignTally::wrongInInterval, &CampaignTally::refused})
        this->*member += other.*member;
    mostAtATouch = std::max(mostAtATouch, other.mostAtATouch);
    worstPoint = std::max(worstPoint, other.worstPoint);
    worstOnRay = std::max(worstOnRay, other.worstOnRay);
    addEach(pairsByKind, other.pairsByKind);
    addEach(excusedByKind, other.excusedByKind);
    addEach(pairsByDegree, other.pairsByDegree);
    addEach(hitsByDegree, other.hitsByDegree);
}

std::string describe(const CampaignPair& pair, const std::vector<OracleHit>& exact,
                     const std::vector<OracleHit>& ours) {
    std::ostringstream text;
    text.precision(17);
    text << "ray " << pair.ray.o << " " << pair.ray.d << " (" << toString(pair.kind) << "), phimax " << pair.phiMax;
    for (const auto* list : {&exact, &ours}) {
        text << (list == &exact ? "\n  exact:" : "\n  ours: ");
        for (std::size_t i = 0; i < std::min(list->size(), std::size_t(100)); ++i) {
            const OracleHit& hit = (*list)[i];
            text << " " << hit.s << "@" << hit.segment + hit.t << (hit.forward ? "+" : "-");
        }
        if (list->size() > 100) text << " and " << list->size() - 100 << " more";
    }
    text << "\n  profile:";
    for (const std::vector<V2d>& segment : pair.profile) {
        for (const V2d& p : segment)
            text << " {" << p.x << "," << p.y << "},";
        text << " |";
    }
    return text.str();
}

CampaignTally Campaign::runBlock(std::uint64_t block) const {
    CampaignTally tally;
    RandomStream random(seed_, block, 4711);
    ProfilePoints points;
    std::optional<Revolution> shape;
    double phiMax = 360;
    while (!shape) {
        const int degree = drawDegree(random);
        points = randomProfile(random, degree);
        phiMax = drawPhiMax(random);
        try {
            shape.emplace(Transform(), false, Profile(joined(points), degree), phiMax);
        } catch (const std::invalid_argument&) {
            ++tally.refused;
        }
    }
    std::optional<ExactOracle> exact;
    std::optional<SlowSolver> slow;
    if (oracle_ == OracleKind::Exact)
        exact.emplace(points);
    else
        slow.emplace(points);
    const std::vector<SlowCurve> curves(points.begin(), points.end());
    for (int i = 0; i < raysEach_; ++i) {
        const RayKind kind = drawKind(random);
        const Ray ray = randomRay(random, kind, points);
        const CampaignPair pair{points, curves, phiMax, kind, ray};
        runPair(
            pair, *shape, [&] { return exact ? exact->hits(ray) : slow->hits(ray); }, tally);
        if (exact || i % 4 == 0)
            checkIntervals(pair, *shape, allHits(*shape, ray, double(points.size())), random, tally);
    }
    return tally;
}

void Campaign::runPair(const CampaignPair& pair, const Revolution& shape,
                       const std::function<std::vector<OracleHit>()>& oracle, CampaignTally& tally) const {
    const std::size_t degree = pair.profile[0].size() - 1, kind = std::size_t(pair.kind);
    const double size = shape.profile().size(), length = pair.ray.d.length(), band = tangencyBand * size;
    const std::vector<OracleHit> ours = allHits(shape, pair.ray, double(pair.profile.size()));
    std::vector<OracleHit> theirs = oracle();
    ++tally.pairs;
    ++tally.pairsByKind[kind];
    ++tally.pairsByDegree[degree];
    tally.pairsWithHits += !theirs.empty();
    tally.hitsByDegree[degree] += !theirs.empty();
    tally.crossings += long(theirs.size());

    for (const OracleHit& hit : ours) {
        const V3d p = shape.pointAt(pair.ray, {hit.s, 0, (hit.segment + hit.t) / double(pair.profile.size()), 0}).p;
        const long double onRay[3] = {pair.ray.o.x + (long double)(hit.s) * pair.ray.d.x,
                                      pair.ray.o.y + (long double)(hit.s) * pair.ray.d.y,
                                      pair.ray.o.z + (long double)(hit.s) * pair.ray.d.z};
        const long double unit = (long double)(degree)*eps, reach = std::max(size, pair.ray.o.length());
        const long double point =
            distanceFromProfile(pair.curves, hit, std::hypot((long double)(p.x), (long double)(p.z)), p.y);
        const long double ray = distanceFromProfile(pair.curves, hit, std::hypot(onRay[0], onRay[2]), onRay[1]);
        const double inPoint = double(point / (unit * size)), inRay = double(ray / (unit * reach));
        tally.worstPoint = std::max(tally.worstPoint, inPoint);
        tally.worstOnRay = std::max(tally.worstOnRay, inRay);
        if (!(inPoint <= maxBackwardError) || !(inRay <= maxBackwardError)) {
            if (++tally.offSurface <= 2)
                report_("off the surface at " + std::to_string(hit.s) + ": " + describe(pair, theirs, ours));
        }
    }

    if (alike(surelyInSector(theirs, pair.ray, pair.phiMax, band), ours, length, size)) return;
    ++tally.judged;
    if (oracle_ == OracleKind::Slow) {
        const std::vector<OracleHit> exact = ExactOracle(pair.profile).hits(pair.ray);
        if (!judge(pair.profile, 360, pair.ray, exact, theirs, band).isClean() && ++tally.overruled <= 1)
            report_("the slow solver errs: " + describe(pair, exact, theirs));
        theirs = exact;
    }
    // By Bezout no line meets more; a list of thousands would keep the judge for hours.
    const bool impossible = ours.size() > 2 * degree * pair.profile.size();
    const Judgement verdict = impossible ? Judgement{0, int(ours.size()), false, 0}
                                         : judge(pair.profile, pair.phiMax, pair.ray, theirs, ours, band);
    tally.excused += verdict.excused;
    tally.noisyTouches += verdict.tooManyAtATouch > 2;
    tally.mostAtATouch = std::max(tally.mostAtATouch, verdict.tooManyAtATouch);
    tally.excusedByKind[kind] += verdict.excused;
    tally.missed += verdict.missed;
    tally.spurious += verdict.spurious;
    if (!verdict.isClean() && ++tally.wrongPairs <= 2)
        report_(std::to_string(verdict.missed) + " missed, " + std::to_string(verdict.spurious) +
                " spurious: " + describe(pair, theirs, ours));
}

void Campaign::checkIntervals(const CampaignPair& pair, const Revolution& shape, const std::vector<OracleHit>& ours,
                              RandomStream& random, CampaignTally& tally) const {
    const double length = pair.ray.d.length();
    const auto near = [&] {
        const double s = ours.empty() ? 0 : ours[std::size_t(random.uniformDouble() * double(ours.size()))].s;
        return s + random.uniform(-1, 1) * shape.profile().size() / length;
    };
    double sMin = random.uniformDouble() < 0.5 ? 0 : near(), sMax = random.uniformDouble() < 0.5 ? infinityD : near();
    if (sMax < sMin) std::swap(sMin, sMax);
    const double doubt = 1e-9 * shape.profile().size() / length;
    double expected = infinityD;
    for (const OracleHit& hit : ours) {
        if (std::abs(hit.s - sMin) < doubt || std::abs(hit.s - sMax) < doubt) return;
        if (hit.s > sMin && hit.s < sMax) expected = std::min(expected, hit.s);
    }
    ++tally.intervals;
    PrimitiveHit best, hit;
    best.s = sMax;
    bool found = false, any = false;
    for (unsigned prim = 0; prim < shape.primitiveCount(); ++prim) {
        if (shape.intersect(prim, pair.ray, sMin, best.s, hit)) best = hit, found = true;
        any = any || shape.occludes(prim, pair.ray, sMin, sMax);
    }
    const bool expectFound = expected < infinityD;
    if (found == expectFound && any == expectFound && (!found || std::abs(best.s - expected) < doubt)) return;
    if (++tally.wrongInInterval <= 2)
        report_("first hit " + std::to_string(found ? best.s : infinityD) + ", any " + std::to_string(any) + " in (" +
                std::to_string(sMin) + ", " + std::to_string(sMax) + "): " + describe(pair, {}, ours));
}

void ParityTally::add(const ParityTally& other) {
    for (const auto member :
         {&ParityTally::rays, &ParityTally::raysWithHits, &ParityTally::crossings, &ParityTally::odd,
          &ParityTally::wrongWalk, &ParityTally::wrongNormal, &ParityTally::grazing, &ParityTally::rounded})
        this->*member += other.*member;
}

ParityTally runParityBlock(std::uint64_t seed, std::uint64_t block, int rays, const Campaign::Report& report) {
    static const ProfilePoints goblet = gobletProfile();
    static const Revolution shape(Transform(), false, Profile(joined(goblet), 3));
    RandomStream random(seed, block, 4712);
    ParityTally tally;
    for (int i = 0; i < rays; ++i) {
        const RayKind kind = drawKind(random);
        const Ray ray = randomRay(random, kind, goblet);
        const std::vector<PrimitiveHit> hits = shape.allHits(ray, -infinityD, infinityD);
        ++tally.rays;
        tally.raysWithHits += !hits.empty();
        tally.crossings += long(hits.size());
        const auto tell = [&](const char* what) {
            const CampaignPair pair{goblet, {}, 360, kind, ray};
            report(std::string(what) + ": " + describe(pair, {}, allHits(shape, ray, double(goblet.size()))));
        };
        if (hits.size() % 2 == 1 && ++tally.odd <= 2) tell("odd");

        // Crossings at the very same s are one step; of those that rounding alone parts, either may be overstepped.
        std::size_t steps = 0, places = 0;
        bool rounded = false;
        for (std::size_t k = 0; k < hits.size(); ++k) {
            const double way = k == 0 ? infinityD : hits[k].s - hits[k - 1].s;
            places += way > 0;
            rounded = rounded || (way > 0 && way < 16 * eps * std::abs(hits[k].s));
        }
        PrimitiveHit best, hit;
        for (double s = -infinityD; steps <= hits.size(); s = best.s, ++steps) {
            best = PrimitiveHit{};
            for (unsigned prim = 0; prim < shape.primitiveCount(); ++prim)
                if (shape.intersect(prim, ray, s, best.s, hit)) best = hit;
            if (best.s == infinityD) break;
        }
        tally.rounded += rounded;
        if (steps != places && !rounded && ++tally.wrongWalk <= 2) tell("walk");

        bool grazes = false, alternates = true;
        const double length = ray.d.length();
        for (std::size_t k = 0; k < hits.size(); ++k) {
            const double cosine = toDouble(shape.pointAt(ray, hits[k]).ng).dot(ray.d) / length;
            const bool together = k > 0 && (hits[k].s - hits[k - 1].s) * length < 1e-7;
            grazes = grazes || std::abs(cosine) < 1e-4 || together;
            alternates = alternates && (cosine > 0) == (k % 2 == 1);
        }
        tally.grazing += grazes;
        if (!grazes && !alternates && ++tally.wrongNormal <= 2) tell("normals");
    }
    return tally;
}

} // namespace vitrine::test
