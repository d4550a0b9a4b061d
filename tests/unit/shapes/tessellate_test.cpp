// Meshes of turned profiles: closed, turned outwards, within their tolerance, with the exact shape's normals and uv.
#include "shapes/revolution/revolution.h"
#include "shapes/revolution/tessellate.h"
#include "support/revolution_cases.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <tuple>

namespace vitrine::test {
namespace {

Profile profileOf(const ProfilePoints& points) {
    std::vector<BezierCurve> segments(points.begin(), points.end());
    return Profile(std::move(segments));
}

/// Every place of a vertex, by its bits: 0 and -0 differ.
std::vector<std::uint32_t> weld(const MeshInput& mesh) {
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> places;
    std::vector<std::uint32_t> welded;
    for (const V3f& p : mesh.p) {
        std::array<std::uint32_t, 3> bits;
        std::memcpy(bits.data(), &p.x, sizeof bits);
        welded.push_back(places.try_emplace(bits, std::uint32_t(places.size())).first->second);
    }
    return welded;
}

/// How many directed edges, of the welded mesh, have no partner in the other direction, or more than one.
int unpairedEdges(const MeshInput& mesh) {
    const std::vector<std::uint32_t> welded = weld(mesh);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
        for (int k = 0; k < 3; ++k)
            ++edges[{welded[mesh.triangles[i + std::size_t(k)]], welded[mesh.triangles[i + std::size_t((k + 1) % 3)]]}];
    int unpaired = 0;
    for (const auto& [edge, count] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        if (count != 1 || edge.first == edge.second || back == edges.end() || back->second != 1) ++unpaired;
    }
    return unpaired;
}

struct Corner {
    V3d p[3], n[3];
    V2d uv[3];
    V3d faceNormal() const { return (p[1] - p[0]).cross(p[2] - p[0]); }
};

Corner corner(const MeshInput& mesh, std::size_t triangle) {
    Corner c;
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t i = mesh.triangles[3 * triangle + std::size_t(k)];
        c.p[k] = toDouble(mesh.p[i]);
        c.n[k] = toDouble(mesh.n[i]);
        c.uv[k] = V2d(mesh.uv[i]);
    }
    return c;
}

double volume(const MeshInput& mesh) {
    double six = 0;
    for (std::size_t i = 0; 3 * i < mesh.triangles.size(); ++i) {
        const Corner c = corner(mesh, i);
        six += c.p[0].dot(c.p[1].cross(c.p[2]));
    }
    return six / 6;
}

/// pi times the integral of x^2 dy, which for a closed profile is the volume up to its sign.
double exactVolume(const Profile& profile) {
    double sum = 0;
    constexpr int steps = 20000; // Simpson, far finer than any tolerance here
    for (const BezierCurve& segment : profile.segments())
        for (int i = 0; i <= 2 * steps; ++i) {
            const CurvePoint c = segment.evaluate(i / (2. * steps));
            sum += sqr(c.p.x) * c.d1.y * (i == 0 || i == 2 * steps ? 1 : i % 2 ? 4 : 2) / (6. * steps);
        }
    return std::abs(piD * sum);
}

/// Distance from a place in the half-plane to the profile, over a dense polyline.
class ProfileDistance {
  public:
    explicit ProfileDistance(const Profile& profile) {
        constexpr int steps = 4000;
        for (const BezierCurve& segment : profile.segments())
            for (int i = 0; i <= steps; ++i)
                points_.push_back(segment.point(double(i) / steps));
    }
    double operator()(const V2d& p) const {
        double least = infinityD;
        for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
            const V2d d = points_[i + 1] - points_[i], to = p - points_[i];
            const double along = d.length2() > 0 ? std::clamp(to.dot(d) / d.length2(), 0., 1.) : 0;
            least = std::min(least, (to - d * along).length2());
        }
        return std::sqrt(least);
    }

  private:
    std::vector<V2d> points_;
};

/// The farthest of so many random points of the mesh.
double farthest(const MeshInput& mesh, const Profile& profile, RandomStream& random, int points) {
    const ProfileDistance distance(profile);
    double most = 0;
    for (int i = 0; i < points; ++i) {
        const Corner c = corner(mesh, std::size_t(random.uniformDouble() * double(mesh.triangles.size() / 3)));
        double a = random.uniformDouble(), b = random.uniformDouble();
        if (a + b > 1) a = 1 - a, b = 1 - b;
        const V3d p = c.p[0] * (1 - a - b) + c.p[1] * a + c.p[2] * b;
        most = std::max(most, distance(V2d(std::hypot(p.x, p.z), p.y)));
    }
    return most;
}

TEST(Tessellation, GobletIsClosedOutwardAndAsLarge) {
    const Profile profile = profileOf(gobletProfile());
    for (const double tolerance : {3e-3, 3e-4, 3e-5}) {
        const MeshInput mesh = tessellate(profile, 360, tolerance);
        EXPECT_EQ(unpairedEdges(mesh), 0) << tolerance;
        // The volume differs by no more than the area times the tolerance.
        const double area = Revolution(Transform(), false, profile).area();
        EXPECT_NEAR(volume(mesh), exactVolume(profile), area * tolerance);
        EXPECT_GT(volume(mesh), 0);
    }
}

TEST(Tessellation, MirroredDrawingIsTurnedOutwardToo) {
    ProfilePoints reversed = gobletProfile();
    std::reverse(reversed.begin(), reversed.end());
    for (auto& segment : reversed)
        std::reverse(segment.begin(), segment.end());
    const MeshInput mesh = tessellate(profileOf(reversed), 360, 1e-3);
    EXPECT_EQ(unpairedEdges(mesh), 0);
    EXPECT_GT(volume(mesh), 0);
    for (std::size_t i = 0; 3 * i < mesh.triangles.size(); ++i) {
        const Corner c = corner(mesh, i);
        EXPECT_GT(c.faceNormal().dot(c.n[0] + c.n[1] + c.n[2]), 0);
    }
}

TEST(Tessellation, StaysWithinItsTolerance) {
    RandomStream random(streamKey(11, 0));
    const Profile goblet = profileOf(gobletProfile()), vase = profileOf(vaseProfile());
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        EXPECT_LE(farthest(tessellate(goblet, 360, tolerance), goblet, random, 1500), tolerance);
        EXPECT_LE(farthest(tessellate(vase, 250, tolerance), vase, random, 1500), tolerance);
    }
}

/// Within the tolerance, and not with many times the triangles that it needs: half of it is reached somewhere.
TEST(Tessellation, DoesNotWasteTriangles) {
    RandomStream random(streamKey(12, 0));
    const Profile vase = profileOf(vaseProfile());
    EXPECT_GE(farthest(tessellate(vase, 360, 1e-3), vase, random, 1500), 0.5e-3);
}

TEST(Tessellation, RandomProfilesStayWithinTheirToleranceAndClose) {
    RandomStream random(streamKey(13, 0));
    int closed = 0;
    for (int i = 0; i < 60; ++i) {
        const ProfilePoints points = randomProfile(random, 1 + i % 12);
        const Profile profile = profileOf(points);
        const double tolerance = 2e-3 * turnedSize(profile);
        const MeshInput mesh = tessellate(profile, 360, tolerance);
        EXPECT_LE(farthest(mesh, profile, random, 150), tolerance) << "profile " << i;
        // A sheet that is drawn to and fro on one line bounds nothing: its edges have four faces.
        if (!profile.isClosed() || exactVolume(profile) < 1e-6 * std::pow(turnedSize(profile), 3)) continue;
        ++closed;
        EXPECT_EQ(unpairedEdges(mesh), 0) << "profile " << i;
    }
    EXPECT_GT(closed, 3);
}

/// Interpolated normals deviate from the exact ones at the same (u, v) by less than half of what the surface turns by
/// between vertices, which is the square root of 8 tolerance / radius of curvature, at most 22.5 degrees.
TEST(Tessellation, NormalsAndUvAreTheExactShapes) {
    const Profile profile = profileOf(gobletProfile());
    const Revolution exact(Transform(), false, profile);
    const MeshInput mesh = tessellate(profile, 360, 1e-4);
    RandomStream random(streamKey(14, 0));
    double widest = 0, widestFace = 0;
    for (int i = 0; i < 20000; ++i) {
        const Corner c = corner(mesh, std::size_t(random.uniformDouble() * double(mesh.triangles.size() / 3)));
        double a = random.uniformDouble(), b = random.uniformDouble();
        if (a + b > 1) a = 1 - a, b = 1 - b;
        const V2d uv = c.uv[0] * (1 - a - b) + c.uv[1] * a + c.uv[2] * b;
        const V3d n = (c.n[0] * (1 - a - b) + c.n[1] * a + c.n[2] * b).normalized();
        const V3d p = c.p[0] * (1 - a - b) + c.p[1] * a + c.p[2] * b;
        const CurvePoint curve = profile.evaluate(uv.y);
        const double phi = uv.x * 2 * piD;
        const V2d t = curve.d1.normalized();
        const V3d normal(t.y * std::cos(phi), -t.x, t.y * std::sin(phi));
        widest = std::max(widest, std::acos(std::min(1., n.dot(normal))));
        widestFace = std::max(widestFace, std::acos(std::min(1., c.faceNormal().normalized().dot(normal))));
        // (u, v) belongs to the place, up to what a chord's length differs along its parameter.
        EXPECT_NEAR(p.y, curve.p.y, 0.02);
        EXPECT_NEAR(std::hypot(p.x, p.z), curve.p.x, 0.02);
        EXPECT_GE(p.x * std::cos(phi) + p.z * std::sin(phi), 0.99 * std::hypot(p.x, p.z));
    }
    EXPECT_LT(degrees(widest), 8);
    EXPECT_LT(degrees(widestFace), 22.5);
    EXPECT_GT(degrees(widestFace), 0.1);
}

TEST(Tessellation, VerticesAreExact) {
    const Profile profile = profileOf(vaseProfile());
    const MeshInput mesh = tessellate(profile, 90, 1e-3);
    ASSERT_EQ(mesh.p.size(), mesh.uv.size());
    for (std::size_t i = 0; i < mesh.p.size(); ++i) {
        const CurvePoint c = profile.evaluate(double(mesh.uv[i].y));
        const double phi = double(mesh.uv[i].x) * piD / 2;
        EXPECT_NEAR(mesh.p[i].x, c.p.x * std::cos(phi), 1e-6);
        EXPECT_NEAR(mesh.p[i].y, c.p.y, 1e-6);
        EXPECT_NEAR(mesh.p[i].z, c.p.x * std::sin(phi), 1e-6);
        const V2d t = c.d1.normalized();
        EXPECT_NEAR(mesh.n[i].dot(V3f(float(t.y * std::cos(phi)), float(-t.x), float(t.y * std::sin(phi)))), 1, 1e-6);
    }
}

/// A cylinder with a hole in it: a closed loop of four straight segments with four sharp edges.
TEST(Tessellation, LoopsWithSharpEdgesCloseByPlace) {
    const std::vector<V2d> square = {{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0}};
    const Profile profile(square, 1);
    ASSERT_TRUE(profile.isClosed());
    const RevolutionTessellation plan(profile, 360, 1e-3);
    const MeshInput mesh = plan.mesh();
    EXPECT_EQ(mesh.triangles.size(), 3 * plan.triangleCount());
    EXPECT_EQ(mesh.p.size(), plan.vertexCount());
    EXPECT_EQ(unpairedEdges(mesh), 0);
    EXPECT_NEAR(volume(mesh), 3 * piD, 0.02);
    // Each face has its own normal: no vertex is shaded between two.
    for (const V3f& n : mesh.n)
        EXPECT_TRUE(std::abs(n.y) < 1e-6f || std::abs(n.y) > 1 - 1e-6f);
    // Without bends, no rings but the four edges.
    for (const V3f& p : mesh.p)
        EXPECT_TRUE(p.y == 0 || p.y == 1);
}

TEST(Tessellation, ConesHaveTheirOwnNormalsAtTheTip) {
    const std::vector<V2d> cone = {{0, 1}, {1, 0}, {0, 0}};
    const MeshInput mesh = tessellate(Profile(cone, 1), 360, 1e-3);
    EXPECT_EQ(unpairedEdges(mesh), 0);
    for (std::size_t i = 0; i < mesh.p.size(); ++i)
        if (mesh.p[i].y == 1) {
            EXPECT_NEAR(mesh.n[i].y, std::sqrt(0.5f), 1e-6f);
        }
}

TEST(Tessellation, SmoothSpheresHaveNoCreases) {
    const double k = 4. / 3 * (std::sqrt(2.) - 1);
    const Profile ball(std::vector<V2d>{{0, -1}, {k, -1}, {1, -k}, {1, 0}, {1, k}, {k, 1}, {0, 1}}, 3);
    const MeshInput mesh = tessellate(ball, 360, 1e-3);
    EXPECT_EQ(unpairedEdges(mesh), 0);
    for (std::size_t i = 0; i < mesh.p.size(); ++i) // the cubics stray from the circle by 2.7e-4
        EXPECT_GT(mesh.n[i].dot(mesh.p[i].normalized()), 1 - 1e-5f);
    for (const ProfileStation& s : placeStations(ball, 1e-3, 0.4, 1000))
        EXPECT_FALSE(s.isCrease());
}

/// Where the profile touches the axis on its way, and runs along it.
TEST(Tessellation, TouchesOfTheAxisClose) {
    const std::vector<V2d> hourglass = {{0, -2}, {1, -1}, {0, 0}, {0, 1}, {1, 2}, {0, 3}};
    const MeshInput mesh = tessellate(Profile(hourglass, 1), 360, 1e-3);
    EXPECT_EQ(unpairedEdges(mesh), 0);
    EXPECT_NEAR(volume(mesh), 4 * piD / 3, 0.02);
}

TEST(Tessellation, AGivenNumberOfTriangles) {
    const Profile goblet = profileOf(gobletProfile());
    for (const std::uint64_t n : {2000u, 100000u, 4000000u}) {
        const double tolerance = toleranceForTriangles(goblet, 360, n);
        const std::uint64_t count = RevolutionTessellation(goblet, 360, tolerance).triangleCount();
        EXPECT_LE(count, n);
        EXPECT_GE(count, n * 6 / 10);
    }
    EXPECT_THROW(toleranceForTriangles(goblet, 360, 10), std::invalid_argument);
}

std::string refusal(const Profile& profile, double tolerance) {
    try {
        RevolutionTessellation(profile, 360, tolerance);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}

TEST(Tessellation, RefusesTolerancesThatCannotBeKept) {
    const Profile goblet = profileOf(gobletProfile());
    EXPECT_EQ(refusal(goblet, 0), "the tolerance must be positive and finite, not 0");
    EXPECT_EQ(refusal(goblet, -1), "the tolerance must be positive and finite, not -1");
    EXPECT_NE(refusal(goblet, std::nan("")), "");
    for (const double tolerance : {1e-7, 1e-12, 1e-300})
        EXPECT_NE(refusal(goblet, tolerance).find("single precision"), std::string::npos);
    const auto sheet = [](double size) { return Profile(std::vector<V2d>{{0, 0}, {size, 0}, {size, size}}, 1); };
    for (const double size : {1e-50, 1e-44, 1e39, 1e300})
        EXPECT_NE(refusal(sheet(size), 1e-4 * size).find("single precision"), std::string::npos) << size;
    for (const double size : {1e-30, 1e30})
        EXPECT_EQ(refusal(sheet(size), 1e-4 * size), "");
    std::vector<V2d> wavy;
    for (int i = 0; i <= 3000; ++i)
        wavy.emplace_back(i % 2 ? 0.99 : 0.9, i / 3000.);
    EXPECT_NE(refusal(Profile(wavy, 2), 3e-7).find("more than 2^31 triangles"), std::string::npos);
}

} // namespace
} // namespace vitrine::test
