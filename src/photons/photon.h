// A photon that landed on a surface.
#pragma once

#include "spectrum/sampled.h"

#include <cstdint>
#include <vector>

namespace vitrine {

/// How light came to a photon's place, in the order in which eye paths find it worse by themselves.
enum class LightHistory : std::uint8_t {
    Scattered, ///< last through a surface that is not polished, or straight from the light
    Caustic,   ///< by polished surfaces alone, from a light that eye paths can run into
    Hidden     ///< by polished surfaces alone, from a point or a single direction: only photons find it
};

/// 32 bytes: a pass keeps several for each path of photons.
class Photon {
  public:
    /// Scattering events that a record can count; longer paths of photons are cut.
    static constexpr int maxDepth = 169;

    /// Not initialised: room for millions of photons is made before they come.
    Photon() = default;
    /// \param p where (PhotonSpace)  \param w unit, back along the path  \param front it came from the side of the surface's
    /// geometric normal  \param depth scattering events before it landed
    /// \param power of the path at the pass's wavelengths, not yet divided by the number of paths
    Photon(const V3f& p, const V3f& w, bool front, int depth, LightHistory history, const SampledSpectrum& power)
        : p_{p.x, p.y, p.z}, packed_(packDirection(w) << 10 |
                                     (std::uint32_t(depth) * histories + std::uint32_t(history)) * 2 | unsigned(front)),
          power_(power.lanes()) {}

    V3f p() const { return V3f(p_[0], p_[1], p_[2]); }
    V3f w() const { return unpackDirection(packed_ >> 10); }
    bool front() const { return packed_ & 1; }
    int depth() const { return int((packed_ & 1023) / (2 * histories)); }
    LightHistory history() const { return LightHistory((packed_ >> 1 & 511) % histories); }
    SampledSpectrum power() const { return SampledSpectrum(power_); }

    /// Octahedral, 11 bits a coordinate: at most 0.12 degrees off (Cigolle et al. 2014, "A Survey of Efficient
    /// Representations for Independent Unit Vectors").
    static std::uint32_t packDirection(const V3f& w);
    static V3f unpackDirection(std::uint32_t bits);

  private:
    static constexpr std::uint32_t histories = 3;
    static_assert(2 * histories * (maxDepth + 1) <= 1024);

    float p_[3]; // first: a search reads eight places at a time
    std::uint32_t packed_;
    SampledSpectrum::Lanes power_;
};

static_assert(sizeof(Photon) == 32 && std::is_trivially_default_constructible_v<Photon>);

/// Photons of a pass in the order of its paths, in parts that are the same for any number of threads.
using PhotonBlocks = std::vector<std::vector<Photon>>;

} // namespace vitrine
