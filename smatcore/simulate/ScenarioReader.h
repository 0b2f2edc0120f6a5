#pragma once

#include <string>

#include "smatcore/simulate/Scenario.h"

namespace smat {

/// The parts of a scenario (used by ScenarioFile alone). Throws InputError with everything that is
/// wrong with them. `remarks`, where it is given, gets a sentence for each former name.
Scenario readScenario(const std::string& text, const std::string& file,
                      std::vector<std::string>* remarks = nullptr);

} // namespace smat
