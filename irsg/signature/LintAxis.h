#pragma once

#include <string>
#include <vector>

#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// What an axis that is no axis of wavelengths in um may be instead.
struct AxisReading {
    std::string name;  ///< "cm-1"
    double toUm = 0.0; ///< factor to um; 0 for wavenumbers, um = 1e4 / value

    double wavelength_um(double value) const;
};

/// The readings under which an axis from `first` to `last`, given in um, becomes one of the
/// infrared (0.1 to 200 um): none where it is one as it stands; else cm-1, nm, or m, those first
/// that overlap one of `bands`. Never more than two.
std::vector<AxisReading> otherReadings(double first_um, double last_um,
                                       const std::vector<SpectralRange>& bands);
/// True where the axis as it stands is not one of the infrared.
bool isAbsurdAxis(double first_um, double last_um);

/// "nm or cm-1 taken for um?" and, where it is clear which, "nm taken for um? Divide the axis by
/// 1000".
std::string axisRepair(const std::vector<AxisReading>& readings, bool isClear);
/// One reading is left, or the bands overlap the first alone.
bool isClear(const std::vector<AxisReading>& readings, double first_um, double last_um,
             const std::vector<SpectralRange>& bands);

/// The axis read otherwise, ascending; `order` is filled with where each node was.
std::vector<double> readOtherwise(const std::vector<double>& axis_um, const AxisReading& reading,
                                  std::vector<std::size_t>& order);

} // namespace irsg
