// Draws an SvgPath: moves, lines, curves and arcs in absolute coordinates.
#pragma once

#include "nodes/svg_path.h"

namespace vitrine {

class SvgOutline {
  public:
    /// What is drawn from here on stands at these bytes of the text.
    void setSource(std::size_t offset, std::size_t length) {
        offset_ = offset;
        length_ = length;
    }
    /// The current point.
    const V2d& at() const { return at_; }

    void moveTo(const V2d& p);
    void lineTo(const V2d& p);
    void quadTo(const V2d& p1, const V2d& p2);
    void cubicTo(const V2d& p1, const V2d& p2, const V2d& p3);
    /// An elliptical arc by its end points (SVG 2, B.2), its x axis turned by `degrees`: radii of zero make a line,
    /// those that are too small to reach are scaled up.
    void arcTo(V2d radii, double degrees, bool large, bool sweep, const V2d& p);
    /// Back to the start of the subpath, by a line if needed.
    void close();

    SvgPath take();

  private:
    void add(std::span<const V2d> points);
    void finishSubpath(bool closed);

    SvgPath path_;
    SvgSubpath subpath_;
    V2d start_{0, 0}, at_{0, 0};
    std::size_t offset_ = 0, length_ = 1;
};

} // namespace vitrine
