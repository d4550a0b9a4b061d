// Film, filter and sampler directives, and what the command line says over them.
#include "scene_text.h"

namespace vitrine {
namespace {

const std::string world = "\nWorldBegin\n";

Scene film(const std::string& parameters, const Overrides& overrides = {}) {
    return built("Film \"rgb\" " + parameters + world, overrides);
}

TEST(FilmBuilder, DefaultsAreThoseOfPbrt) {
    const Scene scene = built(world);
    EXPECT_EQ(scene.film.resolution, V2i(1280, 720));
    EXPECT_EQ(scene.film.cropMin, V2i(0, 0));
    EXPECT_EQ(scene.film.cropMax, V2i(1280, 720));
    EXPECT_EQ(scene.film.colorSpace, &RgbColorSpace::srgb());
    EXPECT_EQ(scene.film.maxComponentValue, infinity);
    EXPECT_EQ(scene.film.imagingRatio, 1.f);
    EXPECT_EQ(scene.film.filter.kind, FilterKind::Gaussian);
    EXPECT_EQ(scene.film.filter.radius, V2f(1.5f, 1.5f));
    EXPECT_EQ(scene.film.filter.sigma, 0.5f);
    EXPECT_EQ(scene.samplesPerPixel, 16u);
    EXPECT_EQ(scene.integratorType, "volpath");
    EXPECT_EQ(scene.outputFile, "scene.exr");
}

TEST(FilmBuilder, CropWindowRoundsUpAsPbrtDoes) {
    const Scene scene =
        film("\"integer xresolution\" 10 \"integer yresolution\" 10 \"float cropwindow\" [ .11 .5 0 .95 ]");
    EXPECT_EQ(scene.film.cropMin, V2i(2, 0));
    EXPECT_EQ(scene.film.cropMax, V2i(5, 10));
}

TEST(FilmBuilder, PixelBoundsAreClippedToThePicture) {
    const Scene scene =
        film("\"integer xresolution\" 10 \"integer yresolution\" 10 \"integer pixelbounds\" [ -5 4 3 2000000000 ]");
    EXPECT_EQ(scene.film.cropMin, V2i(0, 3));
    EXPECT_EQ(scene.film.cropMax, V2i(4, 10));
    EXPECT_EQ(errorsOf("Film \"rgb\" \"integer pixelbounds\" [ 2000 3000 0 1 ]" + world),
              Lines{"1:1: error: \"pixelbounds\" lies outside the picture"});
}

TEST(FilmBuilder, ExposureIsShutterTimeTimesIso) {
    const Scene scene = built("Camera \"perspective\" \"float shutteropen\" .5 \"float shutterclose\" 2\n"
                              "Film \"rgb\" \"float iso\" 200" +
                              world);
    EXPECT_FLOAT_EQ(scene.film.imagingRatio, 3.f);
    EXPECT_EQ(errorsOf("Film \"rgb\" \"float iso\" 0" + world), Lines{"1:12: error: \"iso\" must be positive"});
    EXPECT_EQ(errorsOf("Film \"rgb\" \"float iso\" 3e38\nCamera \"perspective\" \"float shutterclose\" 1e10" + world),
              Lines{"1:1: error: exposed for 1e+10 s at ISO 3e+38, no picture is left"});
}

TEST(FilmBuilder, ColorSpaceIsTheOneAtTheDirective) {
    EXPECT_EQ(built("ColorSpace \"rec2020\"\nFilm \"rgb\"\nColorSpace \"srgb\"" + world).film.colorSpace,
              RgbColorSpace::named("rec2020"));
}

TEST(FilmBuilder, EveryFilter) {
    const auto filter = [](const std::string& text) { return built("PixelFilter " + text + world).film.filter; };
    EXPECT_EQ(filter("\"box\"").radius, V2f(.5f, .5f));
    EXPECT_EQ(filter("\"mitchell\"").radius, V2f(2, 2));
    EXPECT_EQ(filter("\"mitchell\" \"float B\" .5 \"float C\" .25").b, .5f);
    EXPECT_EQ(filter("\"sinc\" \"float tau\" 2").tau, 2.f);
    EXPECT_EQ(filter("\"sinc\"").radius, V2f(4, 4));
    EXPECT_EQ(filter("\"triangle\" \"float xradius\" 3").radius, V2f(3, 2));
    EXPECT_EQ(filter("\"gaussian\" \"float sigma\" 1").sigma, 1.f);
    EXPECT_EQ(errorsOf("PixelFilter \"gaussian\" \"float tau\" 1" + world),
              Lines{"1:24: error: unused parameter \"tau\""});
}

TEST(FilmBuilder, EverySamplerNameOfPbrt) {
    for (const char* name : {"halton", "independent", "paddedsobol", "pmj02bn", "sobol", "zsobol"})
        EXPECT_EQ(built("Sampler \"" + std::string(name) + "\" \"integer pixelsamples\" 7" + world).samplesPerPixel, 7u)
            << name;
    EXPECT_EQ(built("Sampler \"stratified\" \"integer xsamples\" 3 \"integer ysamples\" 5" + world).samplesPerPixel,
              15u);
    EXPECT_EQ(errorsOf("Sampler \"stratified\" \"integer pixelsamples\" 5" + world).size(), 1u);
    EXPECT_EQ(
        errorsOf("Sampler \"stratified\" \"integer xsamples\" 2147483647 \"integer ysamples\" 2147483647" + world),
        Lines{"1:1: error: a stratified sampler takes at most 2^24 strata"});
}

TEST(FilmBuilder, CommandLineComesBeforeTheScene) {
    const std::string text = "\"integer xresolution\" 40 \"integer yresolution\" 20 \"float cropwindow\" [ 0 .5 0 .5 ]";
    Overrides overrides;
    overrides.resolution = V2i(10, 8);
    EXPECT_EQ(film(text, overrides).film.cropMax, V2i(5, 4));
    overrides.pixelBounds = {1, 3, 2, 4};
    EXPECT_EQ(film(text, overrides).film.cropMin, V2i(1, 2));
    overrides.cropWindow = {.5, 1, .5, 1};
    EXPECT_EQ(film(text, overrides).film.cropMin, V2i(5, 4)) << "the window before the bounds";
    overrides.samplesPerPixel = 123456;
    EXPECT_EQ(film(text, overrides).samplesPerPixel, 123456u);
    overrides.quick = true;
    EXPECT_EQ(film(text, overrides).film.resolution, V2i(2, 2));
}

} // namespace
} // namespace vitrine
