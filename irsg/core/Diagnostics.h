#pragma once

#include <vector>

#include "irsg/core/Errors.h"

namespace irsg {

/// What InputError would keep of these, where they are many: for a loader to call at every step, so
/// that a file of nothing but diagnostics takes no memory for them.
void keepFirstDiagnostics(std::vector<Diagnostic>& diagnostics);

} // namespace irsg
