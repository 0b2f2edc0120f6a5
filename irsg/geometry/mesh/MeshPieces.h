#pragma once

#include <cstddef>

#include "irsg/geometry/mesh/Mesh.h"

namespace irsg {

/// Cuts the parts of a mesh (meshOf) into pieces of at most `mostTriangles`, or of a hundredth of
/// their part, so that a drawing of a small part of the image draws little else: sorts the
/// triangles of each part so that those that lie close together follow each other.
void cutIntoPieces(Mesh& mesh);
inline constexpr std::size_t mostTriangles = 256;

} // namespace irsg
