#pragma once

#include <string>

namespace irsg {

/// Where an entry stands, as every message, every hash and every finding names it:
/// "temperatures.1", "materials.3", "spectra.plume".
std::string temperaturePath(int index);
std::string materialPath(int index);
std::string spectrumPath(const std::string& name);

} // namespace irsg
