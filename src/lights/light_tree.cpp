#include "lights/light_tree.h"

#include "lights/light_twigs.h"

namespace vitrine {

/// The children's parts of the choice.
struct LightTree::Shares {
    float importance[EightLights::lanes];
    double sum = 0;

    Shares(const EightLights& lights, const LightReceiver& receiver) {
        lights.importances(receiver, importance);
        for (const float each : importance)
            sum += double(each);
    }
    /// \pre sum > 0
    double of(unsigned lane) const { return double(importance[lane]) / sum; }
    /// The lane that u falls to, and what u is within it.
    unsigned draw(double& u) const {
        const double target = u * sum;
        double below = 0;
        unsigned lane = 0, last = 0;
        for (; lane < EightLights::lanes; ++lane) {
            const double each = double(importance[lane]);
            if (!(each > 0)) continue;
            last = lane;
            if (target < below + each) break;
            below += each;
        }
        // Rounding may lead past the last one.
        if (lane == EightLights::lanes) below -= double(importance[last]);
        u = std::clamp((target - below) / double(importance[last]), 0., 1 - 0x1p-53);
        return last;
    }
};

LightTree::LightTree(const std::vector<LightBounds>& lights) : leaves_(lights.size()) {
    const LightTwigs twigs(lights);
    if (!twigs.empty()) widen(twigs, 0, {});
}

/// Makes a node of a twig and those below it: again and again it opens the one that has most light over the largest place.
std::uint32_t LightTree::widen(const LightTwigs& twigs, std::uint32_t twig, Spot parent) {
    const auto doubt = [&](std::uint32_t t) {
        return twigs[t].isLeaf() ? -1 : twigs[t].bounds.intensity * twigs[t].bounds.box.size().length2();
    };
    std::vector<std::uint32_t> children{twig};
    while (children.size() < EightLights::lanes) {
        const auto widest = std::max_element(children.begin(), children.end(),
                                             [&](std::uint32_t a, std::uint32_t b) { return doubt(a) < doubt(b); });
        if (twigs[*widest].isLeaf()) break;
        const std::uint32_t opened = *widest;
        *widest = twigs[opened].first;
        children.push_back(twigs[opened].second);
    }
    const auto node = std::uint32_t(nodes_.size());
    nodes_.emplace_back();
    std::vector<LightBounds> bounds;
    for (const std::uint32_t child : children)
        bounds.push_back(twigs[child].bounds);
    nodes_[node].lights = EightLights(bounds);
    nodes_[node].parent = parent;
    for (unsigned lane = 0; lane < children.size(); ++lane) {
        const Spot here{node, lane};
        if (twigs[children[lane]].isLeaf()) {
            nodes_[node].leaves |= 1u << lane;
            nodes_[node].next[lane] = twigs[children[lane]].light;
            leaves_[twigs[children[lane]].light] = here;
        } else {
            const std::uint32_t next = widen(twigs, children[lane], here);
            nodes_[node].next[lane] = next;
        }
    }
    return node;
}

std::optional<LightTree::Choice> LightTree::sample(const LightReceiver& receiver, double u) const {
    if (empty()) return {};
    double probability = 1;
    for (std::uint32_t node = 0;;) {
        const Shares shares(nodes_[node].lights, receiver);
        if (!(shares.sum > 0)) return {};
        const unsigned lane = shares.draw(u);
        probability *= shares.of(lane);
        const std::uint32_t next = nodes_[node].next[lane];
        if (nodes_[node].leaves >> lane & 1) return Choice{next, probability};
        node = next;
    }
}

double LightTree::probability(const LightReceiver& receiver, unsigned leaf) const {
    if (leaves_[leaf].node == nowhere) return 0;
    double probability = 1;
    for (Spot at = leaves_[leaf]; at.node != nowhere; at = nodes_[at.node].parent) {
        const Shares shares(nodes_[at.node].lights, receiver);
        if (!(shares.importance[at.lane] > 0)) return 0;
        probability *= shares.of(at.lane);
    }
    return probability;
}

} // namespace vitrine
