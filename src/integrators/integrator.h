// Integrators: recipes that add passes to a film.
#pragma once

#include "film/film.h"
#include "paths/world.h"

#include <atomic>
#include <cstdint>

namespace vitrine {

/// Half-open range of passes. A pass is one sample a pixel for the path tracer, one photon pass for photon integrators.
struct PassRange {
    std::uint64_t begin = 0, end = 0;
    std::uint64_t size() const { return end - begin; }
};

/// Counted while passes run, read by whoever shows progress.
struct RenderCounters {
    std::atomic<std::uint64_t> samples{0};   ///< camera samples done
    std::atomic<std::uint64_t> lostExits{0}; ///< Walk::lostExits(): solids touch, or are open
};

class Integrator {
  public:
    virtual ~Integrator() = default;
    /// Adds `passes` to the film with the threads of the calling task arena. Passes are independent: any grouping of
    /// the same passes gives the same film.
    virtual void addPasses(const World& world, PassRange passes, Film& film, RenderCounters& counters) const = 0;
};

} // namespace vitrine
