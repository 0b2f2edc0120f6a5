#pragma once

#include <filesystem>

#include "irsg/geometry/reading/LoadedGraph.h"

namespace irsg {

/// Reads a polygon file (.ply) of version 1.0 as text or in binary numbers of either order, in time
/// proportional to its size: positions in the precision of the file, normals, colours and texture
/// coordinates of vertices, faces of any number of corners and strips of triangles. Elements and
/// properties of other names are left out and told. Throws InputError for a head that is none of
/// the format, numbers that are none, faces of vertices that there are not and a file that ends
/// before the elements that its head counts, each with its line or byte.
LoadedGraph readPly(const std::filesystem::path& file);

} // namespace irsg
