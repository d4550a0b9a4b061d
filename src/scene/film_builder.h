// Film, filter, sampler and camera nodes -> settings and objects.
#pragma once

#include "cameras/camera.h"
#include "core/motion.h"
#include "core/sampler.h"
#include "film/film.h"
#include "scene/context.h"
#include "scene/overrides.h"

#include <optional>

namespace vitrine {

struct FilmPlan {
    FilmSettings settings;
    std::string fileName; ///< as the scene gives it; empty: not given
};
FilmPlan buildFilm(BuildContext& context, const Overrides& overrides);

struct SamplerPlan {
    SamplerSettings settings;
    std::uint64_t samplesPerPixel = 16;
};
SamplerPlan buildSampler(BuildContext& context, const Overrides& overrides);

struct CameraPlan {
    std::unique_ptr<Camera> camera;
    Shutter shutter;
    /// What pbrt-v4 writes beside pictures: camera space to [0,1]^3, row vectors; none for a spherical camera.
    std::optional<M44d> ndcFromCamera;
};
CameraPlan buildCamera(BuildContext& context, const FilmSettings& film);

} // namespace vitrine
