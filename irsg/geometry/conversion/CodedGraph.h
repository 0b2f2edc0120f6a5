#pragma once

#include <string>
#include <vector>

#include <osg/Node>

#include "irsg/geometry/conversion/ModelNames.h"

namespace irsg {

/// Of a drawable below `path`, which ends with the node above it. The material is that of the
/// nearest state with an osg::Material, or state, that has a name.
FaceNames namesOver(const osg::Drawable& drawable, const std::vector<osg::Node*>& path);
bool fits(const CodeRule& rule, const FaceNames& names);

/// Gives a graph the codes that a file beside its model has for it: drawables whose faces get
/// different ones are cut. Nodes that stand at several places become several where the codes of
/// their faces may differ. What fits nothing comes back as remarks, a sentence each: rules, and
/// painted triangles on which no face lies any more, with their area.
std::vector<std::string> giveCodes(osg::ref_ptr<osg::Node>& graph, const ModelCodes& codes,
                                   const std::string& name);

/// By kind and name; and, where it is asked for, by all names of a face together.
NamesOfKinds namesIn(osg::Node& graph, const std::string& name, NamedParts* parts = nullptr);

} // namespace irsg
