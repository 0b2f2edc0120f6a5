#pragma once

namespace irsg {

/// Has OpenSceneGraph look for its plug-ins beside this library first, where a copy of the program
/// brings its own (osgPlugins-VERSION in the same folder or in ../lib). Does nothing the next time.
void preferOwnPlugins();

} // namespace irsg
