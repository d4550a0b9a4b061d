#include "core/random.h"
#include "nodes/transforms.h"
#include "scene_text.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace vitrine {
namespace {

void expectNear(const V3d& a, const V3d& b, double tolerance = 1e-14) {
    EXPECT_LE((a - b).length(), tolerance) << a << " " << b;
}

void expectInverse(const Transform& t, double tolerance = 1e-13) {
    const M44d product = t.matrix() * t.inverse().matrix();
    EXPECT_TRUE(product.equalWithAbsError(M44d(), tolerance)) << product;
}

V3d shapePoint(const std::string& text, const V3d& p) {
    return world(text + " Shape \"sphere\"").shapes.at(0).worldFromObject->start.point(p);
}

TEST(Transforms, NewestActsFirst) {
    // pbrt-v4: what stands nearest to the shape acts on it first.
    expectNear(shapePoint("Translate 1 2 3 Scale 2 3 4", V3d(1, 1, 1)), V3d(3, 5, 7));
    expectNear(shapePoint("Scale 2 3 4 Translate 1 2 3", V3d(1, 1, 1)), V3d(4, 9, 16));
    expectNear(shapePoint("Translate 1 0 0 Identity Translate 0 1 0", V3d(0)), V3d(0, 1, 0));
}

TEST(Transforms, RotationIsRightHandedInDegrees) {
    expectNear(shapePoint("Rotate 90 0 0 1", V3d(1, 0, 0)), V3d(0, 1, 0), 0);
    expectNear(shapePoint("Rotate 90 1 0 0", V3d(0, 1, 0)), V3d(0, 0, 1), 0);
    expectNear(shapePoint("Rotate 90 0 5 0", V3d(0, 0, 1)), V3d(1, 0, 0), 0);
    expectNear(shapePoint("Rotate -270 0 0 1", V3d(1, 0, 0)), V3d(0, 1, 0), 0);
    expectNear(shapePoint("Rotate 30 0 0 1", V3d(1, 0, 0)), V3d(std::sqrt(0.75), 0.5, 0));
    expectNear(shapePoint("Rotate 120 1 1 1", V3d(1, 2, 3)), V3d(3, 1, 2));
}

TEST(Transforms, MatricesListTheTranslationLast) {
    const std::string numbers = "[ 0 2 0 0  -3 0 0 0  0 0 4 0  5 6 7 1 ]";
    expectNear(shapePoint("Translate 9 9 9 Transform " + numbers, V3d(1, 1, 1)), V3d(5 - 3, 6 + 2, 7 + 4), 0);
    expectNear(shapePoint("Translate 1 1 1 ConcatTransform " + numbers, V3d(1, 1, 1)), V3d(3, 9, 12), 0);
}

TEST(Transforms, LookAtIsPbrtsLeftHandedCamera) {
    const auto scene = parseSceneString("LookAt 1 2 3  1 2 8  0 1 0\nCamera \"perspective\"\nWorldBegin");
    const Transform& worldFromCamera = scene.camera.worldFromCamera->start;
    expectNear(worldFromCamera.point(V3d(0)), V3d(1, 2, 3), 0);
    expectNear(worldFromCamera.vector(V3d(0, 0, 1)), V3d(0, 0, 1), 0);
    expectNear(worldFromCamera.vector(V3d(0, 1, 0)), V3d(0, 1, 0), 0);
    expectNear(worldFromCamera.vector(V3d(1, 0, 0)), V3d(1, 0, 0), 0);
    // Looking along -z, right is -x: the same handedness.
    const auto back = parseSceneString("LookAt 0 0 5  0 0 0  0 1 0\nCamera \"perspective\"\nWorldBegin");
    expectNear(back.camera.worldFromCamera->start.vector(V3d(1, 0, 0)), V3d(-1, 0, 0), 0);
    EXPECT_FALSE(back.camera.worldFromCamera->start.swapsHandedness());
}

TEST(Transforms, InversesAreExactOrNear) {
    RandomStream random(3);
    for (int i = 0; i < 1000; ++i) {
        const auto v = [&] { return V3d(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)); };
        expectInverse(translation(v()), 0);
        expectInverse(scaling(v()));
        expectInverse(rotation(random.uniform(-720, 720), v()));
        expectInverse(lookAt(v(), v(), v()));
        expectInverse(compose(compose(rotation(random.uniform(0, 360), v()), scaling(v())), translation(v())), 1e-12);
    }
}

TEST(Transforms, LargeAndSmallNumbersSurvive) {
    expectInverse(rotation(33, V3d(1e-200, 2e-200, 0)));
    expectInverse(rotation(33, V3d(1e30, 2e30, 1e-30)));
    expectInverse(lookAt(V3d(0), V3d(0, 0, 1e-30), V3d(0, 1e30, 0)));
    // A thin plate turned out of the axes is no singular matrix.
    const Transform plate = compose(scaling(V3d(1, 1e-8, 1)), rotation(37, V3d(1, 2, 3)));
    double numbers[16];
    for (int i = 0; i < 16; ++i)
        numbers[i] = plate.matrix()[i / 4][i % 4];
    EXPECT_NO_THROW(fromNumbers(numbers));
}

TEST(Transforms, WhatCannotBeInvertedIsRefused) {
    EXPECT_THROW(scaling(V3d(1, 1, 0)), std::domain_error);
    EXPECT_THROW(scaling(V3d(1, 1, 5e-324)), std::domain_error);
    EXPECT_THROW(rotation(10, V3d(0)), std::domain_error);
    EXPECT_THROW(lookAt(V3d(1), V3d(1), V3d(0, 1, 0)), std::domain_error);
    EXPECT_THROW(lookAt(V3d(0), V3d(1, 0, 0), V3d(0)), std::domain_error);
    EXPECT_THROW(lookAt(V3d(0), V3d(1, 2, 3), V3d(-2, -4, -6)), std::domain_error);
    const double rankTwo[16] = {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 0, 0, 0, 1};
    EXPECT_THROW(fromNumbers(rankTwo), std::domain_error);
    const double zero[16] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    EXPECT_THROW(fromNumbers(zero), std::domain_error);
    const double projective[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1};
    EXPECT_THROW(fromNumbers(projective), std::domain_error);
    std::string growing;
    for (int i = 0; i < 20; ++i)
        growing += "Scale 1e30 1e30 1e30\n";
    EXPECT_THAT(errorsOf(growing + "WorldBegin"), testing::HasSubstr("grows beyond all numbers"));
}

TEST(Transforms, ActiveTransformKeepsTwoTimes) {
    const auto scene = parseSceneString("TransformTimes .25 .75\nActiveTransform EndTime\nTranslate 1 0 0\n"
                                        "ActiveTransform All\nTranslate 0 1 0\nCamera \"perspective\"\nWorldBegin\n"
                                        "Shape \"sphere\"\nActiveTransform StartTime\nScale 2 2 2\nShape \"sphere\"\n"
                                        "ActiveTransform All\nIdentity\nShape \"sphere\"\n");
    const MovingTransform& camera = *scene.camera.worldFromCamera;
    EXPECT_TRUE(camera.isMoving());
    EXPECT_EQ(camera.startTime, 0.25);
    EXPECT_EQ(camera.endTime, 0.75);
    expectNear(camera.start.point(V3d(0)), V3d(0, -1, 0), 0);
    expectNear(camera.end.point(V3d(0)), V3d(-1, -1, 0), 0);
    EXPECT_FALSE(scene.shapes[0].worldFromObject->isMoving()) << "WorldBegin starts afresh";
    EXPECT_EQ(scene.shapes[0].worldFromObject->endTime, 0.75);
    EXPECT_TRUE(scene.shapes[1].worldFromObject->isMoving());
    expectNear(scene.shapes[1].worldFromObject->start.point(V3d(1)), V3d(2), 0);
    expectNear(scene.shapes[1].worldFromObject->end.point(V3d(1)), V3d(1), 0);
    EXPECT_FALSE(scene.shapes[2].worldFromObject->isMoving());
    EXPECT_THAT(errorsOf("ActiveTransform Both\nWorldBegin"),
                testing::HasSubstr("ActiveTransform takes All, StartTime or EndTime, got \"Both\""));
}

TEST(Transforms, CoordinateSystemsHaveNames) {
    const auto scene =
        parseSceneString("Translate 0 0 5\nCamera \"perspective\"\nWorldBegin\nTranslate 1 0 0\n"
                         "CoordinateSystem \"here\"\nIdentity\nCoordSysTransform \"here\"\nShape \"sphere\"\n"
                         "CoordSysTransform \"camera\"\nShape \"sphere\"\n"
                         "CoordSysTransform \"world\"\nShape \"sphere\"\n");
    expectNear(scene.shapes[0].worldFromObject->start.point(V3d(0)), V3d(1, 0, 0), 0);
    expectNear(scene.shapes[1].worldFromObject->start.point(V3d(0)), V3d(0, 0, -5), 0);
    expectNear(scene.shapes[2].worldFromObject->start.point(V3d(0)), V3d(0, 0, 0), 0);
    EXPECT_THAT(errorsOf("Camera \"perspective\"\nWorldBegin\nCoordSysTransform \"camara\""),
                testing::HasSubstr("did you mean \"camera\"?"));
}

TEST(Transforms, MatricesNeedTheirBrackets) {
    EXPECT_THAT(errorsOf("Transform 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\nWorldBegin"),
                testing::HasSubstr("Transform takes 16 numbers in brackets: expected \"[\", got \"1\""));
    EXPECT_THAT(errorsOf("ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 5]\nWorldBegin"),
                testing::HasSubstr("expected \"]\", got \"5\""));
    EXPECT_THAT(errorsOf("ConcatTransform [1 0 0]\nWorldBegin"),
                testing::HasSubstr("ConcatTransform takes 16 numbers: expected number 4, got \"]\""));
}

} // namespace
} // namespace vitrine
