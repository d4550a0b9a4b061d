// Photons in a hash grid: rows of cells of equal size, made by a counting sort.
#pragma once

#include "photons/eight_places.h"

#include <memory>

namespace vitrine {

/// Rows of cells along x keep their order in the table, so that a disk finds a row of cells as one run of photons. Cells
/// that share a place of the table are told apart by their coordinates: no photon is missed or found twice, whatever
/// collides.
class PhotonGrid final : public PhotonLookup {
  public:
    /// Built by all threads of the current task arena; the result depends on none of them.
    /// \param rowWidth two to three times the radius that is asked for most
    /// \param tableBits the table has 2^tableBits places; 0: as many as there are photons
    PhotonGrid(PhotonBlocks blocks, float rowWidth, unsigned tableBits = 0);

    /// Sorted by cell.
    std::span<const Photon> photons() const override { return {photons_.get(), count_}; }
    void find(std::span<const GatherDisk> disks, NearPhotons& found) const override;
    std::size_t memoryBytes() const override;

  private:
    /// Rows of cells along x.
    struct Row {
        std::int32_t y, z;
    };
    /// A row's cells are shorter than it is wide: a run then holds little besides the disk, and costs no more to find.
    static constexpr float cellsPerWidth = 4;

    static std::int32_t rounded(float x) { return std::int32_t(std::floor(std::clamp(x, -1e9f, 1e9f))); }
    std::int32_t across(float yOrZ) const { return rounded(yOrZ * rowsPerUnit_); }
    std::int32_t along(float x) const { return rounded(x * (cellsPerWidth * rowsPerUnit_)); }
    std::size_t eights() const { return (count_ + EightPlaces::lanes - 1) / EightPlaces::lanes; }
    std::uint32_t key(std::int32_t x, const Row& row) const;
    std::uint32_t key(const Photon& photon) const;
    std::vector<std::uint32_t> sortIntoParts(PhotonBlocks blocks, unsigned shift);
    void sortPart(std::uint32_t begin, std::uint32_t end, std::uint32_t* starts, unsigned bits);
    class Search;

    float rowsPerUnit_;
    std::uint32_t mask_ = 0;
    std::size_t count_ = 0;
    std::unique_ptr<Photon[]> photons_;
    std::unique_ptr<EightPlaces[]> places_; ///< of the photons, and of none behind them
    std::vector<std::uint32_t> starts_;     ///< first photon of each place of the table, and the end
};

} // namespace vitrine
