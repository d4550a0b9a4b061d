// Photons in a hash grid: rows of cells of equal size, made by a counting sort.
#pragma once

#include "photons/photon_lookup.h"

#include <memory>

namespace vitrine {

/// Rows of cells along x keep their order in the table, so that a disk finds a row of cells as one run of photons. Cells
/// that share a place of the table are told apart by their coordinates: no photon is missed or found twice, whatever
/// collides.
class PhotonGrid final : public PhotonLookup {
  public:
    /// Built by all threads of the current task arena; the result depends on none of them.
    /// \param rowWidth one to two times the radius that is asked for most
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
    std::uint32_t key(std::int32_t x, const Row& row) const;
    std::uint32_t key(const Photon& photon) const;
    std::vector<std::uint32_t> sortIntoParts(PhotonBlocks blocks, unsigned shift);
    void sortPart(std::uint32_t begin, std::uint32_t end, std::uint32_t* starts, unsigned bits);
    void findInDisk(const GatherDisk& disk, NearPhotons& found) const;
    void searchRow(const GatherDisk& disk, std::int32_t x0, std::int32_t x1, const Row& row, NearPhotons& found) const;
    void searchRun(const GatherDisk& disk, std::uint32_t begin, std::uint32_t end, const Row* row,
                   NearPhotons& found) const;

    float rowsPerUnit_;
    std::uint32_t mask_ = 0;
    std::size_t count_ = 0;
    std::unique_ptr<Photon[]> photons_; ///< and room behind them for eight to be read at a time
    std::vector<std::uint32_t> starts_; ///< first photon of each place of the table, and the end
};

} // namespace vitrine
