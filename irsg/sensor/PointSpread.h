#pragma once

#include <cstddef>
#include <vector>

#include "irsg/sensor/FourierTransform.h"
#include "irsg/sensor/SensorTransfer.h"

namespace irsg {

/// How the light of a point, and of a cell of a finer grid, falls on the pixels of a sensor: the
/// transform of its SensorTransfer.
class PointSpread {
  public:
    /// InputError for a sensor whose pixels are too wide, or whose points are spread too far.
    PointSpread(const SensorDescription& sensor, double source_K);
    /// Throws that alone.
    static void check(const SensorDescription& sensor);

    /// The part of a point's light behind the pupil that the active area of a pixel receives whose
    /// centre is so far from the point's image, in pixels along rows and columns: at 0, 0 the
    /// ensquared energy. An integral over all frequencies that the optics transmit, right to 1e-8.
    double energyAt(double columns_px, double rows_px) const;

    /// Side of the square of pixels over which a point is spread; what diffraction spreads farther
    /// (parts in a thousand) lies on the same square, which is periodic.
    std::size_t side_px() const { return side_; }
    /// The transform of how the light of a square cell of `cell_px` falls on that square of pixels
    /// (a point: 0), whose centre is `column_px`, `row_px` from the centre of pixel 0, 0. A pixel
    /// receives the mean over its active area, energyAt of a point divided by the fill factor. At
    /// frequency 0 it is 1 where pixels have no gaps: no energy is lost, whatever the place. Of a
    /// point between active areas that is less, and more of one on them.
    HalfSpectrum spectrumOf(double cell_px, double column_px, double row_px) const;

  private:
    double opticsAt(double x_per_px, double y_per_px) const;
    double transferAt(double x_per_px, double y_per_px) const;

    SensorTransfer transfer_;
    double perPixel_; ///< cycles/rad of one cycle/px
    double fillFactor_;
    bool isRound_;
    double cutoff_; ///< cycles/px
    std::size_t side_;
    std::vector<double> radial_; ///< optics at equal steps up to the cutoff
    // The transfer at the frequencies of the square and all that are sampled as these, from 0 on.
    std::vector<double> frequencies_, wide_;
};

} // namespace irsg
