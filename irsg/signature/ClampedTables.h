#pragma once

#include <string>
#include <vector>

#include "irsg/signature/EntityState.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// The lookup tables that are clamped to an end value in this state because their axis does not
/// reach it: "temperatures.4.terms.power". Only what the mode of an entry uses counts. Whoever runs
/// an analysis warns of each once.
std::vector<std::string> clampedTables(const SignatureDatabase& database, const EntityState& state);

} // namespace irsg
