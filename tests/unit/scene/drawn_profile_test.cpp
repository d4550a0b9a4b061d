// Profiles out of drawings: where the axis lies, what is joined, trimmed and refused.
#include "scene/drawn_profile.h"
#include "shapes/revolution/revolution.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

Profile profileOf(const std::string& data, const ProfileFrame& frame = {}) {
    return profileOfDrawing(readSvgPath(data), frame, [](const SvgSegment&) { return Place(); });
}

/// Joints of the profile: "radius,height ...".
std::string joints(const Profile& profile) {
    std::string text;
    for (const BezierCurve& c : profile.segments())
        text += fmt::format("{:.7g},{:.7g} ", c.first().x + 0., c.first().y + 0.);
    const V2d last = profile.segments().back().last();
    return text + fmt::format("{:.7g},{:.7g}", last.x + 0., last.y + 0.);
}

std::string joints(const std::string& data, const ProfileFrame& frame = {}) {
    return joints(profileOf(data, frame));
}

std::string errorOf(const std::string& data, const ProfileFrame& frame = {}) {
    try {
        profileOf(data, frame);
        return "none";
    } catch (const SceneError& e) {
        return e.what();
    }
}

TEST(DrawnProfile, Frames) {
    const std::string line = "M7 1L9 4";
    EXPECT_EQ(joints(line), "7,1 9,4");
    EXPECT_EQ(joints(line, {.scenePerUnit = {2, 3}}), "14,3 18,12");
    EXPECT_EQ(joints(line, {.origin = {5, 10}}), "2,-9 4,-6");
    EXPECT_EQ(joints(line, {.origin = {5, 10}, .flipY = true}), "2,9 4,6");
    EXPECT_EQ(joints(line, {.origin = {11, 0}, .flipX = true}), "4,1 2,4");
    EXPECT_EQ(joints(line, {.origin = {3, 5}, .flipY = true, .lying = true}), "4,4 1,6") << "right is up the axis";
    EXPECT_EQ(joints(line, {.scenePerUnit = {2, 2}, .origin = {3, 0}, .lying = true}), "2,8 8,12");
}

TEST(DrawnProfile, SegmentsKeepTheirDegrees) {
    const Profile p = profileOf("M1 0L2 0Q3 0 3 1C3 2 2 2 2 3");
    ASSERT_EQ(p.segments().size(), 3u);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(p.segments()[std::size_t(i)].degree(), i + 1);
}

TEST(DrawnProfile, LinesAlongTheAxisAtTheEndsAreLeftOut) {
    EXPECT_EQ(joints("M0 0H1V1H0Z"), "0,0 1,0 1,1 0,1");
    EXPECT_EQ(joints("M0 .5V0H1V1H0Z"), "0,0 1,0 1,1 0,1") << "begun within the axis";
    EXPECT_EQ(joints("M1 1H0V0H1Z"), "0,0 1,0 1,1 0,1") << "begun off the axis";
    EXPECT_EQ(joints("M0 -3V0H1V1H0V9"), "0,0 1,0 1,1 0,1") << "open";
    EXPECT_EQ(joints("M0 0H1V1H0V2H1V3H0Z"), "0,2 1,2 1,3 0,3 0,0 1,0 1,1 0,1")
        << "two beads on a string: the first line along the axis goes";
    EXPECT_TRUE(profileOf("M0 0H1V1H0Z").isClosed());
    EXPECT_TRUE(profileOf("M1 0H2V1H1Z").isClosed());
    EXPECT_FALSE(profileOf("M1 0H2V1H1").isClosed());
}

TEST(DrawnProfile, ALineAlongTheAxisBetweenTwoSolidsIsNoSurface) {
    const Revolution beads(Transform(), false, profileOf("M0 0H1V1H0V2H1V3H0Z"));
    const auto hits = [&](double y, double z) {
        return beads.allHits(Ray{V3d(-5, y, z), V3d(1, 0, 0)}, 0, 1e9).size();
    };
    for (const double z : {1e-9, 0.3}) {
        EXPECT_EQ(hits(0.5, z), 2u);
        EXPECT_EQ(hits(1.5, z), 0u);
        EXPECT_EQ(hits(2.5, z), 2u);
    }
    // A ray through the axis itself may enter and leave the line, but not one without the other.
    for (const double y : {0.5, 1.5, 2.5})
        EXPECT_EQ(hits(y, 0) % 2, 0u);
}

TEST(DrawnProfile, WhatIsWithinAMillionthIsJoined) {
    EXPECT_EQ(joints("M5e-7 0H1V1L-5e-7 1"), "0,0 1,0 1,1 0,1");
    EXPECT_TRUE(profileOf("M5e-7 0H1V1L-5e-7 1").isClosed());
    EXPECT_FALSE(profileOf("M5e-6 0H1V1H0").isClosed());
    EXPECT_EQ(joints("M1 0H2V1H1L1 5e-7Z"), "1,0 2,0 2,1 1,1 1,0") << "no sliver of a line to close";
    EXPECT_EQ(joints("M1 0H2L2 5e-7V1"), "1,0 2,0 2,1");
    // Tiny steps do not vanish together.
    std::string steps = "M1 0H2";
    for (int i = 0; i < 1000; ++i)
        steps += "v5e-7";
    EXPECT_NEAR(profileOf(steps).segments().back().last().y, 5e-4, 1.1e-6);
}

TEST(DrawnProfile, RoundedCoordinatesStayOnTheAxis) {
    // A tenth three times is not 0.3; Inkscape's eight digits are worse.
    const ProfileFrame frame{.origin = {0.3, 0}};
    EXPECT_TRUE(profileOf("m.1 0 .1 0 .1 0h1v1h-1z", {.origin = {0.1, 0}}).isClosed());
    EXPECT_EQ(joints("M.30000001 0H1.3V1H.29999999", frame), "0,0 1,0 1,1 0,1");
}

TEST(DrawnProfile, AnArcAboutTheAxisIsASphere) {
    const Profile p = profileOf("M0 -1A1 1 0 0 1 0 1");
    EXPECT_TRUE(p.isClosed());
    for (int i = 0; i <= 1000; ++i)
        EXPECT_NEAR(p.evaluate(i / 1000.).p.length(), 1, 4e-7);
}

TEST(DrawnProfile, ControlPointsMayBeNegative) {
    EXPECT_EQ(errorOf("M1 0C-.2 1 -.2 2 1 3"), "none");
}

TEST(DrawnProfile, BeyondTheAxis) {
    EXPECT_EQ(errorOf("M1 0C-1 1 -1 2 1 3"),
              "error: the radius x(t) is -0.5 at t = 0.5 of this segment, (-0.5, 1.5) in the drawing; it must not be "
              "negative\n    the axis is x = 0 in the drawing: \"point2 origin\" moves it");
    EXPECT_EQ(
        errorOf("M-1 0L-2 3"),
        "error: the whole profile lies beyond the axis, where its radius is negative\n"
        "    the axis is x = 0 in the drawing: \"point2 origin\" moves it, \"bool flipx\" true mirrors the profile");
    EXPECT_EQ(
        errorOf("M-1 3L-2 5", {.origin = {1, 2}, .flipY = true, .lying = true}),
        "error: the whole profile lies beyond the axis, where its radius is negative\n"
        "    the axis is y = 2 in the drawing: \"point2 origin\" moves it, \"bool flipy\" false mirrors the profile");
    EXPECT_EQ(joints("M-1 0L-2 3", {.flipX = true}), "1,0 2,3");
}

TEST(DrawnProfile, WhatIsNoSingleLine) {
    EXPECT_EQ(errorOf("M0 0H1M2 0H3M4 4"),
              "error: a profile is a single line, but this path has 2: here begins the second\n"
              "    give each its own shape (Inkscape: Path > Break Apart)");
    EXPECT_EQ(errorOf("M0 0V1"), "error: the profile does not leave the axis: it has no surface");
    std::string many = "M1 0";
    for (int i = 0; i < 10001; ++i)
        many += "v1";
    EXPECT_EQ(errorOf(many), "error: a profile has at most 10000 segments, this one has 10001\n"
                             "    simplify the line (Inkscape: Path > Simplify)");
}

} // namespace
} // namespace vitrine
