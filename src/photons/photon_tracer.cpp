#include "photons/photon_tracer.h"

#include "photons/gather_point.h"

namespace vitrine {

PhotonTracer::PhotonTracer(const World& world, const PhotonSettings& settings, const SamplerSettings& sampler)
    : space_(world), settings_(settings), paths_(world, std::min(settings.maxDepth, Photon::maxDepth + 1), sampler) {}

PhotonPass PhotonTracer::trace(std::uint64_t pass, const SampledWavelengths& lambda, double time) const {
    struct Block {
        std::vector<Photon> photons;
        std::uint64_t landedPaths = 0, lostExits = 0;
    };
    auto blocks = traceInBlocks(
        settings_.paths, Block{},
        [&](std::uint64_t path, Block& block) {
            const std::size_t before = block.photons.size();
            block.lostExits += std::uint64_t(paths_.follow(
                pass, path, lambda, time,
                [&](const Vertex& vertex, const Bsdf& bsdf, const Walk& walk, const LightPaths::Arrival& arrival,
                    SampleStream&) {
                    if ((arrival.depth > 0 || settings_.keepDirect) && gatherProbability(bsdf, arrival.history) > 0) {
                        const SurfacePoint& at = vertex.point();
                        const bool front = vertex.wo.dot(at.ng) > 0;
                        block.photons.emplace_back(space_.fromWorld(at.p, front ? at.ng : -at.ng), vertex.wo, front,
                                                   arrival.depth, arrival.history,
                                                   rotatedBack(walk.beta, arrival.hero));
                    }
                }));
            block.landedPaths += block.photons.size() > before;
        },
        // Most of a pass's memory is here: no room to spare.
        [](Block& block) { block.photons.shrink_to_fit(); });

    PhotonPass all;
    all.blocks.reserve(blocks.size());
    for (Block& block : blocks) {
        all.photons += block.photons.size();
        all.landedPaths += block.landedPaths;
        all.lostExits += block.lostExits;
        all.blocks.push_back(std::move(block.photons));
    }
    return all;
}

} // namespace vitrine
