#include "apps/atmosphere-tables/Command.h"

#include "irsg/radiometry/Errors.h"

namespace smat::tables {

void makeContinuum(const Folders&) {
    throw irsg::LogicError("Continuum cannot be made yet");
}

} // namespace smat::tables
