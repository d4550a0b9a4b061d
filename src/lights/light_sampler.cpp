#include "lights/light_sampler.h"

#include "core/random.h"
#include "lights/scene_sphere.h"

namespace vitrine {

namespace {

/// The share of the choice that goes to all lights that shine alike. Power tells nothing of distance and shadow: where
/// another light than the mightiest is all there is, the variance grows by no more than the inverse of its part of this.
constexpr double evenShare = 0.2;
/// The same among the lights of a tree, which knows distances: so much that no light that shines is ever left out.
constexpr double evenShareInTree = 0.01;

/// Half of the numbers that choose a light are multiples of 2^-24, while a light among many may be less likely. What lies
/// between is filled by bits that the numbers for the direction make: fixed, and as good as random.
double refined(float u, const V2f& other) {
    const std::uint64_t bits = streamKey(std::bit_cast<std::uint32_t>(other.x), std::bit_cast<std::uint32_t>(other.y));
    return double(u) + unitDouble(bits) * 0x1p-24;
}

} // namespace

struct LightSampler::Shine {
    double power = 0;    ///< as a picture sees it: by the sum of the matching functions
    bool isDark = false; ///< at every nanometre
};

/// Wavelengths less than a nanometre apart over the whole range: nothing between them, however narrow, is missed, as
/// what lights emit has one value a nanometre.
LightSampler::Shine LightSampler::shineOf(const Light& light, const SceneSphere& lit) {
    constexpr int strata = 236; // of four wavelengths each: half a nanometre
    Shine shine{0, true};
    // Shapes of infinite area cannot be sampled.
    if (const Box3d box = light.bounds(); !box.isEmpty() && !isFinite(box.size())) return shine;
    for (int i = 0; i < strata; ++i) {
        const auto lambda = SampledWavelengths::uniform((float(i) + 0.5f) / strata / spectrumSamples);
        const SampledSpectrum power = light.powerInto(lit, lambda);
        shine.isDark &= power.isBlack();
        const SampledSpectrum seen = cieX().sample(lambda) + cieY().sample(lambda) + cieZ().sample(lambda);
        // In a scene of enormous size power may overflow.
        shine.power += double(std::min((power * seen).average(), std::numeric_limits<float>::max()));
    }
    // Into a tiny sphere lights at infinity shine less than floats hold.
    if (shine.isDark && lit.radius < 1) shine.isDark = shineOf(light, {lit.center, 1}).isDark;
    return shine;
}

bool LightSampler::isDark(const Light& light, const SceneSphere& lit) {
    return shineOf(light, lit).isDark;
}

namespace {

/// Of entries that have `power` and `isDark`: so much of each in proportion to power, the even share alike.
template <class Shines>
std::vector<double> weightsByPower(const Shines& shines, double even) {
    double total = 0;
    std::size_t shining = 0;
    for (const auto& shine : shines) {
        total += shine.power;
        shining += !shine.isDark;
    }
    std::vector<double> weights;
    for (const auto& shine : shines) {
        const double alike = shine.isDark ? 0 : 1 / double(shining);
        weights.push_back(total > 0 ? (1 - even) * shine.power / total + even * alike : alike);
    }
    return weights;
}

bool isBounded(const Light& light) {
    return !light.bounds().isEmpty();
}

} // namespace

LightSampler::LightSampler(std::vector<LightPtr> lights, const SceneSphere& lit, Choice choice)
    : lights_(std::move(lights)) {
    if (lights_.empty()) return;
    std::vector<Shine> shines;
    if (choice != Choice::Uniform)
        for (const LightPtr& light : lights_)
            shines.push_back(shineOf(*light, lit));
    table_ = AliasTable(choice == Choice::Uniform ? std::vector<double>(lights_.size(), 1.)
                                                  : weightsByPower(shines, evenShare));
    for (std::size_t i = 0; i < lights_.size(); ++i)
        known_[lights_[i].get()].probability = table_.probability(int(i));
    if (wantsTree(choice)) plantTree(shines);
}

bool LightSampler::wantsTree(Choice choice) const {
    if (choice != Choice::Fitting) return choice == Choice::Tree;
    std::size_t parts = 0;
    for (const LightPtr& light : lights_)
        if (isBounded(*light)) parts += light->partCount();
    return parts > fewParts;
}

/// All lights of the tree count as one beside each light at infinity.
void LightSampler::plantTree(const std::vector<Shine>& shines) {
    std::vector<Shine> inTree, groups{{0, true}};
    std::vector<const Light*> bounded;
    groups_.emplace_back();
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        if (shines[i].isDark) continue;
        if (isBounded(*lights_[i])) {
            bounded.push_back(lights_[i].get());
            inTree.push_back(shines[i]);
            groups[0].power += shines[i].power;
            groups[0].isDark = false;
        } else {
            groups_.push_back({lights_[i].get()});
            groups.push_back(shines[i]);
        }
    }
    std::vector<LightBounds> bounds;
    const std::vector<double> weights = weightsByPower(inTree, evenShareInTree);
    for (std::size_t i = 0; i < bounded.size(); ++i) {
        known_[bounded[i]].firstLeaf = std::uint32_t(leaves_.size());
        for (unsigned part = 0; part < bounded[i]->partCount(); ++part) {
            leaves_.push_back({bounded[i], part});
            bounds.push_back(bounded[i]->partBounds(part));
            bounds.back().intensity *= weights[i];
        }
    }
    tree_ = LightTree(bounds);
    const std::vector<double> shares = weightsByPower(groups, evenShare);
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        groups_[i].begin = i > 0 ? groups_[i - 1].begin + groups_[i - 1].probability : 0;
        groups_[i].probability = shares[i];
        if (groups_[i].light) known_[groups_[i].light].group = shares[i];
    }
    treeProbability_ = shares[0];
}

float LightSampler::probability(const Light* light) const {
    const auto found = known_.find(light);
    return found == known_.end() ? 0 : found->second.probability;
}

std::optional<LightSample> LightSampler::sample(const LightReceiver& at, float uLight, const V2f& u,
                                                const SampledWavelengths& lambda) const {
    std::optional<LightSample> result;
    double probability = 0;
    if (!usesTree()) {
        const Sample chosen = sample(uLight);
        probability = chosen.probability;
        result = chosen.light->sample(at, u, lambda);
    } else {
        const double fine = refined(uLight, u);
        const auto group = std::upper_bound(groups_.begin() + 1, groups_.end(), fine,
                                            [](double x, const Group& g) { return x < g.begin; }) -
                           1;
        probability = group->probability;
        if (group->light) {
            result = group->light->sample(at, u, lambda);
        } else {
            const auto leaf = tree_.sample(at, std::min(fine / probability, 1 - 0x1p-53));
            if (!leaf) return {};
            probability *= leaf->probability;
            result = leaves_[leaf->leaf].light->samplePart(leaves_[leaf->leaf].part, at, u, lambda);
        }
    }
    if (result) result->pdf = float(probability) * result->pdf;
    return result;
}

float LightSampler::pdf(const LightReceiver& at, const AreaLight& light, const PrimitiveHit& hit,
                        const SurfacePoint& point) const {
    if (!usesTree()) return probability(&light) * light.pdf(at, hit, point);
    const auto found = known_.find(&light);
    if (found == known_.end() || found->second.firstLeaf == Known{}.firstLeaf) return 0;
    const unsigned leaf = found->second.firstLeaf + (light.partCount() > 1 ? hit.prim : 0);
    return float(treeProbability_ * tree_.probability(at, leaf)) * light.partPdf(at, hit, point);
}

float LightSampler::pdf(const Light& infinite, const V3f& w) const {
    if (!usesTree()) return probability(&infinite) * infinite.pdf(w);
    const auto found = known_.find(&infinite);
    return found == known_.end() ? 0 : float(found->second.group) * infinite.pdf(w);
}

std::size_t LightSampler::memoryBytes() const {
    return tree_.memoryBytes() + leaves_.capacity() * sizeof(Leaf);
}

} // namespace vitrine
