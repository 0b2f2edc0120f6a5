#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <osg/Node>

#include "irsg/core/Bytes.h"

namespace irsg {

/// A graph with what this program uses of one: groups, transformations, levels of detail, switches,
/// animations, billboards, geometry, infrared codes, states of the fixed pipeline. Every node comes
/// after those below it, so that no graph can contain itself. What is left out (texts, cameras,
/// lights, shaders) is said in `remarks`. Throws InputError, naming `name`, for a graph of more
/// than 1000 levels.
void putGraph(ByteSink& sink, osg::Node& graph, const std::string& name,
              std::vector<std::string>& remarks);

/// The graph again, as new objects of ours. Throws DamagedBytes where it does not hold together,
/// and InputError, naming `name`, for faces of vertices that there are not and for one that grows
/// out of all proportion to what was written, because parts of it are used over and over.
osg::ref_ptr<osg::Node> getGraph(ByteSource& source, const std::string& name,
                                 std::vector<std::string>& remarks);

} // namespace irsg
