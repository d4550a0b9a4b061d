// Surfaces whose delta lobe lies beside others: what photons bring and what eye paths find must count once.
#include "render_text.h"
#include "support/long_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

/// A floor of varnish and a ball of lacquered metal under a ball of glass, which throws a caustic on both. The lamp is
/// seen in the floor.
std::string sceneOf(const std::string& integrator, const std::string& floor, const std::string& metal) {
    return "LookAt .2 1.1 2.2  .2 .1 0  0 1 0\nCamera \"perspective\" \"float fov\" 30\n"
           "Film \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 16\nSampler \"zsobol\"\n"
           "PixelFilter \"box\"\nIntegrator " +
           integrator + "\nWorldBegin\nMaterial " + floor +
           "\nShape \"bilinearmesh\" \"point3 P\" [-1 0 1.5  1.5 0 1.5  -1 0 -1.5  1.5 0 -1.5]\n"
           "AttributeBegin\nTranslate .55 .25 0\nMaterial " +
           metal +
           "\nShape \"sphere\" \"float radius\" .25\nAttributeEnd\n"
           "AttributeBegin\nTranslate 0 1.5 0\nMaterial \"dielectric\" \"float eta\" 1.6\n"
           "Shape \"sphere\" \"float radius\" .4\nAttributeEnd\n"
           "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [8 8 8]\nTranslate 0 3 0\n"
           "Shape \"sphere\" \"float radius\" .6\nAttributeEnd\n";
}

struct Method {
    const char* name;
    std::string integrator;
    double bias; ///< at most, as a part of the mean
    std::uint64_t passes = 64;
};

struct Coats {
    const char* name;
    std::string floor, metal;
    bool hasDelta; ///< that the camera sees, which light tracing cannot connect to
};

void PrintTo(const Coats& coats, std::ostream* out) {
    *out << coats.name;
}

class CoatedAgreement : public testing::TestWithParam<Coats> {};

TEST_P(CoatedAgreement, WithPathTracing) {
    const auto& [coats, floor, metal, hasDelta] = GetParam();
    const auto work = std::uint64_t(test::longRun());
    const Measured path = measure(sceneOf("\"path\" \"integer maxdepth\" 12", floor, metal), 512 * work);
    const std::string common = "\"integer maxdepth\" 12 \"integer photonsperiteration\" 12000 ",
                      small = common + "\"float radiuspixels\" .4 ";
    // Disks of at most 0.4 pixels of 16 lose light where the ball stands and at outlines some eight pixels long.
    std::vector<Method> methods = {
        {"sppm", "\"sppm\" " + small, 0.004},
        {"all by photons", "\"sppm\" \"bool directbyphotons\" true \"string radiusrule\" \"perpoint\" " + small, 0.004},
        // The same eye paths in all passes: some see the lamp in the floor, so that it takes many of them.
        {"ppm", "\"ppm\" \"integer hitpointsperpixel\" 16 " + small, 0.004, 16}};
    if (!hasDelta) methods.push_back({"lightpath", "\"lightpath\" " + common, 0});
    for (const Method& method : methods) {
        expectAgreement(method.name, measure(sceneOf(method.integrator, floor, metal), method.passes * work), path,
                        method.bias, 0.02);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Coats, CoatedAgreement,
    testing::Values(Coats{"polished", "\"coateddiffuse\" \"rgb reflectance\" [.6 .5 .4]",
                          "\"coatedconductor\" \"float conductor.roughness\" .1 \"float thickness\" .05", true},
                    Coats{"rough",
                          "\"coateddiffuse\" \"rgb reflectance\" [.6 .5 .4] \"float roughness\" .1 "
                          "\"float thickness\" .3 \"rgb albedo\" [.9 .7 .5] \"float g\" .3",
                          "\"coatedconductor\" \"float conductor.roughness\" .15 \"float interface.roughness\" .1",
                          false}),
    [](const auto& coats) { return coats.param.name; });

} // namespace
} // namespace vitrine
