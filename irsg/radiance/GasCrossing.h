#pragma once

#include <memory>

#include "irsg/geometry/mesh/Mesh.h"

namespace irsg {

/// Whether the walls of two gases go through each other, so that neither holds the other: by some
/// of their corners; what only touches does not count. Of one gas with itself: whether two of its
/// meshes do that share no corner, or one holds the other, but for one that is turned inside out.
/// Computed once a mesh.
bool doGasZonesCross(const std::shared_ptr<const Mesh>& mesh, const IrCodes& one,
                     const IrCodes& other);

} // namespace irsg
