#pragma once

#include <map>
#include <string>
#include <vector>

#include <osg/Node>
#include <osg/ref_ptr>

#include "irsg/geometry/reading/FileAxes.h"
#include "irsg/geometry/reading/ModelValues.h"

namespace irsg {

/// A graph as the file has it, before anything is merged or stripped.
struct LoadedGraph {
    osg::ref_ptr<osg::Node> node;
    /// Face records per pair of codes where the file was OpenFlight, else empty.
    std::map<IrCodes, int> faces;
    std::vector<std::string> remarks;
    FileAxes axes; ///< of `node`
};

} // namespace irsg
