// Names that may be used before they are defined: materials, media, objects.
#pragma once

#include "core/errors.h"

#include <string>
#include <unordered_map>
#include <vector>

namespace vitrine {

class NameTable {
  public:
    explicit NameTable(std::string kind) : kind_(std::move(kind)) {}

    struct Entry {
        int index = -1;
        bool defined = false;
        Place place; ///< of the definition, before it of the first use
    };

    /// The entry of a use; `makeNode` makes an empty node and gives its index when the name is new.
    template <class F>
    int use(const std::string& name, const Place& place, F&& makeNode) {
        return add(name, place, makeNode).first->index;
    }
    /// The entry of a definition. \throws SceneError when there is one already
    template <class F>
    int define(const std::string& name, const Place& place, F&& makeNode) {
        const auto [entry, isNew] = add(name, place, makeNode);
        if (entry->defined) throw redefined(name, place, entry->place);
        entry->defined = true;
        entry->place = place;
        return entry->index;
    }
    /// One error for each name that was used and never defined, in the order of use.
    void reportUndefined(Diagnostics& diagnostics) const;

  private:
    template <class F>
    std::pair<Entry*, bool> add(const std::string& name, const Place& place, F&& makeNode) {
        const auto [it, isNew] = entries_.try_emplace(name);
        if (isNew) {
            it->second = Entry{makeNode(), false, place};
            order_.push_back(name);
        }
        return {&it->second, isNew};
    }
    SceneError redefined(const std::string& name, const Place& place, const Place& first) const;

    std::string kind_;
    std::unordered_map<std::string, Entry> entries_;
    std::vector<std::string> order_;
};

} // namespace vitrine
