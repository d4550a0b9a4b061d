#include "sample_scenes.h"

#include <array>
#include <fstream>

namespace vitrine::test {

namespace {

constexpr std::array cameras = {
    "LookAt 0.5 1.5 4  0 .5 0  0 1 0\n"
    "Camera \"perspective\" \"float fov\" [ 50 ] \"float lensradius\" .02 \"float focaldistance\" 4\n",
    "LookAt 0 1 5  0 .5 0  0 1 0\n"
    "Camera \"orthographic\" \"float screenwindow\" [ -2 2 -1.5 1.5 ] \"float shutteropen\" 0 \"float shutterclose\" "
    "1\n",
    "Translate 0 -1 0\nCamera \"spherical\" \"string mapping\" \"equirectangular\"\n",
    "Transform [ 1 0 0 0  0 1 0 0  0 0 -1 0  0 0 4 1 ]\n"
    "Camera \"perspective\" \"float fov\" 40 \"float frameaspectratio\" 1.5\n"};
constexpr std::array films = {
    "Film \"rgb\" \"integer xresolution\" 4 \"integer yresolution\" [ 3 ] \"string filename\" \"out.exr\"\n",
    "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 6 \"float cropwindow\" [ .25 .75 0 .5 ] \"float "
    "iso\" 200\n",
    "Film \"rgb\" \"integer xresolution\" 5 \"integer yresolution\" 5 \"integer pixelbounds\" [ 1 4 1 4 ]\n"
    "  \"float maxcomponentvalue\" 10 \"string sensor\" \"cie1931\" \"float diagonal\" 35\n"};
constexpr std::array filters = {
    "PixelFilter \"box\" \"float xradius\" .5 \"float yradius\" .5\n", "PixelFilter \"gaussian\" \"float sigma\" .4\n",
    "PixelFilter \"mitchell\" \"float B\" .3 \"float C\" .3\n",
    "PixelFilter \"sinc\" \"float tau\" 2 \"float xradius\" 3\n", "PixelFilter \"triangle\" \"float xradius\" 1.5\n"};
constexpr std::array samplers = {
    "Sampler \"zsobol\" \"integer pixelsamples\" 2\n",
    "Sampler \"independent\" \"integer pixelsamples\" 1 \"integer seed\" 7\n",
    "Sampler \"stratified\" \"integer xsamples\" 2 \"integer ysamples\" 1 \"bool jitter\" false\n",
    "Sampler \"halton\" \"string randomization\" \"owen\"\n", "Sampler \"pmj02bn\"\nOption \"seed\" 5\n"};
constexpr std::array integrators = {
    "Integrator \"path\" \"integer maxdepth\" 6 \"integer rrdepth\" 2\n",
    "Integrator \"volpath\" \"bool regularize\" true \"string lightsampler\" \"power\"\n",
    "Integrator \"path\" \"bool nee\" false \"integer maxdepth\" [ 3 ]\n"};

constexpr const char* lamp = "LightSource \"point\" \"rgb I\" [ 3 3 3 ] \"point3 from\" [ 1 3 3 ]\n";

constexpr const char* shapes = R"(Shape "sphere" "float radius" .5 "float zmin" -.4 "float zmax" .4 "float phimax" 270
Shape "disk" "float height" .1 "float radius" 1.2 "float innerradius" .2
Shape "cylinder" "float radius" .3 "float zmin" 0 "float zmax" 1.5 "float phimax" 180
Shape "box" "point3 pmin" [ -.2 0 -.2 ] "point3 pmax" [ .2 .5 .2 ]
Shape "plane" "normal n" [ 0 1 0 ] "float d" -1
Shape "plane" "normal n" [ 0 0 1 ] "point3 p" [ 0 0 -4 ]
Shape "revolution" "integer degree" 3 "point2 P" [ 0 0 .4 0 .4 .2 .1 .3  .05 .5 .3 .6 .3 1 ] "float phimax" 300
Shape "revolution" "point2 P" [ .2 0  .5 .2  .1 .4  .3 .9 ]
)";
constexpr const char* meshes = R"(ObjectBegin "pair"
  Material "diffuse" "rgb reflectance" [ .2 .7 .3 ]
  Shape "trianglemesh" "integer indices" [ 0 1 2 2 1 3 ] "point3 P" [ 0 0 0  1 0 0  0 1 0  1 1 .1 ]
    "normal N" [ 0 0 1 0 0 1 0 0 1 0 0 1 ] "point2 uv" [ 0 0 1 0 0 1 1 1 ]
  AttributeBegin
    Translate 0.4 0.35 0.3
    Shape "sphere" "float radius" [ 0.35 ]
  AttributeEnd
ObjectEnd
Shape "bilinearmesh" "point3 P" [ -1 0 2  1 0 2  -1 0 -2  1 .5 -2 ] "point2 uv" [ 0 0 1 0 0 1 1 1 ]
Shape "bilinearmesh" "integer indices" [ 0 1 2 3 ] "point3 P" [ -1 0 2  1 0 2  -1 0 -2  1 0 -2 ]
ObjectInstance "pair"
AttributeBegin
  Translate -1 0 0
  Rotate 30 0 1 0
  Scale .5 .6 .7
  ObjectInstance "pair"
AttributeEnd
)";
constexpr const char* materials =
    R"(Material "dielectric" "spectrum eta" "glass-BK7" "rgb absorption" [ .1 .2 .3 ] "integer priority" 2
Shape "sphere" "float radius" .5
Material "dielectric" "float eta" 1.33 "float roughness" .2 "bool remaproughness" false
Shape "sphere" "float radius" .4
Material "thindielectric" "float eta" 1.6
Shape "box"
Material "conductor" "spectrum eta" "metal-Au-eta" "spectrum k" "metal-Au-k" "float uroughness" .1 "float vroughness" .4
Shape "sphere" "float radius" .3
Material "conductor" "rgb reflectance" [ .9 .8 .7 ]
Shape "disk"
MakeNamedMaterial "red" "string type" "diffuse" "spectrum reflectance" [ 400 .1 500 .2 600 .9 700 .8 ]
NamedMaterial "red"
Shape "disk" "float height" -.5
Material "interface"
Shape "sphere" "float radius" 2
)";
constexpr const char* lights = R"(LightSource "infinite" "blackbody L" 5000 "float scale" .2
LightSource "distant" "rgb L" [ 1 1 .9 ] "point3 from" [ 1 2 1 ] "point3 to" [ 0 0 0 ] "float illuminance" 3
LightSource "point" "spectrum I" [ 400 1 700 2 ] "float power" 10
LightSource "spot" "spectrum I" "stdillum-D65" "point3 from" [ 0 3 0 ] "point3 to" [ 0 0 0 ] "float coneangle" 40 "float conedeltaangle" 8
AttributeBegin
  AreaLightSource "diffuse" "rgb L" [ 5 4 3 ] "bool twosided" true "float scale" .5
  Translate 0 2 0
  Shape "disk" "float radius" .4
  Shape "bilinearmesh" "point3 P" [ -1 1 2  1 1 2  -1 1 -2  1 1.5 -2 ]
AttributeEnd
AttributeBegin
  AreaLightSource "diffuse" "float power" 20
  ReverseOrientation
  Shape "revolution" "point2 P" [ .2 0  .5 .2  .1 .4  .3 .9 ]
  Shape "sphere" "float radius" .2
  Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0  0 1 0 ]
AttributeEnd
Shape "plane"
)";
constexpr const char* blocks = R"(Attribute "shape" "float radius" .7
Attribute "material" "rgb reflectance" [ .3 .4 .5 ]
ColorSpace "rec2020"
CoordinateSystem "here"
Texture "checks" "spectrum" "checkerboard" "rgb tex1" [ 1 0 0 ] "spectrum tex2" [ 400 .1 700 .9 ]
AttributeBegin
  Transform [ 1 0 0 0  0 1 0 0  0 0 1 0  0 .5 0 1 ]
  ConcatTransform [ 2 0 0 0  0 2 0 0  0 0 2 0  0 0 0 1 ]
  MediumInterface "" ""
  Material "diffuse"
  Shape "sphere"
  TransformBegin
    Scale 1 -1 1
    Shape "disk"
  TransformEnd
AttributeEnd
CoordSysTransform "camera"
Shape "sphere" "float radius" .05 # a "comment" [ with brackets
CoordSysTransform "here"
Identity
Shape "cylinder"
)";
constexpr const char* files = R"(Include "part.pbrt"
Import "part.pbrt"
LightSource "infinite" "string filename" "sky.pfm" "float scale" 2
Material "dielectric" "spectrum eta" "eta.spd"
Shape "plymesh" "string filename" "mesh.ply"
)";

} // namespace

std::string sampleHeader(unsigned n) {
    std::string text;
    for (const char* part : {integrators[n % integrators.size()], cameras[n % cameras.size()], films[n % films.size()],
                             filters[n % filters.size()], samplers[n % samplers.size()]})
        text += part;
    return text + "WorldBegin\n";
}

std::vector<SampleScene> sampleScenes() {
    return {{"shapes", sampleHeader(0) + lamp + shapes},       {"meshes", sampleHeader(1) + lamp + meshes},
            {"materials", sampleHeader(2) + lamp + materials}, {"lights", sampleHeader(3) + lights},
            {"blocks", sampleHeader(4) + lamp + blocks},       {"files", sampleHeader(5) + files}};
}

std::string wholeSample() {
    return sampleHeader(0) + lamp + shapes + meshes + materials + lights + blocks + files;
}

void writeSampleFiles(const std::string& folder) {
    const auto write = [&](const char* name, const std::string& text) {
        std::ofstream(folder + "/" + name, std::ios::binary) << text;
    };
    write("part.pbrt", "AttributeBegin\n  Translate 0 .5 0\n  Shape \"sphere\" \"float radius\" .25\nAttributeEnd\n");
    write("eta.spd", "# wavelength, index\n400 1.53\n550 1.52\n700 1.51\n");
    write("mesh.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                      "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
                      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3\n");
    std::string sky = "PF\n4 4\n-1.0\n";
    for (int i = 0; i < 48; ++i) {
        const float value = .25f * float(i % 7);
        sky.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    write("sky.pfm", sky);
}

} // namespace vitrine::test
