#include "nodes/name_table.h"

#include "nodes/text.h"

#include <fmt/format.h>

namespace vitrine {

SceneError NameTable::redefined(const std::string& name, const Place& place, const Place& first) const {
    return SceneError(place, fmt::format("{} {} is defined twice", kind_, inQuotes(name)),
                      fmt::format("first at {}", first.toString()));
}

void NameTable::reportUndefined(Diagnostics& diagnostics) const {
    std::vector<std::string> defined;
    for (const auto& name : order_)
        if (entries_.at(name).defined) defined.push_back(name);
    for (const auto& name : order_) {
        const Entry& entry = entries_.at(name);
        if (entry.defined || diagnostics.full()) continue;
        diagnostics.error(entry.place, fmt::format("there is no {} {}", kind_, inQuotes(name)),
                          didYouMean(name, defined));
    }
}

} // namespace vitrine
