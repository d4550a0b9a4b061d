// Texts with random changes, for readers that must read or refuse whatever comes.
#pragma once

#include "core/random.h"

#include <string>
#include <vector>

namespace vitrine::test {

/// How far a text is changed.
struct Mutation {
    std::size_t mostChanges, mostBytes; ///< changes of a text, bytes of each
};

/// The text with a few random changes: bytes replaced, removed, put in; pieces moved, repeated, cut out.
inline std::string mutated(std::string text, const std::vector<std::string>& pieces, const Mutation& mutation,
                           RandomStream random) {
    const auto below = [&](std::size_t n) { return std::size_t(random.bits() % n); };
    for (std::size_t change = 1 + below(mutation.mostChanges); change > 0 && !text.empty(); --change) {
        const std::size_t at = below(text.size()), length = std::min(text.size() - at, 1 + below(mutation.mostBytes));
        switch (below(6)) {
        case 0:
            text[at] = char(1 + below(255));
            break;
        case 1:
            text.erase(at, length);
            break;
        case 2:
            text.insert(at, pieces[below(pieces.size())]);
            break;
        case 3:
            text.insert(below(text.size()), text.substr(at, length));
            break;
        case 4:
            text.replace(at, length, pieces[below(pieces.size())]);
            break;
        default:
            text[at] = char(below(256));
            break;
        }
    }
    return text;
}

} // namespace vitrine::test
