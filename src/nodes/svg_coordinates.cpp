#include "nodes/svg_coordinates.h"

#include "nodes/svg_path.h"
#include "nodes/svg_scanner.h"
#include "nodes/transforms.h"

#include <fmt/format.h>

#include <span>

namespace vitrine {

namespace {

M33d affine(double a, double b, double c, double d, double e, double f) {
    return M33d(a, b, 0, c, d, 0, e, f, 1);
}

M33d translation(const V2d& by) {
    return affine(1, 0, 0, 1, by.x, by.y);
}

M33d rotation(double degrees) {
    const double c = cosDegrees(degrees), s = sinDegrees(degrees);
    return affine(c, s, -s, c, 0, 0);
}

double tanDegrees(double degrees) {
    return sinDegrees(degrees) / cosDegrees(degrees);
}

struct TransformFunction {
    std::string_view name;
    std::string_view counts; ///< of arguments that it takes, as digits
    M33d (*make)(std::span<const double>);
};

using Arguments = std::span<const double>;
constexpr TransformFunction functions[] = {
    {"matrix", "6", [](Arguments v) { return affine(v[0], v[1], v[2], v[3], v[4], v[5]); }},
    {"translate", "12", [](Arguments v) { return translation(V2d(v[0], v.size() > 1 ? v[1] : 0)); }},
    {"scale", "12", [](Arguments v) { return affine(v[0], 0, 0, v[v.size() - 1], 0, 0); }},
    {"rotate", "13",
     [](Arguments v) {
         const V2d centre = v.size() > 1 ? V2d(v[1], v[2]) : V2d(0, 0);
         return translation(-centre) * rotation(v[0]) * translation(centre);
     }},
    {"skewX", "1", [](Arguments v) { return affine(1, 0, tanDegrees(v[0]), 1, 0, 0); }},
    {"skewY", "1", [](Arguments v) { return affine(1, tanDegrees(v[0]), 0, 1, 0, 0); }},
};

M33d readFunction(SvgScanner& scan) {
    const std::size_t begin = scan.offset();
    const std::string_view name = scan.name();
    const TransformFunction* function = nullptr;
    for (const TransformFunction& f : functions)
        if (f.name == name) function = &f;
    if (!function)
        throw SvgTextError(begin, std::max<std::size_t>(1, name.size()), "unknown transformation",
                           "the transformations are matrix, translate, scale, rotate, skewX and skewY");
    scan.skipBlanks();
    if (scan.peek() != '(') scan.refuseNext("\"(\"");
    scan.take();
    scan.skipBlanks();
    double values[6];
    std::size_t count = 0;
    for (; scan.startsNumber() && count < 6; ++count) {
        values[count] = scan.number();
        scan.skipSeparator();
    }
    if (scan.peek() != ')') scan.refuseNext("\")\"");
    scan.take();
    if (function->counts.find(char('0' + count)) == std::string_view::npos)
        throw SvgTextError(begin, scan.offset() - begin,
                           fmt::format("{} takes {} numbers, got {}", name,
                                       function->counts.size() == 1
                                           ? std::string(function->counts)
                                           : fmt::format("{} or {}", function->counts[0], function->counts[1]),
                                       count));
    return function->make(Arguments(values, count));
}

struct Unit {
    std::string_view name;
    double pixels;
};
constexpr Unit units[] = {{"", 1},           {"px", 1},         {"in", 96},       {"cm", 96 / 2.54},
                          {"mm", 96 / 25.4}, {"Q", 96 / 101.6}, {"pt", 96. / 72}, {"pc", 16}};

/// Where "Min", "Mid", "Max" put what is left over; `axis` is the "x" or "Y" before it.
double alignment(std::string_view word, std::size_t at, char axis) {
    if (word.size() == 8 && word[at] == axis) {
        const std::string_view place = word.substr(at + 1, 3);
        if (place == "Min") return 0;
        if (place == "Mid") return 0.5;
        if (place == "Max") return 1;
    }
    throw SvgTextError(0, std::max<std::size_t>(1, word.size()), "unknown alignment",
                       "it is \"none\", or \"xMidYMid\" and the like with Min, Mid and Max");
}

} // namespace

V2d transformed(const V2d& p, const M33d& m) {
    return V2d(p.x * m[0][0] + p.y * m[1][0] + m[2][0], p.x * m[0][1] + p.y * m[1][1] + m[2][1]);
}

M33d readSvgTransform(std::string_view text) {
    SvgScanner scan(text);
    M33d all;
    for (scan.skipBlanks(); !scan.atEnd(); scan.skipBlanks()) {
        all = readFunction(scan) * all;
        scan.skipBlanks();
        if (scan.peek() == ',') scan.take();
    }
    return all;
}

double readSvgLength(std::string_view text, double hundredPercent) {
    SvgScanner scan(text);
    scan.skipBlanks();
    const double value = scan.number("a length");
    const std::size_t unitAt = scan.offset();
    double factor = 0;
    if (scan.peek() == '%') {
        scan.take();
        factor = hundredPercent / 100;
    } else {
        const std::string_view name = scan.name();
        for (const Unit& unit : units)
            if (unit.name == name) factor = unit.pixels;
        if (factor == 0)
            throw SvgTextError(unitAt, name.size(), fmt::format("unknown unit \"{}\"", name),
                               "the units are px, in, cm, mm, Q, pt, pc and %");
    }
    scan.skipBlanks();
    if (!scan.atEnd()) scan.refuseNext("one length");
    return value * factor;
}

Imath::Box2d readSvgViewBox(std::string_view text) {
    SvgScanner scan(text);
    double v[4];
    scan.skipBlanks();
    for (double& value : v) {
        value = scan.number("four numbers");
        scan.skipSeparator();
    }
    if (!scan.atEnd()) scan.refuseNext("four numbers");
    if (!(v[2] > 0) || !(v[3] > 0))
        throw SvgTextError(0, text.size(), "width and height of a view box must be positive");
    return {V2d(v[0], v[1]), V2d(v[0] + v[2], v[1] + v[3])};
}

M33d readSvgFit(std::string_view preserveAspectRatio, const Imath::Box2d& viewBox, const V2d& viewport) {
    SvgScanner scan(preserveAspectRatio);
    scan.skipBlanks();
    std::string_view align = scan.name();
    if (align.empty()) align = "xMidYMid";
    scan.skipBlanks();
    const std::size_t fitAt = scan.offset();
    const std::string_view fit = scan.name();
    if (!fit.empty() && fit != "meet" && fit != "slice")
        throw SvgTextError(fitAt, fit.size(), fmt::format("expected \"meet\" or \"slice\", got \"{}\"", fit));
    scan.skipBlanks();
    if (!scan.atEnd()) scan.refuseNext("nothing more");

    V2d scale = viewport / viewBox.size(), left(0, 0);
    if (align != "none") {
        const double uniform = fit == "slice" ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
        scale = V2d(uniform, uniform);
        left = viewport - viewBox.size() * uniform;
        left *= V2d(alignment(align, 0, 'x'), alignment(align, 4, 'Y'));
    }
    return translation(-viewBox.min) * affine(scale.x, 0, 0, scale.y, 0, 0) * translation(left);
}

} // namespace vitrine
