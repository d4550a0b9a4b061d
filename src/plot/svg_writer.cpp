#include "plot/svg_writer.h"

#include <fmt/format.h>

namespace vitrine::plot {

namespace {

/// Hundredths of a point, without trailing zeros.
std::string number(double x) {
    std::string text = fmt::format("{:.2f}", x);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string colour(const Colour& c) {
    return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
}

/// Control characters have no place in XML, not even escaped.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (static_cast<unsigned char>(c) >= ' ')
            result += c;
    }
    return result;
}

std::string stroke(const std::optional<Pen>& pen) {
    if (!pen) return " stroke=\"none\"";
    std::string text = fmt::format(" stroke=\"{}\" stroke-width=\"{}\"", colour(pen->colour), number(pen->width));
    if (pen->opacity < 1) text += fmt::format(" stroke-opacity=\"{}\"", number(pen->opacity));
    if (!pen->dashes.empty()) {
        std::string lengths;
        for (const double length : pen->dashes)
            lengths += number(length) + ' ';
        lengths.pop_back();
        text += fmt::format(" stroke-dasharray=\"{}\"", lengths);
    }
    return text;
}

std::string fill(const std::optional<Brush>& brush) {
    if (!brush) return " fill=\"none\"";
    std::string text = fmt::format(" fill=\"{}\"", colour(brush->colour));
    if (brush->opacity < 1) text += fmt::format(" fill-opacity=\"{}\"", number(brush->opacity));
    return text;
}

class SvgWriter {
  public:
    std::string write(const Figure& figure) {
        const std::string width = number(figure.size.x), height = number(figure.size.y);
        text_ = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}pt\" height=\"{1}pt\" "
                            "viewBox=\"0 0 {0} {1}\" font-family=\"{2}, Verdana, sans-serif\" fill-rule=\"evenodd\" "
                            "stroke-linejoin=\"round\" stroke-linecap=\"round\">\n"
                            "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
                            width, height, fontFamily);
        for (const auto& item : figure.items())
            std::visit([this](const auto& i) { add(i); }, item);
        return text_ + "</svg>\n";
    }

  private:
    void add(const Line& line) {
        const bool closed = line.brush && !line.pen;
        text_ += fmt::format("<{} points=\"", closed ? "polygon" : "polyline");
        for (const V2d& p : line.points)
            text_ += fmt::format("{},{} ", number(p.x), number(p.y));
        text_.back() = '"';
        text_ += fmt::format("{}{}/>\n", fill(line.brush), stroke(line.pen));
    }

    void add(const Disk& disk) {
        text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}{}/>\n", number(disk.centre.x),
                             number(disk.centre.y), number(disk.radius), fill(disk.brush), stroke(disk.pen));
    }

    void add(const Text& text) {
        static constexpr const char* anchors[] = {"start", "middle", "end"};
        const std::string x = number(text.at.x), y = number(text.at.y);
        text_ += fmt::format(
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\" xml:space=\"preserve\"", x, y,
            number(text.size), anchors[int(text.anchor)], colour(text.colour));
        if (text.bold) text_ += " font-weight=\"bold\"";
        if (text.upwards) text_ += fmt::format(" transform=\"rotate(-90 {} {})\"", x, y);
        text_ += '>';
        double shifted = 0; // dy moves all that follows: it is taken back
        for (const TextRun& run : textRuns(text.text)) {
            const double shift = text.size * (run.level < 0 ? subscriptDrop : run.level > 0 ? -superscriptRise : 0);
            std::string style;
            if (run.italic) style += " font-style=\"italic\"";
            if (run.level != 0) style += fmt::format(" font-size=\"{}\"", number(scriptSize * text.size));
            if (shift != shifted) style += fmt::format(" dy=\"{}\"", number(shift - shifted));
            shifted = shift;
            text_ += style.empty() ? escaped(run.text) : fmt::format("<tspan{}>{}</tspan>", style, escaped(run.text));
        }
        text_ += "</text>\n";
    }

    void add(const GroupBegin& group) {
        if (!group.clip) {
            text_ += fmt::format("<g class=\"{}\">\n", group.name);
            return;
        }
        const Box2d& b = *group.clip;
        text_ +=
            fmt::format("<clipPath id=\"clip{0}\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" height=\"{4}\"/></clipPath>\n"
                        "<g class=\"{5}\" clip-path=\"url(#clip{0})\">\n",
                        ++clips_, number(b.min.x), number(b.min.y), number(b.max.x - b.min.x),
                        number(b.max.y - b.min.y), group.name);
    }

    void add(const GroupEnd&) { text_ += "</g>\n"; }

    std::string text_;
    int clips_ = 0;
};

} // namespace

std::string toSvg(const Figure& figure) {
    return SvgWriter().write(figure);
}

} // namespace vitrine::plot
