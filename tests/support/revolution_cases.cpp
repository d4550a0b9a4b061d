#include "support/revolution_cases.h"

#include <algorithm>

namespace vitrine::test {

namespace {

ProfilePoints cut(const std::vector<V2d>& points, std::size_t degree) {
    ProfilePoints result;
    for (std::size_t i = 0; i + 1 < points.size(); i += degree)
        result.emplace_back(points.begin() + long(i), points.begin() + long(i + degree + 1));
    return result;
}

struct CurveSample {
    V2d p, d;
};

CurveSample sampleCurve(std::vector<V2d> c, double t) {
    V2d d(0, 0);
    while (c.size() > 1) {
        if (c.size() == 2) d = c[1] - c[0];
        for (std::size_t i = 0; i + 1 < c.size(); ++i)
            c[i] = c[i] * (1 - t) + c[i + 1] * t;
        c.pop_back();
    }
    return {c[0], d};
}

bool isRadiusNegative(const std::vector<V2d>& points) {
    const std::size_t n = points.size() - 1;
    if ((points[0].x == 0 && points[1].x < 0) || (points[n].x == 0 && points[n - 1].x < 0)) return true;
    for (int i = 0; i <= 400; ++i) // densest at the ends
        if (sampleCurve(points, (1 - std::cos(piD * i / 400)) / 2).p.x < 0) return true;
    return false;
}

double logUniform(RandomStream& random, double lowExponent, double highExponent) {
    return std::pow(10., random.uniform(lowExponent, highExponent));
}

double randomSign(RandomStream& random) {
    return random.uniformDouble() < 0.5 ? -1 : 1;
}

V3d unitVector(RandomStream& random) {
    while (true) {
        const V3d d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        if (d.length2() < 1 && d.length2() > 1e-4) return d.normalized();
    }
}

V3d turned(const V2d& p, double phi) {
    return V3d(p.x * std::cos(phi), p.y, p.x * std::sin(phi));
}

} // namespace

std::vector<V2d> joined(const ProfilePoints& profile) {
    std::vector<V2d> result = profile[0];
    for (std::size_t i = 1; i < profile.size(); ++i)
        result.insert(result.end(), profile[i].begin() + 1, profile[i].end());
    return result;
}

ProfilePoints gobletProfile() {
    return cut({{0, 0},       {0.2, 0},      {0.38, 0},     {0.4, 0.02},  {0.42, 0.05}, {0.06, 0.05}, {0.05, 0.15},
                {0.045, 0.3}, {0.045, 0.42}, {0.06, 0.5},   {0.1, 0.58},  {0.42, 0.62}, {0.42, 0.95}, {0.42, 1.1},
                {0.39, 1.2},  {0.37, 1.3},   {0.365, 1.32}, {0.35, 1.32}, {0.345, 1.3}, {0.36, 1.2},  {0.38, 1.1},
                {0.38, 0.95}, {0.38, 0.7},   {0.15, 0.6},   {0, 0.6}},
               3);
}

ProfilePoints vaseProfile() {
    return {{{0.166666667, 0},
             {0.225, 0},
             {0.25, 0.1},
             {0.25, 0.2},
             {0.25, 0.3},
             {0.208333333, 0.4},
             {0.166666667, 0.6},
             {0.125, 0.7},
             {0.25, 0.8}}};
}

namespace {

/// A curve through `start` that has a cusp in its middle: both derivatives hold the factor t - t0.
std::vector<V2d> cuspedCurve(RandomStream& random, const V2d& start, int degree) {
    const double t0 = random.uniform(0.2, 0.8);
    std::vector<V2d> factor;
    for (int k = 0; k <= degree - 2; ++k)
        factor.push_back({random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)});
    const int m = degree - 1; // of the derivative
    std::vector<V2d> points{start};
    for (int k = 0; k <= m; ++k) {
        V2d d(0, 0);
        if (k < m) d -= factor[std::size_t(k)] * (t0 * (m - k) / m);
        if (k > 0) d += factor[std::size_t(k - 1)] * ((1 - t0) * k / m);
        points.push_back(points.back() + d / degree);
    }
    double least = 0;
    for (const V2d& p : points)
        least = std::min(least, p.x);
    for (V2d& p : points)
        p.x -= least;
    return points;
}

void raise(std::vector<V2d>& c) {
    for (int tries = 0; isRadiusNegative(c); ++tries)
        for (std::size_t k = 1; k + 1 < c.size(); ++k)
            c[k].x = tries < 20 ? lerp(0.9, c[k].x, std::abs(c[k].x) + 0.05) : std::abs(c[k].x);
}

} // namespace

ProfilePoints randomProfile(RandomStream& random, int degree) {
    const double closing = random.uniformDouble();
    const bool isLoop = closing<0.15, hasPoles = closing> 0.85;
    const int segments = (isLoop ? 2 : 1) + int(3 * random.uniformDouble());
    const double lowest = random.uniformDouble() < 0.3 ? -0.5 : 0;
    const bool climbs = random.uniformDouble() < 0.6;
    const auto point = [&](double along) {
        return V2d(random.uniform(lowest, 1), climbs ? along + random.uniform(-0.15, 0.15) : random.uniform(0, 1));
    };
    ProfilePoints result;
    V2d start(hasPoles || random.uniformDouble() < 0.3 ? 0 : random.uniform(0.05, 1), random.uniform(0, 1));
    for (int i = 0; i < segments; ++i) {
        const bool isLast = i == segments - 1;
        std::vector<V2d> c{start};
        for (int k = 1; k <= degree; ++k)
            c.push_back(point((i + double(k) / degree) / segments));
        c.back().x = random.uniformDouble() < 0.15 || (hasPoles && isLast) ? 0 : std::abs(c.back().x);
        const double shape = random.uniformDouble();
        if (shape > 0.55 && shape < 0.65 && degree > 2 && i == 0 && !hasPoles) {
            c = cuspedCurve(random, start, degree);
            start = c.front();
        }
        for (V2d& p : c) {
            if (shape < 0.08) p.y = start.y;               // a flat rim
            if (shape > 0.92) p.x = std::max(start.x, .1); // a wall; the joint stays shared below
        }
        if (isLoop && isLast) c.back() = result.front().front();
        if (hasPoles && isLast) c.back().x = 0;
        if (degree == 1 && start.x == 0 && c.back().x == 0) c.back().x = 0.3; // a line along the axis has no area
        c.front() = start;
        if (shape > 0.5 && shape < 0.55 && degree > 2) c[1] = c[0];
        raise(c);
        start = c.back();
        result.push_back(std::move(c));
    }
    return result;
}

int drawDegree(RandomStream& random) {
    double total = 0;
    for (int n = 1; n <= 20; ++n)
        total += 1. / n;
    double u = random.uniformDouble() * total;
    int n = 1;
    while (n < 20 && (u -= 1. / n) > 0)
        ++n;
    return n;
}

double drawPhiMax(RandomStream& random) {
    return random.uniformDouble() < 0.85 ? 360 : random.uniform(5, 355);
}

RayKind drawKind(RandomStream& random) {
    const double u = random.uniformDouble();
    return u < genericShare ? RayKind::Generic
                            : RayKind(1 + int((u - genericShare) / (1 - genericShare) * (rayKinds - 1)));
}

const char* toString(RayKind kind) {
    constexpr const char* names[rayKinds] = {"generic",          "horizontal",     "nearly horizontal", "parallel",
                                             "nearly parallel",  "on the axis",    "through the axis",  "joint",
                                             "end ring",         "nearly tangent", "tangent",           "double root",
                                             "from the surface", "at the tip"};
    return names[int(kind)];
}

namespace {

/// The ray that touches the turned curve at c, moved off it by `offset` along the normal.
Ray touchingRay(RandomStream& random, const CurveSample& c, double phi, double distance, double offset) {
    const V3d along = turned(c.d, phi), around(-std::sin(phi), 0, std::cos(phi));
    V3d normal = along.cross(around);
    if (normal.length2() == 0) normal = V3d(0, 1, 0);
    const double mix = random.uniform(0, 2 * piD), speed = along.length();
    const V3d tangent = (speed > 0 ? along * (std::cos(mix) / speed) : V3d(0, 0, 0)) + around * std::sin(mix);
    return {turned(c.p, phi) + normal.normalized() * offset - tangent * distance, tangent};
}

/// Exactly in double: along the wall, or in the plane of the rim and touching its ring, where a segment ends.
Ray doubleRootRay(RandomStream& random, const V2d& end, double distance) {
    if (random.uniformDouble() < 0.5) return {V3d(end.x, -distance, 0), V3d(0, randomSign(random), 0)};
    const double reach = random.uniformDouble() < 0.5 ? end.x : random.uniform(0, 1);
    return {V3d(reach, end.y, -distance), V3d(0, 0, 1)};
}

} // namespace

Ray randomRay(RandomStream& random, RayKind kind, const ProfilePoints& profile) {
    const std::vector<V2d>& segment = profile[std::size_t(random.uniformDouble() * double(profile.size()))];
    const double t = random.uniformDouble(), phi = random.uniform(0, 2 * piD);
    const CurveSample c = sampleCurve(segment, t);
    const V3d onSurface = turned(c.p, phi), direction = unitVector(random);
    const V3d inside(random.uniform(-0.7, 0.7), random.uniform(-0.2, 1.2), random.uniform(-0.7, 0.7));
    const double distance = logUniform(random, 0, 1.5);
    const auto through = [&](const V3d& p, const V3d& d) { return Ray{p - d * distance, d}; };
    const V3d level = V3d(direction.x, 0, direction.z).normalized(), up(0, randomSign(random), 0);
    const auto beside = [&](V2d target, double exactly) {
        if (random.uniformDouble() >= exactly)
            target += V2d(randomSign(random), randomSign(random)) * logUniform(random, -14, -1);
        return through(turned(target, phi), direction);
    };
    switch (kind) {
    case RayKind::Generic:
        // Half of them aimed at the surface.
        return through(random.uniformDouble() < 0.5 ? onSurface : inside, direction * logUniform(random, -2, 2));
    case RayKind::Horizontal:
        return through(V3d(inside.x * c.p.x, c.p.y, inside.z * c.p.x), level);
    case RayKind::NearlyHorizontal:
        return through(V3d(inside.x * c.p.x, c.p.y, inside.z * c.p.x), level + up * logUniform(random, -16, -1));
    case RayKind::Parallel:
        return through(turned(V2d(c.p.x * random.uniform(0, 1.1), c.p.y), phi), up);
    case RayKind::NearlyParallel:
        return through(turned(V2d(c.p.x * random.uniformDouble(), c.p.y), phi),
                       up + level * logUniform(random, -16, -1));
    case RayKind::OnAxis:
        return {V3d(0, -distance * up.y, 0), up};
    case RayKind::ThroughAxis: {
        const V3d target(0, random.uniformDouble() < 0.5 ? c.p.y : segment.front().y, 0);
        Ray ray{V3d(direction.x, 0, 0) * distance, V3d(0, 0, 0)};
        ray.o.y = random.uniform(-1, 2);
        ray.d = target - ray.o;
        return ray;
    }
    case RayKind::Joint:
        return beside(segment.back(), 0.3);
    case RayKind::EndRing:
        return beside(random.uniformDouble() < 0.5 ? profile.front().front() : profile.back().back(), 0.2);
    case RayKind::NearlyTangent:
        return touchingRay(random, c, phi, distance,
                           randomSign(random) * std::pow(10., -std::floor(random.uniform(1, 15))));
    case RayKind::Tangent:
        return touchingRay(random, c, phi, distance, 0);
    case RayKind::DoubleRoot:
        return doubleRootRay(random, random.uniformDouble() < 0.5 ? segment.front() : segment.back(), distance);
    case RayKind::AtTheTip: {
        const double off = random.uniformDouble() < 0.5 ? 0 : randomSign(random) * logUniform(random, -16, -6);
        const V3d around(-std::sin(phi), up.y * logUniform(random, -9, -2), std::cos(phi));
        return through(turned(c.p + V2d(off, 0), phi), around.normalized());
    }
    case RayKind::FromSurface:
        break;
    }
    return {onSurface, direction};
}

} // namespace vitrine::test
