// A list of shapes as one Embree scene: the world's own shapes, or those of an instanced group.
#pragma once

#include "accel/coincident_faces.h"

namespace vitrine::embree {

/// Where a group lies: Embree sees it moved by -center, so that single precision serves the group's size instead of
/// its distance from the origin.
struct Extent {
    V3d center{0, 0, 0};
    double reach = 0; ///< largest |coordinate| of the bounded shapes after the move
};

/// Center zero in every coordinate where the box is not far away for its size; else a multiple of the units in the
/// last place there, so that moving vertices is exact.
Extent extentOf(const Box3d& box);

class Group {
  public:
    /// \param pad by how much the boxes of analytic shapes must grow, given what Embree's rounding may do to a ray
    Group(const std::vector<CasterShape>& shapes, const Extent& extent, double pad);
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;
    ~Group();

    RTCScene scene() const { return scene_.get(); }
    /// To be called once everything (for the world: also the instances) is attached.
    void commit();
    bool empty() const { return geometryCount_ == 0; }
    /// One more than the largest geometry number in use.
    unsigned geometryCount() const { return geometryCount_; }

    PrimitiveRef find(unsigned geomID, unsigned primID) const {
        const Geometry& geometry = geometries_[geomID];
        if (geometry.table) return (*geometry.table)[primID];
        return PrimitiveRef{geometry.shape, geometry.id, primID, 0, 0, geometry.cutout};
    }
    /// The faces that share the place of `ref`, for which ref.rivals is not 0.
    const std::vector<PrimitiveRef>& rivalsOf(const PrimitiveRef& ref, unsigned geomID) const {
        return geometries_[geomID].coincident->list(ref.rivals);
    }

    /// Shapes that no box holds: infinite ones, and those too large for Embree's floats.
    const std::vector<CasterShape>& unbounded() const { return unbounded_; }
    std::size_t memoryBytes() const;

  private:
    struct Geometry {
        const Shape* shape = nullptr; ///< null when there is a table
        std::uint32_t id = 0;
        const std::vector<PrimitiveRef>* table = nullptr;
        const CoincidentFaces* coincident = nullptr; ///< of small meshes, which have a table
        const Cutout* cutout = nullptr;              ///< where there is no table: it has holes
        bool anyCutout = false;
    };
    struct Merged;   ///< small meshes, copied into one
    struct Analytic; ///< primitives solved in double

    void addLargeMesh(const CasterShape& entry);
    void addMerged(std::unique_ptr<Merged> merged, bool castsShadow);
    void addAnalytic(std::unique_ptr<Analytic> analytic, bool castsShadow);
    void attachMesh(GeometryPtr geometry, bool castsShadow, Geometry record);
    void attach(GeometryPtr geometry, bool castsShadow, Geometry record);
    V3f moved(const float* vertex) const;

    Extent extent_;
    double pad_;
    std::vector<Geometry> geometries_;
    unsigned geometryCount_ = 0;
    std::vector<CasterShape> unbounded_;
    std::vector<ShapePtr> shapes_; ///< kept alive: Embree reads their buffers
    std::vector<CutoutPtr> cutouts_;
    // Released before the tables and buffers above and below would be, as it is declared last.
    std::vector<std::unique_ptr<Merged>> merged_;
    std::vector<std::unique_ptr<Analytic>> analytic_;
    ScenePtr scene_;
};

} // namespace vitrine::embree
