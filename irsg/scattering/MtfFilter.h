#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

#include "irsg/core/RecentlyUsed.h"
#include "irsg/scattering/FftPlans.h"
#include "irsg/scattering/PixelHaze.h"

namespace irsg {

/// A rectangle of pixels; values of it are stored row by row.
struct HazeWindow {
    int x = 0, y = 0, width = 0, height = 0;

    std::size_t size() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    bool isEmpty() const { return width <= 0 || height <= 0; }
    /// Grown on all sides, as far as a frame from (0, 0) reaches.
    HazeWindow grown(int by_px, int frameWidth, int frameHeight) const;
    bool operator==(const HazeWindow&) const = default;
};

/// Spreads the light of objects by a PixelHaze: a linear convolution in windows that are only as
/// large as object and support (or the frame, where it is smaller) ask for. Real float transforms
/// without shifts; nothing wraps around. What comes out may be negative where the density is.
class MtfFilter {
  public:
    explicit MtfFilter(std::shared_ptr<const PixelHaze> haze);
    const PixelHaze& haze() const { return *haze_; }

    /// Adds the haze of an object's pixels to those of another window (as a rule `object` grown by
    /// the support). The direct image is not part of it.
    void addHaze(const HazeWindow& object, std::span<const float> values, const HazeWindow& to,
                 std::span<float> sums);

    /// Points of the transforms that addHaze() takes for these windows.
    std::size_t points(const HazeWindow& object, const HazeWindow& to) const;

  private:
    /// Which displacements occur along an axis, and the period that keeps them apart.
    struct Axis {
        int first = 0, last = -1, period = 1;
        bool operator==(const Axis&) const = default;
    };
    struct Kernel {
        Axis across, down;
        FftBuffer<std::complex<float>> spectrum; ///< divided by the number of points
    };
    Axis axis(int object, int objectSize, int to, int toSize) const;
    const Kernel& kernelOf(const Axis& across, const Axis& down);

    std::shared_ptr<const PixelHaze> haze_;
    RecentlyUsed<Kernel> kernels_;
    FftBuffer<float> reals_;
    FftBuffer<std::complex<float>> spectrum_;
    std::size_t realsRoom_ = 0, spectrumRoom_ = 0;
};

} // namespace irsg
