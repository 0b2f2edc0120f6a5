#pragma once

#include "tools/atmosphere-tables/Command.h"

namespace smat::tables {

/// The parts of makeContinuum, one absorber each; errors as there.
void makeWaterContinuum(const Folders& folders);
void makeNitrogenContinuum(const Folders& folders);
void makeOxygenContinuum(const Folders& folders);

} // namespace smat::tables
