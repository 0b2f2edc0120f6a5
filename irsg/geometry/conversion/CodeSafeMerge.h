#pragma once

#include <osg/Group>

namespace irsg {

/// Counts of drawables before and after.
struct MergeCounts {
    int before = 0, after = 0;
};

/// Gives every drawable below `graph` its codes as a ShapeAttributeList. With `merge` (a graph of
/// the OpenFlight plug-in with a geode per face) polygons that are not convex are cut into
/// triangles and drawables of equal state and equal codes are merged. OpenSceneGraph's optimizer
/// looks at UserData but not at the plug-in's user values, and would merge faces of different
/// codes: while it runs, the codes stand in the state as a uniform, one object a pair, since state
/// sets compare uniforms by address. Arrays that do not fit their vertices are removed first; the
/// number of drawables with such arrays is added to `misfits`.
MergeCounts mergeKeepingCodes(osg::Group& graph, bool merge, int& misfits);

} // namespace irsg
