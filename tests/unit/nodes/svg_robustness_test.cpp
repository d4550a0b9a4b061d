// Whatever the text, reading SVG ends soon, in outlines or in errors.
#include "nodes/svg_file.h"
#include "support/mutate.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>

namespace vitrine {
namespace {

const std::string pathData = "m 5,200 h 33.6 a1.4,1.4 0 0110.5-2.7c-9-3.3-27.6-4.4-29.2-17.3S1e1 2.5e-1 3 4Q5 6,7,8T9 "
                             "10H11V12L13 14zM0 0A5 4 30 1 0 8 8";

void check(const SvgPath& path) {
    for (const SvgSubpath& subpath : path.subpaths) {
        ASSERT_FALSE(subpath.segments.empty());
        for (std::size_t i = 0; i < subpath.segments.size(); ++i) {
            for (const V2d& p : subpath.segments[i].controls())
                ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
            if (i > 0) {
                ASSERT_EQ(subpath.segments[i].first(), subpath.segments[i - 1].last());
            }
        }
        if (subpath.closed) {
            ASSERT_EQ(subpath.segments.back().last(), subpath.segments.front().first());
        }
    }
}

bool readsPath(const std::string& data) {
    try {
        check(readSvgPath(data));
        return true;
    } catch (const SvgTextError& e) {
        EXPECT_LE(e.offset, data.size()) << data;
        EXPECT_GT(e.length, 0u);
        return false;
    }
}

/// How many sound elements a file has; none for a wrong one.
int soundElements(const std::string& text) {
    try {
        const SvgDrawing drawing = readSvgText(text, "a.svg");
        int sound = 0;
        for (const SvgElement& element : drawing.elements) {
            check(element.path);
            for (const SvgSubpath& subpath : element.path.subpaths)
                for (const SvgSegment& segment : subpath.segments)
                    EXPECT_LE(segment.offset + segment.length, text.size());
            EXPECT_NE(element.fault.has_value(), !element.path.subpaths.empty());
            EXPECT_FALSE(element.fault && element.fault->toString().empty());
            sound += !element.fault;
        }
        return sound;
    } catch (const SceneError& e) {
        EXPECT_STRNE(e.what(), "");
        return 0;
    }
}

std::string sampleFile() {
    std::ifstream in(VITRINE_SOURCE_DIR "/tests/scenes/svg/goblet.svg", std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string mutated(const std::string& text, const std::vector<std::string>& pieces, std::uint64_t number) {
    return test::mutated(text, pieces, {6, 40}, RandomStream(11, number));
}

TEST(SvgRobustness, EveryPrefixOfPathData) {
    int fine = 0;
    for (std::size_t n = 0; n <= pathData.size(); ++n)
        fine += readsPath(pathData.substr(0, n));
    EXPECT_TRUE(readsPath(pathData));
    EXPECT_GT(fine, 20);
    EXPECT_LT(fine, int(pathData.size()) - 20);
}

TEST(SvgRobustness, MutationsOfPathData) {
    const std::vector<std::string> pieces = {
        "z",  "M",   "a", "1e38", "-1e308", "1e-320",        ".", "-", "e", ",", "00",
        "\n", "999", "q", "t",    "\xff",   "A0 0 0 0 0 1 1"};
    int fine = 0;
    for (std::uint64_t i = 0; i < 20000; ++i)
        fine += readsPath(mutated(pathData, pieces, i));
    EXPECT_GT(fine, 500);
    EXPECT_LT(fine, 19000);
}

TEST(SvgRobustness, EveryPrefixOfAFile) {
    const std::string text = sampleFile();
    ASSERT_EQ(soundElements(text), 6);
    const std::size_t end = text.rfind('>');
    for (std::size_t n = 0; n < end; ++n)
        ASSERT_EQ(soundElements(text.substr(0, n)), 0) << "not closed: no XML";
}

TEST(SvgRobustness, MutationsOfAFile) {
    const std::vector<std::string> pieces = {
        "<g>",          "</g>", "<svg>",     "/>",       "<path ",
        "d=\"",         "\"",   "&amp;",     "&#0;",     "&",
        "&#x10ffff;",   "%",    "1e38",      "-1",       "viewBox=",
        "none",         "<!--", "<![CDATA[", "xmlns:a=", "scale(0)",
        "r=\"1e38mm\"", "\xff", "<defs>",    "]]>",      "<!DOCTYPE x [<!ENTITY a 'b'>]>"};
    const std::string text = sampleFile();
    int some = 0;
    for (std::uint64_t i = 0; i < 5000; ++i)
        some += soundElements(mutated(text, pieces, i)) > 0;
    EXPECT_GT(some, 200);
    EXPECT_LT(some, 4900);
}

std::string repeated(const std::string& piece, int n) {
    std::string text;
    for (int i = 0; i < n; ++i)
        text += piece;
    return text;
}

// Bounds in seconds tell a reader whose time grows with the square (minutes) from a linear one; they are no benchmark.
template <class F>
double secondsFor(F&& f) {
    const auto start = std::chrono::steady_clock::now();
    f();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
constexpr double soon = 20;
const std::string open = "<svg xmlns=\"http://www.w3.org/2000/svg\">";

TEST(SvgRobustness, EntitiesAreNotExpanded) {
    std::string entities = "<!ENTITY a0 \"M0 0h1\">";
    for (int i = 1; i < 60; ++i)
        entities +=
            "<!ENTITY a" + std::to_string(i) + " \"&a" + std::to_string(i - 1) + ";&a" + std::to_string(i - 1) + ";\">";
    EXPECT_EQ(soundElements("<!DOCTYPE svg [" + entities + "]>" + open + "<path d=\"&a59;\"/></svg>"), 0);
    EXPECT_EQ(soundElements("<!DOCTYPE svg [" + entities + "]>" + open + "<path d=\"M0 0h1\"/></svg>"), 1);
}

TEST(SvgRobustness, DeepNesting) {
    const auto nested = [](int n) {
        return open + repeated("<g>", n) + "<path d=\"M0 0h1\"/>" + repeated("</g>", n) + "</svg>";
    };
    EXPECT_EQ(soundElements(nested(500)), 1);
    EXPECT_EQ(soundElements(nested(501)), 0) << "the limit";
    EXPECT_LT(secondsFor([&] {
                  EXPECT_EQ(soundElements(nested(1000000)), 0);
                  EXPECT_EQ(soundElements(open + repeated("<g>", 1000000)), 0);
              }),
              soon);
}

TEST(SvgRobustness, ManyOfEverythingIsLinear) {
    constexpr int n = 100000;
    EXPECT_LT(
        secondsFor([&] {
            EXPECT_EQ(readSvgPath("M0 0" + repeated("l1 1", 10 * n)).subpaths.at(0).segments.size(), 10u * n);
            EXPECT_EQ(soundElements(open + "<path d=\"M0 0" + repeated("&#10;l1 1", n) + "\"/></svg>"), 1);
            EXPECT_EQ(soundElements(open + repeated("<path d=\"M0 0h1\"/>\n", n) + "</svg>"), n);
            EXPECT_EQ(soundElements(open + repeated("<g x='1'><path d=\"M0 0h1\"/></g>\n", n) + "</svg>"), n);
            EXPECT_EQ(soundElements(open + "<path transform=\"" + repeated("rotate(7)", n) + "\" d=\"M0 0h1\"/></svg>"),
                      1);
            EXPECT_EQ(soundElements(open + "<path style=\"" + std::string(10 * n, ';') + "\" d=\"M0 0h1\"/></svg>"), 1);
        }),
        soon);
}

} // namespace
} // namespace vitrine
