#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "irsg/scene/draw/SurfacePass.h"
#include "irsg/scene/sampling/FrameReduction.h"
#include "irsg/scene/sampling/SampleWindow.h"
#include "irsg/scene/sampling/Samples.h"
#include "irsg/scene/view/Sensor.h"

namespace irsg {

/// What every pixel of a view takes of every kind of surface, in front of and behind transparent
/// ones. With it a picture of other temperatures, spectra or air is a sum, and nothing is drawn.
class PixelFactors {
  public:
    /// `transparent`: by row of the drawing.
    PixelFactors(const Sensor& sensor, std::vector<bool> transparent);

    void add(const SampleWindow& window, const FactorSamples& samples);
    /// After the last window: brings what belongs to a pixel together.
    void finish();

    /// Adds up to what a drawing with these rows gives, within the rounding of float.
    void evaluate(const std::vector<SurfaceRow>& rows, FrameReduction& pixels) const;

  private:
    /// A kind of surface in one pixel: sums over its samples, each with its share of the pixel.
    struct Entry {
        std::int32_t row = 0, front = 0; ///< number of what is in front of it
        float thermal = 0.0F, up = 0.0F, down = 0.0F, sun = 0.0F, coverage = 0.0F;
        std::int32_t next = -1; ///< of the same pixel, until finish()
    };
    struct Pixel {
        std::int32_t x = 0, y = 0;
        std::size_t end = 0; ///< of its entries
    };
    /// Layers in front of a surface: those of another one, and a row behind them.
    struct Front {
        std::int32_t before = 0, row = 0;
    };
    Entry& entry(int x, int y, std::int32_t row, std::int32_t front);
    std::int32_t behind(std::int32_t front, std::int32_t row);

    std::size_t width_px_;
    std::vector<bool> transparent_;
    std::vector<std::int32_t> heads_; ///< first entry of each pixel, until finish()
    std::vector<Entry> entries_;
    std::vector<Pixel> pixels_; ///< that have entries
    std::vector<Front> fronts_{Front{}};
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> known_; ///< (front, row): longer
};

} // namespace irsg
