#pragma once

#include <string>

#include "smatcore/simulate/Scenario.h"

namespace smat {

/// The parts of a scenario (used by ScenarioFile alone). Throws InputError with everything that is
/// wrong with them.
Scenario readScenario(const std::string& text, const std::string& file);

} // namespace smat
