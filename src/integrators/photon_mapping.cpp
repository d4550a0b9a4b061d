#include "integrators/photon_mapping.h"

#include "core/random.h"
#include "integrators/pixel_sample.h"
#include "integrators/tiles.h"
#include "paths/pass_wavelengths.h"
#include "photons/naive_lookup.h"
#include "photons/photon_grid.h"

#include <tbb/enumerable_thread_specific.h>

#include <cstring>

namespace vitrine {

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
    std::vector<GatherDisk> disks;
    NearPhotons near;
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
    const auto gathers = [](const Surface& surface) {
        if (surface.isInterface()) return false;
        SampledWavelengths lambda = SampledWavelengths::visible(0.5f);
        const Bsdf bsdf = surface.material->bsdf(MaterialPoint{}, lambda);
        return gatherProbability(bsdf) > 0;
    };
    if (std::none_of(world.surfaces.begin(), world.surfaces.end(), gathers))
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
        traceEyePaths(world, 0, passWavelengths(0, sampler_.seed), film, pixel, pixel + V2i(1, 1), pilot);
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

std::unique_ptr<PhotonLookup> PhotonMappingIntegrator::makeLookup(std::vector<Photon> photons, float radiusFactor) {
    switch (settings_.search) {
    case PhotonSearch::Naive:
        return std::make_unique<NaiveLookup>(std::move(photons));
    case PhotonSearch::Tree:
        return std::make_unique<TreeLookup>(std::move(photons), tree_);
    case PhotonSearch::Grid:
        break;
    }
    return std::make_unique<PhotonGrid>(std::move(photons), typicalRadius_ * radiusFactor);
}

void PhotonMappingIntegrator::traceEyePaths(const World& world, std::uint64_t pass, const SampledWavelengths& lambda,
                                            const Film& film, const V2i& first, const V2i& last,
                                            Gathering& gathering) const {
    const int perPixel = settings_.eyePathsPerPixel;
    for (int y = first.y; y < last.y; ++y)
        for (int x = first.x; x < last.x; ++x)
            for (int k = 0; k < perPixel; ++k) {
                // The same numbers in every pass make the same eye paths, seen at the pass's wavelengths.
                const std::uint64_t sample =
                    settings_.fixedEyePaths ? std::uint64_t(k) : pass * std::uint64_t(perPixel) + std::uint64_t(k);
                SampleStream stream(sampler_, V2i(x, y), sample);
                const PixelSample in = samplePixel(film.filter(), V2i(x, y), stream);
                const std::size_t pixelIndex =
                    std::size_t(y - radiiMin_.y) * std::size_t(radiiSize_.x) + std::size_t(x - radiiMin_.x);
                const std::uint64_t mixed = streamKey(x, y, k);
                EyeSample eye{V2i(x, y),
                              pixelIndex * std::size_t(perPixel) + std::size_t(k),
                              heroOf(mixed, pass),
                              in.weight,
                              0,
                              SampledSpectrum(0.f),
                              0};
                if (const auto camera = world.camera->generate(in.camera)) {
                    eye.cameraWeight = camera->weight;
                    const auto footprint = PixelFootprint::of(*world.camera, in.camera, camera->ray);
                    eye.light = eyePaths_->trace(camera->ray, footprint, lambda.rotated(eye.hero), eye.hero, stream,
                                                 gathering.points, gathering.lostExits);
                }
                eye.pointsEnd = gathering.points.size();
                gathering.samples.push_back(eye);
            }
}

void PhotonMappingIntegrator::gather(const World& world, Gathering& g, const PhotonLookup& lookup, std::uint64_t pass,
                                     float sharedFactor, RenderCounters& counters) {
    std::size_t at = 0;
    for (const EyeSample& eye : g.samples) {
        const float factor = settings_.rule == RadiusRule::Shared ? sharedFactor : radii_[eye.pathIndex].factor;
        for (; at < eye.pointsEnd; ++at) {
            g.disks.push_back(g.points[at].disk);
            g.disks.back().radius *= factor;
        }
    }
    lookup.find(g.disks, g.near);
    const Gatherer gatherer{settings_.kernel, photonsPerPass_, settings_.eye.maxDepth};
    at = 0;
    for (EyeSample& eye : g.samples) {
        std::uint32_t found = 0;
        RandomStream random(sampler_.seed, 0x676174686572ull, pass, eye.pathIndex);
        for (; at < eye.pointsEnd; ++at) {
            const auto near = g.near.of(at);
            const float u = random.uniform();
            found += std::uint32_t(near.size());
            if (!near.empty())
                eye.light +=
                    gatherer.light(world, eyePaths_->space(), g.points[at], g.disks[at], lookup.photons(), near, u);
        }
        if (settings_.rule == RadiusRule::PerPoint) radii_[eye.pathIndex].found(found, settings_.alpha);
    }
    if (!g.disks.empty()) {
        const auto smaller = [](const GatherDisk& a, const GatherDisk& b) { return a.radius < b.radius; };
        const auto [smallest, largest] = std::minmax_element(g.disks.begin(), g.disks.end(), smaller);
        counters.countRadius(smallest->radius);
        counters.countRadius(largest->radius);
    }
    counters.gatherPoints.fetch_add(g.points.size(), std::memory_order_relaxed);
    counters.gathered.fetch_add(g.near.size(), std::memory_order_relaxed);
    counters.lostExits.fetch_add(g.lostExits, std::memory_order_relaxed);
}

void PhotonMappingIntegrator::addToFilm(const Gathering& gathering, const SampledWavelengths& lambda,
                                        std::uint64_t pass, Film& film) const {
    for (const EyeSample& eye : gathering.samples)
        film.add(eye.pixel, rotatedBack(eye.light, eye.hero) * eye.cameraWeight, lambda, eye.filterWeight,
                 unsigned(pass & 1));
}

void PhotonMappingIntegrator::addPass(const World& world, std::uint64_t pass, Film& film, RenderCounters& counters) {
    const FilmSettings& settings = film.settings();
    const SampledWavelengths lambda = passWavelengths(pass, sampler_.seed);
    film.addPassWavelengths(lambda);

    PhotonPass photons = photonTracer_->trace(pass, lambda);
    counters.photonPaths.fetch_add(photonsPerPass_, std::memory_order_relaxed);
    counters.landedPaths.fetch_add(photons.landedPaths, std::memory_order_relaxed);
    counters.photons.fetch_add(photons.photons.size(), std::memory_order_relaxed);
    counters.lostExits.fetch_add(photons.lostExits, std::memory_order_relaxed);
    const float sharedFactor = sharedRadiusFactor(pass, settings_.alpha);
    const auto lookup = makeLookup(std::move(photons.photons), sharedFactor);
    counters.photonBytes = std::max(counters.photonBytes.load(), std::uint64_t(lookup->memoryBytes()));

    const auto addPart = [&](const V2i& first, const V2i& last, Gathering& gathering) {
        gathering.clear();
        traceEyePaths(world, pass, lambda, film, first, last, gathering);
        gather(world, gathering, *lookup, pass, sharedFactor, counters);
        addToFilm(gathering, lambda, pass, film);
        counters.samples.fetch_add(std::uint64_t(last.x - first.x) * std::uint64_t(last.y - first.y),
                                   std::memory_order_relaxed);
    };
    if (settings_.search == PhotonSearch::Tree) {
        // The tree holds the points of the whole picture, which stay from pass to pass.
        const PlainArithmetic plain;
        Gathering whole;
        addPart(settings.cropMin, settings.cropMax, whole);
        return;
    }
    tbb::enumerable_thread_specific<Gathering> gatherings; // buffers only: nothing is carried from tile to tile
    forEachTile(settings.cropMin, settings.cropMax,
                [&](const V2i& first, const V2i& last) { addPart(first, last, gatherings.local()); });
}

void PhotonMappingIntegrator::addPasses(const World& world, PassRange passes, Film& film, RenderCounters& counters) {
    if (!photonTracer_) prepare(world, film);
    for (std::uint64_t pass = passes.begin; pass < passes.end; ++pass)
        addPass(world, pass, film, counters);
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
