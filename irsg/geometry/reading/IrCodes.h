#pragma once

#include <map>
#include <optional>
#include <vector>

#include "irsg/geometry/reading/ModelValues.h"

namespace osg {
class Drawable;
class Node;
class Object;
} // namespace osg

namespace irsg {

/// Codes of a drawable: its ShapeAttributeList or the OpenFlight plug-in's user values, else those
/// of the geode above it, else of any node further up `path`, else 0. A code that is absent is 0.
IrCodes codesOf(const osg::Drawable& drawable, const std::vector<osg::Node*>& path);

/// Codes that an object states itself, nothing where it states none.
std::optional<IrCodes> declaredCodes(const osg::Object& object);

/// Gives a drawable or node a ShapeAttributeList with IRColor and IRMaterial as its UserData, and
/// removes the plug-in's user values.
void setCodes(osg::Object& object, const IrCodes& codes);

/// Polygons per pair of codes in a graph, with every copy that instances draw: triangles, quads and
/// polygons as the primitive sets have them, hidden ones included; lines and points are not
/// counted.
std::map<IrCodes, long> polygonCounts(osg::Node& graph);

} // namespace irsg
