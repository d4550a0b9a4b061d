#include "scene/context.h"

#include "nodes/parser.h"
#include "nodes/spd.h"
#include "textures/constant.h"

#include <fmt/format.h>

#include <filesystem>

namespace vitrine {

namespace {

void recordUnsupported(const ParameterSet& parameters, std::string_view name, std::string_view what) {
    parameters.error(name, fmt::format("{} \"{}\" is not yet supported", what, name));
}

SpectrumPtr fromPairs(const std::vector<double>& lambdas, const std::vector<double>& values) {
    return std::make_shared<PiecewiseLinearSpectrum>(std::vector<float>(lambdas.begin(), lambdas.end()),
                                                     std::vector<float>(values.begin(), values.end()));
}

SpectrumPtr fromRgb(const ParameterSet& parameters, std::string_view name, const SpectrumNode& node, SpectrumUse use) {
    const RgbColorSpace* space = RgbColorSpace::named(node.colorSpace);
    if (!space) throw SceneError(node.place, fmt::format("unknown colour space \"{}\"", node.colorSpace));
    const Rgb rgb(float(node.values[0]), float(node.values[1]), float(node.values[2]));
    switch (use) {
    case SpectrumUse::Illuminant:
        return std::make_shared<RgbIlluminantSpectrum>(*space, rgb);
    case SpectrumUse::Unbounded:
        return std::make_shared<RgbUnboundedSpectrum>(*space, rgb);
    case SpectrumUse::Albedo:
        break;
    }
    if (std::max({rgb.x, rgb.y, rgb.z}) > 1)
        parameters.error(name, fmt::format("\"rgb {}\" is a reflectance: its values must lie in [0, 1]", name));
    return std::make_shared<RgbAlbedoSpectrum>(*space, rgb);
}

} // namespace

std::string BuildContext::file(const ParameterSet& parameters, std::string_view name, const std::string& value) {
    std::string path = resolveFile(nodes_, parameters.place(name), value);
    files_.insert(path);
    return path;
}

SpectrumPtr BuildContext::namedOrFile(const SpectrumNode& node) {
    if (auto named = namedSpectrum(node.text)) return named;
    const std::string path = resolveFile(nodes_, node.place, node.text);
    // By path: the same text means another file in an included scene of another folder.
    auto& spectrum = spectra_[path];
    if (spectrum) return spectrum;
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) {
        spectra_.erase(path);
        throw SceneError(node.place, fmt::format("\"{}\" is neither a named spectrum nor a file", node.text),
                         didYouMean(node.text, namedSpectra()));
    }
    const SpdSamples samples = readSpd(path);
    files_.insert(path);
    return spectrum = fromPairs(samples.wavelengths, samples.values);
}

SpectrumPtr findSpectrum(BuildContext& context, const ParameterSet& parameters, std::string_view name,
                         SpectrumUse use) {
    if (use != SpectrumUse::Illuminant && parameters.is(name, ParameterType::Float)) {
        const auto value = parameters.findFloat(name);
        return value ? std::make_shared<ConstantSpectrum>(float(*value)) : nullptr;
    }
    const auto node = parameters.findSpectrum(name);
    if (!node) return nullptr;
    try {
        switch (node->kind) {
        case SpectrumNode::Kind::Rgb:
            return fromRgb(parameters, name, *node, use);
        case SpectrumNode::Kind::Blackbody:
            return std::make_shared<BlackbodySpectrum>(float(node->values[0]));
        case SpectrumNode::Kind::Name:
            return context.namedOrFile(*node);
        case SpectrumNode::Kind::Pairs:
            break;
        }
        std::vector<double> lambdas, values;
        for (std::size_t i = 0; i + 1 < node->values.size(); i += 2) {
            lambdas.push_back(node->values[i]);
            values.push_back(node->values[i + 1]);
        }
        return fromPairs(lambdas, values);
    } catch (const std::invalid_argument& e) {
        parameters.error(name, e.what());
    } catch (const FileError& e) {
        parameters.error(name, e.what());
    } catch (const SceneError& e) {
        for (const auto& d : e.diagnostics())
            context.diagnostics().error(d.place, d.message, d.hint);
    }
    return nullptr;
}

SpectrumInput findSpectrumInput(BuildContext& context, const ParameterSet& parameters, std::string_view name,
                                SpectrumUse use) {
    if (const auto texture = parameters.findTexture(name))
        return context.textures().findSpectrum(parameters, name, *texture, use);
    return findSpectrum(context, parameters, name, use);
}

std::optional<FloatInput> findFloatInput(BuildContext& context, const ParameterSet& parameters, std::string_view name) {
    if (const auto texture = parameters.findTexture(name)) {
        const FloatTexturePtr found = context.textures().findFloat(parameters, name, *texture);
        if (!found) return std::nullopt;
        // What is the same everywhere may be checked once, and costs nothing to look up.
        if (const auto* same = dynamic_cast<const ConstantTexture<FloatInput>*>(found.get()))
            return FloatInput(same->evaluate({}));
        return FloatInput(found);
    }
    const auto value = parameters.findFloat(name);
    return value ? std::optional(FloatInput(float(*value))) : std::nullopt;
}

void refuse(const ParameterSet& parameters, std::initializer_list<std::string_view> names) {
    for (const auto name : names)
        if (parameters.has(name)) {
            acceptWithoutEffect(parameters, {name});
            recordUnsupported(parameters, name, "parameter");
        }
}

void acceptWithoutEffect(const ParameterSet& parameters, std::initializer_list<std::string_view> names) {
    // Asked for by each of the types that pbrt-v4 has under these names; only the one given matches.
    for (const auto name : names) {
        if (parameters.is(name, ParameterType::Integer))
            parameters.getIntegers(name);
        else if (parameters.is(name, ParameterType::Float))
            parameters.getFloats(name);
        else if (parameters.is(name, ParameterType::Bool))
            parameters.findBool(name);
        else if (parameters.is(name, ParameterType::Texture))
            parameters.findTexture(name);
        else if (parameters.is(name, ParameterType::Point3))
            parameters.getPoint3s(name);
        else if (parameters.is(name, ParameterType::Rgb) || parameters.is(name, ParameterType::Spectrum) ||
                 parameters.is(name, ParameterType::Blackbody))
            parameters.findSpectrum(name);
        else
            parameters.getStrings(name);
    }
}

Motion motionOf(BuildContext& context, const MovingTransformPtr& transform, const Place& place) {
    try {
        if (transform->isMoving() && !(transform->startTime <= transform->endTime))
            throw std::domain_error("TransformTimes gives an end before the start");
        return Motion(transform->start, transform->startTime, transform->end, transform->endTime);
    } catch (const std::domain_error& e) {
        context.diagnostics().error(place, e.what());
        return Motion(transform->start);
    }
}

const Transform& still(BuildContext& context, const MovingTransformPtr& transform, const Place& place) {
    if (transform->isMoving()) context.diagnostics().error(place, "animated transformations are not yet supported");
    return transform->start;
}

} // namespace vitrine
