#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <assimp/scene.h>
#include <osg/Geode>
#include <osg/Group>
#include <osg/Matrixd>

#include "irsg/geometry/reading/assimp/AssimpStates.h"

namespace irsg {

/// The nodes and meshes of a scene of Assimp as a graph: a group or transformation for each node,
/// with its name; below it a Geode for each of its meshes, one for all nodes that have the same.
/// Faces of more than four corners, and those that are not convex, are cut into triangles.
class AssimpGraph {
  public:
    /// Transformations in double, where they are known better than the scene has them.
    using Transforms = std::map<const aiNode*, osg::Matrixd>;

    AssimpGraph(const aiScene& scene, AssimpStates& states, const Transforms& transforms,
                std::string file)
        : scene_(scene), states_(states), transforms_(transforms), file_(std::move(file)) {}

    /// Throws InputError for a face of vertices that there are not and for more levels than a graph
    /// may have.
    osg::ref_ptr<osg::Group> make();

    /// Polygons of three corners or more with every copy, and corners of each mesh once, lines and
    /// points included.
    double placedPolygons() const { return placed_; }
    std::uint64_t corners() const { return corners_; }
    std::vector<std::string> remarks() const;

  private:
    osg::ref_ptr<osg::Group> make(const aiNode& node, int level);
    osg::Geode& geode(unsigned int mesh);
    osg::ref_ptr<osg::Geometry> geometry(const aiMesh& mesh, double& polygons);

    struct Known {
        osg::ref_ptr<osg::Geode> geode;
        double polygons = 0.0;
    };
    const aiScene& scene_;
    AssimpStates& states_;
    const Transforms& transforms_;
    std::string file_;
    std::map<unsigned int, Known> geodes_;
    double placed_ = 0.0;
    std::uint64_t corners_ = 0;
    long thin_ = 0, empty_ = 0, folded_ = 0;
};

} // namespace irsg
