#pragma once

#include <filesystem>

#include "irsg/geometry/reading/LoadedGraph.h"

namespace irsg {

/// Reads a stereolithography file, binary or text, in time proportional to its size: a drawable
/// for each solid, with the normals of its facets where they are stated. Throws InputError for one
/// that is cut (a binary file says how many facets it has, a text ends with endsolid), and for
/// what is no number or no word of the format, with its place.
LoadedGraph readStl(const std::filesystem::path& file);

} // namespace irsg
