#include "photons/eye_paths.h"

namespace vitrine {

namespace {

/// A bounce takes so many dimensions of the sample stream.
constexpr std::uint32_t bounceDimensions = 6;
/// How often a path forks, and the least share of the light that a branch must carry.
constexpr int maxForks = 4;
constexpr float leastBranch = 0.01f;
/// A disk as large as the scene tells nothing of a place, and single precision cannot tell the points of a much smaller one
/// apart: radii lie between so many times its resolution and this part of the scene's radius.
constexpr double leastRadius = 4, largestRadius = 0.05;

} // namespace

struct EyePaths::Path {
    Walk walk;
    int hero;
    std::uint32_t firstDimension;
    int depth = 0; ///< scattering events so far
    int forks = 0;
    float branch = 1; ///< share of the light that this branch carries
    LastBounce last{};
    bool ends = false; ///< it has gathered and only looks for light that its last direction meets
    /// At its last point that is not polished: what polished surfaces bring from lights has counted there.
    bool causticsGathered = false;
};

EyePaths::EyePaths(const World& world, const EyePathSettings& settings)
    : world_(world), lightReach_(world), space_(world), settings_(settings) {
    for (const LightPtr& light : world.lights.lights())
        hasHiddenLight_ |= light->isDelta();
}

float EyePaths::baseRadius(const V3f& center, double pixelSide) const {
    if (settings_.radius > 0) return settings_.radius;
    const double radius = settings_.radiusInPixels * pixelSide, scene = space_.sceneRadius();
    if (!(scene > 0)) return float(radius);
    return float(std::max(std::min(radius, largestRadius * scene), leastRadius * space_.resolution(center)));
}

void EyePaths::gather(const Path& path, const Vertex& vertex, const Bsdf& bsdf, LightHistory from,
                      std::vector<GatherPoint>& points) const {
    const SurfacePoint& at = vertex.point();
    const V3f center = space_.fromWorld(at.p);
    points.push_back({{center, at.ng, baseRadius(center, path.walk.pixelSide())},
                      vertex.frame,
                      vertex.wo,
                      bsdf,
                      path.hero,
                      path.walk.beta,
                      path.depth,
                      from});
}

bool EyePaths::forks(const Path& path, const Bsdf& bsdf) const {
    constexpr unsigned both = lobe::reflection | lobe::transmission;
    return settings_.branch && path.forks < maxForks && path.branch >= leastBranch && !bsdf.isNonSpecular() &&
           (bsdf.lobes() & both) == both;
}

SampledSpectrum EyePaths::trace(const Ray& ray, const PixelFootprint& footprint, const SampledWavelengths& lambda,
                                int hero, SampleStream& stream, std::vector<GatherPoint>& points,
                                std::uint64_t& lostExits) const {
    SampledSpectrum light(0.f);
    follow(Path{eyeWalk(world_, ray, lambda, footprint), hero, stream.dimension()}, stream, points, light, lostExits);
    return light;
}

void EyePaths::follow(Path path, SampleStream& stream, std::vector<GatherPoint>& points, SampledSpectrum& light,
                      std::uint64_t& lostExits) const {
    Walk& walk = path.walk;
    const int lostBefore = walk.lostExits();
    Vertex vertex;
    for (;;) {
        const bool counts = !(path.causticsGathered && path.last.specular);
        if (!walk.advance(vertex)) {
            if (counts) light += walk.beta * escapedLight(world_, walk, path.last);
            break;
        }
        if (counts) light += walk.beta * emittedLight(world_, walk, vertex, path.last);
        if (!vertex.scatters) {
            walk.passThrough(vertex);
            continue;
        }
        if (path.ends || path.depth == settings_.maxDepth) break;

        const Bsdf bsdf = walk.bsdfAt(vertex);
        stream.setDimension(path.firstDimension + std::uint32_t(path.depth) * bounceDimensions);
        const float uLight = stream.get1D(), uGather = stream.get1D();
        const V2f uDirect = stream.get2D();
        const float uLobe = stream.get1D();
        const V2f uDirection = stream.get2D();

        const bool gatheredBefore = path.causticsGathered;
        const bool gathers = uGather < gatherProbability(bsdf, LightHistory::Scattered);
        // Where photons bring the direct light nothing else does.
        const LightReceiver at = receiverAt(vertex, bsdf);
        const bool asksLights = bsdf.isNonSpecular() && !(gathers && settings_.directByPhotons);
        if (asksLights && !world_.lights.empty())
            light += walk.beta * directLight(world_, walk, vertex, bsdf, at, uLight, uDirect);
        if (gathers) {
            gather(path, vertex, bsdf, LightHistory::Scattered, points);
            const bool hasDelta = bsdf.lobes() & lobe::specular;
            if (settings_.directByPhotons && !hasDelta) break;
            path.ends = true;
        } else if (bsdf.isNonSpecular()) {
            path.causticsGathered = uGather < gatherProbability(bsdf, LightHistory::Caustic);
            if (path.causticsGathered)
                gather(path, vertex, bsdf, LightHistory::Caustic, points);
            else if (hasHiddenLight_)
                gather(path, vertex, bsdf, LightHistory::Hidden, points);
        }
        ++path.depth;

        if (forks(path, bsdf)) {
            ++path.forks;
            Path other = path;
            // The lobe is chosen here, both are followed: each with its own part of the light.
            if (const auto through = other.walk.scatter(vertex, bsdf, 1 - 0x1p-24f, uDirection)) {
                if (through->transmission) {
                    other.walk.beta *= through->pdf;
                    other.branch *= through->pdf;
                    follow(std::move(other), stream, points, light, lostExits);
                }
            }
            const auto back = walk.scatter(vertex, bsdf, 0, uDirection);
            if (!back || back->transmission) break;
            walk.beta *= back->pdf;
            path.branch *= back->pdf;
            path.last = {at, back->pdf, true};
            continue;
        }
        const auto scattered = walk.scatter(vertex, bsdf, uLobe, uDirection);
        if (!scattered) break;
        if (scattered->specular) {
            // Also beside other lobes, on a polished coat, a delta lobe is a mirror: what was gathered is the others'.
            path.ends = false;
            path.causticsGathered = gatheredBefore;
        } else if (path.ends && settings_.directByPhotons) {
            break;
        }
        path.last = {at, scattered->pdf, scattered->specular};
        if (path.ends && !lightReach_.mayMeet(walk.ray)) break;
    }
    lostExits += std::uint64_t(walk.lostExits() - lostBefore);
}

} // namespace vitrine
