#pragma once

#include <filesystem>

#include "irsg/geometry/reading/LoadedGraph.h"

namespace irsg {

/// Reads a drawing in the exchange format of AutoCAD (.dxf, as text), in double: a drawable for
/// each layer, which has its name, and blocks as parts that are used at several places
/// (DxfDrawing.h). Throws InputError as readDxfDrawing() does, for a binary drawing, and for blocks
/// that contain themselves.
LoadedGraph readDxf(const std::filesystem::path& file);

} // namespace irsg
