// Sums of a range of passes in a file: a checkpoint to resume from, or one machine's share of a picture.
#pragma once

#include "film/film.h"
#include "integrators/integrator.h"

#include <string>
#include <vector>

namespace vitrine {

/// A set of passes as sorted, disjoint, non-touching half-open ranges.
class PassSet {
  public:
    /// \throws std::invalid_argument when `range` is inverted or overlaps a pass that is already in the set: passes
    /// must never count twice
    void add(PassRange range);
    std::uint64_t size() const;
    const std::vector<PassRange>& ranges() const { return ranges_; }
    /// The parts of `range` that are not in the set, in order.
    std::vector<PassRange> missingFrom(PassRange range) const;
    /// "0:16, 32:48"
    std::string toString() const;

  private:
    std::vector<PassRange> ranges_;
};

/// What is known of a render that is under way or was cut into parts.
struct PartialRender {
    std::uint64_t fingerprint = 0; ///< of the scene, its files and all settings that change the picture
    std::string sceneName;
    PassSet passes;
    double seconds = 0;                   ///< render time spent so far
    std::map<std::string, M44d> matrices; ///< ImageMetadata::matrices of the picture
    /// Integrator::saveState() after the last pass; empty where passes are independent.
    std::vector<std::byte> integratorState;
};

/// Writes state and the film's sums beside `path`, then renames: a kill never leaves half a file. \throws FileError
void writePartial(const std::string& path, const PartialRender& state, const Film& film);

/// A film and its state from a file that writePartial wrote. \throws FileError for a file that is missing, cut short,
/// damaged (by checksum) or of another version.
struct LoadedPartial {
    PartialRender state;
    Film film;
};
LoadedPartial readPartial(const std::string& path);

} // namespace vitrine
