#pragma once

#include <functional>
#include <span>

#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// The accuracy that sampled curves aim at: straight pieces between nodes follow the curve to
/// better than 1e-6 of its value.
inline constexpr double curveTolerance = 8e-7;
/// Below this part of the largest value of the curve the error is measured against this part
/// instead, so that the flanks of an opaque band cost no nodes that nobody sees.
inline constexpr double curveFloor = 1e-9;

/// A spectrum whose straight pieces follow `curve` to `relativeTolerance` of its local value, or of
/// `floor` times the largest where that is more. The curve is smooth between neighbouring
/// `kinks`, which are wavelengths in um, ascend strictly, become nodes and span the spectrum: at
/// least two of them (LogicError). Each piece is cut into as many equal parts as its deviation from
/// the chord at three points asks for, again and again; the error of a chord falls with the square
/// of the number of parts.
Spectrum sampledCurve(const std::function<double(double)>& curve, std::span<const double> kinks,
                      double relativeTolerance = curveTolerance, double floor = curveFloor);

/// A Planck function times a factor over a range, sampled as above.
Spectrum sampledPlanck(double temperature_K, const SpectralRange& range, double factor = 1.0);

} // namespace irsg
