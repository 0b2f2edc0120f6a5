#pragma once

#include "irsg/sensor/SensorDescription.h"

namespace irsg {

/// The optical transfer function of a pupil with defocus: the autocorrelation of its amplitude with
/// phase, divided by its area (Goodman, Introduction to Fourier Optics, chapter 6.4). Computed as
/// an integral over the overlap of two pupils, in which the phase of defocus depends on one
/// coordinate alone; right to 1e-9 for up to 20 waves. It is real, and negative where contrast is
/// reversed.
///
/// `shiftX` and `shiftY` are the shift between both pupils in radii, of a square in half sides:
/// 2 lambda f / D for a frequency of f cycles/rad; 2 is the cutoff of a circle. `obscuration` is
/// that of an annulus, else 0. `waves` is the wavefront error at the edge, of a square at the
/// middle of its side.
double pupilTransfer(PupilShape shape, double obscuration, double waves, double shiftX,
                     double shiftY);

} // namespace irsg
