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

ProfilePoints randomProfile(RandomStream& random, int degree) {
    const int segments = 1 + int(3 * random.uniformDouble());
    const double lowest = random.uniformDouble() < 0.3 ? -0.5 : 0;
    const bool climbs = random.uniformDouble() < 0.6;
    const auto point = [&](double along) {
        return V2d(random.uniform(lowest, 1), climbs ? along + random.uniform(-0.15, 0.15) : random.uniform(0, 1));
    };
    ProfilePoints result;
    V2d start(random.uniformDouble() < 0.3 ? 0 : random.uniform(0.05, 1), random.uniform(0, 1));
    for (int i = 0; i < segments; ++i) {
        std::vector<V2d> c{start};
        for (int k = 1; k <= degree; ++k)
            c.push_back(point((i + double(k) / degree) / segments));
        c.back().x = random.uniformDouble() < 0.15 ? 0 : std::abs(c.back().x);
        if (degree == 1 && start.x == 0 && c.back().x == 0) c.back().x = 0.3; // a line along the axis has no area
        const double shape = random.uniformDouble();
        for (V2d& p : c) {
            if (shape < 0.08) p.y = start.y;               // a flat rim
            if (shape > 0.92) p.x = std::max(start.x, .1); // a wall; the joint stays shared below
        }
        c.front() = start;
        if (shape > 0.5 && shape < 0.55 && degree > 2) c[1] = c[0];
        // Raise the inner control points until the radius is nowhere negative.
        for (int tries = 0; isRadiusNegative(c); ++tries)
            for (std::size_t k = 1; k + 1 < c.size(); ++k)
                c[k].x = tries < 20 ? lerp(0.9, c[k].x, std::abs(c[k].x) + 0.05) : std::abs(c[k].x);
        start = c.back();
        result.push_back(std::move(c));
    }
    return result;
}

const char* toString(RayKind kind) {
    constexpr const char* names[rayKinds] = {"generic",        "horizontal",       "nearly horizontal",
                                             "axial",          "nearly axial",     "joint",
                                             "nearly tangent", "through the axis", "from the surface"};
    return names[int(kind)];
}

Ray randomRay(RandomStream& random, RayKind kind, const ProfilePoints& profile) {
    const std::vector<V2d>& segment = profile[std::size_t(random.uniformDouble() * double(profile.size()))];
    const double t = random.uniformDouble(), phi = random.uniform(0, 2 * piD);
    const CurveSample c = sampleCurve(segment, t);
    const V3d onSurface = turned(c.p, phi), direction = unitVector(random);
    const V3d inside(random.uniform(-0.7, 0.7), random.uniform(-0.2, 1.2), random.uniform(-0.7, 0.7));
    const double distance = logUniform(random, 0, 1.5);
    Ray ray;
    const auto through = [&](const V3d& p, const V3d& d) { ray = Ray{p - d * distance, d}; };
    const V3d level = V3d(direction.x, 0, direction.z).normalized(), up(0, randomSign(random), 0);
    switch (kind) {
    case RayKind::Generic:
        through(inside, direction * logUniform(random, -2, 2));
        break;
    case RayKind::Horizontal:
        through(V3d(inside.x, c.p.y, inside.z), level);
        break;
    case RayKind::NearlyHorizontal:
        through(V3d(inside.x, c.p.y, inside.z), level + up * logUniform(random, -14, -1));
        break;
    case RayKind::Axial:
        through(V3d(c.p.x, 0, 0) * random.uniform(0, 1.5), up);
        break;
    case RayKind::NearlyAxial:
        through(V3d(c.p.x * random.uniformDouble(), c.p.y, 0), up + level * logUniform(random, -14, -1));
        break;
    case RayKind::Joint: {
        // Exactly through the joint, or a little beside it; never exactly through a free end.
        V2d target = segment.back();
        if (&segment == &profile.back() || random.uniformDouble() < 0.7)
            target += V2d(randomSign(random), randomSign(random)) * logUniform(random, -8, -3);
        through(turned(target, phi), direction);
        break;
    }
    case RayKind::NearlyTangent: {
        const V3d along = turned(c.d, phi), around(-std::sin(phi), 0, std::cos(phi));
        V3d normal = along.cross(around);
        if (normal.length2() == 0) normal = up;
        const double mix = random.uniform(0, 2 * piD), speed = along.length();
        const V3d tangent = (speed > 0 ? along * (std::cos(mix) / speed) : V3d(0, 0, 0)) + around * std::sin(mix);
        through(onSurface + normal.normalized() * (randomSign(random) * logUniform(random, -8.7, -1)), tangent);
        break;
    }
    case RayKind::ThroughAxis: {
        const V3d target = random.uniformDouble() < 0.5 ? V3d(0, c.p.y, 0) : V3d(0, segment.front().y, 0);
        ray = Ray{V3d(direction.x, 0, 0) * distance, V3d(0, 0, 0)};
        ray.o.y = random.uniform(-1, 2);
        ray.d = target - ray.o;
        break;
    }
    case RayKind::FromSurface:
        ray = Ray{onSurface, direction};
        break;
    }
    return ray;
}

} // namespace vitrine::test
