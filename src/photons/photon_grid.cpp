#include "photons/photon_grid.h"

#include "core/random.h"

#include <tbb/parallel_for.h>

#include <bit>

namespace vitrine {

namespace {

unsigned chosenBits(unsigned asked, std::size_t photons) {
    return asked > 0 ? asked : std::clamp(unsigned(std::bit_width(photons)), 10u, 28u);
}

/// A photon on its way through the sort.
struct Keyed {
    std::uint32_t key, index;
};

} // namespace

PhotonGrid::PhotonGrid(std::vector<Photon> photons, float cellSize, unsigned tableBits)
    : perUnit_(1 / cellSize), mask_((1u << chosenBits(tableBits, photons.size())) - 1) {
    sort(photons);
    x_.resize(photons_.size());
    y_.resize(photons_.size());
    z_.resize(photons_.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, photons_.size(), 16384), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            const V3f p = photons_[i].p();
            x_[i] = p.x;
            y_[i] = p.y;
            z_[i] = p.z;
        }
    });
}

std::uint32_t PhotonGrid::key(std::int32_t x, const Row& row) const {
    const auto rowKey = mixBits(std::uint64_t(std::uint32_t(row.y)) << 32 | std::uint32_t(row.z));
    return (std::uint32_t(rowKey) + std::uint32_t(x)) & mask_;
}

/// Two counting sorts, both stable: by the key's highest bits in blocks of photons, then by the whole key within each
/// of these parts. Blocks and parts are the same for any number of threads.
void PhotonGrid::sort(const std::vector<Photon>& photons) {
    constexpr std::size_t blockSize = 32768;
    const std::size_t count = photons.size(), blocks = (count + blockSize - 1) / blockSize;
    const unsigned bits = unsigned(std::bit_width(mask_)), partBits = std::min(bits, 8u), rest = bits - partBits;
    const std::size_t parts = std::size_t(1) << partBits;

    std::vector<Keyed> keyed(count), byPart(count);
    std::vector<std::uint32_t> offsets(blocks * parts);
    tbb::parallel_for(std::size_t(0), blocks, [&](std::size_t block) {
        std::uint32_t* const histogram = &offsets[block * parts];
        for (std::size_t i = block * blockSize; i < std::min(count, (block + 1) * blockSize); ++i) {
            const V3f p = photons[i].p();
            keyed[i] = {key(cell(p.x), {cell(p.y), cell(p.z)}), std::uint32_t(i)};
            ++histogram[keyed[i].key >> rest];
        }
    });
    std::vector<std::uint32_t> partStarts(parts + 1);
    std::uint32_t sum = 0;
    for (std::size_t part = 0; part < parts; ++part) {
        partStarts[part] = sum;
        for (std::size_t block = 0; block < blocks; ++block)
            sum += std::exchange(offsets[block * parts + part], sum);
    }
    partStarts[parts] = sum;
    tbb::parallel_for(std::size_t(0), blocks, [&](std::size_t block) {
        std::uint32_t* const next = &offsets[block * parts];
        for (std::size_t i = block * blockSize; i < std::min(count, (block + 1) * blockSize); ++i)
            byPart[next[keyed[i].key >> rest]++] = keyed[i];
    });

    photons_.resize(count);
    starts_.assign(std::size_t(mask_) + 2, 0);
    starts_.back() = std::uint32_t(count);
    tbb::parallel_for(std::size_t(0), parts, [&](std::size_t part) {
        std::uint32_t* const starts = &starts_[part << rest];
        const std::uint32_t places = 1u << rest, placeMask = places - 1;
        const std::uint32_t begin = partStarts[part], end = partStarts[part + 1];
        std::vector<std::uint32_t> next(places);
        for (std::uint32_t i = begin; i < end; ++i)
            ++next[byPart[i].key & placeMask];
        std::uint32_t at = begin;
        for (std::uint32_t place = 0; place < places; ++place) {
            starts[place] = at;
            at += std::exchange(next[place], at);
        }
        for (std::uint32_t i = begin; i < end; ++i)
            photons_[next[byPart[i].key & placeMask]++] = photons[byPart[i].index];
    });
}

void PhotonGrid::find(std::span<const GatherDisk> disks, NearPhotons& found) const {
    found.clear();
    for (const GatherDisk& disk : disks) {
        findInDisk(disk, found);
        found.endDisk();
    }
}

void PhotonGrid::findInDisk(const GatherDisk& disk, NearPhotons& found) const {
    // A little more than the disk, as distances are rounded.
    const V3f half = disk.halfExtents() * 1.0001f;
    const auto lowest = [&](float c, float h) { return cell(c - h - 1e-6f * std::abs(c)); };
    const auto highest = [&](float c, float h) { return cell(c + h + 1e-6f * std::abs(c)); };
    const V3f& c = disk.center;
    const std::int32_t x0 = lowest(c.x, half.x), x1 = highest(c.x, half.x);
    const std::int32_t y0 = lowest(c.y, half.y), y1 = highest(c.y, half.y);
    const std::int32_t z0 = lowest(c.z, half.z), z1 = highest(c.z, half.z);
    // A disk far larger than a cell: trying all photons is less work than all cells.
    const double rows = (double(y1) - y0 + 1) * (double(z1) - z0 + 1);
    if (rows > 64 + double(photons_.size()) / 8) {
        searchRun(disk, 0, std::uint32_t(photons_.size()), nullptr, found);
        return;
    }
    for (std::int32_t z = z0; z <= z1; ++z)
        for (std::int32_t y = y0; y <= y1; ++y)
            searchRow(disk, x0, x1, {y, z}, found);
}

void PhotonGrid::searchRow(const GatherDisk& disk, std::int32_t x0, std::int32_t x1, const Row& row,
                           NearPhotons& found) const {
    const std::uint32_t first = key(x0, row);
    const std::uint64_t places = std::min(std::uint64_t(std::int64_t(x1) - x0 + 1), std::uint64_t(mask_) + 1);
    const std::uint64_t last = first + places; // may run over the table's end, and on from its start
    const std::uint64_t end = std::min(last, std::uint64_t(mask_) + 1);
    searchRun(disk, starts_[first], starts_[end], &row, found);
    if (last > end) searchRun(disk, starts_[0], starts_[last - end], &row, found);
}

void PhotonGrid::searchRun(const GatherDisk& disk, std::uint32_t begin, std::uint32_t end, const Row* row,
                           NearPhotons& found) const {
    constexpr std::uint32_t lanes = 8;
    const V3f c = disk.center, n = disk.normal;
    const float radius2 = disk.radius2(), most = GatherDisk::thickness * disk.radius;
    for (std::uint32_t i = begin; i < end; i += lanes) {
        const std::uint32_t count = std::min(lanes, end - i);
        // The same operations as distance2InDisk(), in loops that the compiler turns into vector instructions.
        float distance2[lanes];
        if (count == lanes) {
            for (std::uint32_t k = 0; k < lanes; ++k) {
                const float dx = x_[i + k] - c.x, dy = y_[i + k] - c.y, dz = z_[i + k] - c.z;
                const float off = dx * n.x + dy * n.y + dz * n.z;
                const float d2 = dx * dx + dy * dy + dz * dz - off * off;
                distance2[k] = d2 < radius2 && std::abs(off) <= most ? std::max(0.f, d2) : -1;
            }
        } else {
            for (std::uint32_t k = 0; k < count; ++k)
                distance2[k] = distance2InDisk(disk, V3f(x_[i + k], y_[i + k], z_[i + k]));
        }
        for (std::uint32_t k = 0; k < count; ++k) {
            if (distance2[k] < 0) continue;
            // Of another row, which shares its place of the table.
            if (row && (cell(y_[i + k]) != row->y || cell(z_[i + k]) != row->z)) continue;
            found.add({i + k, distance2[k]});
        }
    }
}

std::size_t PhotonGrid::memoryBytes() const {
    return photons_.capacity() * (sizeof(Photon) + 3 * sizeof(float)) + starts_.capacity() * sizeof(std::uint32_t);
}

} // namespace vitrine
