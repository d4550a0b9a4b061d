// Integrators: recipes that add passes to a film.
#pragma once

#include "film/film.h"
#include "paths/world.h"

#include <atomic>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

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
    /// Of photon integrators: paths traced from lights, those that left photons, photons kept, points that gathered and
    /// pairs of a point and a photon in its disk.
    std::atomic<std::uint64_t> photonPaths{0}, landedPaths{0}, photons{0}, gatherPoints{0}, gathered{0};
    std::atomic<std::uint64_t> photonBytes{0}; ///< most that the photons of a pass took
    /// Where photon mapping's time went, by the clock: tracing photons, sorting them, eye paths and gathering (these two
    /// overlap, and share their time as they share the threads).
    std::atomic<std::uint64_t> photonNanoseconds{0}, sortNanoseconds{0}, eyeNanoseconds{0}, gatherNanoseconds{0};
    /// Of the disks so far. Without any: infinity and 0.
    std::atomic<float> smallestRadius{infinity}, largestRadius{0};

    /// Threads may call this in any order.
    void countRadius(float radius) {
        float known = smallestRadius.load(std::memory_order_relaxed);
        while (radius < known && !smallestRadius.compare_exchange_weak(known, radius, std::memory_order_relaxed)) {
        }
        known = largestRadius.load(std::memory_order_relaxed);
        while (radius > known && !largestRadius.compare_exchange_weak(known, radius, std::memory_order_relaxed)) {
        }
    }
};

/// Of photons or of light, for photon integrators: what was asked for, or as many as the whole picture has pixels.
/// \param asked negative: nothing was
inline std::uint64_t pathsOfPass(std::int64_t asked, const FilmSettings& film) {
    return asked >= 0 ? std::uint64_t(asked) : std::uint64_t(film.resolution.x) * std::uint64_t(film.resolution.y);
}

/// Belongs to one render: it may keep what it needs from pass to pass.
class Integrator {
  public:
    virtual ~Integrator() = default;
    /// Whether it can do anything with this scene. \throws std::invalid_argument saying why not
    virtual void check(const World& world) const { (void)world; }
    /// Adds `passes` to the film with the threads of the calling task arena.
    virtual void addPasses(const World& world, PassRange passes, Film& film, RenderCounters& counters) = 0;

    /// Any grouping and order of the same passes gives the same film. False: passes must be added from 0 on, one after the
    /// other, with the state that they left.
    virtual bool passesAreIndependent() const { return true; }
    /// What passes left for the next ones, for checkpoints.
    virtual std::vector<std::byte> saveState() const { return {}; }
    /// \throws std::invalid_argument for what saveState() of a render of this size cannot have written
    virtual void restoreState(std::span<const std::byte> state) {
        if (!state.empty()) throw std::invalid_argument("a state of another integrator");
    }
};

} // namespace vitrine
