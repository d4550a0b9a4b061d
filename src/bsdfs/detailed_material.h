// A material on a surface that is shaded with relief.
#pragma once

#include "bsdfs/material.h"

namespace vitrine {

class DetailedMaterial final : public Material {
  public:
    /// \pre material is no mix: those are on surfaces with the relief of what is there
    DetailedMaterial(MaterialPtr material, SurfaceDetailPtr detail)
        : material_(std::move(material)), detail_(std::move(detail)) {}

    Bsdf bsdf(const MaterialPoint& point, SampledWavelengths& lambda) const override {
        return material_->bsdf(point, lambda);
    }
    const SurfaceDetail* detail() const override { return detail_.get(); }
    bool hasDetail() const override { return true; }
    const Interior* interior() const override { return material_->interior(); }
    bool isInterface() const override { return material_->isInterface(); }
    bool isPolished() const override { return material_->isPolished(); }
    bool filtersTextures() const override { return material_->filtersTextures() || detail_->isFiltered(); }

  private:
    MaterialPtr material_;
    SurfaceDetailPtr detail_;
};

} // namespace vitrine
