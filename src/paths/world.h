// What a path travels through: surfaces with materials, lights, the camera.
#pragma once

#include "accel/caster.h"
#include "bsdfs/material.h"
#include "cameras/camera.h"
#include "core/motion.h"
#include "lights/light_sampler.h"
#include "paths/interior_stack.h"

namespace vitrine {

/// A surface by the number the caster reports (CasterShape::id).
struct Surface {
    MaterialPtr material; ///< null: none, as an interface
    const AreaLight* light = nullptr;

    explicit Surface(MaterialPtr made, const AreaLight* shines = nullptr)
        : material(std::move(made)), light(shines), interior_(material ? material->interior() : nullptr),
          isInterface_(!material || material->isInterface()), filtersTextures_(material && material->filtersTextures()),
          hasDetail_(material && material->hasDetail()) {}

    /// Not null for a surface that bounds a dielectric solid.
    const Interior* interior() const { return interior_; }
    /// Light passes as if it were not there.
    bool isInterface() const { return isInterface_; }
    /// It has a texture that asks for the pixel's footprint.
    bool filtersTextures() const { return filtersTextures_; }
    /// It is shaded with relief.
    bool hasDetail() const { return hasDetail_; }

  private:
    // Asked at every vertex: a copy is nearer than a virtual function.
    const Interior* interior_;
    bool isInterface_, filtersTextures_, hasDetail_;
};

/// Everything that integrators read. Immutable once prepared; shared by all threads.
struct World {
    std::unique_ptr<const Caster> caster;
    std::vector<Surface> surfaces;
    LightSampler lights;
    std::vector<const Light*> infiniteLights;
    /// Of lights.lights(): whether each certainly lies in the same solids all over. Empty: nothing is known.
    std::vector<bool> undividedLights;
    std::unique_ptr<const Camera> camera;
    Shutter shutter;
    /// Whether anything moves: then each path has its time. prepare() adds the camera.
    bool moves = false;

    /// Solids that the camera stands in.
    InteriorStack cameraInterior;
    /// Whether any solid has a priority: then surfaces may be overruled, and shadow rays must be walked.
    bool hasNestedDielectrics = false;
    /// Whether any solid absorbs: then shadow rays inside solids are attenuated.
    bool hasAbsorption = false;
    /// Whether any surface filters a texture: then paths need their pixel's footprint.
    bool filtersTextures = false;
    /// Camera rays start far apart, or in what moves, so that each may start in other solids: they are looked for ray by ray.
    bool raysStartApart = false;

    /// Fills the derived members from the others: infinite lights, flags, the camera's interior.
    void prepare();
};

/// The solids around a point at a time: those that rays from it leave without having entered them.
InteriorStack interiorAt(const World& world, const V3d& p, double time = 0);

} // namespace vitrine
