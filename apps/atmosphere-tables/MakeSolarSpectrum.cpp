#include "apps/atmosphere-tables/Command.h"

#include "irsg/radiometry/Errors.h"

namespace smat::tables {

void makeSolarSpectrum(const Folders&) {
    throw irsg::LogicError("SolarSpectrum cannot be made yet");
}

} // namespace smat::tables
