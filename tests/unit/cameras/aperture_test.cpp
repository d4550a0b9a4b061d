#include "cameras/aperture.h"
#include "cameras/perspective.h"
#include "core/random.h"

#include <stdexcept>

namespace vitrine {
namespace {

TEST(Aperture, AreasInClosedForm) {
    for (const int n : {3, 4, 5, 8, 100}) {
        const double area = n / 2. * std::sin(2 * piD / n);
        EXPECT_NEAR(PolygonAperture::polygon(n, 13)->inverseDensity(V2d(0.01, 0.02)), area, 1e-12) << n;
    }
    // A pentagram of circumradius 1: ten triangles of sides 1 and (3 - sqrt 5) / 2 about the centre.
    const double inner = (3 - std::sqrt(5.)) / 2;
    EXPECT_NEAR(PolygonAperture::star(5, 0)->inverseDensity(V2d(0, 0.9)), 5 * inner * std::sin(piD / 5), 1e-12);
}

TEST(Aperture, CornersAndSidesLieWhereTheyAreSaidTo) {
    const auto passes = [](const Aperture& aperture, double x, double y) {
        return std::isfinite(aperture.inverseDensity(V2d(x, y)));
    };
    const auto pentagon = PolygonAperture::polygon(5, 0), turned = PolygonAperture::polygon(5, 90);
    EXPECT_TRUE(passes(*pentagon, 0, 0.999)) << "a corner is up";
    EXPECT_FALSE(passes(*pentagon, 0, -0.82)) << "a side is down, at cos 36 degrees";
    EXPECT_TRUE(passes(*pentagon, 0, -0.80));
    EXPECT_TRUE(passes(*turned, -0.999, 0)) << "counterclockwise: up goes to the left";
    const auto square = PolygonAperture::polygon(4, 45);
    EXPECT_TRUE(passes(*square, 0.7, -0.7));
    EXPECT_FALSE(passes(*square, 0, 0.72));
    const auto star = PolygonAperture::star(5, 0);
    EXPECT_TRUE(passes(*star, 0, 0.99));
    EXPECT_FALSE(passes(*star, 0, -0.4)) << "between two points";
    EXPECT_TRUE(passes(*star, 0, -0.38));
    EXPECT_FALSE(passes(*star, 0, 1.01));
}

TEST(Aperture, MaskIsUpright) {
    // One white texel of 2 x 2, top left; turned by 90 degrees it is bottom left.
    const Image image{2, 2, 1, {1, 0, 0, 0}};
    const ImageAperture upright(image, 0), turned(image, 90);
    RandomStream random(3);
    for (int i = 0; i < 1000; ++i) {
        const V2f u(random.uniform(), random.uniform());
        const V2d p = upright.sample(u), q = turned.sample(u);
        EXPECT_TRUE(p.x <= 0 && p.y >= 0) << p;
        EXPECT_TRUE(q.x <= 1e-12 && q.y <= 1e-12) << q;
        EXPECT_NEAR(upright.inverseDensity(p), 1, 1e-6);
    }
    EXPECT_EQ(upright.inverseDensity(V2d(0.5, 0.5)), infinityD);
    EXPECT_EQ(upright.inverseDensity(V2d(-1.1, 0.5)), infinityD);
}

TEST(Aperture, RefusesNonsense) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(PolygonAperture::polygon(2, 0), std::invalid_argument);
    EXPECT_THROW(PolygonAperture::polygon(5, infinityD), std::invalid_argument);
    EXPECT_THROW(PolygonAperture::star(4, 0), std::invalid_argument);
    EXPECT_THROW(ImageAperture(Image{2, 1, 1, {0, 0}}, 0), std::invalid_argument);
    EXPECT_THROW(ImageAperture(Image{2, 1, 1, {1, -1}}, 0), std::invalid_argument);
    EXPECT_THROW(ImageAperture(Image{2, 1, 1, {1, nan}}, 0), std::invalid_argument);
}

/// A lens of any aperture weighs all its rays alike: an even picture keeps its brightness.
TEST(Aperture, RaysKeepTheirWeight) {
    PerspectiveCamera::Settings settings{ScreenWindow(), 50, 0.3, 2, PolygonAperture::star(5, 0)};
    const PerspectiveCamera camera(Transform(), V2i(10, 10), settings);
    RandomStream random(5);
    for (int i = 0; i < 100; ++i) {
        const CameraSample sample{V2d(random.uniform(0, 10), random.uniform(0, 10)),
                                  V2f(random.uniform(), random.uniform())};
        const auto ray = camera.generate(sample);
        ASSERT_TRUE(ray);
        EXPECT_EQ(ray->weight, 1);
        const auto density = camera.density(ray->ray);
        // weight = we cos / (position direction), with the lens across z.
        EXPECT_NEAR(density.we * ray->ray.d.z / (density.position * density.direction), 1, 1e-5);
        EXPECT_TRUE(density.raster.equalWithAbsError(sample.raster, 1e-9));
    }
}

} // namespace
} // namespace vitrine
