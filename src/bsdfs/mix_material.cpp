#include "bsdfs/mix_material.h"

#include <fmt/format.h>

#include <stdexcept>

namespace vitrine {

namespace {

bool isSame(const SpectrumPtr& a, const SpectrumPtr& b) {
    const auto at = [](const SpectrumPtr& s, float lambda) { return s ? (*s)(lambda) : 0.f; };
    for (float lambda = lambdaMin; lambda <= lambdaMax; lambda += 1)
        if (at(a, lambda) != at(b, lambda)) return false;
    return true;
}

/// The solid that a surface of both bounds.
const Interior* common(const Interior* a, const Interior* b) {
    if (!a || !b) return a ? a : b;
    if (a->priority == b->priority && isSame(a->eta, b->eta) && isSame(a->absorption, b->absorption)) return a;
    throw std::invalid_argument("the two materials of a mix bound different solids: their \"eta\", \"absorption\" and "
                                "\"priority\" must be the same");
}

const Material& checked(const MaterialPtr& part) {
    if (!part || part->isInterface()) throw std::invalid_argument("an \"interface\" material cannot be part of a mix");
    return *part;
}

} // namespace

MixMaterial::MixMaterial(MaterialPtr first, MaterialPtr second, FloatInput amount, std::uint64_t salt)
    : first_(std::move(first)), second_(std::move(second)), amount_(std::move(amount)), salt_(salt),
      interior_(common(checked(first_).interior(), checked(second_).interior())) {
    if (!std::isfinite(amount_.constant()))
        throw std::invalid_argument(fmt::format("\"amount\" is {}, but must be finite", amount_.constant()));
}

const Material& MixMaterial::resolve(const MaterialPoint& point, const SampledWavelengths& lambda) const {
    const float u = RandomStream(chanceKey(point, lambda), salt_).uniform();
    return (u < amount_(point) ? second_ : first_)->resolve(point, lambda);
}

} // namespace vitrine
