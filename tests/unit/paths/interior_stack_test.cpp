#include "paths/interior_stack.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

Interior solid(std::optional<int> priority) {
    Interior interior;
    interior.eta = std::make_shared<ConstantSpectrum>(1.5f);
    interior.priority = priority;
    return interior;
}

TEST(InteriorStack, StartsInVacuum) {
    const InteriorStack stack;
    EXPECT_TRUE(stack.empty());
    EXPECT_EQ(stack.current(), nullptr);
}

TEST(InteriorStack, TheHigherPriorityFillsTheOverlap) {
    const Interior glass = solid(2), wine = solid(1);
    InteriorStack stack;
    // A ray through the glass into wine that is modelled to overlap the wall: vacuum, glass, glass + wine, wine.
    auto crossing = stack.crossing(glass, true);
    EXPECT_TRUE(crossing.isReal);
    EXPECT_EQ(crossing.outside, nullptr);
    stack.enter(glass);

    crossing = stack.crossing(wine, true);
    EXPECT_FALSE(crossing.isReal) << "inside the glass the wine's surface is not there";
    stack.enter(wine);
    EXPECT_EQ(stack.current(), &glass);

    crossing = stack.crossing(glass, false);
    EXPECT_TRUE(crossing.isReal);
    EXPECT_EQ(crossing.outside, &wine) << "the glass's inner wall is a glass-wine interface";
    stack.leave(glass);
    EXPECT_EQ(stack.current(), &wine);

    crossing = stack.crossing(glass, true);
    EXPECT_TRUE(crossing.isReal);
    EXPECT_EQ(crossing.outside, &wine);
    stack.enter(glass);
    crossing = stack.crossing(wine, false);
    EXPECT_FALSE(crossing.isReal);
    stack.leave(wine);
    EXPECT_EQ(stack.current(), &glass);
    stack.leave(glass);
    EXPECT_TRUE(stack.empty());
}

TEST(InteriorStack, AmongEqualsTheFirstEnteredStays) {
    const Interior a = solid(1), b = solid(1);
    InteriorStack stack;
    stack.enter(a);
    EXPECT_FALSE(stack.crossing(b, true).isReal);
    stack.enter(b);
    EXPECT_EQ(stack.current(), &a);
    const auto leavingA = stack.crossing(a, false);
    EXPECT_TRUE(leavingA.isReal);
    EXPECT_EQ(leavingA.outside, &b);
    EXPECT_FALSE(stack.crossing(b, false).isReal);
}

TEST(InteriorStack, OverlapsOfOneMaterialAreOneSolid) {
    const Interior glass = solid(1);
    InteriorStack stack;
    stack.enter(glass);
    EXPECT_FALSE(stack.crossing(glass, true).isReal);
    stack.enter(glass);
    EXPECT_FALSE(stack.crossing(glass, false).isReal) << "still inside the other one";
    stack.leave(glass);
    EXPECT_TRUE(stack.crossing(glass, false).isReal);
    EXPECT_EQ(stack.crossing(glass, false).outside, nullptr);
}

TEST(InteriorStack, WithoutPriorityASurfaceIsAlwaysThereAndRelative) {
    const Interior water = solid(5), plain = solid({});
    InteriorStack stack;
    stack.enter(water);
    const auto crossing = stack.crossing(plain, true);
    EXPECT_TRUE(crossing.isReal);
    EXPECT_EQ(crossing.outside, nullptr);
    stack.enter(plain);
    EXPECT_EQ(stack.current(), &plain);
}

TEST(InteriorStack, LeavingWhatWasNeverEnteredChangesNothing) {
    const Interior glass = solid(1), other = solid(1);
    InteriorStack stack;
    stack.leave(glass);
    EXPECT_TRUE(stack.empty());
    stack.enter(glass);
    stack.leave(other);
    EXPECT_EQ(stack.current(), &glass);
    EXPECT_FALSE(stack.crossing(glass, false).isLost);
    EXPECT_TRUE(stack.crossing(other, false).isLost);
    EXPECT_FALSE(stack.crossing(other, false).isReal);
}

TEST(InteriorStack, ForgetsTheOldestWhenFull) {
    std::vector<Interior> solids(InteriorStack::capacity + 1, solid(1));
    InteriorStack stack;
    for (const auto& s : solids)
        stack.enter(s);
    EXPECT_EQ(stack.size(), InteriorStack::capacity);
    EXPECT_EQ(stack.current(), &solids[1]);
}

} // namespace
} // namespace vitrine
