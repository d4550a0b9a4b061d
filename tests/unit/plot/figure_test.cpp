// Marks in texts, simplified lines, and the SVG of a figure.
#include "plot/svg_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vitrine::plot {
namespace {

using testing::HasSubstr;

std::string described(const std::string& marked) {
    std::string text;
    for (const TextRun& run : textRuns(marked))
        text.append(run.italic ? "/" : "|").append(run.level < 0 ? "_" : run.level > 0 ? "^" : "").append(run.text);
    return text;
}

TEST(Figure, MarksMakeRuns) {
    EXPECT_EQ(described("plain"), "|plain");
    EXPECT_EQ(described("*d*_{r}(*y*)^{2}!"), "/d|_r|(/y|)|^2|!");
    EXPECT_EQ(described("a_b^c}"), "|a_b^c}");
    EXPECT_EQ(described("\\*x\\*"), "|*x*");
    EXPECT_EQ(described(""), "");
}

TEST(Figure, UnmarkedNamesStayAsTheyAre) {
    for (const std::string name : {"a*b_{c}.pbrt", "\\*", "x^{2}\\", "_{"}) {
        const auto runs = textRuns(unmarked(name));
        ASSERT_EQ(runs.size(), 1u) << name;
        EXPECT_EQ(runs[0].text, name);
        EXPECT_FALSE(runs[0].italic);
    }
}

TEST(Figure, LinesLosePointsThatNobodySees) {
    Line line{{}, Pen{{}, 1}};
    for (int i = 0; i <= 1000; ++i)
        line.points.push_back(V2d(i < 500 ? i : 500, i < 500 ? 0 : i - 500));
    Line circle{{}, Pen{{}, 1}};
    for (int i = 0; i <= 4000; ++i)
        circle.points.push_back(V2d(std::cos(2 * piD * i / 4000), std::sin(2 * piD * i / 4000)) * 100);
    Figure figure;
    figure.add(line);
    figure.add(circle);
    EXPECT_EQ(std::get<Line>(figure.items()[0]).points, (std::vector<V2d>{V2d(0, 0), V2d(500, 0), V2d(500, 500)}));
    // A chord that leaves a circle of radius r by e spans 2 sqrt(2 r e): some hundred of them for e = 0.02, r = 100.
    const auto& kept = std::get<Line>(figure.items()[1]).points;
    EXPECT_LT(kept.size(), 400u);
    for (std::size_t i = 1; i < kept.size(); ++i)
        EXPECT_GT(((kept[i] + kept[i - 1]) / 2).length(), 100 - 0.0201);
}

TEST(Figure, AsSvg) {
    Figure figure;
    figure.size = V2d(100, 50);
    figure.begin("panel", Box2d(V2d(1, 2), V2d(31, 42)));
    figure.add(Line{{V2d(0, 0), V2d(10.126, -1e-9)}, Pen{{255, 0, 16}, 1.5, 0.5, {3, 2}}});
    figure.end();
    figure.add(Text{V2d(5, 6), "a<b&*x*_{1}c", 10, Anchor::Middle, {1, 2, 3}, true, true});
    const std::string svg = toSvg(figure);
    EXPECT_THAT(svg, HasSubstr("width=\"100pt\" height=\"50pt\" viewBox=\"0 0 100 50\""));
    EXPECT_THAT(svg, HasSubstr("<clipPath id=\"clip1\"><rect x=\"1\" y=\"2\" width=\"30\" height=\"40\"/></clipPath>\n"
                               "<g class=\"panel\" clip-path=\"url(#clip1)\">\n"
                               "<polyline points=\"0,0 10.13,0\" fill=\"none\" stroke=\"#ff0010\" stroke-width=\"1.5\" "
                               "stroke-opacity=\"0.5\" stroke-dasharray=\"3 2\"/>\n</g>\n"));
    EXPECT_THAT(svg, HasSubstr("text-anchor=\"middle\" fill=\"#010203\" xml:space=\"preserve\" font-weight=\"bold\" "
                               "transform=\"rotate(-90 5 6)\">a&lt;b&amp;<tspan font-style=\"italic\">x</tspan>"
                               "<tspan font-size=\"7.2\" dy=\"2.2\">1</tspan><tspan dy=\"-2.2\">c</tspan></text>\n"));
}

} // namespace
} // namespace vitrine::plot
