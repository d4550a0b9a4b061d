#include "nodes/scene_writer.h"

#include "nodes/parameter_writer.h"

#include <fmt/format.h>

#include <set>

namespace vitrine {

namespace {

class SceneWriter {
  public:
    explicit SceneWriter(const SceneNodes& scene) : scene_(scene) { nameMaterials(); }

    std::string write(const std::vector<std::string>& comments) {
        for (const auto& comment : comments)
            text_ += fmt::format("# {}\n", comment);
        writeOptions();
        text_ += "\nWorldBegin\n\n";
        for (std::size_t i = 0; i < scene_.media.size(); ++i)
            if (static_cast<int>(i) != scene_.camera.medium) writeMedium(scene_.media[i]);
        for (const auto& texture : scene_.floatTextures)
            writeTexture(texture, "float");
        for (const auto& texture : scene_.spectrumTextures)
            writeTexture(texture, "spectrum");
        for (std::size_t i = 0; i < scene_.materials.size(); ++i)
            if (used_.contains(static_cast<int>(i))) writeMaterial(i);
        for (const auto& light : scene_.lights)
            writeLight(light);
        for (const auto& object : scene_.objects) {
            line("ObjectBegin " + quotedString(object.name));
            for (const auto& shape : object.shapes)
                writeShape(shape);
            line("ObjectEnd");
        }
        for (const auto& shape : scene_.shapes)
            writeShape(shape);
        for (const auto& instance : scene_.instances) {
            begin();
            transform(instance.worldFromInstance, instance.place);
            line("ObjectInstance " + quotedString(scene_.objects[std::size_t(instance.object)].name));
            end();
        }
        return std::move(text_);
    }

  private:
    /// Inline materials get names that no named one has. Mix materials refer by name, so all named ones are used.
    void nameMaterials() {
        std::set<std::string> taken;
        for (const auto& [name, index] : scene_.namedMaterials) {
            taken.insert(name);
            used_.insert(index);
        }
        const auto use = [&](const std::vector<ShapeNode>& shapes) {
            for (const auto& shape : shapes)
                if (shape.material > 0) used_.insert(shape.material);
        };
        use(scene_.shapes);
        for (const auto& object : scene_.objects)
            use(object.shapes);
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            std::string name = scene_.materials[i].name;
            if (name.empty()) name = fmt::format("material-{}", i);
            while (scene_.materials[i].name.empty() && taken.contains(name))
                name += "'";
            materialNames_.push_back(std::move(name));
        }
    }

    void line(const std::string& text) { text_ += indent_ + text + '\n'; }
    void begin() {
        line("AttributeBegin");
        indent_ += "  ";
        saved_.push_back(colorSpace_);
    }
    void end() {
        indent_.resize(indent_.size() - 2);
        colorSpace_ = saved_.back();
        saved_.pop_back();
        line("AttributeEnd");
    }

    void transform(const MovingTransformPtr& t, const Place& place) {
        if (!t) return;
        if (t->isMoving()) throw SceneError(place, "transformations that move cannot be written");
        matrix(t->start);
    }
    void matrix(const Transform& t) {
        if (t.isIdentity()) return;
        std::string numbers;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                numbers += fmt::format(" {}", t.matrix()[i][j] + 0.); // -0 becomes 0
        line("Transform [" + numbers + " ]");
    }
    void colorSpace(const std::string& name) {
        if (name == colorSpace_) return;
        line("ColorSpace " + quotedString(name));
        colorSpace_ = name;
    }
    const std::string& mediumName(int index) const {
        static const std::string none;
        return index < 0 ? none : scene_.media[std::size_t(index)].name;
    }
    void media(int inside, int outside) {
        if (inside >= 0 || outside >= 0)
            line(fmt::format("MediumInterface {} {}", quotedString(mediumName(inside)),
                             quotedString(mediumName(outside))));
    }

    /// The parameters of the Attribute directives first, the oldest first, as later ones go before.
    void node(const Node& node, const std::string& directive, const std::string& target) {
        const ParameterList& defaults = node.parameters.defaults();
        for (std::size_t i = defaults.size(); i-- > 0;) {
            colorSpace(defaults[i]->colorSpace);
            line(fmt::format("Attribute \"{}\" {}", target, parameterText(*defaults[i], indent_)));
        }
        colorSpace(node.parameters.colorSpace());
        line(directive);
        for (const auto& parameter : node.parameters.own())
            line("    " + parameterText(*parameter, indent_ + "    "));
    }
    static std::string typed(const std::string& directive, const Node& node) {
        return directive + ' ' + quotedString(node.type);
    }

    void writeOptions() {
        for (const auto& [name, option] : scene_.options)
            line(fmt::format("Option {} {}", quotedString(name),
                             std::visit(
                                 [](const auto& value) {
                                     if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>)
                                         return quotedString(value);
                                     else
                                         return fmt::format("{}", value);
                                 },
                                 option.value)));
        const std::pair<const char*, const Node*> nodes[] = {{"Film", &scene_.film},
                                                             {"PixelFilter", &scene_.filter},
                                                             {"Sampler", &scene_.sampler},
                                                             {"Integrator", &scene_.integrator},
                                                             {"Accelerator", &scene_.accelerator}};
        for (const auto& [directive, each] : nodes)
            if (each->place) node(*each, typed(directive, *each), "");
        const CameraNode& camera = scene_.camera;
        if (camera.worldFromCamera->isMoving())
            throw SceneError(camera.place, "transformations that move cannot be written");
        if (camera.medium >= 0) {
            node(scene_.media[std::size_t(camera.medium)], "MakeNamedMedium " + quotedString(mediumName(camera.medium)),
                 "medium");
            media(-1, camera.medium);
        }
        matrix(camera.worldFromCamera->start.inverse());
        if (camera.place) node(camera, typed("Camera", camera), "");
        if (camera.medium >= 0) line("MediumInterface \"\" \"\"");
    }

    void writeMedium(const MediumNode& medium) {
        begin();
        transform(medium.worldFromMedium, medium.place);
        node(medium, "MakeNamedMedium " + quotedString(medium.name), "medium");
        end();
    }
    void writeTexture(const TextureNode& texture, const std::string& kind) {
        begin();
        transform(texture.worldFromTexture, texture.place);
        node(texture, fmt::format("Texture {} \"{}\" {}", quotedString(texture.name), kind, quotedString(texture.type)),
             "texture");
        end();
    }
    void writeMaterial(std::size_t index) {
        const MaterialNode& material = scene_.materials[index];
        begin();
        // The type of a named one is a parameter that it has already.
        std::string directive = "MakeNamedMaterial " + quotedString(materialNames_[index]);
        if (!material.parameters.has("type")) directive += " \"string type\" " + quotedString(material.type);
        node(material, directive, "material");
        end();
    }
    void writeLight(const LightNode& light) {
        begin();
        transform(light.worldFromLight, light.place);
        media(-1, light.medium);
        node(light, typed("LightSource", light), "light");
        end();
    }
    void writeShape(const ShapeNode& shape) {
        begin();
        transform(shape.worldFromObject, shape.place);
        if (shape.reverseOrientation) line("ReverseOrientation");
        media(shape.insideMedium, shape.outsideMedium);
        if (shape.material > 0) line("NamedMaterial " + quotedString(materialNames_[std::size_t(shape.material)]));
        if (shape.areaLight >= 0) {
            const Node& light = scene_.areaLights[std::size_t(shape.areaLight)];
            node(light, typed("AreaLightSource", light), "light");
        }
        node(shape, typed("Shape", shape), "shape");
        end();
    }

    const SceneNodes& scene_;
    std::vector<std::string> materialNames_;
    std::set<int> used_;
    std::string text_, indent_, colorSpace_ = "srgb";
    std::vector<std::string> saved_;
};

} // namespace

std::string writeScene(const SceneNodes& scene, const std::vector<std::string>& comments) {
    return SceneWriter(scene).write(comments);
}

} // namespace vitrine
