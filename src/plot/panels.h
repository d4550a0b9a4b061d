// The panels of a profile's figure. Each draws into its frame.
#pragma once

#include "plot/axes.h"
#include "plot/profile_figure.h"

namespace vitrine::plot {

/// (radius, height) with control polygon, joints, axis, the other half, and where the ray runs.
void drawProfilePanel(Figure& figure, const Box2d& frame, const ProfileDrawing& drawing);

/// \param order 1 or 2, of the derivative
void drawHodograph(Figure& figure, const Box2d& frame, const ProfileDrawing& drawing, int order);

/// Teeth along the normals, as long as the curvature says, on the side that bulges.
void drawCurvatureComb(Figure& figure, const Box2d& frame, const ProfileDrawing& drawing);

/// Signed curvature over arc length.
void drawCurvature(Figure& figure, const Box2d& frame, const ProfileDrawing& drawing);

/// d_r and d_b over y, for a horizontal ray d over s too, and the table of roots; returns the height used.
double drawRay(Figure& figure, double top, const ProfileDrawing& drawing);

/// Where along the ray and on the profile it meets the surface; the corner is that of the panels' frames.
void drawRootTable(Figure& figure, const V2d& corner, const std::vector<RayRoot>& roots, double phiMaxDegrees);
double rootTableHeight(std::size_t roots);

/// The words of a legend's entry whose key is drawn at `at`, 18 points wide; returns where the next entry begins.
V2d addLegendEntry(Figure& figure, const V2d& at, const std::string& text, double room);
/// The key of a profile: lines in the inks of its segments.
void addSegmentKey(Figure& figure, const V2d& at);

/// Samples of one curve at equal steps of its parameter: dense enough for any figure.
std::vector<V2d> densePoints(const BezierCurve& curve);
inline constexpr int denseSteps = 512;

} // namespace vitrine::plot
