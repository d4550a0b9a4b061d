// Which photons lie in which disks: one question, three structures that answer it alike.
#pragma once

#include "photons/gather_disk.h"
#include "photons/photon.h"

#include <span>
#include <vector>

namespace vitrine {

/// A photon in a disk.
struct NearPhoton {
    std::uint32_t index; ///< in the span that was searched
    float distance2;     ///< in the disk's plane
};

/// For each disk its photons, one disk after the other. Their order is fixed by the search and what it searched, never
/// by threads.
class NearPhotons {
  public:
    void clear() {
        size_ = 0;
        ends_.clear();
    }
    std::size_t disks() const { return ends_.size(); }
    std::span<const NearPhoton> of(std::size_t disk) const {
        const std::size_t begin = disk == 0 ? 0 : ends_[disk - 1];
        return {photons_.data() + begin, ends_[disk] - begin};
    }
    std::size_t size() const { return size_; }

    /// All at once. \param ends of each disk's photons in `photons`
    void assign(std::vector<NearPhoton> photons, std::vector<std::size_t> ends) {
        photons_ = std::move(photons);
        size_ = photons_.size();
        ends_ = std::move(ends);
    }
    /// To the disk that is next to be ended.
    void add(const NearPhoton& photon) {
        *room(1) = photon;
        grow(1);
    }
    /// Where so many may be written.
    NearPhoton* room(std::size_t photons) {
        if (photons_.size() < size_ + photons) photons_.resize(2 * (size_ + photons));
        return photons_.data() + size_;
    }
    /// So many were written to the room.
    void grow(std::size_t photons) { size_ += photons; }
    void endDisk() { ends_.push_back(size_); }

  private:
    std::vector<NearPhoton> photons_; ///< and room behind them
    std::size_t size_ = 0;
    std::vector<std::size_t> ends_;
};

/// A search over the photons of a pass. Immutable: any thread may ask.
class PhotonLookup {
  public:
    virtual ~PhotonLookup() = default;
    /// The photons in the order that indices mean: the one they were given in, or sorted.
    virtual std::span<const Photon> photons() const = 0;
    /// Clears `found` and fills it for these disks.
    virtual void find(std::span<const GatherDisk> disks, NearPhotons& found) const = 0;
    virtual std::size_t memoryBytes() const = 0;
};

} // namespace vitrine
