#pragma once

#include <array>

#include "irsg/atmosphere/path/AtmosphericQuery.h"

namespace irsg::lbl {

struct TruthBand {
    double lower_per_cm, upper_per_cm;
};

/// The bands (8-12, 3-5 and 1.5-2.5 um, at whole multiples of 5 cm-1) and the paths in each of the
/// six model atmospheres over which the spectral mode is held to line by line.
inline constexpr std::array<TruthBand, 3> truthBands = {
    {{830.0, 1250.0}, {2000.0, 3335.0}, {4000.0, 6670.0}}};
inline constexpr double truthBinWidth_per_cm = 5.0;
inline constexpr std::array<AtmosphericPath, 10> truthPaths = {{{100.0, 100.0, 1e3},
                                                                {100.0, 100.0, 10e3},
                                                                {2000.0, 2000.0, 20e3},
                                                                {6000.0, 6000.0, 60e3},
                                                                {10000.0, 10000.0, 200e3},
                                                                {100.0, 3000.0, 6e3},
                                                                {3000.0, 10000.0, 14e3},
                                                                {8000.0, 100.0, 12e3},
                                                                {12000.0, 6000.0, 80e3},
                                                                {100.0, 99000.0, 140e3}}};

} // namespace irsg::lbl
