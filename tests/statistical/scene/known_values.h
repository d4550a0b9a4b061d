// What is known in closed form, for whichever integrator is asked.
#pragma once

#include <cmath>
#include <utility>

namespace vitrine {

/// Reflectance at normal incidence between two indices of refraction.
inline double fresnel(double a, double b) {
    return (a - b) * (a - b) / ((a + b) * (a + b));
}

/// Lights, and the irradiance of the plane z = 0 in the origin.
inline const std::pair<const char*, double> lightsOverAFloor[] = {
    {"LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 0 2]\n", 3. / 4},
    {"LightSource \"spot\" \"rgb I\" [3 3 3] \"point3 from\" [0 0 2] \"point3 to\" [0 0 0]\n", 3. / 4},
    {"LightSource \"distant\" \"rgb L\" [2 2 2] \"point3 from\" [1 0 1] \"point3 to\" [0 0 0]\n", 2 * M_SQRT1_2},
    {"LightSource \"infinite\" \"rgb L\" [1 1 1]\n", M_PI},
    // Which of two is chosen is far from even.
    {"LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 0 2]\n"
     "LightSource \"point\" \"rgb I\" [.04 .04 .04] \"point3 from\" [0 0 2]\n",
     3.04 / 4},
    // A ball's irradiance is as if its light came from the middle: pi L r^2 / d^2 (while above the horizon).
    {"AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [4 4 4]\nTranslate 0 0 3\n"
     "Shape \"sphere\" \"float radius\" .5\nAttributeEnd\n",
     M_PI * 4 * .25 / 9},
    {"AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [4 4 4]\nTranslate 0 0 3\nRotate 180 1 0 0\n"
     "Shape \"disk\" \"float radius\" 2\nAttributeEnd\n",
     M_PI * 4 * 4. / (9 + 4)},
    // A revolved lamp: the same disk, turned from a horizontal profile that faces down (object y is world -z).
    {"AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [4 4 4] \"bool twosided\" true\n"
     "Translate 0 0 3\nRotate -90 1 0 0\n"
     "Shape \"revolution\" \"point2 P\" [0 0  2 0]\nAttributeEnd\n",
     M_PI * 4 * 4. / (9 + 4)}};

} // namespace vitrine
