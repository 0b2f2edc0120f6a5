#pragma once

#include <osg/Node>

namespace irsg {

/// Makes the names in a graph texts in UTF-8, those of nodes, drawables, states and materials: one
/// that is none is read as Latin-1, in which old programs write. So they may stand in files of ours
/// and be matched by rules. Returns how many were read so.
int nameInUtf8(osg::Node& graph);

} // namespace irsg
