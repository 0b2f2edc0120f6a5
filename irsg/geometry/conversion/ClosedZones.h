#pragma once

#include <map>
#include <set>
#include <string>

#include <osg/Group>

#include "irsg/geometry/reading/ModelValues.h"

namespace irsg {

/// Faces by codes.
using FacesAdded = std::map<IrCodes, long>;

/// Adds to a graph the faces that close what is open of the meshes of these materials, as a
/// drawable for each pair of codes: shells about gas, open where they begin in a nozzle, become
/// zones. An opening gets triangles about its middle, which fits openings that are nearly flat and
/// seen whole from there. Throws InputError, with `name`, for edges that are no border of an
/// opening, such as those of faces that are turned over.
FacesAdded closeMeshes(osg::Group& graph, const std::set<int>& materials, const std::string& name);

} // namespace irsg
