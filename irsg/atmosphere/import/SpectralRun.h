#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/atmosphere/path/AtmosphericQuery.h"
#include "irsg/core/Errors.h"

namespace irsg {

/// What a run computed: MODTRAN's IEMSCT.
enum class RunKind { transmittance = 0, thermalRadiance = 1, solarRadiance = 2, sunlight = 3 };
const char* name(RunKind kind);

/// The line of sight of a run: MODTRAN's ITYPE.
enum class RunPath { horizontal = 1, slant = 2, toSpace = 3 };

/// Where a run looked. Altitudes are above the ground (MODTRAN's H1, H2 less GNDALT).
struct RunGeometry {
    RunPath path = RunPath::horizontal;
    double sensorAltitude_m = 0.0;
    double targetAltitude_m = 0.0; ///< top of the atmosphere for a path to space
    double range_m = 0.0;          ///< 0 where the run does not tell
    double elevation_rad = 0.0;    ///< at the sensor; 0 for a horizontal path
    /// Of the sun, at the sensor: kind sunlight, and solarRadiance where the run states it.
    std::optional<double> sunElevation_rad;

    bool operator==(const RunGeometry&) const = default;
};

/// The result of one run of a radiative transfer program over one line of sight, in our units.
/// Vectors are empty where the run has no such column, else as long as the wavenumbers.
struct SpectralRun {
    std::string source; ///< file, and which run in it
    RunKind kind = RunKind::transmittance;
    RunGeometry geometry;
    /// The settings of the run by the names of MODTRAN's cards: MODEL, IHAZE, VIS, ...
    std::map<std::string, double> cards;
    std::vector<std::string> warnings;

    std::vector<double> wavenumbers_per_cm;       ///< ascending
    std::vector<double> transmittance;            ///< 0 to 1
    std::vector<double> pathRadiance_W_m2_sr_um;  ///< emitted and scattered into the path
    std::vector<double> totalRadiance_W_m2_sr_um; ///< with what is at the end of the path
    std::vector<double> solarIrradiance_W_m2_um;  ///< at the sensor, normal to the beam
    std::vector<double> scatteringDepth;          ///< optical depth by scattering alone

    bool operator==(const SpectralRun&) const = default;
};

/// What a column of a run's table holds, whatever the version calls it.
enum class RunColumn {
    wavenumber,
    transmittance,
    depth,
    thermal,
    thermalScatter,
    surface,
    solarScatter,
    singleScatter,
    ground,
    total,
    sunAtObserver,
    sunTransmitted,
    molecularScatter,
    aerosol,
    aerosolAbsorption
};
/// The column of a header: "TOT_TRANS" and "TOT TRANS" (tape7), "total transmittance" (spectral
/// library), "SOL_AT_OBS" (JSON). No value for columns that are not used.
std::optional<RunColumn> runColumn(std::string_view header);

/// The unit of the spectral axis and of densities, MODTRAN's XFLAG: W (cm-1, W cm-2 per cm-1),
/// M (um, W cm-2 per um), N (nm, uW cm-2 per nm).
enum class SpectralUnit { wavenumber, micrometre, nanometre };

/// The table of a run as it stands in its file; NaN is a blank cell.
struct RunTable {
    std::string file;
    std::vector<std::string> positions; ///< of each row: "line 12"
    std::map<RunColumn, std::vector<double>> columns;
    SpectralUnit unit = SpectralUnit::wavenumber;
    /// Half a step of the last digit that transmittances are printed with; 0 when not known.
    double transmittanceRounding = 0.0;
    /// True where the thermal and solar columns already include what is scattered (PTH_THRML and
    /// SOL_SCAT of MODTRAN 4 and 5), false where they stand beside it (THRML_EM, MULT_SCAT of 6).
    bool sumsIncluded = true;
};

/// Fills the spectra of `run` (whose kind and geometry are set) from its table and converts units.
///
/// Path radiance is thermal plus solar. Whether THRML_SCT and SING_SCAT are parts of these columns
/// or stand beside them depends on the version: that sum is taken which together with SURF_EMIS and
/// GRND_RFLT gives the file's own TOTAL_RAD; a warning says when none does to 1 %. A transmittance
/// that is printed with too few digits is taken from the optical depth beside it. Scattering depth
/// is -ln(MOLEC SCAT) - ln(AER+CLD TRANS / AER+CLD abTRNS). Adds a diagnostic for each missing
/// column, each required cell that is blank, each value out of range, wavenumbers that do not
/// ascend.
void fillRun(SpectralRun& run, const RunTable& table, std::vector<Diagnostic>& diagnostics);

/// Length in m of the straight chord of a spherical earth from one altitude to another, leaving at
/// an elevation; no value where the ray does not reach that altitude
/// before the ground. `beyondTangent` takes the
/// farther crossing of a downward ray.
std::optional<double> chord_m(double fromAltitude_m, double toAltitude_m, double elevation_rad,
                              double earthRadius_m, bool beyondTangent = false);

} // namespace irsg
