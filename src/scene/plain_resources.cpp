#include "scene/plain_resources.h"

#include "nodes/parser.h"
#include "scene/rewritten.h"
#include "spectrum/spectrum.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <set>

namespace vitrine {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> fileParameters = {"filename", "normalmap",     "emissionfilename",
                                                            "lensfile", "imagefilename", "aperture"};

class Gatherer {
  public:
    explicit Gatherer(PlainScene& scene) : scene_(scene) {
        for (const auto& mesh : scene.meshes)
            ours_.insert(mesh.fileName);
    }

    void gather(Node& node) {
        node.parameters = rewritten(node, [&](const ParameterPtr& p) {
            const auto* strings = std::get_if<Parameter::Strings>(&p->values);
            return strings && strings->size() == 1 && namesFile(*p, strings->front()) ? moved(*p, strings->front()) : p;
        });
    }

  private:
    bool namesFile(const Parameter& p, const std::string& value) const {
        if (p.type == ParameterType::Spectrum) return !namedSpectrum(value);
        if (p.type != ParameterType::String || ours_.contains(value)) return false;
        const bool known = std::find(fileParameters.begin(), fileParameters.end(), p.name) != fileParameters.end();
        std::error_code ignored; // "aperture" may also be the name of a form
        return known && fs::is_regular_file(resolveFile(scene_.nodes, p.place, value), ignored);
    }

    ParameterPtr moved(const Parameter& p, const std::string& value) {
        auto result = std::make_shared<Parameter>(p);
        result->values = Parameter::Strings{copyOf(resolveFile(scene_.nodes, p.place, value))};
        return result;
    }

    std::string copyOf(const std::string& from) {
        for (const auto& copy : scene_.copies)
            if (copy.from == from) return copy.to;
        const fs::path name = fs::path(from).filename();
        std::string to = (fs::path("resources") / name).string();
        const auto isTaken = [&](const PlainScene::Copy& copy) { return copy.to == to; };
        for (int i = 2; std::any_of(scene_.copies.begin(), scene_.copies.end(), isTaken); ++i)
            to = fmt::format("resources/{}-{}", i, name.string());
        scene_.copies.push_back({from, to});
        return to;
    }

    PlainScene& scene_;
    std::set<std::string> ours_;
};

} // namespace

void gatherResources(PlainScene& scene) {
    Gatherer gatherer(scene);
    SceneNodes& nodes = scene.nodes;
    for (Node* node : {static_cast<Node*>(&nodes.camera), &nodes.sampler, &nodes.integrator, &nodes.filter})
        gatherer.gather(*node);
    const auto all = [&](auto& family) {
        for (auto& node : family)
            gatherer.gather(node);
    };
    all(nodes.shapes);
    for (auto& object : nodes.objects)
        all(object.shapes);
    all(nodes.lights);
    all(nodes.areaLights);
    all(nodes.materials);
    all(nodes.floatTextures);
    all(nodes.spectrumTextures);
    all(nodes.media);
}

} // namespace vitrine
