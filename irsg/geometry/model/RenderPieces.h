#pragma once

#include <vector>

#include "irsg/geometry/model/RenderList.h"

namespace irsg {

/// The same surfaces in pieces that lie close together, of at most `mostTriangles` or of a
/// hundredth of their geometry, so that a drawing of a small part of the image draws little else.
/// Pieces share the arrays of their geometry, which stays as it is; one whose normals belong to its
/// faces stays whole.
std::vector<RenderItem> inRenderPieces(const std::vector<RenderItem>& items);
inline constexpr std::size_t mostTriangles = 256;

} // namespace irsg
