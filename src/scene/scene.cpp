#include "scene/scene.h"

#include "core/random.h"
#include "nodes/parser.h"
#include "scene/film_builder.h"
#include "scene/integrator_builder.h"
#include "scene/world_builder.h"

#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <fstream>

namespace vitrine {

namespace {

/// A hash of everything that the picture depends on.
class Fingerprint {
  public:
    void add(std::string_view text) {
        for (const char c : text)
            value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
        value_ = mixBits(value_ + goldenGamma + text.size());
    }
    void addFile(const std::string& path) {
        std::ifstream in(path, std::ios::binary);
        std::vector<char> block(1 << 20);
        while (in.read(block.data(), std::streamsize(block.size())) || in.gcount() > 0) {
            const auto size = std::size_t(in.gcount());
            std::uint64_t word = 0;
            for (std::size_t i = 0; i < size; i += sizeof word) {
                word = 0;
                std::memcpy(&word, block.data() + i, std::min(sizeof word, size - i));
                value_ = mixBits(value_ ^ word) + goldenGamma;
            }
        }
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

/// `--set` parameters go to whichever of integrator, film and sampler read them.
struct Settings {
    std::vector<ParameterPtr> parameters;

    void addTo(SceneNodes& nodes) const {
        for (const auto& p : parameters)
            for (Node* node : {&nodes.integrator, &nodes.film, &nodes.sampler})
                node->parameters.addOverride(p);
    }
    void checkRead(const SceneNodes& nodes, Diagnostics& diagnostics) const {
        std::vector<std::string> known;
        for (const Node* node : {&nodes.integrator, &nodes.film, &nodes.sampler})
            for (const auto& name : node->parameters.askedNames())
                known.push_back(name);
        for (const auto& p : parameters)
            if (std::find(known.begin(), known.end(), p->name) == known.end()) {
                Place name = p->place; // of the value, after the name and '='
                name.column = int(name.file->text.rfind(p->name, std::size_t(name.column - 1))) + 1;
                name.length = int(p->name.size());
                diagnostics.error(name,
                                  fmt::format("no integrator, film or sampler parameter is called \"{}\"", p->name),
                                  didYouMean(p->name, known));
            }
    }
};

/// Of pbrt-v4's options those that change the picture or write more files. The others steer how pbrt-v4 itself works.
void refuseOptions(const SceneNodes& nodes, Diagnostics& diagnostics) {
    for (const char* name : {"disablepixeljitter", "disablewavelengthjitter", "forcediffuse", "msereferenceimage",
                             "msereferenceout", "pixelstats"}) {
        const auto option = nodes.options.find(name);
        if (option == nodes.options.end()) continue;
        const bool* isOn = std::get_if<bool>(&option->second.value);
        if (!isOn || *isOn)
            diagnostics.error(option->second.place, fmt::format("option \"{}\" is not yet supported", name));
    }
}

void count(const SceneNodes& nodes, Scene& scene) {
    const auto countShapes = [&](const std::vector<ShapeNode>& shapes) {
        for (const auto& shape : shapes) {
            ++scene.shapeTypes[shape.type];
            if (shape.areaLight >= 0) ++scene.lightTypes["area"];
        }
    };
    countShapes(nodes.shapes);
    for (const auto& object : nodes.objects)
        countShapes(object.shapes);
    for (const auto& light : nodes.lights)
        ++scene.lightTypes[light.type];
    for (const auto& material : nodes.materials)
        if (material.place) ++scene.materialTypes[material.type];
    scene.instances = nodes.instances.size();
    scene.cameraType = nodes.camera.type;
    scene.samplerType = nodes.sampler.type;
}

void describe(const SceneNodes& nodes, const std::optional<M44d>& ndcFromCamera, Scene& scene) {
    scene.metadata = metadataOf(scene.film);
    const M44d worldToCamera = nodes.camera.worldFromCamera->start.inverse().matrix();
    scene.metadata.matrices["worldToCamera"] = worldToCamera;
    if (ndcFromCamera) scene.metadata.matrices["worldToNDC"] = worldToCamera * *ndcFromCamera;
}

/// In the current folder, by the scene's name. Names have dots of their own: glass.v2.pbrt.
std::string defaultOutput(const std::string& sceneName) {
    std::string name = std::filesystem::path(sceneName).filename().string();
    for (const std::string_view ending : {".gz", ".pbrt"})
        if (name.ends_with(ending)) name.resize(name.size() - ending.size());
    return (name.empty() || sceneName == standardInputName ? "vitrine" : name) + ".exr";
}

/// By file and place, as a reader goes through them; builders find them family by family.
std::vector<Diagnostic> inOrder(std::vector<Diagnostic> all,
                                const std::vector<std::shared_ptr<const SourceFile>>& sources) {
    const auto rank = [&](const Diagnostic& d) {
        const auto file = std::find(sources.begin(), sources.end(), d.place.file);
        return std::tuple(file - sources.begin(), d.place.line, d.place.column);
    };
    std::stable_sort(all.begin(), all.end(),
                     [&](const Diagnostic& a, const Diagnostic& b) { return rank(a) < rank(b); });
    // An area light is built for each of its shapes, with the same errors.
    const auto same = [&](const Diagnostic& a, const Diagnostic& b) {
        return rank(a) == rank(b) && a.message == b.message;
    };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    return all;
}

/// What the integrator says of the scene, at its own place.
void checkIntegrator(const Scene& scene, const Node& written, const Overrides& overrides) {
    try {
        scene.integrator->check(scene.world);
    } catch (const std::invalid_argument& e) {
        if (overrides.integrator.empty())
            throw SceneError(written.typePlace ? written.typePlace : written.place, e.what());
        throw SceneError(Place{}, fmt::format("--integrator {}: {}", overrides.integrator, e.what()));
    }
}

Scene buildScene(ParsedScene parsed, const Overrides& overrides) {
    if (parsed.hasErrors && !parsed.nodesTellMore) throw SceneError(std::move(parsed.diagnostics));
    SceneNodes& nodes = parsed.nodes;
    Scene scene;
    scene.name = nodes.name;
    Settings settings;
    for (const auto& text : overrides.settings)
        settings.parameters.push_back(parseSetting(text));
    settings.addTo(nodes);

    if (overrides.textureCacheMegabytes)
        nodes.options["texturecachemb"] = {"texturecachemb", *overrides.textureCacheMegabytes, {}};

    Diagnostics diagnostics;
    for (const auto& d : parsed.diagnostics)
        if (d.severity == Diagnostic::Severity::Error)
            diagnostics.error(d.place, d.message, d.hint);
        else
            diagnostics.warning(d.place, d.message, d.hint);
    refuseOptions(nodes, diagnostics);
    BuildContext context(nodes, diagnostics);
    const FilmPlan film = buildFilm(context, overrides);
    const SamplerPlan sampler = buildSampler(context, overrides);
    scene.film = film.settings;
    scene.samplesPerPixel = sampler.samplesPerPixel;
    IntegratorPlan integrator = buildIntegrator(context, overrides, sampler.settings);
    // The command line comes first.
    if (integrator.passes && !overrides.samplesPerPixel && !overrides.quick)
        scene.samplesPerPixel = *integrator.passes;
    scene.integrator = std::move(integrator.integrator);
    scene.integratorType = overrides.integrator.empty() ? nodes.integrator.type : overrides.integrator;
    // Without a film there is no aspect for the camera: its error is the one to show.
    CameraPlan camera;
    if (scene.film.resolution.x > 0 && scene.film.resolution.y > 0) camera = buildCamera(context, scene.film);
    scene.world = buildWorld(context, integrator.lights, camera.shutter);
    // What an integrator of its own would read is not known where its directive is wrong.
    if (!parsed.hasErrors) settings.checkRead(nodes, diagnostics);
    if (diagnostics.hasErrors()) throw SceneError(inOrder(diagnostics.all(), nodes.sources));

    scene.world.camera = std::move(camera.camera);
    scene.world.prepare();
    checkIntegrator(scene, nodes.integrator, overrides);
    scene.outputFile = film.fileName.empty() ? defaultOutput(nodes.name) : film.fileName;
    for (const auto& d : diagnostics.all())
        scene.warnings.push_back(d);
    count(nodes, scene);
    scene.primitives = context.primitives();
    describe(nodes, camera.ndcFromCamera, scene);

    Fingerprint fingerprint;
    for (const auto& source : nodes.sources) {
        fingerprint.add(source->text);
        scene.files.push_back(source->name);
    }
    for (const auto& file : context.files()) {
        fingerprint.addFile(file);
        scene.files.push_back(file);
    }
    // Not the number of samples: a checkpoint may go on to more.
    for (const auto& text : overrides.settings)
        fingerprint.add(text);
    // Another build may round otherwise: its passes do not belong to the same picture.
    fingerprint.add(VITRINE_VERSION " " VITRINE_ARCH);
    fingerprint.add(fmt::format("{} {} {} {} {} {} {}", scene.integratorType, sampler.settings.seed,
                                int(sampler.settings.kind), scene.film.resolution.x, scene.film.resolution.y,
                                scene.film.cropMin.x, scene.film.cropMin.y));
    scene.fingerprint = fingerprint.value();
    return scene;
}

} // namespace

Scene loadScene(const std::string& file, const Overrides& overrides) {
    return buildScene(readSceneFile(file), overrides);
}

Scene loadSceneString(const std::string& text, const std::string& name, const Overrides& overrides,
                      const std::string& baseDirectory) {
    return buildScene(readSceneString(text, name, baseDirectory), overrides);
}

} // namespace vitrine
