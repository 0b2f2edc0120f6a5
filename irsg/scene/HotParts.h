#pragma once

#include <map>
#include <vector>

#include "irsg/scene/CameraFrame.h"
#include "irsg/scene/DrawList.h"
#include "irsg/scene/SceneRadiometry.h"

namespace irsg {

/// True for each surface of a scene that shines out of its object: its in-band thermal radiance at
/// the sensor is at least `hotFrom` times the mean of the object's area, and it holds at least
/// `shareFrom` of what that area emits. An exhaust pipe is one, skin in the sun is not. The
/// samples of a window that holds the whole object are too far apart for such surfaces where they
/// are small.
std::vector<bool> hotSurfaces(const SceneRadiometry& radiometry,
                              const std::vector<Entity>& entities);
inline constexpr double hotFrom = 4.0;
inline constexpr double shareFrom = 0.01;

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
