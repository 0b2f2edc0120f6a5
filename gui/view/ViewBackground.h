#pragma once

#include <osg/Camera>
#include <osg/Geometry>
#include <osg/ref_ptr>

namespace smat::gui {

/// Draws a unit square over the whole view, behind and without regard to everything else.
osg::ref_ptr<osg::Camera> makeBackdrop(osg::Geometry* unitSquare);
/// The unit square, its first two corners at the bottom.
osg::ref_ptr<osg::Geometry> makeUnitSquare();

/// A quiet gradient behind the model, from the horizon up.
osg::ref_ptr<osg::Camera> makeViewBackground(bool dark);

} // namespace smat::gui
