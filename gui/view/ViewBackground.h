#pragma once

#include <osg/Camera>
#include <osg/ref_ptr>

namespace smat::gui {

/// A quiet gradient behind the model, from the horizon up.
osg::ref_ptr<osg::Camera> makeViewBackground(bool dark);

} // namespace smat::gui
