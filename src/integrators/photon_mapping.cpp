#include "integrators/photon_mapping.h"

#include "core/random.h"
#include "integrators/pixel_sample.h"
#include "integrators/tiles.h"
#include "paths/pass_time.h"
#include "paths/pass_wavelengths.h"
#include "photons/naive_lookup.h"
#include "photons/photon_grid.h"

#include <tbb/enumerable_thread_specific.h>

#include <chrono>
#include <cstring>

namespace vitrine {

namespace {

/// Width of the photon grid's rows by the radius that disks have most: wider ones are fewer a disk, but have more photons
/// to try (docs/photon-mapping.md, "Lookup").
constexpr float rowRadii = 3;

/// The search has read their places alone: what a disk found, before its turn comes.
void fetchPhotons(std::span<const Photon> photons, const NearPhotons& found, std::size_t disk) {
    if (disk >= found.disks()) return;
    for (const NearPhoton& near : found.of(disk))
        __builtin_prefetch(&photons[near.index]);
}

using Clock = std::chrono::steady_clock;

std::uint64_t nanoseconds(Clock::time_point from, Clock::time_point to) {
    return std::uint64_t(std::chrono::nanoseconds(to - from).count());
}

std::vector<Photon> joined(PhotonBlocks blocks) {
    std::vector<Photon> all;
    for (auto& block : blocks) {
        all.insert(all.end(), block.begin(), block.end());
        std::vector<Photon>().swap(block);
    }
    return all;
}

} // namespace

struct PhotonMappingIntegrator::Pass {
    std::uint64_t index;
    SampledWavelengths lambda;
    float sharedFactor; ///< of all disks, by the shared rule
    double time;
};

/// An eye path and what it found.
struct PhotonMappingIntegrator::EyeSample {
    V2i pixel;
    std::size_t pathIndex; ///< in radii_
    int hero;
    float filterWeight, cameraWeight;
    SampledSpectrum light; ///< without photons, hero first
    std::size_t pointsEnd; ///< its points end here, where the next one's begin
};

/// Eye paths of a part of the picture, with the points where they gather.
struct PhotonMappingIntegrator::Gathering {
    std::vector<EyeSample> samples;
    std::vector<GatherPoint> points;
    std::vector<GatherDisk> disks; ///< of the points, as large as in this pass
    std::uint64_t lostExits = 0;

    void clear() {
        samples.clear();
        points.clear();
        disks.clear();
        lostExits = 0;
    }
};

void PhotonMappingIntegrator::check(const World& world) const {
    if (world.lights.empty()) throw std::invalid_argument("photon mapping needs a light: this scene has none");
    if (!hasUnpolishedSurface(world))
        throw std::invalid_argument("photon mapping needs a surface that is not polished, for photons to land on: "
                                    "this scene has none. The path integrator renders it");
}

void PhotonMappingIntegrator::prepare(const World& world, const Film& film) {
    const FilmSettings& settings = film.settings();
    photonsPerPass_ = pathsOfPass(settings_.photonsPerPass, settings);
    photonTracer_.emplace(world, PhotonSettings{photonsPerPass_, settings_.eye.maxDepth, settings_.eye.directByPhotons},
                          sampler_);
    eyePaths_.emplace(world, settings_.eye);
    radiiMin_ = settings.cropMin;
    radiiSize_ = settings.cropSize();
    const std::size_t eyePaths =
        std::size_t(radiiSize_.x) * std::size_t(radiiSize_.y) * std::size_t(settings_.eyePathsPerPixel);
    if (settings_.rule == RadiusRule::PerPoint && radii_.size() != eyePaths) {
        if (!radii_.empty()) throw std::invalid_argument("the checkpoint is of a picture of another size");
        radii_.resize(eyePaths);
    }

    // The median over a sparse grid of pixels: cells of the photon grid shall be as large.
    constexpr int across = 64;
    Gathering pilot;
    for (int i = 0; i < across * across; ++i) {
        const V2i pixel(settings.cropMin.x + int(std::int64_t(i % across) * radiiSize_.x / across),
                        settings.cropMin.y + int(std::int64_t(i / across) * radiiSize_.y / across));
        traceEyePaths(world, makePass(world, 0), film, pixel, pixel + V2i(1, 1), pilot);
    }
    std::vector<float> radii;
    for (const GatherPoint& point : pilot.points)
        radii.push_back(point.disk.radius);
    if (radii.empty()) {
        typicalRadius_ = std::max(float(0.01 * eyePaths_->space().sceneRadius()), 1e-6f);
        return;
    }
    const auto middle = radii.begin() + std::ptrdiff_t(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    typicalRadius_ = *middle;
}

std::unique_ptr<PhotonLookup> PhotonMappingIntegrator::makeLookup(PhotonBlocks photons, float sharedFactor) {
    switch (settings_.search) {
    case PhotonSearch::Naive:
        return std::make_unique<NaiveLookup>(joined(std::move(photons)));
    case PhotonSearch::Tree:
        return std::make_unique<TreeLookup>(joined(std::move(photons)), tree_);
    case PhotonSearch::Grid:
        break;
    }
    return std::make_unique<PhotonGrid>(std::move(photons), rowRadii * typicalRadius_ * sharedFactor);
}

PhotonMappingIntegrator::Pass PhotonMappingIntegrator::makePass(const World& world,
                                                                         std::uint64_t index) const {
    return {index, passWavelengths(index, sampler_.seed), sharedRadiusFactor(index, settings_.alpha),
            passTime(world.shutter, index, sampler_.seed)};
}

void PhotonMappingIntegrator::traceEyePaths(const World& world, const Pass& pass, const Film& film, const V2i& first,
                                            const V2i& last, Gathering& gathering) const {
    const int perPixel = settings_.eyePathsPerPixel;
    for (int y = first.y; y < last.y; ++y)
        for (int x = first.x; x < last.x; ++x)
            for (int k = 0; k < perPixel; ++k) {
                // The same numbers in every pass make the same eye paths, seen at the pass's wavelengths.
                const std::uint64_t sample = settings_.fixedEyePaths
                                                 ? std::uint64_t(k)
                                                 : pass.index * std::uint64_t(perPixel) + std::uint64_t(k);
                SampleStream stream(sampler_, V2i(x, y), sample);
                PixelSample in = samplePixel(film.filter(), V2i(x, y), stream);
                in.camera.time = pass.time;
                const std::size_t pixelIndex =
                    std::size_t(y - radiiMin_.y) * std::size_t(radiiSize_.x) + std::size_t(x - radiiMin_.x);
                const std::uint64_t mixed = streamKey(x, y, k);
                EyeSample eye{V2i(x, y),
                              pixelIndex * std::size_t(perPixel) + std::size_t(k),
                              heroOf(mixed, pass.index),
                              in.weight,
                              0,
                              SampledSpectrum(0.f),
                              0};
                if (const auto camera = world.camera->generate(in.camera)) {
                    eye.cameraWeight = camera->weight;
                    const auto footprint = PixelFootprint::of(*world.camera, in.camera, camera->ray);
                    eye.light = eyePaths_->trace(camera->ray, footprint, pass.lambda.rotated(eye.hero), eye.hero,
                                                 stream, gathering.points, gathering.lostExits);
                }
                eye.pointsEnd = gathering.points.size();
                gathering.samples.push_back(eye);
            }
}

void PhotonMappingIntegrator::makeDisks(Gathering& g, float sharedFactor) const {
    std::size_t at = 0;
    for (const EyeSample& eye : g.samples) {
        const float factor = settings_.rule == RadiusRule::Shared ? sharedFactor : radii_[eye.pathIndex].factor;
        for (; at < eye.pointsEnd; ++at) {
            g.disks.push_back(g.points[at].disk);
            g.disks.back().radius *= factor;
        }
    }
}

void PhotonMappingIntegrator::gather(const World& world, Gathering& g, const PhotonLookup& lookup,
                                     const NearPhotons& found, std::size_t firstDisk, const Pass& pass,
                                     RenderCounters& counters) {
    const Gatherer gatherer{settings_.kernel, photonsPerPass_, settings_.eye.maxDepth, pass.time};
    std::size_t at = 0;
    std::uint64_t pairs = 0;
    for (EyeSample& eye : g.samples) {
        std::uint32_t ofPath = 0;
        RandomStream random(sampler_.seed, 0x676174686572ull, pass.index, eye.pathIndex);
        for (; at < eye.pointsEnd; ++at) {
            const auto near = found.of(firstDisk + at);
            fetchPhotons(lookup.photons(), found, firstDisk + at + 2);
            const float u = random.uniform();
            ofPath += std::uint32_t(near.size());
            if (!near.empty())
                eye.light +=
                    gatherer.light(world, eyePaths_->space(), g.points[at], g.disks[at], lookup.photons(), near, u);
        }
        pairs += ofPath;
        if (settings_.rule == RadiusRule::PerPoint) radii_[eye.pathIndex].found(ofPath, settings_.alpha);
    }
    if (!g.disks.empty()) {
        const auto smaller = [](const GatherDisk& a, const GatherDisk& b) { return a.radius < b.radius; };
        const auto [smallest, largest] = std::minmax_element(g.disks.begin(), g.disks.end(), smaller);
        counters.countRadius(smallest->radius);
        counters.countRadius(largest->radius);
    }
    counters.samples.fetch_add(g.samples.size() / std::uint64_t(settings_.eyePathsPerPixel), std::memory_order_relaxed);
    counters.gatherPoints.fetch_add(g.points.size(), std::memory_order_relaxed);
    counters.gathered.fetch_add(pairs, std::memory_order_relaxed);
    counters.lostExits.fetch_add(g.lostExits, std::memory_order_relaxed);
}

void PhotonMappingIntegrator::addToFilm(const Gathering& gathering, const Pass& pass, Film& film) const {
    for (const EyeSample& eye : gathering.samples)
        film.add(eye.pixel, rotatedBack(eye.light, eye.hero) * eye.cameraWeight, pass.lambda, eye.filterWeight,
                 unsigned(pass.index & 1));
}

void PhotonMappingIntegrator::addPass(const World& world, const Pass& pass, Film& film, RenderCounters& counters) {
    film.addPassWavelengths(pass.lambda);

    const auto start = Clock::now();
    PhotonPass photons = photonTracer_->trace(pass.index, pass.lambda, pass.time);
    const auto traced = Clock::now();
    counters.photonPaths.fetch_add(photonsPerPass_, std::memory_order_relaxed);
    counters.landedPaths.fetch_add(photons.landedPaths, std::memory_order_relaxed);
    counters.photons.fetch_add(photons.photons, std::memory_order_relaxed);
    counters.lostExits.fetch_add(photons.lostExits, std::memory_order_relaxed);
    const auto lookup = makeLookup(std::move(photons.blocks), pass.sharedFactor);
    counters.photonNanoseconds.fetch_add(nanoseconds(start, traced), std::memory_order_relaxed);
    counters.sortNanoseconds.fetch_add(nanoseconds(traced, Clock::now()), std::memory_order_relaxed);
    counters.photonBytes = std::max(counters.photonBytes.load(), std::uint64_t(lookup->memoryBytes()));

    if (settings_.search == PhotonSearch::Tree)
        gatherAtOnce(world, *lookup, pass, film, counters);
    else
        gatherInTiles(world, *lookup, pass, film, counters);
}

void PhotonMappingIntegrator::gatherInTiles(const World& world, const PhotonLookup& lookup, const Pass& pass,
                                            Film& film, RenderCounters& counters) {
    struct Buffers { // nothing is carried from tile to tile
        Gathering gathering;
        NearPhotons near;
    };
    tbb::enumerable_thread_specific<Buffers> buffers;
    std::atomic<std::uint64_t> tracing{0}, gathering{0}; // ns of all threads
    const auto begin = Clock::now();
    forEachTile(film.settings().cropMin, film.settings().cropMax, [&](const V2i& first, const V2i& last) {
        auto& [tile, near] = buffers.local();
        const auto start = Clock::now();
        tile.clear();
        traceEyePaths(world, pass, film, first, last, tile);
        const auto traced = Clock::now();
        makeDisks(tile, pass.sharedFactor);
        lookup.find(tile.disks, near);
        gather(world, tile, lookup, near, 0, pass, counters);
        addToFilm(tile, pass, film);
        tracing.fetch_add(nanoseconds(start, traced), std::memory_order_relaxed);
        gathering.fetch_add(nanoseconds(traced, Clock::now()), std::memory_order_relaxed);
    });
    const std::uint64_t whole = nanoseconds(begin, Clock::now());
    const auto eye = std::uint64_t(double(whole) * double(tracing) / std::max(1., double(tracing) + double(gathering)));
    counters.eyeNanoseconds.fetch_add(eye, std::memory_order_relaxed);
    counters.gatherNanoseconds.fetch_add(whole - eye, std::memory_order_relaxed);
}

/// The tree holds the points of the whole picture, which stay from pass to pass.
void PhotonMappingIntegrator::gatherAtOnce(const World& world, const PhotonLookup& lookup, const Pass& pass, Film& film,
                                           RenderCounters& counters) {
    constexpr int stripRows = 4;
    const V2i min = film.settings().cropMin, max = film.settings().cropMax;
    std::vector<Gathering> strips(std::size_t(max.y - min.y + stripRows - 1) / stripRows);
    const auto start = Clock::now();
    tbb::parallel_for(std::size_t(0), strips.size(), [&](std::size_t strip) {
        const PlainArithmetic plain;
        const int y = min.y + int(strip) * stripRows;
        traceEyePaths(world, pass, film, V2i(min.x, y), V2i(max.x, std::min(y + stripRows, max.y)), strips[strip]);
        makeDisks(strips[strip], pass.sharedFactor);
    });
    const auto traced = Clock::now();
    std::vector<std::size_t> firstDisks;
    std::vector<GatherDisk> disks;
    for (const Gathering& strip : strips) {
        firstDisks.push_back(disks.size());
        disks.insert(disks.end(), strip.disks.begin(), strip.disks.end());
    }
    NearPhotons near;
    lookup.find(disks, near);
    tbb::parallel_for(std::size_t(0), strips.size(), [&](std::size_t strip) {
        const PlainArithmetic plain;
        gather(world, strips[strip], lookup, near, firstDisks[strip], pass, counters);
        addToFilm(strips[strip], pass, film);
    });
    counters.eyeNanoseconds.fetch_add(nanoseconds(start, traced), std::memory_order_relaxed);
    counters.gatherNanoseconds.fetch_add(nanoseconds(traced, Clock::now()), std::memory_order_relaxed);
}

void PhotonMappingIntegrator::addPasses(const World& world, PassRange passes, Film& film, RenderCounters& counters) {
    if (!photonTracer_) prepare(world, film);
    for (std::uint64_t pass = passes.begin; pass < passes.end; ++pass)
        addPass(world, makePass(world, pass), film, counters);
}

std::vector<std::byte> PhotonMappingIntegrator::saveState() const {
    const auto bytes = std::as_bytes(std::span(radii_));
    return {bytes.begin(), bytes.end()};
}

void PhotonMappingIntegrator::restoreState(std::span<const std::byte> state) {
    if (state.size() % sizeof(PointRadius) != 0 || (state.empty() != (settings_.rule == RadiusRule::Shared)))
        throw std::invalid_argument("the checkpoint does not hold what this integrator needs");
    radii_.resize(state.size() / sizeof(PointRadius));
    if (!state.empty()) std::memcpy(radii_.data(), state.data(), state.size());
}

} // namespace vitrine
