#pragma once

#include <filesystem>
#include <string>

#include "irsg/geometry/reading/LoadedGraph.h"

namespace irsg {

/// Reads a model from what putFlightStreams() wrote, each file once, by the plug-in, in this
/// process. Axes are left to who wrote it. Throws InputError for one that cannot be read.
LoadedGraph readFlightHere(std::string bytes);

/// Scans an .flt that a scene refers to, with what it refers to itself, and gives what
/// putFlightStreams() writes of it, with or without its pictures. Throws InputError.
using FlightScanning = std::string (*)(const std::filesystem::path& file, bool withPictures);
/// Set by a reading process at its start; the scanner lies above this folder.
void setFlightScanning(FlightScanning scanning);
/// LogicError where none was set.
std::string scannedFlight(const std::filesystem::path& file, bool withPictures);

} // namespace irsg
