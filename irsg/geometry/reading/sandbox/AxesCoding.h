#pragma once

#include "irsg/core/Bytes.h"
#include "irsg/geometry/reading/FileAxes.h"

namespace irsg {

/// What a file says of its axes and unit, as bytes.
void putAxes(ByteSink& sink, const FileAxes& axes);
/// Throws DamagedBytes for an axis that there is not and a unit that is no length.
FileAxes getAxes(ByteSource& source);

} // namespace irsg
