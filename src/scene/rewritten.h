// Parameters of a node that is written again as something else.
#pragma once

#include "nodes/nodes.h"

namespace vitrine {

ParameterPtr makeParameter(ParameterType type, std::string name, decltype(Parameter::values) values,
                           std::string colorSpace = "srgb");

/// The node's own parameter of this name, or else that of the Attribute directive; null for none.
ParameterPtr findParameter(const Node& node, std::string_view name);

/// The node's parameters, those of Attribute directives included, as `change` returns each: itself, another, or null to
/// drop it; and some more. In the result nothing has been read.
template <class Change>
ParameterSet rewritten(const Node& node, Change&& change, ParameterList added = {}) {
    const auto changed = [&](const ParameterList& list) {
        ParameterList result;
        for (const auto& parameter : list)
            if (auto p = change(parameter)) result.push_back(std::move(p));
        return result;
    };
    ParameterList own = changed(node.parameters.own());
    own.insert(own.end(), added.begin(), added.end());
    return ParameterSet(std::move(own), std::make_shared<ParameterList>(changed(node.parameters.defaults())),
                        node.parameters.colorSpace(), node.place);
}

} // namespace vitrine
