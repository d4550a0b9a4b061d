// Scenes for POV-Ray: a subject as its lathe, and a sphere of the same size, by the subject's own camera.
#pragma once

#include "revolution_subjects.h"

#include <fmt/os.h>

namespace vitrine::bench {

/// Cubics through the ends and end tangents of pieces of each segment, as POV-Ray's lathe knows nothing above degree 3;
/// cubic segments are kept as they are.
inline std::vector<BezierCurve> asCubics(const Subject& subject) {
    constexpr int pieces = 8;
    std::vector<BezierCurve> cubics;
    for (const std::vector<V2d>& points : subject.points) {
        const BezierCurve curve(points);
        if (curve.degree() <= 3) {
            cubics.push_back(curve.degree() < 3 ? curve.elevated(3) : curve);
            continue;
        }
        for (int i = 0; i < pieces; ++i) {
            const double ta = double(i) / pieces, tb = double(i + 1) / pieces;
            const CurvePoint a = curve.evaluate(ta), b = curve.evaluate(tb);
            const double third = (tb - ta) / 3;
            cubics.emplace_back(std::vector<V2d>{a.p, a.p + a.d1 * third, b.p - b.d1 * third, b.p});
        }
    }
    return cubics;
}

/// Writes NAME.pov with the lathe and NAME_sphere.pov into the folder. Light is uniform and no ray is cast but the
/// camera's.
inline void writePovray(const Subject& subject, const std::string& folder) {
    const Pinhole& camera = subject.camera;
    const auto begin = [&](fmt::ostream& out) {
        // POV-Ray's space is left-handed: "right" is negated to see the same picture.
        out.print("#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\nbackground {{ rgb 0 }}\n"
                  "camera {{ perspective location <{}, {}, {}> right -x up y angle {} look_at <{}, {}, {}> }}\n",
                  camera.eye.x, camera.eye.y, camera.eye.z, 2 * degrees(std::atan(camera.tanHalf)), camera.target.x,
                  camera.target.y, camera.target.z);
    };
    const char* look = "  pigment { rgb 1 } finish { ambient 1 diffuse 0 }\n}\n";
    fmt::ostream lathe = fmt::output_file(folder + "/" + subject.name + ".pov");
    begin(lathe);
    const std::vector<BezierCurve> cubics = asCubics(subject);
    lathe.print("lathe {{ bezier_spline {}", 4 * cubics.size());
    for (const BezierCurve& cubic : cubics)
        for (const V2d& p : cubic.points())
            lathe.print(", <{}, {}>", p.x, p.y);
    lathe.print("\n{}", look);
    fmt::ostream sphere = fmt::output_file(folder + "/" + subject.name + "_sphere.pov");
    begin(sphere);
    sphere.print("sphere {{ <{}, {}, {}>, {}\n{}", subject.middle.x, subject.middle.y, subject.middle.z, subject.half.y,
                 look);
}

} // namespace vitrine::bench
