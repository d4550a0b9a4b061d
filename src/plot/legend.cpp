#include "plot/palette.h"
#include "plot/panels.h"

namespace vitrine::plot {

V2d addLegendEntry(Figure& figure, const V2d& at, const std::string& text, double room) {
    figure.add(Text{at + V2d(24, 3), text, 9, Anchor::Start, ink});
    return at + V2d(room, 0);
}

void addSegmentKey(Figure& figure, const V2d& at) {
    figure.add(Line{{at, at + V2d(9, 0)}, Pen{segmentInk[0], 2}});
    figure.add(Line{{at + V2d(9, 0), at + V2d(18, 0)}, Pen{segmentInk[1], 2}});
}

} // namespace vitrine::plot
