// Paths that start at lights.
#pragma once

#include "core/plain_arithmetic.h"
#include "core/sampler.h"
#include "paths/pass_wavelengths.h"
#include "paths/walk.h"
#include "photons/photon.h"

#include <tbb/parallel_for.h>

namespace vitrine {

/// Light paths, each a pure function of (seed, pass, path). Photons and light tracing differ in what they do at vertices.
class LightPaths {
  public:
    /// How a path comes to a vertex.
    struct Arrival {
        int depth = 0; ///< scattering events before
        int hero = 0;  ///< of the path, among the pass's wavelengths
        LightHistory history = LightHistory::Scattered;
    };

    /// \param world outlives this; must have lights  \param maxVertices surfaces a path may scatter at
    LightPaths(const World& world, int maxVertices, const SamplerSettings& sampler);

    /// Follows a path and calls atVertex(vertex, bsdf, walk, arrival, stream) at each surface that it meets and that
    /// scatters. walk.beta is the power that arrives there, hero first.
    /// \param lambda, time of the pass  \return Walk::lostExits()
    template <class AtVertex>
    int follow(std::uint64_t pass, std::uint64_t path, const SampledWavelengths& lambda, double time,
               AtVertex&& atVertex) const;

    /// Dimensions of the stream that a vertex leaves for atVertex, from its stream's position on.
    static constexpr std::uint32_t vertexDimensions = 3;

  private:
    /// Dimensions of the sample streams: which light, where, which way; then those of vertices and their scattering.
    static constexpr std::uint32_t emissionDimensions = 3, bounceDimensions = vertexDimensions + 3;

    SampleStream stream(std::uint64_t pass, std::uint64_t path) const;
    InteriorStack interiorRound(const Light* light, const Ray& ray) const;

    const World& world_;
    int maxVertices_;
    SamplerSettings sampler_;
    /// Solids round each light, where they are the same for all its rays.
    std::unordered_map<const Light*, InteriorStack> interiors_;
};

/// Whether there is a surface that is not polished: else photons land nowhere, and the camera cannot be connected to.
bool hasUnpolishedSurface(const World& world);

/// Paths that one thread traces in a row.
inline constexpr std::uint64_t pathsOfBlock = 4096;

/// Calls onPath(path, block) for all paths of a pass, in blocks that are the same for any number of threads; those of a block
/// in order, on one thread, with onEnd(block) when they are done. \return the blocks, which began as `empty`
template <class Block, class OnPath, class OnEnd>
std::vector<Block> traceInBlocks(std::uint64_t paths, const Block& empty, OnPath&& onPath, OnEnd&& onEnd) {
    std::vector<Block> blocks((paths + pathsOfBlock - 1) / pathsOfBlock, empty);
    tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
        const PlainArithmetic plain;
        for (std::uint64_t path = b * pathsOfBlock; path < std::min(paths, (b + 1) * pathsOfBlock); ++path)
            onPath(path, blocks[b]);
        onEnd(blocks[b]);
    });
    return blocks;
}

template <class Block, class OnPath>
std::vector<Block> traceInBlocks(std::uint64_t paths, const Block& empty, OnPath&& onPath) {
    return traceInBlocks(paths, empty, onPath, [](Block&) {});
}

template <class AtVertex>
int LightPaths::follow(std::uint64_t pass, std::uint64_t path, const SampledWavelengths& lambda, double time,
                       AtVertex&& atVertex) const {
    SampleStream numbers = stream(pass, path);
    const auto chosen = world_.lights.sample(numbers.get1D());
    const V2f uPosition = numbers.get2D(), uDirection = numbers.get2D();
    Arrival arrival{0, heroOf(path, pass), LightHistory::Scattered};
    const SampledWavelengths own = lambda.rotated(arrival.hero);
    const auto emission = chosen.light->emit(uPosition, uDirection, own, time);
    if (!emission) return 0;
    Ray ray = emission->ray;
    ray.time = time;
    Walk walk(world_, TransportMode::Importance, own, interiorRound(chosen.light, ray));
    walk.ray = ray;
    walk.beta = emission->power / chosen.probability;

    bool polished = true; // all surfaces so far
    Vertex vertex;
    for (int& depth = arrival.depth; depth < maxVertices_ && walk.advance(vertex);) {
        if (!vertex.scatters) {
            walk.passThrough(vertex);
            continue;
        }
        const Bsdf bsdf = walk.bsdfAt(vertex);
        const std::uint32_t dimension = emissionDimensions + std::uint32_t(depth) * bounceDimensions;
        numbers.setDimension(dimension);
        if (depth > 0 && polished)
            arrival.history = chosen.light->isDelta() ? LightHistory::Hidden : LightHistory::Caustic;
        else
            arrival.history = LightHistory::Scattered;
        atVertex(vertex, bsdf, walk, arrival, numbers);
        if (++depth == maxVertices_) break;
        numbers.setDimension(dimension + vertexDimensions);
        const float power = walk.beta.average();
        const float uLobe = numbers.get1D();
        const auto scattered = walk.scatter(vertex, bsdf, uLobe, numbers.get2D());
        if (!scattered) break;
        polished &= scattered->specular;
        // Survival by what the scattering left keeps the power of photons even: many alike serve better than a few strong.
        const float survival = walk.beta.average() / power;
        if (survival < 1) {
            if (numbers.get1D() >= survival) break;
            walk.beta /= survival;
        }
    }
    return walk.lostExits();
}

} // namespace vitrine
