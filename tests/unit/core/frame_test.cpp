#include "core/frame.h"
#include "core/random.h"
#include "core/sampling.h"

namespace vitrine {
namespace {

void expectOrthonormal(const Frame& f, float tolerance) {
    EXPECT_NEAR(f.s.length(), 1, tolerance);
    EXPECT_NEAR(f.t.length(), 1, tolerance);
    EXPECT_NEAR(f.n.length(), 1, tolerance);
    EXPECT_NEAR(f.s.dot(f.t), 0, tolerance);
    EXPECT_NEAR(f.t.dot(f.n), 0, tolerance);
    EXPECT_NEAR(f.n.dot(f.s), 0, tolerance);
    EXPECT_NEAR((f.s.cross(f.t) - f.n).length(), 0, 2 * tolerance) << "not right-handed";
}

std::vector<V3f> directions() {
    std::vector<V3f> all = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0},    {-1, 0, 0},
                            {0, 1, 0}, {0, -1, 0}, {1, 0, -0.f}, {0, 1, -0.f}};
    // Close to the pole where other constructions divide by zero.
    for (const float e : {1e-3f, 1e-5f, 1e-10f, 1e-30f})
        for (const float z : {1.f, -1.f}) {
            all.push_back(V3f(e, 0, z).normalized());
            all.push_back(V3f(-e, e, z).normalized());
        }
    RandomStream random(1);
    for (int i = 0; i < 1000; ++i)
        all.push_back(sampleUniformSphere(V2f(random.uniform(), random.uniform())));
    return all;
}

TEST(Frame, AboutANormalIsOrthonormal) {
    for (const V3f& n : directions()) {
        SCOPED_TRACE(testing::Message() << n);
        const Frame f(n);
        EXPECT_EQ(f.n, n);
        expectOrthonormal(f, 1e-6f);
    }
}

TEST(Frame, GoesToLocalAndBack) {
    RandomStream random(2);
    for (const V3f& n : directions()) {
        const Frame f(n);
        const V3f v(random.uniform(), random.uniform(), random.uniform());
        EXPECT_NEAR((f.toWorld(f.toLocal(v)) - v).length(), 0, 2e-6f);
        EXPECT_NEAR((f.toLocal(n) - V3f(0, 0, 1)).length(), 0, 1e-6f);
    }
}

TEST(Frame, KeepsTheTangent) {
    const Frame f(V3f(0, 0, 1), V3f(3, 4, 12));
    EXPECT_NEAR((f.s - V3f(0.6f, 0.8f, 0)).length(), 0, 1e-6f);
    expectOrthonormal(f, 1e-6f);
}

TEST(Frame, WithATangentAlmostAlongTheNormalIsStillOrthonormal) {
    RandomStream random(3);
    for (const V3f& n : directions()) {
        const V3f across = Frame(n).s;
        for (const float slope : {1.f, 1e-1f, 1e-2f, 1e-3f, 1e-4f, 1e-5f, 3e-6f, 1e-6f, 1e-7f, 0.f})
            for (const float scale : {1e-6f, 1.f, 1e6f}) {
                SCOPED_TRACE(testing::Message() << n << " slope " << slope << " scale " << scale);
                expectOrthonormal(Frame(n, (n + across * slope) * scale), 2e-6f);
            }
    }
}

TEST(Frame, WithAUselessTangentIsAnyFrame) {
    for (const V3f& tangent : {V3f(0), V3f(infinity, 0, 0), V3f(NAN, 0, 0), V3f(0, 0, 2)})
        expectOrthonormal(Frame(V3f(0, 0, 1), tangent), 1e-6f);
}

} // namespace
} // namespace vitrine
