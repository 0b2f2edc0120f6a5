#include "apps/atmosphere-tables/Command.h"

#include "irsg/radiometry/Errors.h"

namespace smat::tables {

void makeGases(const Folders&) {
    throw irsg::LogicError("Gases cannot be made yet");
}

} // namespace smat::tables
