#include "photons/photon_grid.h"

#include "core/random.h"

#include <tbb/parallel_for.h>

#include <bit>

namespace vitrine {

namespace {

constexpr std::uint32_t lanes = EightPlaces::lanes;

unsigned chosenBits(unsigned asked, std::size_t photons) {
    return asked > 0 ? asked : std::clamp(unsigned(std::bit_width(photons)), 10u, 28u);
}

/// Of coordinates in widths of rows, in row i.
struct RowSpan {
    float begin, end;
};

RowSpan spanOf(std::int32_t i) {
    const float begin = float(i); // exact: large ones were rounded from a float
    return {begin, std::abs(i) < 1 << 24 ? begin + 1 : std::nextafter(begin, infinity)};
}

} // namespace

PhotonGrid::PhotonGrid(PhotonBlocks blocks, float rowWidth, unsigned tableBits) : rowsPerUnit_(1 / rowWidth) {
    for (const auto& block : blocks)
        count_ += block.size();
    const unsigned bits = chosenBits(tableBits, count_), partBits = std::min(bits, 8u), rest = bits - partBits;
    mask_ = std::uint32_t((std::uint64_t(1) << bits) - 1);
    photons_ = std::make_unique_for_overwrite<Photon[]>(count_);
    const std::vector<std::uint32_t> partStarts = sortIntoParts(std::move(blocks), rest);
    places_ = std::make_unique_for_overwrite<EightPlaces[]>(eights());
    if (count_ > 0) places_[eights() - 1] = EightPlaces{};
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
    for (std::size_t i = begin; i < end; ++i)
        places_[i / lanes].set(i % lanes, photons_[i].p());
}

/// Looks through runs of photons in the order in which disks ask for them, but many at a time: each run is first fetched
/// from the table and then from memory while others are. Waiting for one after the other takes longer than all the rest.
class PhotonGrid::Search {
  public:
    Search(const PhotonGrid& grid, std::span<const GatherDisk> disks, NearPhotons& found)
        : grid_(grid), disks_(disks), found_(found) {}

    void add(std::uint32_t disk);
    void finish() {
        searchRuns();
        endDisksBefore(disks_.size());
    }

  private:
    /// Photons to be tried. While it waits: places of the table.
    struct Run {
        std::uint32_t begin, end, disk;
        float yBegin, yEnd, zBegin, zEnd; ///< of the row, in widths of rows: others may share its place of the table
    };
    static constexpr std::size_t together = 128;

    void add(const Run& run) {
        if (count_ == together) searchRuns();
        __builtin_prefetch(&grid_.starts_[run.begin]);
        __builtin_prefetch(&grid_.starts_[run.end]);
        runs_[count_++] = run;
    }
    void addRow(std::uint32_t disk, std::int32_t x0, std::int32_t x1, const Row& row);
    void fetch();
    void searchRuns();
    void searchRun(const Run& run);
    void endDisksBefore(std::size_t disk) {
        while (found_.disks() < disk)
            found_.endDisk();
    }

    const PhotonGrid& grid_;
    std::span<const GatherDisk> disks_;
    NearPhotons& found_;
    std::array<Run, together> runs_;
    std::size_t count_ = 0;
};

void PhotonGrid::Search::add(std::uint32_t disk) {
    // A little more than the disk, as distances are rounded.
    const V3f half = disks_[disk].halfExtents() * 1.0001f;
    const auto lowest = [](float c, float h) { return c - h - 1e-6f * std::abs(c); };
    const auto highest = [](float c, float h) { return c + h + 1e-6f * std::abs(c); };
    const V3f& c = disks_[disk].center;
    const std::int32_t x0 = grid_.along(lowest(c.x, half.x)), x1 = grid_.along(highest(c.x, half.x));
    const std::int32_t y0 = grid_.across(lowest(c.y, half.y)), y1 = grid_.across(highest(c.y, half.y));
    const std::int32_t z0 = grid_.across(lowest(c.z, half.z)), z1 = grid_.across(highest(c.z, half.z));
    // A disk far larger than a cell: trying all photons is less work than all cells.
    const double rows = (double(y1) - y0 + 1) * (double(z1) - z0 + 1);
    if (rows > 64 + double(grid_.count_) / lanes) {
        add({0, grid_.mask_ + 1, disk, -infinity, infinity, -infinity, infinity});
        return;
    }
    for (std::int32_t z = z0; z <= z1; ++z)
        for (std::int32_t y = y0; y <= y1; ++y)
            addRow(disk, x0, x1, {y, z});
}

void PhotonGrid::Search::addRow(std::uint32_t disk, std::int32_t x0, std::int32_t x1, const Row& row) {
    const std::uint32_t first = grid_.key(x0, row);
    const std::uint64_t size = std::uint64_t(grid_.mask_) + 1;
    const std::uint64_t places = std::min(std::uint64_t(std::int64_t(x1) - x0 + 1), size);
    const std::uint64_t last = first + places; // may run over the table's end, and on from its start
    const std::uint64_t end = std::min(last, size);
    const RowSpan y = spanOf(row.y), z = spanOf(row.z);
    add({first, std::uint32_t(end), disk, y.begin, y.end, z.begin, z.end});
    if (last > end) add({0, std::uint32_t(last - end), disk, y.begin, y.end, z.begin, z.end});
}

/// Looks the runs up in the table and fetches their beginnings; what is longer comes by itself, as it is read in order.
void PhotonGrid::Search::fetch() {
    constexpr std::size_t cacheLine = 64;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        Run& run = runs_[kept];
        run = runs_[i];
        run.begin = grid_.starts_[run.begin];
        run.end = grid_.starts_[run.end];
        kept += run.begin < run.end;
        const auto* const places = reinterpret_cast<const char*>(&grid_.places_[run.begin / lanes]);
        for (std::size_t line = 0; line < 3; ++line)
            __builtin_prefetch(places + line * cacheLine);
    }
    count_ = kept;
}

void PhotonGrid::Search::searchRuns() {
    fetch();
    for (std::size_t i = 0; i < count_; ++i) {
        endDisksBefore(runs_[i].disk);
        searchRun(runs_[i]);
    }
    count_ = 0;
}

void PhotonGrid::Search::searchRun(const Run& run) {
    const GatherDisk disk = disks_[run.disk];
    const float scale = grid_.rowsPerUnit_;
    unsigned lanesOfRun = ~0u << run.begin % lanes & 255;
    for (std::uint32_t i = run.begin / lanes * lanes; i < run.end; i += lanes) {
        const EightPlaces& places = grid_.places_[i / lanes];
        EightPlaces::Floats distance2;
        const EightPlaces::Mask inDisk = places.inDisk(disk, distance2);
        const EightPlaces::Floats y = places.y * scale, z = places.z * scale;
        const EightPlaces::Mask inRow = (y >= run.yBegin) & (y < run.yEnd) & (z >= run.zBegin) & (z < run.zEnd);
        if (run.end - i < lanes) lanesOfRun &= (1u << (run.end - i)) - 1;
        const unsigned inside = EightPlaces::bitsOf(inDisk & inRow) & lanesOfRun;
        EightPlaces::write(inside, i, distance2, found_.room(lanes));
        found_.grow(unsigned(std::popcount(inside)));
        lanesOfRun = 255;
    }
}

void PhotonGrid::find(std::span<const GatherDisk> disks, NearPhotons& found) const {
    found.clear();
    Search search(*this, disks, found);
    for (std::size_t i = 0; i < disks.size(); ++i)
        search.add(std::uint32_t(i));
    search.finish();
}

std::size_t PhotonGrid::memoryBytes() const {
    return count_ * sizeof(Photon) + eights() * sizeof(EightPlaces) + starts_.capacity() * sizeof(std::uint32_t);
}

} // namespace vitrine
