#pragma once

#include <string>
#include <vector>

#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// Adds what is wrong or doubtful about one user-defined spectrum that is filed under `key`: its
/// form (named components on one shared axis, zero outside) as errors, negative radiance and
/// brightness temperatures outside 200 to 4000 K as warnings.
void lintSpectrum(const std::string& key, const UserSpectrum& spectrum,
                  std::vector<Finding>& findings);

} // namespace irsg
