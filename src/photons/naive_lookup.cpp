#include "photons/naive_lookup.h"

namespace vitrine {

void NaiveLookup::find(std::span<const GatherDisk> disks, NearPhotons& found) const {
    found.clear();
    for (const GatherDisk& disk : disks) {
        for (std::size_t i = 0; i < photons_.size(); ++i)
            if (const float distance2 = distance2InDisk(disk, photons_[i].p()); distance2 >= 0)
                found.add({std::uint32_t(i), distance2});
        found.endDisk();
    }
}

} // namespace vitrine
