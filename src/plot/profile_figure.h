// The figure of a profile: the curve with its control polygon, the curvature comb, both hodographs, curvature over arc
// length; and of a ray that meets it, turned.
#pragma once

#include "plot/figure.h"
#include "plot/ray_section.h"

namespace vitrine::plot {

struct ProfileDrawing {
    std::string title;    ///< what it is and where it stands; with the marks of textRuns()
    std::string subtitle; ///< the same, small, beneath
    std::string unit;     ///< of its coordinates
    std::vector<BezierCurve> segments;
    std::optional<Profile> profile; ///< of the segments; none if they cannot be turned
    std::string fault;              ///< then why not
    double phiMaxDegrees = 360;
    std::optional<Ray> ray; ///< in the profile's space
    std::string rayTitle;   ///< how it was given
};

/// Draws at the lower end of the figure, which grows.
void addProfile(Figure& figure, const ProfileDrawing& drawing);

} // namespace vitrine::plot
