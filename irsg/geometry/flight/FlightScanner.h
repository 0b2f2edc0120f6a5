#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "irsg/geometry/flight/FlightFile.h"
#include "irsg/geometry/reading/sandbox/FlightStreams.h"

namespace irsg {

/// Validates the bytes of one OpenFlight file of version 14 to 16.4: record lengths, levels, vertex
/// offsets, palettes, mesh pools and their indices, finite coordinates, instances, everything that
/// the stock plug-in would follow blindly. Real files hold vertex offsets that lie inside the
/// palette but on no vertex; such a vertex is left out and remarked. Throws InputError with every
/// diagnostic and its byte offset. `coloursGiven`: a referring file lends its colour palette.
/// External references are listed, not followed, and their `file` is empty.
FlightFile scanFlightBytes(std::string bytes, const std::filesystem::path& name,
                           bool coloursGiven = false);

/// A file with everything it refers to, each file once, the first one first.
struct FlightScan {
    std::vector<FlightFile> files;

    /// Face and Mesh records per pair of codes, every file counted once however often it is placed.
    std::map<IrCodes, int> faceCounts() const;
    /// The entry of a path; LogicError where it is missing.
    const FlightFile& find(const std::filesystem::path& path) const;
    /// What the plug-in gets of the files, in their order.
    std::vector<FlightStream> streams(FlightFile::Purpose purpose) const;
};

/// Reads and validates a file and, recursively, its external references. Throws InputError for a
/// file that is missing or malformed, a reference that leads nowhere (naming both files) or in a
/// circle, and a model that instances and references multiply beyond 20 million faces.
FlightScan scanFlight(const std::filesystem::path& file);

} // namespace irsg
