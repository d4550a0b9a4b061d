// Ticks, numbers and the scales of panels.
#include "plot/axes.h"

#include <gtest/gtest.h>

namespace vitrine::plot {
namespace {

TEST(Axes, TicksAreRoundAndAboutAsManyAsAsked) {
    EXPECT_EQ(tickValues(0, 1, 4), (std::vector<double>{0, 0.2, 0.4, 3 * 0.2, 0.8, 1}));
    EXPECT_EQ(tickValues(-15.01, 15.01, 3), (std::vector<double>{-10, 0, 10}));
    for (const double size : {1e-7, 0.3, 1., 7., 1e9})
        for (const int count : {2, 4, 9}) {
            const auto ticks = tickValues(0.37 * size, 1.37 * size, count);
            EXPECT_GE(ticks.size(), std::size_t(count / 2)) << size << " " << count;
            EXPECT_LE(ticks.size(), std::size_t(2 * count)) << size << " " << count;
            for (const double tick : ticks)
                EXPECT_TRUE(tick > 0.3699 * size && tick < 1.3701 * size) << tick;
        }
}

TEST(Axes, NumbersAsFiguresShowThem) {
    EXPECT_EQ(shown(0.5), "0.5");
    EXPECT_EQ(shown(-2.34567), "\u22122.346");
    EXPECT_EQ(shown(-1.5e-7), "\u22121.5\u00b710^{\u22127}");
    EXPECT_EQ(shown(2e12), "2\u00b710^{12}");
    EXPECT_EQ(shown(infinityD), "\u221e");
}

TEST(Axes, EqualScaleHoldsTheDataInTheMiddle) {
    const Box2d frame(V2d(10, 20), V2d(210, 120));
    for (const Box2d& data : {Box2d(V2d(0, 0), V2d(1, 5)), Box2d(V2d(-3, 2), V2d(40, 3))}) {
        const Box2d box = Axes::equalScale(data, frame);
        EXPECT_NEAR(frame.size().x / box.size().x, frame.size().y / box.size().y, 1e-12);
        EXPECT_NEAR((box.center() - data.center()).length(), 0, 1e-12);
        EXPECT_LE(box.min.x, data.min.x + 1e-12);
        EXPECT_LE(box.min.y, data.min.y + 1e-12);
    }
}

TEST(Axes, DataWithoutSizeGetsSome) {
    const Box2d point = Axes::padded(Box2d(V2d(2, 3), V2d(2, 3)), 0.1);
    EXPECT_EQ(point, Box2d(V2d(1, 2), V2d(3, 4)));
    const Box2d level = Axes::padded(Box2d(V2d(0, 3), V2d(10, 3)), 0.1);
    EXPECT_EQ(level, Box2d(V2d(-1, -2), V2d(11, 8)));
}

TEST(Axes, DataGoesIntoTheFrameUpsideUp) {
    Figure figure;
    const Axes axes(figure, Box2d(V2d(10, 20), V2d(110, 70)), Box2d(V2d(0, -1), V2d(10, 1)), {"t", "n", "x", "y"});
    EXPECT_EQ(axes.at(V2d(0, -1)), V2d(10, 70));
    EXPECT_EQ(axes.at(V2d(10, 1)), V2d(110, 20));
    EXPECT_EQ(axes.at(V2d(5, 0)), V2d(60, 45));
}

} // namespace
} // namespace vitrine::plot
