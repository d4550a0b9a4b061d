// Every photon tried for every disk: the oracle.
#pragma once

#include "photons/photon_lookup.h"

namespace vitrine {

class NaiveLookup final : public PhotonLookup {
  public:
    explicit NaiveLookup(std::vector<Photon> photons) : photons_(std::move(photons)) {}

    std::span<const Photon> photons() const override { return photons_; }
    void find(std::span<const GatherDisk> disks, NearPhotons& found) const override;
    std::size_t memoryBytes() const override { return photons_.capacity() * sizeof(Photon); }

  private:
    std::vector<Photon> photons_;
};

} // namespace vitrine
