// Profiles that cross themselves, and profiles that only seem to.
#include "shapes/revolution/profile_crossing.h"
#include "support/revolution_cases.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using namespace test;
using Points = std::vector<V2d>;

std::optional<WrongSide> wrongSide(Points points, int degree = 1) {
    const auto found = findWrongSide(Profile(points, degree));
    std::reverse(points.begin(), points.end());
    EXPECT_EQ(findWrongSide(Profile(points, degree)).has_value(), found.has_value()) << "drawn backwards";
    return found;
}

TEST(ProfileCrossing, LobesInsideOut) {
    const auto eight = wrongSide({{.2, .1}, {1, 1.1}, {1, .1}, {.2, 1.1}, {.2, .1}});
    ASSERT_TRUE(eight);
    EXPECT_LE(eight->winding, 0);
    // The larger lobe, on the right, decides: the wall of the smaller one is wrong.
    const auto uneven = wrongSide({{.2, .1}, {1, 1.1}, {1, -.5}, {.2, 1.1}, {.2, .1}});
    ASSERT_TRUE(uneven);
    EXPECT_EQ(uneven->p.x, 0.2);
    EXPECT_EQ(uneven->winding, 0);
    const auto poles = wrongSide({{0, 0}, {1, 0}, {1, 1}, {.5, 1}, {.5, 2}, {1.5, 2}, {1.5, .8}, {0, .8}});
    EXPECT_TRUE(poles);
}

TEST(ProfileCrossing, OverlapsAreCoveredTwice) {
    // A line that goes round once and again, a little smaller.
    const auto spiral =
        wrongSide({{1, 0}, {3, 0}, {3, 2}, {1, 2}, {1, .5}, {2.5, .5}, {2.5, 1.5}, {.5, 1.5}, {.5, 0}, {1, 0}});
    ASSERT_TRUE(spiral);
    EXPECT_EQ(spiral->winding, 2);
    EXPECT_TRUE(wrongSide({{.5, 0}, {1.5, .5}, {1.5, 1.5}, {-.2, 1.5}, {-.2, .5}, {1, 0}, {.5, 0}}, 6));
}

/// Weakly simple: nothing is inside out where lines touch, run twice, or end in a cusp.
TEST(ProfileCrossing, TouchesAreNone) {
    const std::pair<const char*, Points> sound[] = {
        {"a can", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
        {"a can, closed along the axis", {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}},
        {"an annulus", {{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0}}},
        {"a fin of no thickness", {{0, 0}, {1, 0}, {1, .5}, {2, .5}, {1, .5}, {1, 1}, {0, 1}}},
        {"a slit", {{0, 0}, {2, 0}, {2, .5}, {1, .5}, {2, .5}, {2, 1}, {0, 1}}},
        {"two balls that share a line", {{0, 0}, {1, .5}, {0, 1}, {1, 1.5}, {0, 2}}},
        {"two rings that touch in a ring", {{1, 0}, {3, 0}, {2, 1}, {3, 2}, {1, 2}, {2, 1}, {1, 0}}},
        {"a bridge", {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}},
        {"a wall of 1e-9", {{0, 0}, {1, 0}, {1, 3}, {1 - 1e-9, 3}, {1 - 1e-9, 1e-9}, {0, 1e-9}}},
        {"nothing but a line", {{0, 0}, {1, 1}, {0, 0}}}};
    for (const auto& [name, points] : sound)
        EXPECT_FALSE(wrongSide(points)) << name;
    // (1 + s^2, 1 + s^3): a cusp that points to the axis, closed by a wall.
    EXPECT_FALSE(wrongSide({{2, 0}, {2. / 3, 2}, {2. / 3, 0}, {2, 2}, {2, 4. / 3}, {2, 2. / 3}, {2, 0}}, 3));
    EXPECT_FALSE(wrongSide(joined(gobletProfile()), 3));
    EXPECT_FALSE(wrongSide(joined(vaseProfile()), 8)) << "open";
}

/// Loops seen from a centre in the order of the angle are simple, however ragged.
TEST(ProfileCrossing, RaggedLoopsAreNone) {
    for (int i = 0; i < 120; ++i) {
        RandomStream random(77, i);
        const int corners = 3 + i % 60;
        Points points;
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * piD * (k + 0.9 * random.uniformDouble()) / corners;
            const double r = i % 2 ? random.uniformDouble() : std::pow(10., -7 * random.uniformDouble());
            points.emplace_back(1.5 + r * std::cos(angle), r * std::sin(angle));
        }
        points.push_back(points.front());
        EXPECT_FALSE(wrongSide(points)) << i;
    }
}

} // namespace
} // namespace vitrine
