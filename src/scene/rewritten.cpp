#include "scene/rewritten.h"

namespace vitrine {

ParameterPtr makeParameter(ParameterType type, std::string name, decltype(Parameter::values) values,
                           std::string colorSpace) {
    auto parameter = std::make_shared<Parameter>();
    parameter->type = type;
    parameter->name = std::move(name);
    parameter->values = std::move(values);
    parameter->colorSpace = std::move(colorSpace);
    return parameter;
}

ParameterPtr findParameter(const Node& node, std::string_view name) {
    for (const auto& parameter : node.parameters.own())
        if (parameter->name == name) return parameter;
    for (const auto& parameter : node.parameters.defaults())
        if (parameter->name == name) return parameter;
    return nullptr;
}

} // namespace vitrine
