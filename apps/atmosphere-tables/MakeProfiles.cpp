#include "apps/atmosphere-tables/Command.h"

#include "irsg/radiometry/Errors.h"

namespace smat::tables {

void makeProfiles(const Folders&) {
    throw irsg::LogicError("Profiles cannot be made yet");
}

} // namespace smat::tables
