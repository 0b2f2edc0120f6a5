#pragma once

#include <array>
#include <string>

namespace irsg {

/// Takes an origin, in the unit of the file, from every position of a validated stream of
/// OpenFlight records, in double: the plug-in that reads them keeps single precision.
void takeOriginFrom(std::string& stream, const std::array<double, 3>& origin);

} // namespace irsg
