// A panel: a frame with ticks and labels, and the map from data to the figure.
#pragma once

#include "plot/figure.h"

namespace vitrine::plot {

struct PanelLabels {
    std::string title, note; ///< the note stands beneath the title, small
    std::string x, y;
};

/// Multiples of 1, 2 or 5 times a power of ten that lie in [low, high], about `count` of them.
std::vector<double> tickValues(double low, double high, int count);

/// A number as figures show it: `digits` significant digits, a true minus sign.
std::string shown(double x, int digits = 4);

class Axes {
  public:
    /// Draws frame, grid, ticks and labels; the data box fills the frame.
    Axes(Figure& figure, const Box2d& frame, const Box2d& data, const PanelLabels& labels);

    /// `data` widened so that a unit is as long in x as in y.
    static Box2d equalScale(Box2d data, const Box2d& frame);
    /// `data` with a margin of a part of its size, and of some size even where it has none.
    static Box2d padded(Box2d data, double part);

    V2d at(const V2d& data) const;
    std::vector<V2d> at(const std::vector<V2d>& data) const;
    const Box2d& data() const { return data_; }
    const Box2d& frame() const { return frame_; }
    /// Points of the figure per unit of data.
    V2d scale() const;

  private:
    void drawTicks(Figure& figure) const;

    Box2d frame_, data_;
};

} // namespace vitrine::plot
