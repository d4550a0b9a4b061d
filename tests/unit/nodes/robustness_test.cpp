// Whatever the text, reading it ends soon, in nodes or in errors.
#include "core/random.h"
#include "scene_text.h"
#include "support/mutate.h"

#include <chrono>

namespace vitrine {
namespace {

const std::string sample = R"(# Every directive that needs no other file.
Option "seed" 3
ColorSpace "rec2020"
TransformTimes 0 .5
Scale -1 1 1
LookAt 0.5 1.2 3.6  0 0.6 0  0 1 0
ActiveTransform EndTime  Rotate 5 0 1 0  ActiveTransform All
MediumInterface "" "fog"
Camera "perspective" "float fov" [ 36 ] "float screenwindow" [ -1 1 -1 1 ]
Sampler "zsobol" "integer pixelsamples" 64
Integrator "path" "integer maxdepth" [ 40 ] "bool regularize" false
PixelFilter "box" "float xradius" [ 0.5 ]
Film "rgb" "integer xresolution" [ 128 ] "string filename" "va\"se.exr"
Accelerator "bvh" "string splitmethod" "sah"
MakeNamedMedium "fog" "string type" "homogeneous" "rgb sigma_a" [ .1 .2 .3 ]
Attribute "shape" "float alpha" 1
WorldBegin
LightSource "infinite" "rgb L" [ .5 .5 .5 ] "float scale" 2
LightSource "point" "blackbody I" 5000 "point3 from" [ 2 3 2 ]
Texture "checks" "spectrum" "checkerboard" "rgb tex1" [ 1 0 0 ] "spectrum tex2" [ 400 .1 700 .9 ]
MakeNamedMaterial "gold" "string type" "conductor" "spectrum eta" "metal-Au-eta" "spectrum k" "metal-Au-k"
Material "diffuse" "texture reflectance" "checks"
Shape "bilinearmesh" "point3 P" [ -1 0 2  1 0 2  -1 0 -2  1 0 -2 ] "point2 uv" [ 0 0 1 0 0 1 1 1 ]
AttributeBegin
  ReverseOrientation
  AreaLightSource "diffuse" "rgb L" [ 80 80 80 ] "bool twosided" "true"
  Transform [ 1 0 0 0  0 1 0 0  0 0 1 0  0 5 0 1 ]
  ConcatTransform [ 2 0 0 0  0 2 0 0  0 0 2 0  0 0 0 1 ]
  Shape "disk" "float radius" .3
AttributeEnd
CoordinateSystem "here"
ObjectBegin "pair"
  NamedMaterial "gold"
  AttributeBegin
    Translate 0.4 0.35 0.3
    Shape "sphere" "float radius" [ 0.35 ]
  AttributeEnd
  Shape "trianglemesh" "integer indices" [ 0 1 2 ] "point3 P" [ 0 0 0  1 0 0  0 1 0 ] "normal N" [ 0 0 1 0 0 1 0 0 1 ]
ObjectEnd
Identity
CoordSysTransform "here"
ObjectInstance "pair"
TransformBegin
  Material "dielectric" "float eta" [ 1.5 ] "vector3 unused" [ 1e-3 -2.5E+2 .5 ]
  Shape "revolution" "integer degree" [ 8 ] "point2 P" [ 0.166666667 0  0.225 0  0.25 0.1  0.25 0.2  0.25 0.3 ]
TransformEnd
)";

/// True when there were no errors. Every error must be valid and not empty.
bool parses(const std::string& text) {
    try {
        parseSceneString(text, "s");
        return true;
    } catch (const SceneError& error) {
        EXPECT_FALSE(error.diagnostics().empty());
        EXPECT_LE(error.diagnostics().size(), Diagnostics::maxErrors + 2) << "errors and few warnings";
        for (const auto& d : error.diagnostics())
            EXPECT_FALSE(d.message.empty());
        return false;
    }
}

double secondsFor(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Robustness, TheSampleItselfIsFine) {
    EXPECT_EQ(errorsOf(sample), "");
}

TEST(Robustness, EveryPrefix) {
    ASSERT_GT(sample.size(), 2000u);
    std::size_t complete = 0;
    for (std::size_t n = 0; n < sample.size(); ++n)
        complete += parses(sample.substr(0, n));
    EXPECT_GT(complete, 20u) << "those that end behind a directive of the world, outside every block";
    EXPECT_LT(complete, sample.size() / 2);
    EXPECT_FALSE(parses(sample.substr(0, sample.find("WorldBegin"))));
}

std::string mutated(std::uint64_t number) {
    static const std::vector<std::string> pieces = {"\"",
                                                    "[",
                                                    "]",
                                                    "#",
                                                    "\\",
                                                    "\n",
                                                    "nan",
                                                    "1e999",
                                                    "-",
                                                    "Shape",
                                                    "\"]",
                                                    "WorldBegin",
                                                    "\x80",
                                                    "\xff",
                                                    "true",
                                                    "0",
                                                    "ObjectEnd",
                                                    "AttributeEnd",
                                                    "Include \"s\"",
                                                    "99999999999",
                                                    "\"float x\" "};
    return test::mutated(sample, pieces, {8, 60}, RandomStream(20181, number));
}

TEST(Robustness, TwentyThousandMutations) {
    int fine = 0;
    for (std::uint64_t i = 0; i < 20000; ++i)
        fine += parses(mutated(i));
    EXPECT_GT(fine, 200) << "some changes do no harm";
    EXPECT_LT(fine, 15000) << "most do";
}

TEST(Robustness, RandomBytes) {
    for (std::uint64_t i = 0; i < 300; ++i) {
        RandomStream random(7, i);
        std::string text(1 + random.bits() % 3000, ' ');
        for (char& c : text)
            c = char(1 + random.bits() % 255);
        EXPECT_FALSE(parses(text));
    }
}

std::string repeated(const std::string& piece, int n) {
    std::string text;
    text.reserve(piece.size() * std::size_t(n));
    for (int i = 0; i < n; ++i)
        text += piece;
    return text;
}

// The bounds in seconds tell a quadratic reader (minutes) from a linear one on a busy machine; they are no benchmark.
constexpr double soon = 20;

TEST(Robustness, DeepNesting) {
    constexpr int n = 1000000;
    EXPECT_LT(secondsFor([] {
                  EXPECT_TRUE(parses("WorldBegin\n" + repeated("AttributeBegin\n", n) + repeated("AttributeEnd\n", n)));
                  EXPECT_FALSE(parses("WorldBegin\n" + repeated("AttributeBegin Translate 1 0 0\n", n / 4)));
                  EXPECT_FALSE(parses("WorldBegin\n" + repeated("AttributeEnd ", n)));
              }),
              soon);
}

TEST(Robustness, MuchGarbageIsSkippedInLinearTime) {
    constexpr int n = 300000;
    EXPECT_LT(secondsFor([] {
                  EXPECT_FALSE(parses("WorldBegin\nFoo " + repeated("\"bar\nbaz [ 1 2\n", n)));
                  EXPECT_FALSE(parses("WorldBegin\nFoo " + repeated("[", n * 10)));
                  EXPECT_FALSE(parses("WorldBegin\nFoo " + std::string(std::size_t(n) * 10, 'x')));
                  EXPECT_FALSE(parses("WorldBegin\nShape \"" + std::string(std::size_t(n) * 10, '\\')));
              }),
              soon);
}

TEST(Robustness, ManyOfEverythingIsLinear) {
    constexpr int n = 100000;
    std::string text = "WorldBegin\n";
    for (int i = 0; i < n; ++i) {
        const std::string name = "\"n" + std::to_string(i) + "\" ";
        text += "MakeNamedMaterial " + name + "\"string type\" \"diffuse\" NamedMaterial " + name +
                "Attribute \"shape\" \"float p" + std::to_string(i % 90) + "\" 1 Shape \"sphere\" Texture " + name +
                "\"float\" \"constant\"\n";
    }
    EXPECT_LT(secondsFor([&] { EXPECT_EQ(parseSceneString(text).shapes.size(), std::size_t(n)); }), soon);
    std::string parameters = "WorldBegin\nShape \"sphere\" ";
    for (int i = 0; i < n; ++i)
        parameters += "\"float p" + std::to_string(i) + "\" 1 ";
    EXPECT_LT(secondsFor([&] { EXPECT_TRUE(parses(parameters)); }), soon);
    std::string attributes;
    for (int i = 0; i < n; ++i)
        attributes += "Attribute \"shape\" \"float p" + std::to_string(i) + "\" 1 ";
    EXPECT_LT(secondsFor([&] { EXPECT_FALSE(parses(attributes)) << "more than a state holds"; }), soon);
}

TEST(Robustness, AMillionTriangles) {
    constexpr int columns = 1000, rows = 500;
    std::string text = "WorldBegin\nShape \"trianglemesh\" \"point3 P\" [\n";
    for (int y = 0; y <= rows; ++y)
        for (int x = 0; x <= columns; ++x)
            text += "0." + std::to_string(100000 + x) + " -0.0" + std::to_string(10000 + y) + " 1." +
                    std::to_string(x * y) + "e-2\n";
    text += "] \"integer indices\" [\n";
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const int a = y * (columns + 1) + x, c = a + columns + 1;
            for (int i : {a, a + 1, c, c, a + 1, c + 1})
                text += std::to_string(i) + " ";
        }
    text += "]\n";
    SceneNodes scene;
    const double seconds = secondsFor([&] { scene = parseSceneString(std::move(text)); });
    EXPECT_EQ(scene.shapes.at(0).parameters.getIntegers("indices").size(), 3000000u);
    EXPECT_EQ(scene.shapes.at(0).parameters.getPoint3s<V3f>("P").size(), 501501u);
    EXPECT_LT(seconds, 4) << "2 s on a quiet machine";
    RecordProperty("milliseconds", int(seconds * 1000));
}

TEST(Robustness, ErrorsAreValidText) {
    const std::string errors = errorsOf("WorldBegin\n\x80\xff\x01"
                                        "foo \"\xc3\"\nShape \"sphere\" \"float \xfe\" \x07");
    EXPECT_NE(errors.find("unknown directive \"\\x80\\xff\\x01foo\""), std::string::npos) << errors;
    EXPECT_NE(errors.find("expected a number, got \"\\x07\""), std::string::npos) << errors;
}

} // namespace
} // namespace vitrine
