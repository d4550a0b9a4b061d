#include "nodes/hints.h"

#include <array>

namespace vitrine {

namespace {

struct Renamed {
    std::string_view family, before, after;
};

constexpr std::array renamedTypes = {
    Renamed{"material", "matte", "diffuse"},
    Renamed{"material", "glass", "dielectric"},
    Renamed{"material", "metal", "conductor"},
    Renamed{"material", "mirror", "conductor"},
    Renamed{"material", "plastic", "coateddiffuse"},
    Renamed{"material", "substrate", "coateddiffuse"},
    Renamed{"material", "uber", "coateddiffuse"},
    Renamed{"material", "disney", "diffuse"},
    Renamed{"material", "translucent", "diffusetransmission"},
    Renamed{"material", "kdsubsurface", "subsurface"},
    Renamed{"material", "none", "interface"},
    Renamed{"area light", "area", "diffuse"},
    Renamed{"film", "image", "rgb"},
    Renamed{"camera", "environment", "spherical"},
    Renamed{"sampler", "random", "independent"},
    Renamed{"sampler", "lowdiscrepancy", "paddedsobol"},
    Renamed{"sampler", "02sequence", "paddedsobol"},
    Renamed{"sampler", "maxmindist", "paddedsobol"},
    Renamed{"integrator", "directlighting", "path"},
    Renamed{"integrator", "whitted", "path"},
    Renamed{"integrator", "mlt", "path"},
    Renamed{"shape", "triangle", "trianglemesh"},
    Renamed{"medium", "heterogeneous", "uniformgrid"},
};

constexpr std::array renamedParameters = {
    Renamed{"", "Kd", "reflectance"},   Renamed{"", "Kr", "reflectance"},
    Renamed{"", "Kt", "transmittance"}, Renamed{"", "index", "eta"},
    Renamed{"", "mapname", "filename"}, Renamed{"", "st", "uv"},
    Renamed{"", "xwidth", "xradius"},   Renamed{"", "ywidth", "yradius"},
    Renamed{"", "nlevels", "levels"},   Renamed{"", "bumpmap", "displacement"},
};

constexpr std::array oldDirectives = {
    Renamed{"", "WorldEnd", "a pbrt-v4 scene ends with its file: remove it"},
    Renamed{"", "SurfaceIntegrator", "pbrt-v4 calls it Integrator"},
    Renamed{"", "VolumeIntegrator", "pbrt-v4 has Integrator \"volpath\""},
    Renamed{"", "Renderer", "pbrt-v4 calls it Integrator"},
    Renamed{"", "Volume", "pbrt-v4 has MakeNamedMedium and MediumInterface"},
    Renamed{"", "SearchPath", "file names are relative to the scene file"},
    Renamed{"", "Shutter", "give the camera \"float shutteropen\" and \"float shutterclose\""},
    Renamed{"", "CoordinateSystemTransform", "pbrt calls it CoordSysTransform"},
};

template <std::size_t N>
std::string_view find(const std::array<Renamed, N>& table, std::string_view family, std::string_view name) {
    for (const auto& entry : table)
        if (entry.family == family && entry.before == name) return entry.after;
    return {};
}

} // namespace

std::string hintForOldDirective(std::string_view name) {
    return std::string(find(oldDirectives, "", name));
}

std::string_view renamedType(std::string_view family, std::string_view name) {
    return find(renamedTypes, family, name);
}

std::string_view renamedParameter(std::string_view name) {
    return find(renamedParameters, "", name);
}

} // namespace vitrine
