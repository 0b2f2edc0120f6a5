#pragma once

#include <vector>

#include <osg/Geometry>
#include <osg/Group>
#include <osg/ref_ptr>

namespace smat::gui {

/// Makes faces stand out in the visible and in the infrared display: a tint in a colour that no
/// infrared colour map has, the edges of what is marked in the same colour on a dark seam, and
/// edges that something hides faintly. `faces` hold vertices and indexed triangles; their arrays
/// are shared.
osg::ref_ptr<osg::Group> makeFaceMarks(const std::vector<const osg::Geometry*>& faces,
                                       double devicePixelRatio);

/// The edges of all triangles in one colour, whether something hides them or not: the wireframe
/// over an infrared picture.
osg::ref_ptr<osg::Group> makeWireframe(const std::vector<const osg::Geometry*>& faces,
                                       const osg::Vec4& color, double devicePixelRatio);

} // namespace smat::gui
