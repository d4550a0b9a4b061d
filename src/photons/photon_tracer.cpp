#include "photons/photon_tracer.h"

#include "photons/gather_point.h"

namespace vitrine {

PhotonTracer::PhotonTracer(const World& world, const PhotonSettings& settings, const SamplerSettings& sampler)
    : space_(world), settings_(settings), paths_(world, std::min(settings.maxDepth, Photon::maxDepth + 1), sampler) {}

PhotonPass PhotonTracer::trace(std::uint64_t pass, const SampledWavelengths& lambda) const {
    auto blocks = traceInBlocks(settings_.paths, PhotonPass{}, [&](std::uint64_t path, PhotonPass& block) {
        const std::size_t before = block.photons.size();
        block.lostExits += std::uint64_t(paths_.follow(
            pass, path, lambda,
            [&](const Vertex& vertex, const Bsdf& bsdf, const Walk& walk, int depth, int hero, SampleStream&) {
                if ((depth > 0 || settings_.keepDirect) && gatherProbability(bsdf) > 0)
                    block.photons.emplace_back(space_.fromWorld(vertex.point().p), vertex.wo, depth,
                                               rotatedBack(walk.beta, hero));
            }));
        block.landedPaths += block.photons.size() > before;
    });

    PhotonPass all;
    std::vector<std::size_t> starts;
    std::size_t count = 0;
    for (const PhotonPass& block : blocks) {
        starts.push_back(count);
        count += block.photons.size();
        all.landedPaths += block.landedPaths;
        all.lostExits += block.lostExits;
    }
    all.photons.resize(count);
    tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
        std::copy(blocks[b].photons.begin(), blocks[b].photons.end(), all.photons.begin() + std::ptrdiff_t(starts[b]));
        std::vector<Photon>().swap(blocks[b].photons);
    });
    return all;
}

} // namespace vitrine
