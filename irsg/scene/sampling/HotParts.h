#pragma once

#include <map>
#include <vector>

#include "irsg/scene/model/DrawList.h"
#include "irsg/scene/view/CameraFrame.h"

namespace irsg {

/// Boxes, in model axes, around the connected pieces of what carries a pair of codes: triangles
/// with a common place of a vertex are connected, and pieces whose boxes meet are one.
std::vector<BoundingBox> connectedPieces(const std::vector<DrawItem>& items, const IrCodes& codes);

/// The hot parts of one object, found once for each pair of codes that was ever hot.
class HotParts {
  public:
    /// Parts of the image plane around the hot pieces of an object that stands at `pose`; those
    /// that would largely hold each other are one. At most `mostDetails`: a surface in more pieces
    /// than that is no small part.
    std::vector<ImageRectangle> seenBy(const CameraFrame& camera, const Pose& pose,
                                       const std::vector<DrawItem>& items,
                                       const std::vector<IrCodes>& hot);
    static constexpr std::size_t mostDetails = 16;

  private:
    std::map<IrCodes, std::vector<BoundingBox>> pieces_;
};

} // namespace irsg
