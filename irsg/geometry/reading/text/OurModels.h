#pragma once

#include <filesystem>

#include "irsg/geometry/reading/LoadedGraph.h"
#include "irsg/geometry/reading/text/ObjReader.h"

namespace irsg {

/// Reads a model of a format that OpenableFiles.h gives to us, .obj, .stl, .ply or .dxf by its
/// extension. Pictures are read by `picture`, where there is one. Throws InputError as the reader
/// of the format does.
LoadedGraph readOurModel(const std::filesystem::path& file, const PictureReading& picture);

} // namespace irsg
