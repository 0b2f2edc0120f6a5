#pragma once

#include <vector>

#include "irsg/core/Errors.h"

namespace irsg {

/// Does `work`; what an InputError has to say is added to `diagnostics`, so that all that is wrong
/// is said at once. Other exceptions pass.
template <typename Work>
void collect(std::vector<Diagnostic>& diagnostics, const Work& work) {
    try {
        work();
    } catch (const InputError& error) {
        diagnostics.insert(diagnostics.end(), error.diagnostics().begin(),
                           error.diagnostics().end());
    }
}

} // namespace irsg
