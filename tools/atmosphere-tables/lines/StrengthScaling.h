#pragma once

#include <vector>

#include "tools/atmosphere-tables/lines/Line.h"

namespace irsg::lbl {

/// Transmittances of one gas alone over a path through uniform air, as somebody else has them.
struct KnownPath {
    AtmosphericState air;
    double length_cm = 0.0;
    std::vector<double> wavenumbers_per_cm,
        transmittances; ///< as many, ascending; means over some cm-1
};

/// Windows of the spectrum, `width_per_cm` each, between whole multiples of their width.
struct ScalingWindows {
    double lower_per_cm = 0.0, upper_per_cm = 0.0, width_per_cm = 100.0;
};

/// Multiplies the strengths of the lines inside the windows until the mean transmittance over each
/// of them is that of the path. The logarithm of the factor runs straight from the middle of a
/// window to the middle of the next and is clamped beyond the outermost; it stays between 1/3
/// and 3. A window that transmits everything (above 0.9995) asks for nothing. LogicError where the
/// windows are not a whole number or the path has no value in one of them.
void scaleStrengths(LineList& list, const KnownPath& path, const ScalingWindows& windows);

} // namespace irsg::lbl
