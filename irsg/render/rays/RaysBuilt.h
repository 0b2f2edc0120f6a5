#pragma once

#include <string>

namespace irsg {

/// Whether this build has rays, what they are ("Embree 3.13.5"), and why not: empty where it has.
bool areRaysBuilt();
std::string raysDescription();
std::string whyNoRays();

} // namespace irsg
