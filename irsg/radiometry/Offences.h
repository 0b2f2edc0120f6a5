#pragma once

#include <vector>

#include "irsg/radiometry/Errors.h"

namespace irsg {

/// What InputError would keep of these, where they are many: for a loader to call at every step, so
/// that a file of nothing but offences takes no memory for them.
void keepFirstOffences(std::vector<Offence>& offences);

} // namespace irsg
