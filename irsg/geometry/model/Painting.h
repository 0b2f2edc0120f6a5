#pragma once

#include <vector>

#include "irsg/geometry/model/FaceChoice.h"

namespace irsg {

/// Painted surfaces with faces painted over: what a code is not given for stays as it was painted.
/// A face's triangles are taken from the surfaces before, so that painting again does not pile them
/// up, and faces with equal codes share a surface. What was painted on an earlier export and covers
/// other faces besides is cut to those.
std::vector<PaintedSurface> painted(const std::vector<PaintedSurface>& before, const FaceMesh& mesh,
                                    const FaceNumbers& faces, const GivenCodes& codes);
/// The same with nothing painted on these faces: they have what file and rules say.
std::vector<PaintedSurface> erased(const std::vector<PaintedSurface>& before, const FaceMesh& mesh,
                                   const FaceNumbers& faces);

} // namespace irsg
