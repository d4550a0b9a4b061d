// Which dielectric solids a path is inside of: nested dielectrics by priority (Schmidt & Budge, "Simple Nested
// Dielectrics in Ray Traced Images", JGT 2002).
#pragma once

#include "bsdfs/material.h"

#include <array>

namespace vitrine {

/// The solids around a point of a path, in the order in which they were entered. Small and copied with the path.
class InteriorStack {
  public:
    /// More overlapping solids than this are not kept apart: the oldest is forgotten.
    static constexpr int capacity = 12;

    /// What a path meets at the surface of a solid.
    struct Crossing {
        bool isReal = true;                ///< false: a solid of higher priority is there; the surface does nothing
        const Interior* outside = nullptr; ///< what lies on the outer side; null: vacuum
        bool isLost = false;               ///< leaving a solid with a priority that was never entered
    };

    /// The surface of `interior`, met from outside (`entering`) or from inside. A solid that is left without having been
    /// entered does nothing: its other face coincided with that of another solid, or it is open. Refracting there would
    /// make energy. Solids that touch must overlap, for priorities to say who is there.
    Crossing crossing(const Interior& interior, bool entering) const;

    void enter(const Interior& interior);
    /// Leaving what was never entered (an open surface, a camera in glass) is no fault.
    void leave(const Interior& interior);

    /// Goes through the surface of `interior`: in or out.
    void cross(const Interior& interior, bool entering) {
        if (entering)
            enter(interior);
        else
            leave(interior);
    }

    /// What fills the space here; null: vacuum.
    const Interior* current() const;
    bool operator==(const InteriorStack& other) const {
        return std::equal(entries_.begin(), entries_.begin() + size_, other.entries_.begin(),
                          other.entries_.begin() + other.size_);
    }
    bool empty() const { return size_ == 0; }
    int size() const { return size_; }

  private:
    /// Index of the strongest solid with a priority, not counting `except`; -1 if none. Among equals the first entered.
    int strongest(int except) const;
    int lastOf(const Interior& interior) const;

    std::array<const Interior*, capacity> entries_{};
    int size_ = 0;
};

} // namespace vitrine
