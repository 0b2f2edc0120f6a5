#pragma once

#include "tools/samples/GltfWriter.h"

namespace smat {

/// A light utility helicopter of 10 m as somebody's own model comes: glTF in centimetres, y up,
/// materials with names, no infrared codes. About 12,000 triangles.
GltfWriter helicopterModel();

} // namespace smat
