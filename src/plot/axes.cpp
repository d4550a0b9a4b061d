#include "plot/axes.h"

#include "plot/palette.h"

#include <fmt/format.h>

namespace vitrine::plot {

namespace {

constexpr double tickLength = 4, tickSize = 9, labelSize = 10.5, titleSize = 12, noteSize = 9;

/// The 1, 2 or 5 times a power of ten that is nearest in ratio.
double niceStep(double rough) {
    const double power = std::pow(10, std::floor(std::log10(rough)));
    for (const double factor : {1., 2., 5.})
        if (sqr(rough / power) < factor * (factor == 2 ? 5 : 2 * factor)) return factor * power;
    return 10 * power;
}

/// Ticks of one axis are written alike: with the decimals that their step needs.
std::string tickLabel(double value, double step) {
    const int decimals = int(std::ceil(-std::log10(step) - 1e-9));
    const double largest = std::max(std::abs(value), step);
    if (largest >= 1e5 || decimals > 4) return shown(value, 5);
    std::string text = fmt::format("{:.{}f}", std::abs(value), std::max(decimals, 0));
    return value < 0 ? "\u2212" + text : text;
}

} // namespace

std::vector<double> tickValues(double low, double high, int count) {
    const double step = niceStep((high - low) / count);
    std::vector<double> values;
    for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
        values.push_back(i * step + 0.); // no negative zero
    return values;
}

std::string shown(double x, int digits) {
    if (std::isinf(x)) return x < 0 ? "\u2212\u221e" : "\u221e";
    std::string text = fmt::format("{:.{}g}", std::abs(x), digits);
    if (const auto e = text.find('e'); e != std::string::npos) {
        const int exponent = std::stoi(text.substr(e + 1));
        const std::string power = exponent < 0 ? fmt::format("\u2212{}", -exponent) : fmt::format("{}", exponent);
        text = text.substr(0, e) + "\u00b710^{" + power + "}";
    }
    return x < 0 ? "\u2212" + text : text;
}

Box2d Axes::equalScale(Box2d data, const Box2d& frame) {
    const V2d extent = data.size(), room = frame.size();
    const double unit = std::min(room.x / extent.x, room.y / extent.y);
    const V2d centre = data.center(), half = room / (2 * unit);
    return Box2d(centre - half, centre + half);
}

Box2d Axes::padded(Box2d data, double part) {
    const V2d extent = data.size();
    const double largest = std::max(extent.x, extent.y), some = largest > 0 ? largest / 2 : 1;
    for (int i = 0; i < 2; ++i) {
        const double margin = extent[i] > 1e-9 * largest ? extent[i] * part : some;
        data.min[i] -= margin;
        data.max[i] += margin;
    }
    return data;
}

Axes::Axes(Figure& figure, const Box2d& frame, const Box2d& data, const PanelLabels& labels)
    : frame_(frame), data_(data) {
    figure.begin("axes");
    drawTicks(figure);
    const V2d a = frame.min, b = frame.max;
    figure.add(Line{{a, V2d(b.x, a.y), b, V2d(a.x, b.y), a}, Pen{axisInk, 0.8}});
    figure.add(Text{V2d(a.x, a.y - 21), labels.title, titleSize, Anchor::Start, ink, true});
    figure.add(Text{V2d(a.x, a.y - 7), labels.note, noteSize, Anchor::Start, faintInk});
    figure.add(Text{V2d((a.x + b.x) / 2, b.y + 31), labels.x, labelSize, Anchor::Middle, ink});
    figure.add(Text{V2d(a.x - 39, (a.y + b.y) / 2), labels.y, labelSize, Anchor::Middle, ink, false, true});
    figure.end();
}

V2d Axes::scale() const {
    return frame_.size() / data_.size();
}

V2d Axes::at(const V2d& p) const {
    const V2d s = scale();
    return V2d(frame_.min.x + (p.x - data_.min.x) * s.x, frame_.max.y - (p.y - data_.min.y) * s.y);
}

std::vector<V2d> Axes::at(const std::vector<V2d>& points) const {
    std::vector<V2d> result;
    result.reserve(points.size());
    for (const V2d& p : points)
        result.push_back(at(p));
    return result;
}

void Axes::drawTicks(Figure& figure) const {
    constexpr double apartX = 55, apartY = 36; // so that labels have room
    for (int axis = 0; axis < 2; ++axis) {
        const double length = frame_.size()[axis];
        const int count = std::max(2, int(length / (axis == 0 ? apartX : apartY)));
        const std::vector<double> values = tickValues(data_.min[axis], data_.max[axis], count);
        const double step = values.size() > 1 ? values[1] - values[0] : 1;
        for (double value : values) {
            if (std::abs(value) < 1e-9 * step) value = 0;
            V2d data = data_.min;
            data[axis] = value;
            const V2d p = at(data);
            const V2d across = axis == 0 ? V2d(0, frame_.min.y - frame_.max.y) : V2d(frame_.max.x - frame_.min.x, 0);
            const V2d out = axis == 0 ? V2d(0, tickLength) : V2d(-tickLength, 0);
            figure.add(Line{{p, p + across}, Pen{gridInk, value == 0 ? 1.4 : 0.7}});
            figure.add(Line{{p, p + out}, Pen{axisInk, 0.8}});
            const V2d label = axis == 0 ? p + V2d(0, 15) : p + V2d(-7, 3.2);
            figure.add(Text{label, tickLabel(value, step), tickSize, axis == 0 ? Anchor::Middle : Anchor::End, ink});
        }
    }
}

} // namespace vitrine::plot
