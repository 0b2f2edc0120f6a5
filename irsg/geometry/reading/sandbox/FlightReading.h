#pragma once

#include <string>

#include "irsg/geometry/reading/LoadedGraph.h"

namespace irsg {

/// Reads a model from what putFlightStreams() wrote, each file once, by the plug-in, in this
/// process. Axes are left to who wrote it. Throws InputError for one that cannot be read.
LoadedGraph readFlightHere(std::string bytes);

} // namespace irsg
