#include "nodes/svg_path.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace vitrine {
namespace {

/// The control points of every segment, those of one in brackets; subpaths apart by "|", "Z" behind closed ones.
std::string drawn(std::string_view data) {
    std::string text;
    const SvgPath path = readSvgPath(data);
    for (const SvgSubpath& subpath : path.subpaths) {
        if (!text.empty()) text += " | ";
        for (const SvgSegment& segment : subpath.segments) {
            text += "[";
            for (const V2d& p : segment.controls())
                text += fmt::format("{}{:g},{:g}", text.back() == '[' ? "" : " ", p.x, p.y);
            text += "]";
        }
        if (subpath.closed) text += "Z";
    }
    return text;
}

/// "offset+length: message" of what is wrong.
std::string faultOf(std::string_view data) {
    try {
        readSvgPath(data);
        return "nothing";
    } catch (const SvgTextError& e) {
        return fmt::format("{}+{}: {}", e.offset, e.length, e.what());
    }
}

TEST(SvgPath, EveryCommandAbsoluteAndRelative) {
    EXPECT_EQ(drawn("M 1 2 L 3 4 H 5 V 6"), "[1,2 3,4][3,4 5,4][5,4 5,6]");
    EXPECT_EQ(drawn("m 1 2 l 3 4 h 5 v 6"), "[1,2 4,6][4,6 9,6][9,6 9,12]");
    EXPECT_EQ(drawn("M0 0 Q1 2 3 4 T 5 6"), "[0,0 1,2 3,4][3,4 5,6 5,6]");
    EXPECT_EQ(drawn("m1 1 q1 2 3 4 t 5 6"), "[1,1 2,3 4,5][4,5 6,7 9,11]");
    EXPECT_EQ(drawn("M0 0 C1 2 3 4 5 6 S 7 8 9 9"), "[0,0 1,2 3,4 5,6][5,6 7,8 7,8 9,9]");
    EXPECT_EQ(drawn("m1 1 c1 2 3 4 5 6 s 7 8 9 9"), "[1,1 2,3 4,5 6,7][6,7 8,9 13,15 15,16]");
}

TEST(SvgPath, SmoothCurvesReflectOnlyTheirOwnKind) {
    EXPECT_EQ(drawn("M0 0 Q1 2 3 4 S 5 6 7 8"), "[0,0 1,2 3,4][3,4 3,4 5,6 7,8]");
    EXPECT_EQ(drawn("M0 0 C1 2 3 4 5 6 T 7 8"), "[0,0 1,2 3,4 5,6][5,6 5,6 7,8]");
    EXPECT_EQ(drawn("M0 0 T 1 1 T 3 1"), "[0,0 0,0 1,1][1,1 2,2 3,1]");
    EXPECT_EQ(drawn("M0 0 Q1 2 3 4 L5 5 T 6 5"), "[0,0 1,2 3,4][3,4 5,5][5,5 5,5 6,5]");
    // The control point counts although the curve that it belongs to has no length.
    EXPECT_EQ(drawn("M0 0 Q0 0 0 0 T 1 1"), "[0,0 0,0 1,1]");
}

TEST(SvgPath, CommandsRepeatWithoutTheirLetter) {
    EXPECT_EQ(drawn("M0 0 1 1 2 0"), "[0,0 1,1][1,1 2,0]");
    EXPECT_EQ(drawn("m1 1 1 1 2 0"), "[1,1 2,2][2,2 4,2]");
    EXPECT_EQ(drawn("M0 0h1 2-4"), "[0,0 1,0][1,0 3,0][3,0 -1,0]");
    EXPECT_EQ(drawn("M0 0q1 0 1 1 1 0 1 1"), "[0,0 1,0 1,1][1,1 2,1 2,2]");
}

TEST(SvgPath, NumbersNeedNoSeparators) {
    EXPECT_EQ(drawn("M.5.25-1-.5L1e1+2e-1,1.,.5"), "[0.5,0.25 -1,-0.5][-1,-0.5 10,0.2][10,0.2 1,0.5]");
    EXPECT_EQ(drawn("\n\tM0,0\r\fL1 , 1\n"), "[0,0 1,1]");
    EXPECT_EQ(drawn("M0 0L1E+1 2E0"), "[0,0 10,2]");
    EXPECT_EQ(drawn("M0 0L1e-400 1"), "[0,0 0,1]") << "too small for a double is zero";
}

TEST(SvgPath, ArcFlagsNeedNoSeparators) {
    EXPECT_EQ(drawn("M0 0a1 1 0 0110 0"), drawn("M0 0 a 1 1 0 0 1 10 0"));
    EXPECT_EQ(drawn("M0 0a1,1 0 1,0.5.5 1 1 0 00-1-1"), drawn("M0 0 a 1 1 0 1 0 0.5 0.5 a 1 1 0 0 0 -1 -1"));
}

TEST(SvgPath, SubpathsAndClosing) {
    EXPECT_EQ(drawn("M0 0L1 0 1 1Z"), "[0,0 1,0][1,0 1,1][1,1 0,0]Z");
    EXPECT_EQ(drawn("M0 0L1 0 1 1 0 0z"), "[0,0 1,0][1,0 1,1][1,1 0,0]Z") << "closed already: no line of no length";
    EXPECT_EQ(drawn("M0 0L1 0ZL5 5"), "[0,0 1,0][1,0 0,0]Z | [0,0 5,5]") << "goes on from the start";
    EXPECT_EQ(drawn("m1 1 1 0zm1 1 1 0"), "[1,1 2,1][2,1 1,1]Z | [2,2 3,2]");
    EXPECT_EQ(drawn("M9 9M0 0L1 1M5 5"), "[0,0 1,1]") << "what draws nothing is no subpath";
    EXPECT_EQ(drawn("M0 0L0 0H0V0Q0 0 0 0C0 0 0 0 0 0A1 1 0 0 0 0 0L1 1"), "[0,0 1,1]");
    EXPECT_EQ(drawn("M3 3"), "");
    EXPECT_EQ(drawn("M0 0C1 1 1 1 0 0"), "[0,0 1,1 1,1 0,0]") << "a loop has a length";
}

TEST(SvgPath, SegmentsKnowWhereTheyStand) {
    const std::string data = "M0 0 L1 1 2 2 h1z";
    std::string where;
    const SvgPath path = readSvgPath(data);
    for (const SvgSegment& segment : path.subpaths.at(0).segments)
        where += data.substr(segment.offset, segment.length) + ";";
    EXPECT_EQ(where, "L1 1;2 2;h1;z;");
}

TEST(SvgPath, ExactErrors) {
    EXPECT_EQ(faultOf(""), "0+1: the path is empty");
    EXPECT_EQ(faultOf(" \n"), "0+1: the path is empty");
    EXPECT_EQ(faultOf("L1 1"), "0+1: a path begins with \"M\", not \"L\"");
    EXPECT_EQ(faultOf("1 1"), "0+1: expected \"M\", with which a path begins, got \"1\"");
    EXPECT_EQ(faultOf("M1 1 X"), "5+1: expected a path command, got \"X\"");
    EXPECT_EQ(faultOf("M1 1 L2 2 spline"), "11+5: expected number 1 of 4 of \"s\", got \"pline\"");
    EXPECT_EQ(faultOf("M1 1Z 2"), "6+1: expected a path command (\"Z\" takes no numbers), got \"2\"");
    EXPECT_EQ(faultOf("M1"), "2+1: expected number 2 of 2 of \"M\", got the end");
    EXPECT_EQ(faultOf("M1 1C 1 2 3 4 5"), "15+1: expected number 6 of 6 of \"C\", got the end");
    EXPECT_EQ(faultOf("M1 1c 1 2 3 4 L 5"), "14+1: expected number 5 of 6 of \"c\", got \"L\"");
    EXPECT_EQ(faultOf("M1 1A 1 1 0 2 0 1 1"), "12+1: expected a flag, 0 or 1, as number 4 of 7 of \"A\", got \"2\"");
    EXPECT_EQ(faultOf("M1 1L1,,1"), "6+1: a comma must stand between two numbers");
    EXPECT_EQ(faultOf("M1 1,L1 1"), "4+1: a comma must stand between two numbers");
    EXPECT_EQ(faultOf("M,1 1"), "1+1: expected number 1 of 2 of \"M\", got \",\"");
    EXPECT_EQ(faultOf("M1 1L1 1e99"), "7+4: \"1e99\" is too large: numbers go up to 3.4e38");
    EXPECT_EQ(faultOf("M1 1L1 nan"), "7+3: expected number 2 of 2 of \"L\", got \"nan\"");
    EXPECT_EQ(faultOf("M1 1L1 -"), "7+1: expected number 2 of 2 of \"L\", got \"-\"");
    EXPECT_EQ(faultOf("M1 1 \xc3\xa9"), "5+2: expected a path command, got \"\xc3\xa9\"");
}

// ---- arcs ----

struct Ellipse {
    V2d centre, radii;
    double degrees;

    /// Distance from the ellipse, to first order, in parts of the larger radius.
    double distance(const V2d& p) const {
        const double a = degrees * piD / 180, c = std::cos(a), s = std::sin(a);
        const V2d d = p - centre, q(c * d.x + s * d.y, c * d.y - s * d.x);
        const V2d scaled(q.x / radii.x, q.y / radii.y);
        const V2d gradient(scaled.x / radii.x, scaled.y / radii.y);
        const double r = scaled.length();
        return (r - 1) * r / gradient.length() / std::max(radii.x, radii.y);
    }
};

V2d pointOf(const SvgSegment& s, double t) {
    const double u = 1 - t;
    return s.points[0] * (u * u * u) + s.points[1] * (3 * u * u * t) + s.points[2] * (3 * u * t * t) +
           s.points[3] * (t * t * t);
}

double turnOf(const SvgSubpath& subpath, const V2d& centre) {
    double turn = 0;
    for (const SvgSegment& s : subpath.segments) {
        const V2d a = s.first() - centre, b = s.last() - centre;
        turn += std::atan2(a.x * b.y - a.y * b.x, a.dot(b));
    }
    return turn * 180 / piD;
}

void expectOn(const std::string& data, const Ellipse& ellipse) {
    SCOPED_TRACE(data);
    const SvgPath path = readSvgPath(data);
    double farthest = 0;
    for (const SvgSegment& s : path.subpaths.at(0).segments) {
        ASSERT_EQ(s.degree, 3);
        for (int i = 0; i <= 1000; ++i)
            farthest = std::max(farthest, std::abs(ellipse.distance(pointOf(s, i / 1000.))));
    }
    EXPECT_LT(farthest, 4e-7) << "2/27 sin^6(7.5 degrees)/cos^2(7.5 degrees) = 3.75e-7";
}

TEST(SvgArc, StaysOnItsCircleOrEllipse) {
    expectOn("M1 0A1 1 0 0 1 0 1", {{0, 0}, {1, 1}, 0});
    expectOn("M1 0A1 1 0 0 0 0 1", {{1, 1}, {1, 1}, 0});
    expectOn("M1 0A1 1 0 1 0 0 1", {{0, 0}, {1, 1}, 0});
    expectOn("M1 0A1 1 0 1 1 0 1", {{1, 1}, {1, 1}, 0});
    expectOn("M20 0A20 5 0 0 1 -20 0", {{0, 0}, {20, 5}, 0});
    // Centre (3, -2), turned by 30 degrees: from the end of one half axis to that of the other.
    const double c = std::cos(piD / 6), s = std::sin(piD / 6);
    expectOn(fmt::format("M{} {}A7 2 30 0 1 {} {}", 3 + 7 * c, -2 + 7 * s, 3 - 2 * s, -2 + 2 * c),
             {{3, -2}, {7, 2}, 30});
    expectOn(fmt::format("M{} {}A7 2 30 1 0 {} {}", 3 + 7 * c, -2 + 7 * s, 3 - 2 * s, -2 + 2 * c),
             {{3, -2}, {7, 2}, 30});
}

TEST(SvgArc, TurnsTheRightWayAndFar) {
    const auto turn = [](const char* data, const V2d& centre) {
        return turnOf(readSvgPath(data).subpaths.at(0), centre);
    };
    EXPECT_NEAR(turn("M1 0A1 1 0 0 1 0 1", {0, 0}), 90, 1e-9);
    EXPECT_NEAR(turn("M1 0A1 1 0 1 0 0 1", {0, 0}), -270, 1e-9);
    EXPECT_NEAR(turn("M1 0A1 1 0 0 0 0 1", {1, 1}), -90, 1e-9);
    EXPECT_NEAR(turn("M1 0A1 1 0 1 1 0 1", {1, 1}), 270, 1e-9);
    EXPECT_NEAR(turn("M1 0A1 1 0 0 1 -1 0", {0, 0}), 180, 1e-9);
    EXPECT_NEAR(turn("M1 0A1 1 0 0 0 -1 0", {0, 0}), -180, 1e-9);
    EXPECT_NEAR(turn("M1 0A1 1 360 0 1 0 1", {0, 0}), 90, 1e-9);
}

TEST(SvgArc, EndsExactlyWhereItIsTold) {
    const SvgPath path = readSvgPath("M.1 .2A.3 .7 13 1 1 .4 .1L1 1");
    const auto& segments = path.subpaths.at(0).segments;
    for (std::size_t i = 1; i < segments.size(); ++i)
        EXPECT_EQ(segments[i].first(), segments[i - 1].last());
    EXPECT_EQ(segments[segments.size() - 2].last(), V2d(.4, .1));
}

TEST(SvgArc, SpecialRadii) {
    EXPECT_EQ(drawn("M0 0A0 5 0 0 1 3 4"), "[0,0 3,4]") << "no radius: a line";
    EXPECT_EQ(drawn("M0 0A-5 5 0 0 1 6 8"), drawn("M0 0A5 5 0 0 1 6 8")) << "signs do not count";
    // Too small to reach: scaled up to a half circle.
    expectOn("M0 0A1 1 0 0 1 6 8", {{3, 4}, {5, 5}, 0});
    expectOn("M0 0A1e-9 1e-9 0 1 0 6 8", {{3, 4}, {5, 5}, 0});
    expectOn("M-4 0A2 1 0 0 1 4 0", {{0, 0}, {4, 2}, 0});
}

} // namespace
} // namespace vitrine
