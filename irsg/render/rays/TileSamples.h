#pragma once

#include <cstddef>
#include <vector>

#include "irsg/geometry/view/Sensor.h"
#include "irsg/geometry/view/Vec3.h"
#include "irsg/render/rays/RayVectors.h"
#include "irsg/render/sampling/SampleTile.h"
#include "irsg/render/sampling/SurfaceScene.h"

namespace irsg {

/// Some rows of a tile of a sheet, counted from the top.
struct TileRows {
    std::size_t tile = 0;
    int first = 0, last = 0; ///< `last` is the one after them
};
/// A sheet in the pieces that one thread takes at a time, the same for any number of threads.
std::vector<TileRows> rowsOf(const SampleSheet& sheet);

/// Place of a sample of a tile in its drawing.
inline std::size_t indexOf(const SampleTile& tile, int column, int row) {
    return tile.firstSample + static_cast<std::size_t>(tile.height() - 1 - row) * tile.stride() +
           static_cast<std::size_t>(column);
}

/// Unit vectors from the eye through the samples of a tile, in eye space.
class EyeDirections {
  public:
    EyeDirections() = default;
    EyeDirections(const Sensor& sensor, const SampleTile& tile);

    Vec3 at(int column, int row) const {
        // As SampleTile::placeOf has it.
        const double down = row + fall_ * ((column + 0.5) / width_ - 0.5);
        const double right = column - (shearRows_ != 0.0 ? down / shearRows_ : 0.0);
        const Vec3 along{(left_ + (right + 0.5) * cellWidth_ - middleX_) * pitch_,
                         (middleY_ - (top_ + (down + 0.5) * cellHeight_)) * pitch_, -1.0};
        return along * (1.0 / plainLength(along));
    }

  private:
    double fall_ = 0.0, width_ = 1.0, shearRows_ = 0.0, left_ = 0.0, top_ = 0.0, cellWidth_ = 1.0,
           cellHeight_ = 1.0, middleX_ = 0.0, middleY_ = 0.0, pitch_ = 1.0;
};

/// Angle between neighbouring samples in the middle of the frame, rad.
double sampleWidthOf(const Sensor& sensor, const SampleTile& tile);

} // namespace irsg
