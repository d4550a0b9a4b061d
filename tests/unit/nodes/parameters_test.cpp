#include "nodes/parameters.h"
#include "scene_text.h"

#include <gmock/gmock.h>

namespace vitrine {
namespace {

ParameterSet set(const std::string& text) {
    return ParameterSet(parseParameters(text, "p"), nullptr, "srgb", {});
}

/// What report() says, without the excerpts.
std::vector<std::string> reported(const ParameterSet& parameters) {
    Diagnostics diagnostics;
    parameters.report(diagnostics);
    std::vector<std::string> lines;
    for (const auto& d : diagnostics.all())
        lines.push_back(d.place.toString() + ": " + d.message + (d.hint.empty() ? "" : " - " + d.hint));
    return lines;
}

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Parameters, EveryType) {
    const ParameterSet p =
        set("\"integer i\" 3 \"float f\" [ 1.5 ] \"bool b\" true \"bool d\" \"false\" \"string s\" \"x y\"\n"
            "\"texture t\" \"wood\" \"point2 p2\" [ 1 2 ] \"vector2 v2\" [ 3 4 ] \"point3 p3\" [ 1 2 3 ]\n"
            "\"vector3 v3\" [ 4 5 6 ] \"normal n\" [ 7 8 9 ] \"point q\" [ 1 1 1 ] \"vector w\" [ 2 2 2 ]\n"
            "\"normal3 m\" [ 3 3 3 ] \"rgb c\" [ .1 .2 .3 ] \"blackbody k\" 6500 \"spectrum g\" \"glass-BK7\"\n"
            "\"spectrum r\" [ 400 .5 700 .25 ]");
    EXPECT_EQ(p.getInteger("i", 0), 3);
    EXPECT_EQ(p.getFloat("f", 0), 1.5);
    EXPECT_TRUE(p.getBool("b", false));
    EXPECT_FALSE(p.getBool("d", true));
    EXPECT_EQ(p.getString("s", ""), "x y");
    EXPECT_EQ(p.findTexture("t"), "wood");
    EXPECT_EQ(p.getPoint2("p2", V2d(0)), V2d(1, 2));
    EXPECT_EQ(p.getVector2("v2", V2d(0)), V2d(3, 4));
    EXPECT_EQ(p.getPoint3("p3", V3d(0)), V3d(1, 2, 3));
    EXPECT_EQ(p.getVector3("v3", V3d(0)), V3d(4, 5, 6));
    EXPECT_EQ(p.getNormal("n", V3d(0)), V3d(7, 8, 9));
    EXPECT_EQ(p.getPoint3("q", V3d(0)), V3d(1));
    EXPECT_EQ(p.getVector3("w", V3d(0)), V3d(2));
    EXPECT_EQ(p.getNormal("m", V3d(0)), V3d(3));
    EXPECT_EQ(p.findSpectrum("c")->kind, SpectrumNode::Kind::Rgb);
    EXPECT_THAT(p.findSpectrum("c")->values, ElementsAre(.1, .2, .3));
    EXPECT_EQ(p.findSpectrum("k")->kind, SpectrumNode::Kind::Blackbody);
    EXPECT_THAT(p.findSpectrum("k")->values, ElementsAre(6500));
    EXPECT_EQ(p.findSpectrum("g")->kind, SpectrumNode::Kind::Name);
    EXPECT_EQ(p.findSpectrum("g")->text, "glass-BK7");
    EXPECT_EQ(p.findSpectrum("r")->kind, SpectrumNode::Kind::Pairs);
    EXPECT_THAT(p.findSpectrum("r")->values, ElementsAre(400, .5, 700, .25));
    EXPECT_THAT(reported(p), IsEmpty());
}

TEST(Parameters, WhatIsNotGivenIsTheFallback) {
    const ParameterSet p = set("");
    EXPECT_EQ(p.getFloat("radius", 7), 7);
    EXPECT_FALSE(p.findInteger("n"));
    EXPECT_FALSE(p.findSpectrum("L"));
    EXPECT_FALSE(p.findTexture("t"));
    EXPECT_TRUE(p.getPoint3s("P").empty());
    EXPECT_TRUE(p.getFloats("x").empty());
    EXPECT_FALSE(p.has("radius"));
}

TEST(Parameters, Arrays) {
    const ParameterSet p =
        set("\"point3 P\" [ 0 1 2 3 4 5 ] \"point2 uv\" [ 0 1 .5 .25 ] \"integer indices\" [ 2 1 0 ]\n"
            "\"float x\" [ 1 2 ] \"string s\" [ \"a\" \"b\" ] \"normal N\" [ 0 0 1 ] \"vector3 S\" [ 1 0 0 ]");
    EXPECT_THAT(p.getPoint3s("P"), ElementsAre(V3d(0, 1, 2), V3d(3, 4, 5)));
    EXPECT_THAT(p.getPoint3s<V3f>("P"), ElementsAre(V3f(0, 1, 2), V3f(3, 4, 5)));
    EXPECT_THAT(p.getPoint2s<V2f>("uv"), ElementsAre(V2f(0, 1), V2f(.5f, .25f)));
    EXPECT_THAT(p.getIntegers("indices"), ElementsAre(2, 1, 0));
    EXPECT_THAT(p.getFloats("x"), ElementsAre(1, 2));
    EXPECT_THAT(p.getStrings("s"), ElementsAre("a", "b"));
    EXPECT_THAT(p.getNormals("N"), ElementsAre(V3d(0, 0, 1)));
    EXPECT_THAT(p.getVector3s("S"), ElementsAre(V3d(1, 0, 0)));
    EXPECT_THAT(reported(p), IsEmpty());
}

TEST(Parameters, WrongTypeAndCount) {
    const ParameterSet p =
        set("\"integer radius\" 1\n\"float fov\" [ 1 2 ]\n\"point3 P\" [ 1 2 3 4 ]\n\"rgb L\" [ 1 2 ]\n"
            "\"point3 from\" [ 1 2 ]");
    EXPECT_EQ(p.getFloat("radius", 5), 5);
    EXPECT_EQ(p.getFloat("fov", 6), 6);
    EXPECT_TRUE(p.getPoint3s("P").empty());
    EXPECT_FALSE(p.findSpectrum("L"));
    EXPECT_EQ(p.getPoint3("from", V3d(0)), V3d(0));
    EXPECT_TRUE(p.hasErrors());
    EXPECT_THAT(reported(p),
                ElementsAre("p:1:1: expected \"float radius\", got \"integer radius\"",
                            "p:2:17: \"float fov\" takes 1 value, got 2",
                            "p:3:1: \"point3 P\" takes a multiple of 3 values, got 4",
                            "p:4:1: \"rgb L\" takes 3 values, got 2", "p:5:1: \"point3 from\" takes 3 values, got 2"));
}

TEST(Parameters, SpectraAreChecked) {
    const ParameterSet p =
        set("\"rgb a\" [ 1 -2 0 ]\n\"blackbody b\" 0\n\"spectrum c\" [ 400 1 500 ]\n"
            "\"spectrum d\" [ 400 1 400 2 ]\n\"spectrum e\" [ -1 1 ]\n\"float f\" 1\n\"blackbody g\" [ 5000 2 ]\n"
            "\"spectrum h\" [ \"x\" \"y\" ]");
    for (const char* name : {"a", "b", "c", "d", "e", "f", "g", "h"})
        EXPECT_FALSE(p.findSpectrum(name)) << name;
    EXPECT_THAT(reported(p),
                ElementsAre("p:1:13: \"rgb a\": a colour's components must not be negative",
                            "p:2:15: \"blackbody b\": the temperature must be positive",
                            "p:3:22: \"spectrum c\": needs pairs of wavelength and value, but the last lacks its value",
                            "p:4:22: \"spectrum d\": wavelengths must increase",
                            "p:5:16: \"spectrum e\": wavelengths (nm) must be positive",
                            "p:6:1: expected \"spectrum f\", got \"float f\"",
                            "p:7:22: \"blackbody g\" takes 1 value, got 2",
                            "p:8:20: \"spectrum h\" takes 1 value, got 2"));
}

TEST(Parameters, WhatNobodyReadIsAnError) {
    const ParameterSet p = set("\"float raduis\" 1 \"float zmin\" 2\n\"rgb Kd\" [ 0 0 0 ] \"float unheardof\" 1");
    p.getFloat("radius", 1);
    p.getFloat("zmin", 0);
    p.findSpectrum("reflectance");
    EXPECT_THAT(reported(p), ElementsAre("p:1:1: unused parameter \"raduis\" - did you mean \"radius\"?",
                                         "p:2:1: unused parameter \"Kd\" - pbrt-v4 calls it \"reflectance\"",
                                         "p:2:20: unused parameter \"unheardof\""));
}

TEST(Parameters, HasAndIsDoNotCountAsReading) {
    const ParameterSet p = set("\"float eta\" 1.5");
    EXPECT_TRUE(p.has("eta"));
    EXPECT_TRUE(p.is("eta", ParameterType::Float));
    EXPECT_FALSE(p.is("eta", ParameterType::Spectrum));
    EXPECT_THAT(reported(p), ElementsAre("p:1:1: unused parameter \"eta\""));
}

TEST(Parameters, ErrorsOfTheReaderHavePlaces) {
    const ParameterSet p = set("\"float radius\" -1 \"integer indices\" [\n 0\n 1 7 ] \"string mode\" \"clmp\"");
    p.getFloat("radius", 0);
    p.getIntegers("indices");
    p.error("radius", "too small");
    p.errorAtValue("indices", 2, "out of range");
    p.errorAtValue("indices", 99, "no such value");
    EXPECT_EQ(p.getChoice("mode", "repeat", {"repeat", "clamp"}), "repeat");
    EXPECT_THAT(reported(p), ElementsAre("p:1:1: too small", "p:3:4: out of range", "p:1:19: no such value",
                                         "p:3:22: \"mode\" cannot be \"clmp\" - did you mean \"clamp\"?"));
}

TEST(Parameters, ReportStopsWhenFull) {
    std::string text;
    for (int i = 0; i < 100; ++i)
        text += "\"float p" + std::to_string(i) + "\" 1 ";
    EXPECT_EQ(reported(set(text)).size(), Diagnostics::maxErrors);
}

TEST(Parameters, TextAfterTheListIsRefused) {
    EXPECT_THROW(parseParameters("\"float a\" 1 Shape"), SceneError);
    EXPECT_THROW(parseParameters("\"float a\" 1 2"), SceneError);
    EXPECT_THROW(parseParameters("\"float a\""), SceneError);
    EXPECT_THROW(parseParameters("\"float a\" ["), SceneError);
    EXPECT_THROW(parseParameters("\"bool a\" 1"), SceneError);
    EXPECT_THROW(parseParameters("\"string a\" b"), SceneError);
    EXPECT_THROW(parseParameters("\"spectrum a\" [ 400 1 \"b\" ]"), SceneError);
    EXPECT_THROW(parseParameters("\"untyped a\" \"b\""), SceneError);
}

TEST(Settings, TakeTheTypeTheyAreAskedFor) {
    const auto with = [](const std::string& setting) {
        ParameterSet p = set("\"integer n\" 1 \"float x\" 1 \"float other\" 2");
        p.addOverride(parseSetting(setting));
        return p;
    };
    EXPECT_EQ(with("n=5").getInteger("n", 0), 5);
    EXPECT_EQ(with("x=5").getFloat("x", 0), 5);
    EXPECT_EQ(with("name=out.exr").getString("name", ""), "out.exr");
    EXPECT_EQ(with("name=\"a b\"").getString("name", ""), "a b");
    EXPECT_TRUE(with("flag=true").getBool("flag", false));
    EXPECT_THAT(with("crop=0,.5,0,1").getFloats("crop"), ElementsAre(0, .5, 0, 1));
    EXPECT_THAT(with("crop=0 .5 0 1").getFloats("crop"), ElementsAre(0, .5, 0, 1));
    EXPECT_EQ(with("float x=7").getFloat("x", 0), 7);
    EXPECT_EQ(with("eta=glass-BK7").findSpectrum("eta")->text, "glass-BK7");
    EXPECT_THAT(with("eta=400 1 700 2").findSpectrum("eta")->values, ElementsAre(400, 1, 700, 2));
    EXPECT_TRUE(with("x=5").is("x", ParameterType::Float));
    EXPECT_FALSE(with("x=abc").is("x", ParameterType::Float));
}

TEST(Settings, MayStayUnreadButItIsKnown) {
    ParameterSet p = set("");
    p.addOverride(parseSetting("n=5"));
    EXPECT_THAT(reported(p), IsEmpty());
    EXPECT_FALSE(p.wasRead("n"));
    p.getInteger("n", 0);
    EXPECT_TRUE(p.wasRead("n"));
    EXPECT_THAT(p.askedNames(), ElementsAre("n"));
    EXPECT_TRUE(p.remove("n"));
    EXPECT_FALSE(p.remove("n"));
}

TEST(Settings, ErrorsShowTheSetting) {
    ParameterSet p = set("");
    p.addOverride(parseSetting("maxdepth=deep"));
    p.getInteger("maxdepth", 0);
    Diagnostics diagnostics;
    p.report(diagnostics);
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_EQ(diagnostics.all()[0].toString(),
              "--set:1:10: error: \"integer maxdepth\": expected an integer, got \"deep\"\n"
              "    maxdepth=deep\n"
              "             ^^^^");
    for (const char* text : {"", "maxdepth", "maxdepth=", "=5", "a b c=5", "\"a\"=5", "flaot x=5", "float x=abc"})
        EXPECT_THROW(parseSetting(text), SceneError) << text;
}

} // namespace
} // namespace vitrine
