#pragma once

#include <memory>
#include <string>

#include <osg/Node>

#include "irsg/core/Errors.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/reading/LoadedGraph.h"
#include "irsg/geometry/reading/ModelCodes.h"
#include "irsg/render/background/Terrain.h"

namespace irsg::test {

/// A graph made in memory as if it had been read; its axes are those of a file that states none.
inline LoadedGraph loaded(osg::Node* node, const FileAxes& axes = {}) {
    LoadedGraph graph;
    graph.node = node;
    graph.axes = axes;
    return graph;
}

inline std::shared_ptr<Model> modelOfGraph(osg::Node* node, const std::string& name,
                                           const ModelOptions& options = {}) {
    return Model::ofGraph(loaded(node), {}, name, options);
}

inline std::shared_ptr<const Terrain> terrainOfGraph(osg::Node& node, const std::string& name,
                                                     const Vec3& position_m = {}) {
    return Terrain::ofGraph(loaded(&node), name, position_m);
}

} // namespace irsg::test
