#include "plot/palette.h"
#include "plot/panels.h"

#include <fmt/format.h>

namespace vitrine::plot {

namespace {

struct Column {
    std::string title;
    double at; ///< right edge, in points from the table's left
};

std::string title(const std::vector<RayRoot>& roots) {
    const auto met = std::count_if(roots.begin(), roots.end(), [](const RayRoot& r) { return r.counts(); });
    return met == 0   ? "The ray meets nothing"
           : met == 1 ? "The ray meets the surface once"
                      : fmt::format("The ray meets the surface {} times", met);
}

/// Numbers of one column are written alike: six digits of the largest.
std::string columnText(double x, double largest) {
    const int decimals = largest > 0 ? 5 - int(std::floor(std::log10(largest))) : 5;
    if (decimals < 0 || decimals > 6) return shown(x, 6);
    const std::string text = fmt::format("{:.{}f}", std::abs(x), decimals);
    return x < 0 ? "\u2212" + text : text;
}

constexpr double tableWidth = 300, rowHeight = 15;
constexpr std::size_t maxRows = 60;

} // namespace

double rootTableHeight(std::size_t roots) {
    return rowHeight * double(std::min(roots, maxRows) + 4);
}

void drawRootTable(Figure& figure, const V2d& corner, const std::vector<RayRoot>& roots, double phiMaxDegrees) {
    const Column columns[] = {{"", 14}, {"*s*", 78}, {"segment", 130}, {"*t*", 186}, {"*y*", 243}, {"*d*", tableWidth}};
    figure.begin("root-table");
    figure.add(Text{corner - V2d(0, 21), title(roots), 12, Anchor::Start, ink, true});
    if (roots.empty()) {
        figure.end();
        return;
    }
    RayRoot largest{};
    for (const RayRoot& root : roots) {
        largest.s = std::max(largest.s, std::abs(root.s));
        largest.y = std::max(largest.y, std::abs(root.y));
        largest.d = std::max(largest.d, root.d);
    }
    double y = corner.y + 8;
    const auto rule = [&](double width) {
        figure.add(Line{{V2d(corner.x, y + 5), V2d(corner.x + tableWidth, y + 5)}, Pen{axisInk, width}});
    };
    for (const Column& column : columns)
        figure.add(Text{V2d(corner.x + column.at, y), column.title, 9.5, Anchor::End, ink, true});
    rule(0.8);
    const std::size_t rows = std::min(roots.size(), maxRows);
    bool behind = false, left = false;
    for (std::size_t i = 0; i < rows; ++i) {
        const RayRoot& root = roots[i];
        y += rowHeight;
        const std::string cells[] = {std::to_string(i + 1),         columnText(root.s, largest.s),
                                     std::to_string(root.segment),  fmt::format("{:.6f}", root.t),
                                     columnText(root.y, largest.y), columnText(root.d, largest.d)};
        for (std::size_t k = 0; k < std::size(cells); ++k)
            figure.add(Text{V2d(corner.x + columns[k].at, y + 3), cells[k], 9.5, Anchor::End,
                            root.counts() ? (k == 0 ? rootInk : ink) : faintInk, k == 0});
        behind = behind || root.s <= 0;
        left = left || !root.inSector;
    }
    y += 4;
    rule(0.5);
    std::string note = roots.size() > rows ? fmt::format("and {} more. ", roots.size() - rows) : "";
    if (behind) note += "Hollow: behind the origin. ";
    if (left) note += fmt::format("Hollow: beyond phimax = {}\u00b0.", shown(phiMaxDegrees));
    if (!note.empty()) figure.add(Text{V2d(corner.x, y + 20), note, 9, Anchor::Start, faintInk});
    figure.end();
}

} // namespace vitrine::plot
