#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "irsg/core/Bytes.h"

namespace irsg {

/// One file of OpenFlight as OpenSceneGraph's plug-in gets it: records that were checked.
struct FlightStream {
    std::filesystem::path path;
    std::string bytes;
    std::array<double, 3> origin_m{}; ///< from which its positions are counted
    /// External references: as written, and the number of the file that is meant.
    std::vector<std::pair<std::string, std::uint32_t>> externals;
};

/// A model's files, the first one first.
void putFlightStreams(ByteSink& sink, const std::vector<FlightStream>& streams);

/// The same again, one or more. Throws DamagedBytes.
std::vector<FlightStream> getFlightStreams(ByteSource& source);

} // namespace irsg
