// Textures "imagemap".
#pragma once

#include "scene/context.h"

namespace vitrine {

FloatTexturePtr buildFloatImageTexture(BuildContext& context, const TextureNode& node);
SpectrumTexturePtr buildSpectrumImageTexture(BuildContext& context, const TextureNode& node, SpectrumUse use);

} // namespace vitrine
