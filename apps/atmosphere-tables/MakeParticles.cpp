#include "apps/atmosphere-tables/Command.h"

#include "irsg/radiometry/Errors.h"

namespace smat::tables {

void makeParticles(const Folders&) {
    throw irsg::LogicError("Particles cannot be made yet");
}

} // namespace smat::tables
