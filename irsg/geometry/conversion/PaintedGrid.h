#pragma once

#include <unordered_map>
#include <vector>

#include <osg/Vec3d>

#include "irsg/geometry/reading/ModelCodes.h"

namespace irsg {

/// Finds the painted triangle on which a point of a model's surface lies.
class PaintedGrid {
  public:
    explicit PaintedGrid(const std::vector<PaintedSurface>& painted);

    /// The surface whose triangle holds a point, of those that look the same way; of several one
    /// that holds it exactly, else within the tolerance, and of these the last; -1 where there is
    /// none.
    int find(const osg::Vec3d& point, const osg::Vec3d& normal) const;
    /// All triangles that hold a point as well as that one does, by their number in the order of
    /// the surfaces.
    std::vector<unsigned int> holding(const osg::Vec3d& point, const osg::Vec3d& normal) const;
    bool empty() const { return triangles_.empty(); }

  private:
    struct Triangle {
        osg::Vec3d corner, first, second, normal; ///< edges from the corner; unit normal
        double area = 0.0;
        int surface = 0;
    };
    enum class Fit { none, near, exact };
    Fit fitOf(const Triangle& triangle, const osg::Vec3d& point, const osg::Vec3d& normal) const;
    std::uint64_t cellOf(const osg::Vec3d& point) const;

    std::vector<Triangle> triangles_;
    std::unordered_map<std::uint64_t, std::vector<unsigned int>> cells_;
    osg::Vec3d low_;
    double cell_ = 1.0, tolerance_ = 0.0;
};

} // namespace irsg
