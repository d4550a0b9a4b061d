// A drawing: lines, disks and texts in points (1/72 inch) from its upper left corner, y downwards. svg_writer.h and
// png_writer.h turn the same list into files.
#pragma once

#include "core/vec.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vitrine::plot {

using Imath::Box2d;

struct Colour {
    std::uint8_t r = 0, g = 0, b = 0;
};

struct Pen {
    Colour colour;
    double width = 1, opacity = 1;
    std::vector<double> dashes{}; ///< lengths of strokes and gaps in turn; empty: a solid line
};

struct Brush {
    Colour colour;
    double opacity = 1;
};

/// Straight pieces from point to point.
struct Line {
    std::vector<V2d> points;
    std::optional<Pen> pen;
    std::optional<Brush> brush{}; ///< fills the inside by the even-odd rule, closing the line
};

struct Disk {
    V2d centre;
    double radius;
    Pen pen;
    Brush brush;
};

enum class Anchor { Start, Middle, End };

struct Text {
    V2d at;           ///< on the baseline
    std::string text; ///< with the marks of textRuns()
    double size = 11;
    Anchor anchor = Anchor::Start;
    Colour colour{};
    bool bold = false, upwards = false; ///< turned to be read from below to above
};

/// What is drawn until the matching GroupEnd belongs together under a name, and is cut off outside of `clip`.
struct GroupBegin {
    std::string name;
    std::optional<Box2d> clip;
};
struct GroupEnd {};

class Figure {
  public:
    using Item = std::variant<Line, Disk, Text, GroupBegin, GroupEnd>;

    V2d size{0, 0};

    const std::vector<Item>& items() const { return items_; }

    /// Points that lie within a fiftieth of a point of the line through their neighbours are left out.
    void add(Line line);
    void add(Disk disk) { items_.emplace_back(std::move(disk)); }
    void add(Text text) { items_.emplace_back(std::move(text)); }
    void begin(std::string name, std::optional<Box2d> clip = {}) {
        items_.emplace_back(GroupBegin{std::move(name), clip});
    }
    void end() { items_.emplace_back(GroupEnd{}); }

  private:
    std::vector<Item> items_;
};

/// A stretch of text in one style.
struct TextRun {
    std::string text;
    bool italic = false;
    int level = 0; ///< -1 for a subscript, 1 for a superscript
};

/// Marks in texts: `*x*` is italic, `_{r}` a subscript, `^{2}` a superscript; `\` takes the next character as it is.
std::vector<TextRun> textRuns(const std::string& marked);
/// A text in which nothing is a mark, for names that come from files.
std::string unmarked(const std::string& text);

/// How texts are set: sub- and superscripts are this much smaller, and moved by this much of the size.
inline constexpr double scriptSize = 0.72, subscriptDrop = 0.22, superscriptRise = 0.38;
/// The family that Debian's fontconfig brings along.
inline constexpr const char* fontFamily = "DejaVu Sans";

} // namespace vitrine::plot
