// What the figure of a profile holds, and that both writers take it.
#include "plot/png_writer.h"
#include "plot/profile_figure.h"
#include "plot/svg_writer.h"

#include <gtest/gtest.h>

namespace vitrine::plot {
namespace {

ProfileDrawing drawingOf(const std::vector<V2d>& points, int degree) {
    ProfileDrawing drawing;
    drawing.title = "title";
    drawing.unit = "mm";
    drawing.profile = Profile(points, degree);
    drawing.segments = drawing.profile->segments();
    return drawing;
}

ProfileDrawing bowl() {
    return drawingOf({V2d(0, 0), V2d(2, 0), V2d(2, 3), V2d(1.5, 3), V2d(1.5, 1), V2d(1, 0.5), V2d(0, 0.5)}, 3);
}

Figure figureOf(const ProfileDrawing& drawing) {
    Figure figure;
    addProfile(figure, drawing);
    return figure;
}

/// The items of the first group of this name, nested ones included.
std::vector<Figure::Item> group(const Figure& figure, const std::string& name) {
    std::vector<Figure::Item> result;
    int depth = 0;
    for (const Figure::Item& item : figure.items()) {
        const auto* begin = std::get_if<GroupBegin>(&item);
        if (depth > 0 && std::holds_alternative<GroupEnd>(item) && --depth == 0) break;
        if (depth > 0) result.push_back(item);
        if (begin && (depth > 0 || begin->name == name)) ++depth;
    }
    return result;
}

template <class T>
std::size_t countOf(const std::vector<Figure::Item>& items) {
    return std::size_t(std::count_if(items.begin(), items.end(),
                                     [](const Figure::Item& item) { return std::holds_alternative<T>(item); }));
}

/// Numbers in all lines and disks, for a figure that must be finite.
bool isFiniteFigure(const Figure& figure) {
    for (const Figure::Item& item : figure.items()) {
        if (const auto* line = std::get_if<Line>(&item))
            for (const V2d& p : line->points)
                if (!std::isfinite(p.x) || !std::isfinite(p.y)) return false;
        if (const auto* disk = std::get_if<Disk>(&item))
            if (!std::isfinite(disk->centre.x) || !std::isfinite(disk->centre.y)) return false;
    }
    return true;
}

TEST(ProfileFigure, HoldsThePanels) {
    const Figure figure = figureOf(bowl());
    EXPECT_EQ(countOf<Line>(group(figure, "curve")), 2u);
    EXPECT_EQ(countOf<Disk>(group(figure, "control-polygon")), 4u); // two inner points a segment
    EXPECT_EQ(countOf<Disk>(group(figure, "joints")), 4u);          // three joints, and the ring about the start
    EXPECT_EQ(countOf<Line>(group(figure, "other-half")), 2u);
    EXPECT_EQ(countOf<Line>(group(figure, "axis-of-revolution")), 1u);
    EXPECT_EQ(countOf<Line>(group(figure, "solid")), 2u); // closed: both halves are filled
    for (const char* name : {"hodograph-1", "hodograph-2", "comb", "comb-scale", "curvature"})
        EXPECT_GT(countOf<Line>(group(figure, name)), 2u) << name;
    EXPECT_GT(countOf<Line>(group(figure, "comb")), 60u);
    EXPECT_TRUE(group(figure, "ray").empty());
    EXPECT_TRUE(isFiniteFigure(figure));
}

/// Short segments too, and where lines cross: each has a number, and no two lie on each other.
TEST(ProfileFigure, NumbersEverySegmentApart) {
    std::vector<V2d> points{{1, 0}, {2, 0}, {2, 3}, {1.99, 3.01}, {1.98, 3.01}, {1.97, 3}, {1, 3}};
    for (int i = 0; i < 6; ++i) // lines through one point, their middles
        points.insert(points.end(), {V2d(1.5 + 0.4 * std::cos(i * 0.5), 1.5 + 0.4 * std::sin(i * 0.5)),
                                     V2d(1.5 - 0.4 * std::cos(i * 0.5), 1.5 - 0.4 * std::sin(i * 0.5))});
    const Figure figure = figureOf(drawingOf(points, 1));
    std::vector<Text> numbers;
    for (const auto& item : group(figure, "segment-numbers"))
        if (const auto* text = std::get_if<Text>(&item)) numbers.push_back(*text);
    ASSERT_EQ(numbers.size(), points.size() - 1);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_TRUE(std::abs(numbers[i].at.x - numbers[k].at.x) > 12 ||
                        std::abs(numbers[i].at.y - numbers[k].at.y) > 9)
                << i << " on " << k;
}

TEST(ProfileFigure, CombTeethAreAsLongAsTheCurvatureSays) {
    // Nearly half a circle of radius 2 about (3, 0): curvature 1/2, teeth nearly alike, outwards.
    constexpr double k = 2 * 0.5522847498;
    ProfileDrawing drawing =
        drawingOf({V2d(3, -2), V2d(3 + k, -2), V2d(5, -k), V2d(5, 0), V2d(5, k), V2d(3 + k, 2), V2d(3, 2)}, 3);
    const Figure figure = figureOf(drawing);
    double shortest = infinityD, longest = 0;
    for (const auto& item : group(figure, "comb"))
        if (const auto* line = std::get_if<Line>(&item); line && line->points.size() == 2 && line->pen->width == 0.6) {
            const double length = (line->points[1] - line->points[0]).length();
            shortest = std::min(shortest, length);
            longest = std::max(longest, length);
            EXPECT_GT(line->points[1].x, line->points[0].x - 1e-9);
        }
    EXPECT_GT(shortest, 10);
    double least = infinityD, most = 0; // of a cubic arc, which is no circle
    for (int i = 0; i <= 1000; ++i) {
        const double curvature = drawing.segments[0].curvature(i / 1000.);
        least = std::min(least, curvature);
        most = std::max(most, curvature);
    }
    EXPECT_NEAR(longest / shortest, most / least, 1e-3);
}

TEST(ProfileFigure, MarksTheRoots) {
    ProfileDrawing drawing = bowl();
    drawing.ray = Ray{V3d(-4, 2, 0.2), V3d(1, -0.1, 0)};
    const std::size_t roots = RaySection(*drawing.ray).roots(*drawing.profile, 360).size();
    EXPECT_EQ(roots, 4u);
    const Figure figure = figureOf(drawing);
    EXPECT_EQ(countOf<Disk>(group(figure, "roots")), roots);
    EXPECT_EQ(countOf<Text>(group(figure, "roots")), roots);
    EXPECT_EQ(countOf<Text>(group(figure, "root-table")), 7 + 6 * roots);
    EXPECT_EQ(countOf<Disk>(group(figure, "ray-path")), roots);
    EXPECT_TRUE(group(figure, "distance-over-s").empty());
    EXPECT_TRUE(isFiniteFigure(figure));
    // A root's mark lies on both curves: on the line of the ray, too.
    const auto marks = group(figure, "roots");
    const auto lines = group(figure, "d-ray");
    for (const auto& item : marks)
        if (const auto* disk = std::get_if<Disk>(&item)) {
            double nearest = infinityD;
            for (const auto& other : lines)
                for (std::size_t i = 1; i < std::get<Line>(other).points.size(); ++i) {
                    const auto& points = std::get<Line>(other).points;
                    const V2d d = points[i] - points[i - 1];
                    const double t = std::clamp((disk->centre - points[i - 1]).dot(d) / d.length2(), 0., 1.);
                    nearest = std::min(nearest, (disk->centre - points[i - 1] - d * t).length());
                }
            EXPECT_LT(nearest, 0.05);
        }
}

TEST(ProfileFigure, HorizontalAndAxialRays) {
    ProfileDrawing drawing = bowl();
    drawing.ray = Ray{V3d(-4, 2, 0.2), V3d(1, 0, 0)};
    const Figure level = figureOf(drawing);
    EXPECT_EQ(countOf<Disk>(group(level, "roots")), 4u);
    EXPECT_EQ(countOf<Line>(group(level, "radii")), 4u);
    const auto line = std::get<Line>(group(level, "d-ray")[0]);
    for (const V2d& p : line.points)
        EXPECT_NEAR(p.x, line.points[0].x, 0.01); // upright, at y = 2
    drawing.ray = Ray{V3d(0.3, 9, 0.4), V3d(0, -1, 0)};
    const Figure axial = figureOf(drawing);
    EXPECT_EQ(countOf<Disk>(group(axial, "roots")), 2u);
    const auto across = std::get<Line>(group(axial, "d-ray").back());
    for (const V2d& p : across.points)
        EXPECT_NEAR(p.y, across.points[0].y, 0.01); // d = 0.5 throughout
    for (const Figure& figure : {level, axial})
        EXPECT_TRUE(isFiniteFigure(figure));
}

TEST(ProfileFigure, NastyProfilesStayFinite) {
    const ProfileDrawing cusp = drawingOf({V2d(1, 0), V2d(3, 2), V2d(1, 2), V2d(3, 0)}, 3);
    const ProfileDrawing straight = drawingOf({V2d(1, 0), V2d(1, 3)}, 1);
    const ProfileDrawing tiny = drawingOf({V2d(1e-9, 0), V2d(2e-9, 1e-9), V2d(1e-9, 2e-9)}, 2);
    const ProfileDrawing huge = drawingOf({V2d(1e12, 0), V2d(2e12, 1e12), V2d(1e12, 2e12)}, 2);
    const ProfileDrawing disk = drawingOf({V2d(0, 1), V2d(2, 1)}, 1);
    const ProfileDrawing doubled = drawingOf({V2d(1, 0), V2d(1, 0), V2d(1, 0), V2d(2, 1)}, 3);
    std::vector<V2d> wild;
    for (int i = 0; i <= 60; ++i)
        wild.push_back(V2d(5 + (i % 2 ? 4 : -4), i % 7));
    for (ProfileDrawing drawing : {cusp, straight, tiny, huge, disk, doubled, drawingOf(wild, 60)}) {
        const V2d middle = drawing.segments[0].point(0.5);
        drawing.ray = Ray{V3d(-3 * middle.x, middle.y, 0.1 * middle.x), V3d(1, 0.3, 0)};
        const Figure figure = figureOf(drawing);
        EXPECT_TRUE(isFiniteFigure(figure)) << drawing.segments[0].degree();
        EXPECT_LT(figure.items().size(), 4000u);
        EXPECT_EQ(toSvg(figure).find("nan"), std::string::npos);
    }
}

TEST(ProfileFigure, WithoutAProfileSaysWhyNot) {
    ProfileDrawing drawing;
    drawing.unit = "px";
    drawing.segments = {BezierCurve({V2d(-1, 0), V2d(1, 1)})};
    drawing.fault = "it crosses the axis";
    drawing.ray = Ray{V3d(-4, 0.5, 0), V3d(1, 0, 0)};
    const Figure figure = figureOf(drawing);
    EXPECT_NE(toSvg(figure).find("Cannot be turned: it crosses the axis"), std::string::npos);
    EXPECT_TRUE(group(figure, "ray").empty());
}

TEST(ProfileFigure, FiguresStackAndRepeatBitForBit) {
    ProfileDrawing drawing = bowl();
    drawing.ray = Ray{V3d(-4, 2, 0.2), V3d(1, -0.1, 0)};
    Figure two;
    addProfile(two, drawing);
    const double height = two.size.y;
    addProfile(two, drawing);
    EXPECT_EQ(two.size.y, 2 * height);
    Figure again;
    addProfile(again, drawing);
    addProfile(again, drawing);
    EXPECT_EQ(toSvg(two), toSvg(again));
    EXPECT_EQ(toPng(two, 1), toPng(again, 1));
}

TEST(ProfileFigure, PngOfTheAskedSize) {
    Figure figure;
    figure.size = V2d(30.5, 20);
    const auto png = toPng(figure, 2);
    const auto word = [&](std::size_t at) {
        unsigned value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value = 256 * value + std::to_integer<unsigned>(png.at(at + i));
        return value;
    };
    EXPECT_EQ(word(0), 0x89504e47u); // PNG's signature; width and height stand in the first chunk
    EXPECT_EQ(word(16), 61u);
    EXPECT_EQ(word(20), 40u);
    figure.size.y = 20000;
    EXPECT_THROW(toPng(figure, 2), std::invalid_argument);
}

} // namespace
} // namespace vitrine::plot
