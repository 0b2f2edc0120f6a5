#pragma once

#include <filesystem>
#include <vector>

#include "irsg/atmosphere/engine/AtmosphericState.h"

namespace irsg::lbl {

/// What every table fitted to the published run says of it.
inline constexpr const char* publishedRunSource =
    "# source: a MODTRAN run published with pyradi (C. J. Willers et al., MIT licence), file "
    "horizon5kmtropical.fl7\n";

/// The transmittances of a MODTRAN run, absorber by absorber: 5 km horizontal in tropical air at
/// the ground, 657 to 50000 cm-1 by 5 cm-1, triangular slit of 10 cm-1, four decimals.
struct PublishedRun {
    static constexpr double length_cm = 5e5;
    static constexpr double rounding = 5e-5; ///< of a transmittance

    std::vector<double> wavenumber_per_cm, water, waterContinuum, methane, oxygen;

    /// Throws InputError naming the file and each line that is not a row of the run.
    static PublishedRun read(const std::filesystem::path& data);
    /// Tropical air at the ground.
    static AtmosphericState air();
};

} // namespace irsg::lbl
