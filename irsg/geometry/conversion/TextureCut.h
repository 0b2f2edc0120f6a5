#pragma once

#include <array>
#include <compare>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "irsg/geometry/reading/DrawablePolygons.h"

namespace osg {
class StateSet;
class TexMat;
class Texture2D;
} // namespace osg

namespace irsg {

/// The texture that stands over a polygon, of the first unit, as a walk down a graph finds it.
struct TextureState {
    const osg::Texture2D* texture = nullptr;
    const osg::TexMat* matrix = nullptr;
    bool isEnabled = false;
    bool isTested = true; ///< false where the file says that alpha means nothing (glTF's OPAQUE)
    float least = 0.5f;   ///< alpha of what is there; of another test than that the file's own

    void update(const osg::StateSet& state);
    bool isOn() const { return isEnabled && isTested && texture; }
    /// A compressed picture, whose alpha nobody here reads.
    bool isUnreadable() const;
    auto operator<=>(const TextureState&) const = default;
};

/// Which part of a texture is there: where its alpha, linear between the middles of texels, is not
/// below a threshold. A cell between four middles is four triangles about their mean.
class AlphaMask {
  public:
    /// Null for a texture of which everything is there.
    static std::shared_ptr<const AlphaMask> of(const TextureState& state);

    /// How the plane of a texture goes on along one axis beyond its picture.
    enum class Beyond { repeats, mirrors, stays, border };
    int texels(int axis) const { return size_[static_cast<std::size_t>(axis)]; }
    Beyond beyond(int axis) const { return beyond_[static_cast<std::size_t>(axis)]; }
    /// Alpha minus the threshold; -1 on either axis is the border.
    float above(int column, int row) const {
        return column < 0 || row < 0
                   ? border_
                   : above_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_[0]) +
                            static_cast<std::size_t>(column)];
    }
    /// A place on the texture as the file has it, in texels from the middle of the first one.
    osg::Vec2d texelOf(const osg::Vec2d& place) const;

  private:
    std::array<int, 2> size_{};
    std::array<Beyond, 2> beyond_{};
    std::vector<float> above_; ///< rows from the bottom
    float border_ = 0.0f;
    std::array<double, 6> matrix_{1, 0, 0, 1, 0, 0}; ///< (s, t) = s (0, 1) + t (2, 3) + (4, 5)
};

/// Calls `each` with the parts of a polygon that are there, with corners linear between those of
/// its triangles, and returns their number. A polygon of which all is there comes as it is; one
/// whose places on the texture lie on a line is there or not as the middle of its triangle is. The
/// area of the parts is that of the region of the mask, to rounding. Throws InputError, naming
/// `name`, for a polygon over more than 2^26 texels.
long cutOut(const AlphaMask& mask, std::vector<PolygonCorner>& corners, const std::string& name,
            const std::function<void(std::vector<PolygonCorner>&)>& each);

} // namespace irsg
