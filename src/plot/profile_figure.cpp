#include "plot/profile_figure.h"

#include "plot/palette.h"
#include "plot/panels.h"

namespace vitrine::plot {

namespace {

constexpr double width = 980, left = 64, right = 952;

} // namespace

void addProfile(Figure& figure, const ProfileDrawing& drawing) {
    double y = figure.size.y;
    if (y > 0) figure.add(Line{{V2d(28, y), V2d(right, y)}, Pen{gridInk, 1}});
    figure.begin("figure");
    figure.add(Text{V2d(28, y + 32), drawing.title, 16, Anchor::Start, ink, true});
    figure.add(Text{V2d(28, y + 50), drawing.subtitle, 10.5, Anchor::Start, faintInk});
    if (!drawing.profile)
        figure.add(Text{V2d(28, y + 67), "Cannot be turned: " + drawing.fault, 10.5, Anchor::Start, rootInk});
    y += drawing.profile ? 100 : 117;
    drawProfilePanel(figure, Box2d(V2d(left, y), V2d(364, y + 380)), drawing);
    drawCurvatureComb(figure, Box2d(V2d(430, y), V2d(680, y + 380)), drawing);
    drawHodograph(figure, Box2d(V2d(748, y), V2d(right, y + 155)), drawing, 1);
    drawHodograph(figure, Box2d(V2d(748, y + 225), V2d(right, y + 380)), drawing, 2);
    y += 380 + 103;
    drawCurvature(figure, Box2d(V2d(left, y), V2d(right, y + 140)), drawing);
    y += 140 + 52;
    if (drawing.ray && drawing.profile) y += drawRay(figure, y, drawing);
    figure.end();
    figure.size = V2d(width, y);
}

} // namespace vitrine::plot
