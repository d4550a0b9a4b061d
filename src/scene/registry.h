// One table a family: the type's name in scene files and the function that builds it.
#pragma once

#include "nodes/parser.h"

#include <span>

namespace vitrine {

/// A type of scene files. No builder: pbrt-v4 (or a later Vitrine) knows it, this one does not yet.
template <class Builder>
struct RegistryEntry {
    std::string_view name;
    Builder build = nullptr;
};

/// The builder of `node`'s type. \throws SceneError: unknown, with the nearest valid name; or not yet supported
template <class Builder>
Builder findBuilder(std::span<const RegistryEntry<Builder>> table, const Node& node, const std::string& family) {
    std::vector<std::string> names;
    for (const auto& entry : table) {
        if (entry.name == node.type) {
            if (entry.build) return entry.build;
            throw SceneError(node.typePlace ? node.typePlace : node.place,
                             family + " \"" + node.type + "\" is not yet supported");
        }
        names.emplace_back(entry.name);
    }
    throw unknownType(node, family, names);
}

} // namespace vitrine
