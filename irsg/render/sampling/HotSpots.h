#pragma once

#include <map>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/geometry/view/CameraFrame.h"
#include "irsg/render/sampling/SampleTile.h"
#include "irsg/render/sampling/Samples.h"

namespace irsg {

/// Boxes, in model axes, around the connected pieces of what carries a pair of codes: triangles
/// with a common place of a vertex are connected, and pieces whose boxes meet are one. At most
/// `mostPieces`; of more, neighbours share a box.
std::vector<BoundingBox> connectedPieces(const Mesh& mesh, const IrCodes& codes);
inline constexpr std::size_t mostPieces = 256;

/// A hot piece of an object as a camera sees it.
struct HotSpot {
    ImageRectangle extent;  ///< what the frame shows of the box around it
    double nearest_m = 0.0; ///< from the camera to that box
};

/// One sample a block around all the parts, some hundred along the longer side: to find out which
/// of them are hidden.
SampleTile probeOf(const std::vector<HotSpot>& parts, int entity);
/// The blocks of a probe in which a part and a block around it lie, both ends among them.
struct ProbedBlocks {
    int left = 0, right = 0, top = 0, bottom = 0;
};
ProbedBlocks blocksAround(const HotSpot& part, const SampleTile& probe);
/// True where a probe, drawn with distances around the part at least, finds an opaque surface
/// before all of a part and a block around it. What is seen through a gap narrower than a block is
/// hidden, too: it is left to the tile around.
bool isHidden(const HotSpot& part, const SampleTile& probe, const GeometrySamples& samples);

/// The hot parts of one object, found once for each pair of codes that was ever hot.
class HotSpots {
  public:
    /// The hot pieces of an object that stands at `pose`.
    std::vector<HotSpot> seenBy(const CameraFrame& camera, const Pose& pose, const Mesh& mesh,
                                const std::vector<IrCodes>& hot);

  private:
    std::map<IrCodes, std::vector<BoundingBox>> pieces_;
};

} // namespace irsg
