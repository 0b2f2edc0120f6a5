#pragma once

#include <filesystem>

#include "irsg/geometry/reading/LoadedGraph.h"

namespace irsg {

/// Reads .gltf, .glb, .fbx and .dae with Assimp, in the axes and the unit of the file, and holds
/// what comes against what the file says of itself (GltfFile.h, DeclaredContents.h). Throws
/// InputError for a file that is not whole, cannot be read, or of which less was read than it has.
/// For the reading process alone.
LoadedGraph readWithAssimp(const std::filesystem::path& place, const std::filesystem::path& file);

} // namespace irsg
