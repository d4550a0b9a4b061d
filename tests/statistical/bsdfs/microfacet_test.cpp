// The distribution of facets against the definitions of Heitz 2014.
#include "bsdf_cases.h"
#include "bsdfs/microfacet.h"
#include "support/chi_squared.h"

#include <gtest/gtest.h>

namespace vitrine::test {
namespace {

// Eq. 4: the facets' projected area is the surface's.
TEST(Microfacet, ProjectedAreaOfTheFacetsIsOne) {
    for (const V2f& alpha : roughnesses()) {
        const TrowbridgeReitz facets(alpha.x, alpha.y);
        EXPECT_NEAR(integrateSphere([&](const V3f& m) { return m.z > 0 ? double(facets.d(m)) * m.z : 0.; }), 1, 2e-4)
            << nameOf(alpha);
    }
}

// Eq. 13 and 16: what w sees of the facets, shadowed by g1, is the surface's own projected area, and visible normals
// are a density.
TEST(Microfacet, VisibleFacetsFillTheProjectedArea) {
    for (const V2f& alpha : roughnesses())
        for (const V3f& w : outgoingDirections()) {
            const TrowbridgeReitz facets(alpha.x, alpha.y);
            const float side = std::copysign(1.f, w.z);
            const double seen = integrateSphere([&](const V3f& m) {
                const double facing = double(w.dot(m)) * side;
                return m.z > 0 && facing > 0 ? facets.g1(w) * facing * facets.d(m) : 0.;
            });
            EXPECT_NEAR(seen / std::abs(w.z), 1, 3e-4) << nameOf(alpha) << ", w " << w;
            const double visible = integrateSphere(
                [&](const V3f& m) { return m.z > 0 && w.dot(m) * side > 0 ? double(facets.visiblePdf(w, m)) : 0.; });
            EXPECT_NEAR(visible, 1, 3e-4) << nameOf(alpha) << ", w " << w;
        }
}

} // namespace
} // namespace vitrine::test
