#include "cameras/orthographic.h"
#include "cameras/perspective.h"
#include "cameras/spherical.h"
#include "film/imageio.h"
#include "scene/film_builder.h"
#include "scene/registry.h"

namespace vitrine {

namespace {

struct CameraInput {
    BuildContext& context;
    const ParameterSet& parameters;
    const Motion& worldFromCamera;
    V2i resolution;
};

ScreenWindow screenWindow(const CameraInput& input) {
    const ParameterSet& p = input.parameters;
    const double aspect = p.getFloat("frameaspectratio", double(input.resolution.x) / input.resolution.y);
    ScreenWindow window = ScreenWindow::ofAspect(aspect);
    const auto given = p.getFloats("screenwindow");
    if (given.size() == 4)
        window = {given[0], given[1], given[2], given[3]};
    else if (!given.empty())
        p.error("screenwindow", "\"screenwindow\" takes four values: xmin xmax ymin ymax");
    return window;
}

AperturePtr imageAperture(const CameraInput& input, const std::string& file, double rotation) {
    const ParameterSet& p = input.parameters;
    try {
        ImageMetadata metadata;
        return std::make_shared<ImageAperture>(readColours(input.context.file(p, "aperture", file), metadata),
                                               rotation);
    } catch (const FileError& e) {
        throw SceneError(p.valuePlace("aperture", 0), e.what(),
                         didYouMean(file, {"circular", "pentagon", "square", "star"}));
    } catch (const std::invalid_argument& e) {
        throw SceneError(p.valuePlace("aperture", 0), e.what());
    }
}

/// Null for the full circle.
AperturePtr aperture(const CameraInput& input) {
    const ParameterSet& p = input.parameters;
    const auto given = p.findString("aperture");
    const int blades = p.getInteger("apertureblades", 0);
    const double rotation = p.getFloat("aperturerotation", 0);
    if (given && p.has("apertureblades"))
        p.error("apertureblades", "a camera takes \"aperture\" or \"apertureblades\", not both");
    if (p.has("apertureblades")) return PolygonAperture::polygon(blades, rotation);
    if (!given || *given == "circular") return nullptr;
    if (*given == "pentagon") return PolygonAperture::polygon(5, rotation);
    if (*given == "square") return PolygonAperture::polygon(4, rotation + 45);
    if (*given == "star") return PolygonAperture::star(5, rotation);
    return imageAperture(input, *given, rotation);
}

/// Screen space's [-1, 1] to [0, 1] after `screenFromCamera` (pbrt-v4's NDCFromWorld, ProjectiveCamera::InitMetadata).
M44d toNdc(M44d screenFromCamera) {
    return screenFromCamera * M44d().setScale(0.5) * M44d().setTranslation(V3d(0.5, 0.5, 0.5));
}

CameraPlan perspective(const CameraInput& input) {
    const ParameterSet& p = input.parameters;
    PerspectiveCamera::Settings s;
    s.window = screenWindow(input);
    s.fov = p.getFloat("fov", 90);
    s.lensRadius = p.getFloat("lensradius", 0);
    s.focalDistance = p.getFloat("focaldistance", 1e6);
    s.aperture = aperture(input);
    // pbrt's clipping planes: they shape z alone.
    constexpr double near = 1e-2, far = 1000;
    const double scale = 1 / std::tan(radians(s.fov) / 2);
    const M44d screenFromCamera(scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, far / (far - near), 1, 0, 0,
                                -far * near / (far - near), 0);
    return {
        std::make_unique<PerspectiveCamera>(input.worldFromCamera, input.resolution, s), {}, toNdc(screenFromCamera)};
}

CameraPlan orthographic(const CameraInput& input) {
    const ParameterSet& p = input.parameters;
    OrthographicCamera::Settings s;
    s.window = screenWindow(input);
    s.lensRadius = p.getFloat("lensradius", 0);
    s.focalDistance = p.getFloat("focaldistance", 1e6);
    s.aperture = aperture(input);
    return {std::make_unique<OrthographicCamera>(input.worldFromCamera, input.resolution, s), {}, toNdc(M44d())};
}

CameraPlan spherical(const CameraInput& input) {
    const ParameterSet& p = input.parameters;
    const std::string mapping = p.getChoice("mapping", "equalarea", {"equalarea", "equirectangular"});
    acceptWithoutEffect(p, {"lensradius", "focaldistance", "frameaspectratio", "screenwindow"}); // as pbrt-v4
    return {std::make_unique<SphericalCamera>(input.worldFromCamera, input.resolution,
                                              mapping == "equalarea" ? SphericalCamera::Mapping::EqualArea
                                                                     : SphericalCamera::Mapping::Equirectangular),
            {},
            {}};
}

using CameraBuilder = CameraPlan (*)(const CameraInput&);
constexpr RegistryEntry<CameraBuilder> cameraTypes[] = {
    {"perspective", perspective}, {"orthographic", orthographic}, {"spherical", spherical}, {"realistic"}};

} // namespace

CameraPlan buildCamera(BuildContext& context, const FilmSettings& film) {
    const CameraNode& node = context.nodes().camera;
    return context.guarded(node, [&] {
        const auto build = findBuilder<CameraBuilder>(cameraTypes, node, "camera");
        const Motion worldFromCamera = motionOf(context, node.worldFromCamera, node.place);
        CameraPlan plan = build({context, node.parameters, worldFromCamera, film.resolution});
        // Times that cannot be are the film's to tell: it reads them for the exposure.
        plan.shutter = {node.parameters.getFloat("shutteropen", 0), node.parameters.getFloat("shutterclose", 1)};
        return plan;
    });
}

} // namespace vitrine
