#include "paths/interior_stack.h"

namespace vitrine {

int InteriorStack::strongest(int except) const {
    int best = -1;
    for (int i = 0; i < size_; ++i) {
        const Interior& entry = *entries_[std::size_t(i)];
        if (i == except || !entry.priority) continue;
        if (best < 0 || *entry.priority > *entries_[std::size_t(best)]->priority) best = i;
    }
    return best;
}

int InteriorStack::lastOf(const Interior& interior) const {
    int i = size_ - 1;
    while (i >= 0 && entries_[std::size_t(i)] != &interior)
        --i;
    return i;
}

InteriorStack::Crossing InteriorStack::crossing(const Interior& interior, bool entering) const {
    // Without a priority the surface is pbrt's: a relative index, whatever is around.
    if (!interior.priority) return {};
    const int own = entering ? -1 : lastOf(interior);
    if (!entering && own < 0) return {false, nullptr, true};
    const int other = strongest(own);
    if (other < 0) return {};
    const Interior* outside = entries_[std::size_t(other)];
    const int theirs = *outside->priority, ours = *interior.priority;
    // Among equals the first entered fills the overlap; one that is being entered comes last.
    const bool otherCameFirst = entering || other < own;
    const bool overruled = theirs > ours || (theirs == ours && otherCameFirst);
    return {!overruled, outside, false};
}

void InteriorStack::enter(const Interior& interior) {
    if (size_ == capacity) {
        std::move(entries_.begin() + 1, entries_.end(), entries_.begin());
        --size_;
    }
    entries_[std::size_t(size_++)] = &interior;
}

void InteriorStack::leave(const Interior& interior) {
    const int index = lastOf(interior);
    if (index < 0) return;
    std::move(entries_.begin() + index + 1, entries_.begin() + size_, entries_.begin() + index);
    --size_;
}

const Interior* InteriorStack::current() const {
    if (size_ == 0) return nullptr;
    const Interior* newest = entries_[std::size_t(size_ - 1)];
    if (!newest->priority) return newest;
    return entries_[std::size_t(strongest(-1))];
}

} // namespace vitrine
