#pragma once

#include <vector>

#include <osg/ProxyNode>

namespace irsg {

/// Every reference to another file below a graph, each once.
std::vector<osg::ref_ptr<osg::ProxyNode>> proxiesOf(osg::Node& graph);

/// Replaces each of them by a plain group with its children: written to a file, a proxy would read
/// its own file again and without the codes.
void removeProxies(osg::Node& graph);

} // namespace irsg
