// A caster against the brute-force one, over rays of every kind.
#pragma once

#include "accel/caster.h"
#include "core/random.h"
#include "core/sampling.h"

#include <gtest/gtest.h>

namespace vitrine::test {

/// Scaled, then turned about an axis that is none of the coordinates', then moved.
inline Transform placed(const V3d& translation, const V3d& scale, double angle) {
    M44d m;
    m.setAxisAngle(V3d(1, 2, 3).normalized(), angle);
    M44d s;
    s.setScale(scale);
    M44d t;
    t.setTranslation(translation);
    return Transform(s * m * t);
}

/// A ray of one of many kinds about a box: from inside, outside, far away; along axes, along faces; with directions of
/// any length; segments; and, now and then, rays that must meet nothing because they are none.
/// \param inFace whether the ray runs in the plane of a face of the box, where all it meets is edges
inline Ray anyRay(RandomStream& random, const Box3d& box, bool& inFace) {
    const V3d size = box.size() + V3d(1e-3 * maxAbs(box.size()));
    const auto pointIn = [&](double grow) {
        V3d p;
        for (int k = 0; k < 3; ++k)
            p[k] = (box.min[k] + box.max[k]) / 2 + size[k] * grow * random.uniform(-0.5, 0.5);
        return p;
    };
    Ray ray;
    inFace = false;
    ray.o = pointIn(random.uniform() < 0.5f ? 1 : 3);
    ray.d = pointIn(1) - ray.o;
    const double kind = random.uniformDouble();
    if (kind < 0.1) { // along an axis
        const int axis = int(random.bits() % 3);
        const double length = random.uniform(-1, 1);
        ray.d = V3d(0, 0, 0);
        ray.d[axis] = length;
        ray.o[(axis + 1) % 3] = pointIn(1)[(axis + 1) % 3];
        ray.o[(axis + 2) % 3] = pointIn(1)[(axis + 2) % 3];
    } else if ((inFace = kind < 0.15)) { // in a plane of the box's faces or of its middle
        const int axis = int(random.bits() % 3);
        const double planes[3] = {box.min[axis], box.max[axis], (box.min[axis] + box.max[axis]) / 2};
        ray.o[axis] = planes[random.bits() % 3];
        ray.d[axis] = 0;
    } else if (kind < 0.2) { // from very far
        ray.o = ray.o - ray.d * std::exp(random.uniform(0, 12));
        ray.d = pointIn(1) - ray.o;
    }
    if (random.uniform() < 0.2f) ray.d *= std::exp(random.uniform(-69, 69));
    if (random.uniform() < 0.2f) ray.tMax = random.uniform(0, 2) * maxAbs(size) / maxAbs(ray.d);
    return ray;
}

/// Rays that are none: each must meet nothing.
inline std::vector<Ray> impossibleRays() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Ray> rays{Ray{V3d(0, 0, 0), V3d(0, 0, 0)}};
    for (const double bad : {nan, infinityD, -infinityD})
        for (int k = 0; k < 3; ++k) {
            Ray ray{V3d(0.1, 0.2, 0.3), V3d(0.3, 0.2, 0.1)};
            ray.d[k] = bad;
            rays.push_back(ray);
            ray = Ray{V3d(0.1, 0.2, 0.3), V3d(0.3, 0.2, 0.1)};
            ray.o[k] = bad;
            rays.push_back(ray);
        }
    Ray ray{V3d(0.1, 0.2, 0.3), V3d(0.3, 0.2, 0.1)};
    for (const double bad : {nan, 0., -1.}) {
        ray.tMax = bad;
        rays.push_back(ray);
    }
    return rays;
}

/// What an agreement test allows.
struct Allowance {
    /// How far the two hits may lie apart along the normal, for the size of the scene; 0 for scenes of analytic shapes
    /// only, where the very same solver answers. Quads may be bent by the rounding of their vertices, and a
    /// parallelogram's own plane is then not quite that of its two triangles.
    double distance = 2e-7;
    /// Share of rays (but those in a face's plane) that may differ because they pass an edge or a start by less than single-precision rounding.
    /// Each such ray must be explained: a ray moved by less than that gets the caster's answer from the oracle.
    double nearEdges = 1e-3;
};

inline bool sameHit(const Ray& ray, const Box3d& box, bool a, const CasterHit& hitA, bool b, const CasterHit& hitB,
                    double tolerance) {
    if (a != b) return false;
    if (!a) return true;
    const double apart = std::abs((hitA.s - hitB.s) * ray.d.dot(toDouble(hitB.point.ng)));
    return hitA.id == hitB.id && hitA.instance == hitB.instance && apart <= tolerance * maxAbs(box.size()) &&
           (tolerance > 0 || hitA.s == hitB.s);
}

/// Whether some ray that differs from `ray` by rounding gets `answer` from the oracle.
template <class Answers>
bool explainedByRounding(const Ray& ray, const Box3d& box, RandomStream& random, Answers&& answers) {
    const double reach = std::max({maxAbs(box.min), maxAbs(box.max), std::min(maxAbs(ray.o), 10 * maxAbs(box.size()))});
    const double step = 0x1p-19 * reach;
    for (int trial = 0; trial < 2000; ++trial) {
        Ray moved = ray;
        const double size = step * std::exp(random.uniform(-4, 0));
        const auto jump = [&] { return toDouble(sampleUniformSphere(V2f(random.uniform(), random.uniform()))) * size; };
        moved.o += jump();
        moved.d += jump() * (ray.d.length() / maxAbs(box.size()));
        if (std::isfinite(moved.tMax)) moved.tMax += random.uniform(-1, 1) * size / ray.d.length();
        if (answers(moved)) return true;
    }
    return false;
}

/// Whether the hit is a crossing, though perhaps not the first. Of rays in the plane of a box's face Embree's box test
/// drops half, so that edges which they run along may be passed by.
inline bool isTrueCrossing(const Caster& oracle, const Ray& ray, bool found, const CasterHit& hit) {
    CasterHit truth;
    const double before = hit.s * (1 - 1e-7);
    return found && oracle.intersect(Ray{ray.at(before), ray.d}, truth) && truth.id == hit.id &&
           std::abs(truth.s + before - hit.s) <= 1e-6 * hit.s;
}

inline void expectAgreement(const Caster& caster, const CasterInput& input, const Box3d& aim, std::uint64_t seed,
                            int rays, const Allowance& allowance) {
    const auto oracle = makeBruteForceCaster(input);
    RandomStream random(seed);
    int hits = 0, differing = 0, unexplained = 0;
    for (int i = 0; i < rays; ++i) {
        bool inFace;
        Ray ray = anyRay(random, aim, inFace);
        // For what moves. Not from the stream: what stands still is cast the same rays as ever.
        ray.time = unitDouble(streamKey(seed, i));
        CasterHit hit, truth;
        const bool found = caster.intersect(ray, hit), trueFound = oracle->intersect(ray, truth);
        hits += trueFound;
        bool differs = false, explained = true;
        if (!sameHit(ray, aim, found, hit, trueFound, truth, allowance.distance)) {
            differs = true;
            explained = allowance.distance > 0 && ((inFace && isTrueCrossing(*oracle, ray, found, hit)) ||
                                                   explainedByRounding(ray, aim, random, [&](const Ray& moved) {
                                                       CasterHit other;
                                                       const bool any = oracle->intersect(moved, other);
                                                       return sameHit(moved, aim, found, hit, any, other, 1e-4);
                                                   }));
        }
        const bool shadow = caster.occluded(ray);
        if (shadow != oracle->occluded(ray)) {
            differs = true;
            explained = explained && allowance.distance > 0 &&
                        explainedByRounding(ray, aim, random,
                                            [&](const Ray& moved) { return oracle->occluded(moved) == shadow; });
        }
        differing += differs && !inFace;
        unexplained += !explained;
        if (!explained && unexplained <= 3)
            ADD_FAILURE() << "ray " << i << " o " << ray.o << " d " << ray.d << " tMax " << ray.tMax << ": the caster "
                          << (found ? hit.s : -1) << " of " << hit.id << " shadow " << shadow << ", oracle "
                          << (trueFound ? truth.s : -1) << " of " << truth.id;
    }
    EXPECT_EQ(unexplained, 0);
    EXPECT_LE(differing, allowance.nearEdges * rays);
    EXPECT_GT(hits, rays / 20) << "the rays say little about the scene";
    for (const Ray& ray : impossibleRays()) {
        CasterHit hit;
        EXPECT_FALSE(caster.intersect(ray, hit));
        EXPECT_FALSE(oracle->intersect(ray, hit));
        EXPECT_FALSE(caster.occluded(ray));
        EXPECT_FALSE(oracle->occluded(ray));
    }
}

inline void expectCastersAgree(const CasterInput& input, const Box3d& aim, std::uint64_t seed, int rays,
                               const Allowance& allowance) {
    expectAgreement(*makeEmbreeCaster(input), input, aim, seed, rays, allowance);
}

} // namespace vitrine::test
