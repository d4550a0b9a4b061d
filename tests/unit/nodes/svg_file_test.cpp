#include "nodes/svg_file.h"
#include "scene_text.h"

#include <fmt/format.h>

#include <cmath>

namespace vitrine {
namespace {

const std::string header = "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://inkscape\">\n";

SvgDrawing drawing(const std::string& content, const std::string& opening = header) {
    return readSvgText(opening + content + "</svg>\n", "a.svg");
}

/// Joints of an element's only subpath.
std::string joints(const SvgElement& element) {
    if (element.fault) return element.fault->message;
    std::string text;
    for (const SvgSegment& s : element.path.subpaths.at(0).segments)
        text += fmt::format("{:.6g},{:.6g} ", s.first().x + 0., s.first().y + 0.);
    const V2d& last = element.path.subpaths[0].segments.back().last();
    return text + fmt::format("{:.6g},{:.6g}", last.x + 0., last.y + 0.);
}

/// Of the only element in some content.
std::string joints(const std::string& content, const std::string& opening = header) {
    const SvgDrawing d = drawing(content, opening);
    EXPECT_EQ(d.elements.size(), 1u);
    return joints(d.elements.at(0));
}

std::string transformed(const std::string& list) {
    return joints("<line x1=\"1\" y1=\"2\" x2=\"3\" y2=\"5\" transform=\"" + list + "\"/>");
}

std::string errorOf(const std::string& text) {
    try {
        readSvgText(text, "a.svg");
        return "none";
    } catch (const SceneError& e) {
        return e.what();
    }
}

std::string chosen(const SvgDrawing& d, const std::optional<std::string>& id) {
    try {
        return d.choose(id, {}).tag;
    } catch (const SceneError& e) {
        return e.what();
    }
}

TEST(SvgFile, EveryTransformation) {
    EXPECT_EQ(transformed(""), "1,2 3,5");
    EXPECT_EQ(transformed("translate(10)"), "11,2 13,5");
    EXPECT_EQ(transformed("translate(10 20)"), "11,22 13,25");
    EXPECT_EQ(transformed("scale(2)"), "2,4 6,10");
    EXPECT_EQ(transformed("scale(2,-3)"), "2,-6 6,-15");
    EXPECT_EQ(transformed("rotate(90)"), "-2,1 -5,3") << "clockwise on the screen, as y points down";
    EXPECT_EQ(transformed("rotate(90 1 2)"), "1,2 -2,4");
    EXPECT_EQ(transformed("matrix(1 2 3 4 5 6)"), "12,16 23,32");
    EXPECT_EQ(transformed("skewX(45)"), "3,2 8,5");
    EXPECT_EQ(transformed("skewY(45)"), "1,3 3,8");
    EXPECT_EQ(transformed(" translate( 10 , 20 ) , scale(2)rotate(90)"), "6,22 0,26") << "the last acts first";
    EXPECT_EQ(transformed("scale(2) translate(10,20)"), "22,44 26,50");
}

TEST(SvgFile, TransformationsOfAllAncestors) {
    EXPECT_EQ(joints("<g transform=\"translate(100,0)\"><a transform=\"scale(2)\"><switch>"
                     "<line transform=\"rotate(90)\" x1=\"1\" y1=\"2\" x2=\"3\" y2=\"5\"/></switch></a></g>"),
              "96,2 90,6");
}

TEST(SvgFile, WrongTransformations) {
    EXPECT_EQ(transformed("turn(90)"), "unknown transformation");
    EXPECT_EQ(transformed("rotate(90 1)"), "rotate takes 1 or 3 numbers, got 2");
    EXPECT_EQ(transformed("matrix(1 2 3)"), "matrix takes 6 numbers, got 3");
    EXPECT_EQ(transformed("scale 2"), "expected \"(\", got \"2\"");
    EXPECT_EQ(transformed("scale(2"), "expected \")\", got the end");
    EXPECT_EQ(transformed("scale(0)"), "the transformation is singular or too large");
    EXPECT_EQ(transformed("skewX(90)"), "the transformation is singular or too large");
    EXPECT_EQ(joints("<line x2=\"1\" style=\"fill:red; transform : rotate(3deg)\"/>"),
              "\"transform\" in a style is not supported");
    EXPECT_EQ(joints("<line x2=\"1\" transform-origin=\"3 4\"/>"), "\"transform-origin\" is not supported");
    EXPECT_EQ(joints("<line x2=\"1\" style=\"text-transform:none\"/>"), "0,0 1,0");
}

TEST(SvgFile, EveryShape) {
    EXPECT_EQ(joints("<path d=\"M1 2h3\"/>"), "1,2 4,2");
    EXPECT_EQ(joints("<polyline points=\"1,2 3,4,5 6\"/>"), "1,2 3,4 5,6");
    EXPECT_EQ(joints("<polygon points=\"1-2 3,4\n5 6\"/>"), "1,-2 3,4 5,6 1,-2");
    EXPECT_EQ(joints("<rect x=\"1\" y=\"2\" width=\"3\" height=\"4\"/>"), "1,2 4,2 4,6 1,6 1,2");
    EXPECT_EQ(joints("<line x1=\"1in\" y2=\"72pt\"/>"), "96,0 0,96");
    EXPECT_EQ(joints("<line x1=\"25.4mm\" y1=\"5.08cm\" x2=\"3pc\" y2=\"406.4Q\"/>"), "96,192 48,384");
}

TEST(SvgFile, CirclesAndEllipses) {
    const SvgDrawing d = drawing("<circle cx=\"1\" cy=\"2\" r=\"3\"/><ellipse rx=\"5\" ry=\"2\"/><ellipse rx=\"5\"/>");
    for (const SvgElement& element : d.elements) {
        ASSERT_FALSE(element.fault);
        const SvgSubpath& subpath = element.path.subpaths.at(0);
        EXPECT_EQ(subpath.segments.size(), 12u);
        EXPECT_TRUE(subpath.closed);
        EXPECT_EQ(subpath.segments.front().first(), subpath.segments.back().last());
    }
    const auto at = [&](std::size_t i, std::size_t quarter) {
        return d.elements[i].path.subpaths[0].segments[3 * quarter].first();
    };
    EXPECT_EQ(at(0, 0), V2d(4, 2));
    EXPECT_EQ(at(0, 1), V2d(1, 5));
    EXPECT_EQ(at(0, 2), V2d(-2, 2));
    EXPECT_EQ(at(1, 1), V2d(0, 2));
    EXPECT_EQ(at(2, 1), V2d(0, 5)) << "one radius stands for both";
}

TEST(SvgFile, RoundedRectangles) {
    const SvgDrawing d = drawing("<rect width=\"10\" height=\"4\" rx=\"1\" ry=\"9\"/>");
    EXPECT_EQ(d.elements[0].path.subpaths[0].segments[0].first(), V2d(1, 0));
    EXPECT_EQ(d.elements[0].path.subpaths[0].segments[3].last(), V2d(10, 2)) << "at most half the height";
    EXPECT_EQ(d.elements[0].path.subpaths[0].segments.size(), 14u) << "two lines and four quarters";
}

TEST(SvgFile, WhatDrawsNothingOrWrongly) {
    EXPECT_EQ(joints("<path/>"), "the path is empty");
    EXPECT_EQ(joints("<path d=\"M3 3\"/>"), "the path draws nothing");
    EXPECT_EQ(joints("<rect width=\"3\"/>"), "the rect draws nothing");
    EXPECT_EQ(joints("<circle/>"), "the circle draws nothing");
    EXPECT_EQ(joints("<circle r=\"-1\"/>"), "\"r\" must not be negative");
    EXPECT_EQ(joints("<circle r=\"2em\"/>"), "unknown unit \"em\"");
    EXPECT_EQ(joints("<circle r=\"two\"/>"), "expected a length, got \"two\"");
    EXPECT_EQ(joints("<circle r=\"2 3\"/>"), "expected one length, got \"3\"");
    EXPECT_EQ(joints("<polyline points=\"1 2 3\"/>"), "expected the y of the last point, got the end");
    EXPECT_EQ(joints("<path transform=\"scale(1e38)\" d=\"M0 0L1e38 1e38\"/>").substr(0, 3), "0,0")
        << "a double has room";
}

TEST(SvgFile, LengthsOfThePage) {
    const auto size = [](const std::string& attributes) {
        return drawing("", "<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">").millimetresPerUnit;
    };
    EXPECT_NEAR(size("").x, 25.4 / 96, 1e-15);
    EXPECT_NEAR(size("width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\"").x, 1, 1e-15);
    EXPECT_NEAR(size("width=\"8in\" viewBox=\"0 0 16 5\"").y, 12.7, 1e-13);
    EXPECT_NEAR(size("height=\"10cm\" viewBox=\"0 0 16 50\"").x, 2, 1e-14);
    EXPECT_NEAR(size("width=\"100%\" viewBox=\"0 0 16 50\"").x, 25.4 / 96, 1e-15);
    EXPECT_NEAR(size("width=\"40mm\" height=\"10mm\" viewBox=\"0 0 10 10\"").x, 1, 1e-15) << "meet";
    EXPECT_NEAR(size("width=\"40mm\" height=\"10mm\" viewBox=\"0 0 10 10\" preserveAspectRatio=\"xMidYMid slice\"").x,
                4, 1e-15);
    const V2d stretched = size("width=\"40mm\" height=\"10mm\" viewBox=\"0 0 10 10\" preserveAspectRatio=\"none\"");
    EXPECT_NEAR(stretched.x, 4, 1e-15);
    EXPECT_NEAR(stretched.y, 1, 1e-15);
    // Coordinates stay as they are written.
    EXPECT_EQ(joints("<line x2=\"50%\" y2=\"50%\"/>", "<svg width=\"10mm\" viewBox=\"5 5 20 40\">"), "0,0 10,20");
}

TEST(SvgFile, NestedViewBoxes) {
    const auto nested = [](const std::string& attributes) {
        return joints("<svg x=\"100\" y=\"200\" width=\"40\" height=\"10\" " + attributes +
                      "><line x1=\"1\" y1=\"1\" x2=\"3\" y2=\"2\"/></svg>");
    };
    EXPECT_EQ(nested(""), "101,201 103,202");
    const std::string box = "viewBox=\"1 1 2 1\" ";
    EXPECT_EQ(nested(box), "110,200 130,210") << "xMidYMid meet";
    EXPECT_EQ(nested(box + "preserveAspectRatio=\"xMinYMin\""), "100,200 120,210");
    EXPECT_EQ(nested(box + "preserveAspectRatio=\"xMaxYMid meet\""), "120,200 140,210");
    EXPECT_EQ(nested(box + "preserveAspectRatio=\"xMidYMid slice\""), "100,195 140,215");
    EXPECT_EQ(nested(box + "preserveAspectRatio=\"xMidYMax slice\""), "100,190 140,210");
    EXPECT_EQ(nested(box + "preserveAspectRatio=\"none\""), "100,200 140,210");
    EXPECT_EQ(nested(box + "transform=\"scale(2)\" preserveAspectRatio=\"none\""), "200,400 280,420");
    EXPECT_EQ(nested(box + "preserveAspectRatio=\"xMidyMid\""), "unknown alignment");
    EXPECT_EQ(nested(box + "preserveAspectRatio=\"none meat\""), "expected \"meet\" or \"slice\", got \"meat\"");
    EXPECT_EQ(nested("viewBox=\"0 0 0 1\""), "width and height of a view box must be positive");
    EXPECT_EQ(nested("viewBox=\"0 0 1\""), "expected four numbers, got the end");
    EXPECT_EQ(joints("<svg viewBox=\"0 0 10 10\"><line x2=\"10%\" y2=\"10\"/></svg>", "<svg viewBox=\"0 0 40 80\">"),
              "0,20 4,60")
        << "as large as what is around it; a tenth of its own view box";
}

TEST(SvgFile, NamespacesCommentsAndReferences) {
    const SvgDrawing prefixed =
        readSvgText("<?xml version=\"1.0\"?><!DOCTYPE svg PUBLIC \"a\" \"b\" [<!ENTITY e \"x\">]>"
                    "<!-- <path/> --><s:svg xmlns:s=\"http://www.w3.org/2000/svg\" "
                    "xmlns:o=\"http://other\"><s:path id=\"a&amp;b\" d='M0 0&#10;h1'/>"
                    "<o:path/><path/><s:style><![CDATA[ <path/> ]]></s:style></s:svg>",
                    "a.svg");
    ASSERT_EQ(prefixed.elements.size(), 1u);
    EXPECT_EQ(prefixed.elements[0].id, "a&b");
    EXPECT_EQ(joints(prefixed.elements[0]), "0,0 1,0");
    EXPECT_EQ(joints("<path d=\"M0 0h1\"/>", "<svg>"), "0,0 1,0") << "without a namespace";
    EXPECT_EQ(drawing("<path d=\"M0 0h1\"/>",
                      "<svg xmlns=\"http://www.w3.org/2000/svg\"><g xmlns=\"http://other\"><path/></g>")
                  .elements.size(),
              1u);
}

TEST(SvgFile, SegmentsAndErrorsKnowTheirBytes) {
    const std::string text = header + "<path d=\"M0 0&#x20;&#10;L1&amp;1\"/><path d=\"M0 0&#10;&#10;h1 v1\"/></svg>";
    const SvgDrawing d = readSvgText(text, "a.svg");
    EXPECT_EQ(d.elements.at(0).fault->toString(),
              "a.svg:2:27: error: expected number 2 of 2 of \"L\", got \"&\"\n"
              "    <path d=\"M0 0&#x20;&#10;L1&amp;1\"/><path d=\"M0 0&#10;&#10;h1 v1\"/></svg>\n"
              "                              ^^^^^");
    std::string where;
    for (const SvgSegment& s : d.elements.at(1).path.subpaths.at(0).segments)
        where += text.substr(s.offset, s.length) + ";" + d.placeOf(s.offset).toString() + ";";
    EXPECT_EQ(where, "h1;a.svg:2:59;v1;a.svg:2:62;");
}

TEST(SvgFile, Choosing) {
    const SvgDrawing d =
        drawing("<g id=\"layer\"><path id=\"body\" d=\"M0 0h1\"/><rect id=\"x1\" inkscape:label=\"foot\" "
                "width=\"1\" height=\"1\"/></g><defs><circle id=\"hidden\" r=\"1\"/></defs>"
                "<use id=\"clone\"/><text id=\"words\"/><line x2=\"1\"/><line id=\"bad\"/>"
                "<line id=\"twice\" x2=\"1\"/><line id=\"twice\" x2=\"1\"/>");
    EXPECT_EQ(chosen(d, "body"), "path");
    EXPECT_EQ(chosen(d, "foot"), "rect");
    EXPECT_EQ(chosen(d, "hidden"), "circle");
    EXPECT_EQ(chosen(d, "bodi"), "error: a.svg has no shape with the id \"bodi\"\n    did you mean \"body\"?");
    EXPECT_EQ(chosen(d, "whatever"), "error: a.svg has no shape with the id \"whatever\"\n"
                                     "    the shapes are \"body\", \"x1\" (\"foot\"), \"hidden\", the line in line 2 "
                                     "(without id), \"bad\", \"twice\", \"twice\"");
    EXPECT_EQ(chosen(d, "clone"), "error: \"clone\" in a.svg is a clone, not a shape\n"
                                  "    Inkscape: Edit > Clone > Unlink Clone");
    EXPECT_EQ(chosen(d, "words"), "error: \"words\" in a.svg is text, not a shape\n"
                                  "    Inkscape: Path > Object to Path, then Ungroup");
    EXPECT_EQ(chosen(d, "layer").substr(0, 50), "error: \"layer\" in a.svg is a group, not a shape\n  ");
    EXPECT_EQ(chosen(d, "twice"), "error: a.svg has 2 shapes with the id \"twice\"");
    EXPECT_EQ(chosen(d, "bad").substr(0, 43), "a.svg:2:195: error: the line draws nothing\n");
    EXPECT_EQ(chosen(d, {}).substr(0, 49), "error: a.svg has 6 shapes: choose one by its id\n ");
}

TEST(SvgFile, TheOnlyShapeNeedsNoId) {
    const std::string shown = "<path d=\"M0 0h1\"/>";
    EXPECT_EQ(chosen(drawing(shown), {}), "path");
    EXPECT_EQ(
        chosen(drawing(shown + "<g style=\"fill:red;display: none\"><rect/></g><g display=\"none\"><rect/></g>"
                               "<rect style=\"display:none\"/><symbol><rect/></symbol><clipPath><rect/></clipPath>"),
               {}),
        "path");
    EXPECT_EQ(chosen(drawing(""), {}), "error: a.svg has no shape that is shown");
    EXPECT_EQ(chosen(drawing(""), "a"),
              "error: a.svg has no shape with the id \"a\"\n    there are no shapes in the file");
}

TEST(SvgFile, WhatIsNoSvg) {
    EXPECT_EQ(errorOf(""), "a.svg:1:1: error: the file is not well-formed XML: no document element found\n    \n    ^");
    EXPECT_EQ(errorOf("<html></html>"),
              "a.svg:1:2: error: the file is no SVG: it begins with \"html\"\n    <html></html>\n     ^^^^");
    EXPECT_EQ(errorOf("<svg>\n<g>\n</svg>"),
              "a.svg:3:3: error: the file is not well-formed XML: start-end tags mismatch\n    </svg>\n      ^");
    EXPECT_EQ(errorOf("<svg viewBox=\"0 0 1\"/>").substr(0, 46), "a.svg:1:20: error: expected four numbers, got ");
    EXPECT_EQ(errorOf("<svg transform=\"scale(2)\"/>"),
              "a.svg:1:17: error: a transformation of the whole file is not supported\n"
              "    <svg transform=\"scale(2)\"/>\n                    ^^^^^^^^");
    EXPECT_NE(errorOf(std::string("<svg>\0</svg>", 12)).find("a NUL byte: this is not the text of an SVG file"),
              std::string::npos);
}

/// As older Illustrators write their namespaces and styles.
TEST(SvgFile, EntitiesOfTheDoctype) {
    const std::string doctype = "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"svg11.dtd\" [\n"
                                "\t<!ENTITY ns_svg \"http://www.w3.org/2000/svg\">\n"
                                "\t<!ENTITY st0 'fill:none;'>\n\t<!ENTITY st1 'transform:scale(2)'>\n]>\n";
    const SvgDrawing d = readSvgText(doctype + "<svg xmlns=\"&ns_svg;\"><path style=\"&st0;\" d=\"M0 0h1\"/>"
                                               "<path style=\"&st0;&st1;\" d=\"M0 0h1\"/></svg>",
                                     "a.svg");
    ASSERT_EQ(d.elements.size(), 2u);
    EXPECT_EQ(joints(d.elements[0]), "0,0 1,0");
    EXPECT_EQ(joints(d.elements[1]), "\"transform\" in a style is not supported");
    EXPECT_EQ(errorOf("<svg xmlns=\"&ns_svg;\"/>"),
              "a.svg:1:2: error: the namespace is the entity \"&ns_svg;\", which the file does not define\n"
              "    <svg xmlns=\"&ns_svg;\"/>\n     ^^^\n    SVG's is xmlns=\"http://www.w3.org/2000/svg\"");
    EXPECT_EQ(errorOf("<svg xmlns=\"http://other\"/>").substr(0, 66),
              "a.svg:1:2: error: the file is no SVG: its namespace is \"http://oth");
}

TEST(SvgFile, StyleSheetsThatWouldMoveOutlines) {
    const auto styled = [](const std::string& sheet, const std::string& attributes = "") {
        return joints("<g class=\"layer one\"><path id=\"p\" class=\"cls-1\" " + attributes +
                      " d=\"M0 0h1\"/></g><style>" + sheet + "</style>");
    };
    const std::string refused = "\"transform\" in a style sheet is not supported";
    for (const char* sheet :
         {"path{transform:translate(50px,0)}", "* { TRANSFORM : rotate(3deg) }", ".cls-1{fill:red;transform:none}",
          "#p{transform:scale(2)}", "rect,g.one > path{transform:scale(2)}", "g { transform:scale(2) }",
          ".layer.one{transform:scale(2)}", "@media all { path:not(.other) { transform:scale(2) } }",
          "svg{transform:scale(2)}", "<![CDATA[ /* } */ path{transform:scale(2)} ]]>", "svg|path{transform:scale(2)}",
          "text{fill:url('a}b')} path{transform:scale(2)}"}) {
        const std::string file = header +
                                 "<g class=\"layer one\"><path id=\"p\" class=\"cls-1\" d=\"M0 0h1\"/></g><style>" +
                                 sheet + "</style></svg>";
        std::string found;
        try {
            found = joints(readSvgText(file, "a.svg").elements.at(0));
        } catch (const SceneError& e) {
            found = e.diagnostics().front().message;
        }
        EXPECT_EQ(found, refused) << sheet;
    }
    EXPECT_EQ(styled("path{d:path('M0 0h2')}"), "\"d\" in a style sheet is not supported");
    for (const char* sheet :
         {"path{fill:red;stroke-width:3;text-transform:none}", ".cls-2{transform:scale(2)}", "#q{x:3px}",
          "text{transform:scale(2)}", ".layer.two{transform:scale(2)}", "/* path{transform:scale(2)} */",
          "@font-face{d:1} @keyframes a{from{transform:scale(2)}}", "svg{width:100%;height:auto}", "path{", "}}{",
          "@media", "path{/*", ""})
        EXPECT_EQ(styled(sheet), "0,0 1,0") << sheet;
    const SvgDrawing d =
        drawing("<style>\n.a{fill:red}\n .b { fill:red; rx : 3px }</style>"
                "<rect class=\"a\" width=\"1\" height=\"1\"/><rect class=\"b\" width=\"1\" height=\"1\"/>");
    EXPECT_FALSE(d.elements.at(0).fault);
    EXPECT_EQ(d.elements.at(1).fault->toString().substr(0, 57),
              "a.svg:4:17: error: \"rx\" in a style sheet is not supported");
}

TEST(SvgFile, IsReadCompressedAndNamesWhoNamedIt) {
    const ScratchDirectory folder;
    const std::string name = folder.write("a.svg", "<svg><g>");
    auto scene = std::make_shared<SourceFile>();
    scene->name = "scene.pbrt";
    try {
        readSvgFile(name, Place{scene, 7, 1});
        FAIL();
    } catch (const SceneError& e) {
        EXPECT_NE(std::string(e.what()).find("\n    included from scene.pbrt:7"), std::string::npos) << e.what();
    }
    EXPECT_THROW(readSvgFile(folder.file("none.svg")), FileError);
}

} // namespace
} // namespace vitrine
