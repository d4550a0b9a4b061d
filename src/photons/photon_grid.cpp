#include "photons/photon_grid.h"

#include "core/random.h"

#include <tbb/parallel_for.h>

#include <bit>
#include <cstring>

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace vitrine {

namespace {

/// Photons whose distances are computed at a time.
constexpr std::uint32_t lanes = 8;

unsigned chosenBits(unsigned asked, std::size_t photons) {
    return asked > 0 ? asked : std::clamp(unsigned(std::bit_width(photons)), 10u, 28u);
}

using Eight [[gnu::vector_size(32)]] = float;
using EightMask [[gnu::vector_size(32)]] = std::int32_t;

unsigned bitsOf(const EightMask& mask) {
#ifdef __AVX__
    return unsigned(_mm256_movemask_ps(__m256(mask)));
#else
    unsigned bits = 0;
    for (unsigned i = 0; i < lanes; ++i)
        bits |= unsigned(mask[i] != 0) << i;
    return bits;
#endif
}

/// Lanes, as bits, in whose disk the photons p[0] to p[7] lie, by the same operations as distance2InDisk().
unsigned eightInDisk(const GatherDisk& disk, const Photon* p, float* distance2) {
    // Places of four photons and four others, transposed: x, y, z of all eight.
    const auto pair = [p](int i) {
        using Four [[gnu::vector_size(16)]] = float;
        const auto load = [](const Photon* photon) {
            Four place;
            std::memcpy(&place, photon, sizeof place);
            return place;
        };
        return __builtin_shufflevector(load(p + i), load(p + i + 4), 0, 1, 2, 3, 4, 5, 6, 7);
    };
    const Eight p0 = pair(0), p1 = pair(1), p2 = pair(2), p3 = pair(3);
    const auto low = [](const Eight& a, const Eight& b) {
        return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    };
    const Eight xy01 = low(p0, p1), xy23 = low(p2, p3);
    const Eight z01 = __builtin_shufflevector(p0, p1, 2, 10, 2, 10, 6, 14, 6, 14);
    const Eight z23 = __builtin_shufflevector(p2, p3, 2, 10, 2, 10, 6, 14, 6, 14);
    const V3f &c = disk.center, &n = disk.normal;
    const Eight dx = __builtin_shufflevector(xy01, xy23, 0, 1, 8, 9, 4, 5, 12, 13) - c.x,
                dy = __builtin_shufflevector(xy01, xy23, 2, 3, 10, 11, 6, 7, 14, 15) - c.y,
                dz = __builtin_shufflevector(z01, z23, 0, 1, 8, 9, 4, 5, 12, 13) - c.z;
    const Eight off = dx * n.x + dy * n.y + dz * n.z;
    const Eight d2 = dx * dx + dy * dy + dz * dz - off * off;
    const Eight height = off < 0 ? -off : off;
    const EightMask inside = (d2 < disk.radius2()) & (height <= GatherDisk::thickness * disk.radius);
    const Eight nearest = d2 > 0 ? d2 : Eight{};
    std::memcpy(distance2, &nearest, sizeof nearest);
    return bitsOf(inside);
}

} // namespace

PhotonGrid::PhotonGrid(PhotonBlocks blocks, float rowWidth, unsigned tableBits) : rowsPerUnit_(1 / rowWidth) {
    for (const auto& block : blocks)
        count_ += block.size();
    const unsigned bits = chosenBits(tableBits, count_), partBits = std::min(bits, 8u), rest = bits - partBits;
    mask_ = std::uint32_t((std::uint64_t(1) << bits) - 1);
    photons_ = std::make_unique_for_overwrite<Photon[]>(count_ + lanes);
    std::fill_n(photons_.get() + count_, lanes,
                Photon(V3f(0), V3f(0, 0, 1), 0, LightHistory::Scattered, SampledSpectrum(0.f)));
    const std::vector<std::uint32_t> partStarts = sortIntoParts(std::move(blocks), rest);
    starts_.resize(std::size_t(mask_) + 2);
    starts_.back() = std::uint32_t(count_);
    tbb::parallel_for(std::size_t(0), partStarts.size() - 1, [&](std::size_t part) {
        sortPart(partStarts[part], partStarts[part + 1], &starts_[part << rest], rest);
    });
}

std::uint32_t PhotonGrid::key(std::int32_t x, const Row& row) const {
    const auto rowKey = mixBits(std::uint64_t(std::uint32_t(row.y)) << 32 | std::uint32_t(row.z));
    return (std::uint32_t(rowKey) + std::uint32_t(x)) & mask_;
}

std::uint32_t PhotonGrid::key(const Photon& photon) const {
    const V3f p = photon.p();
    return key(along(p.x), {across(p.y), across(p.z)});
}

/// Stable, by the keys shifted down: the first of two counting sorts. Each block is freed once read. \return where the parts
/// begin, and the end
std::vector<std::uint32_t> PhotonGrid::sortIntoParts(PhotonBlocks blocks, unsigned shift) {
    const std::size_t parts = (std::size_t(mask_) >> shift) + 1;
    std::vector<std::uint32_t> offsets(blocks.size() * parts);
    tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t block) {
        std::uint32_t* const histogram = &offsets[block * parts];
        for (const Photon& photon : blocks[block])
            ++histogram[key(photon) >> shift];
    });
    std::vector<std::uint32_t> partStarts(parts + 1);
    std::uint32_t sum = 0;
    for (std::size_t part = 0; part < parts; ++part) {
        partStarts[part] = sum;
        for (std::size_t block = 0; block < blocks.size(); ++block)
            sum += std::exchange(offsets[block * parts + part], sum);
    }
    partStarts[parts] = sum;
    // The last first, as what was allocated last goes back to the system first: photons should not take twice their room.
    tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t i) {
        const std::size_t block = blocks.size() - 1 - i;
        std::uint32_t* const next = &offsets[block * parts];
        for (const Photon& photon : blocks[block])
            photons_[next[key(photon) >> shift]++] = photon;
        std::vector<Photon>().swap(blocks[block]);
    });
    return partStarts;
}

/// The second, of a part that shares all but the lowest bits of its keys. \param starts of the part's places
void PhotonGrid::sortPart(std::uint32_t begin, std::uint32_t end, std::uint32_t* starts, unsigned bits) {
    const std::uint32_t places = 1u << bits, placeMask = places - 1;
    const std::vector<Photon> unsorted(photons_.get() + begin, photons_.get() + end);
    std::vector<std::uint32_t> keys(unsorted.size()), next(places);
    for (std::size_t i = 0; i < unsorted.size(); ++i)
        ++next[keys[i] = key(unsorted[i]) & placeMask];
    std::uint32_t at = begin;
    for (std::uint32_t place = 0; place < places; ++place) {
        starts[place] = at;
        at += std::exchange(next[place], at);
    }
    for (std::size_t i = 0; i < unsorted.size(); ++i)
        photons_[next[keys[i]]++] = unsorted[i];
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
    const auto lowest = [](float c, float h) { return c - h - 1e-6f * std::abs(c); };
    const auto highest = [](float c, float h) { return c + h + 1e-6f * std::abs(c); };
    const V3f& c = disk.center;
    const std::int32_t x0 = along(lowest(c.x, half.x)), x1 = along(highest(c.x, half.x));
    const std::int32_t y0 = across(lowest(c.y, half.y)), y1 = across(highest(c.y, half.y));
    const std::int32_t z0 = across(lowest(c.z, half.z)), z1 = across(highest(c.z, half.z));
    // A disk far larger than a cell: trying all photons is less work than all cells.
    const double rows = (double(y1) - y0 + 1) * (double(z1) - z0 + 1);
    if (rows > 64 + double(count_) / lanes) {
        searchRun(disk, 0, std::uint32_t(count_), nullptr, found);
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
    for (std::uint32_t i = begin; i < end; i += lanes) {
        float distance2[lanes];
        unsigned inside = eightInDisk(disk, &photons_[i], distance2);
        if (end - i < lanes) inside &= (1u << (end - i)) - 1;
        for (; inside; inside &= inside - 1) {
            const auto k = unsigned(std::countr_zero(inside));
            const V3f p = photons_[i + k].p();
            // Of another row, which shares its place of the table.
            if (row && (across(p.y) != row->y || across(p.z) != row->z)) continue;
            found.add({i + k, distance2[k]});
        }
    }
}

std::size_t PhotonGrid::memoryBytes() const {
    return (count_ + lanes) * sizeof(Photon) + starts_.capacity() * sizeof(std::uint32_t);
}

} // namespace vitrine
