#include "bsdfs/interface_material.h"

namespace vitrine {

Bsdf InterfaceMaterial::bsdf(const MaterialPoint&, SampledWavelengths&) const {
    return DielectricBsdf(1);
}

} // namespace vitrine
