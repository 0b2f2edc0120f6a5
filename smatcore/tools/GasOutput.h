#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "irsg/gas/GasSpectrum.h"
#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/data/ResultTable.h"

namespace smat {

/// The way from the first layer of gas to the sensor.
struct GasPath {
    irsg::Environment environment;
    double gasAltitude_m = 0.0;
    double sensorAltitude_m = 0.0;
    double range_m = 0.0;
};

struct GasOutputRequest {
    irsg::GasRequest gas;
    std::optional<GasPath> path = {}; ///< none: the sensor stands before the gas
    std::string commandLine = {};     ///< goes into the provenance where it is not empty
};

struct GasOutput {
    /// `wavenumber [cm-1]` (ascending), `wavelength [um]`, `spectral_radiance`, `transmittance`,
    /// the stated error of the radiance, what each gas and soot adds; through an atmosphere also
    /// the product of means (without the coincidence of lines), the radiance before it, both
    /// transmittances and the path radiance.
    ResultTable table;
    std::vector<SummaryItem> summary; ///< band radiance, its error, transmittance, parts, RADCAL's
    std::vector<std::string> warnings;
    /// Spectral radiance of the same rows by RADCAL's tables, W m-2 sr-1 um-1; empty where they are
    /// the source of the table.
    std::vector<double> radcal_W_m2_sr_um;
    /// Words of the sources that answered for each gas in the band, "lines" or "lines, radcal"; ""
    /// for a gas that is not there.
    std::array<std::string, irsg::hotGasCount> answeredBy;
};

/// Spectrum of layers of gas with its band numbers and who answered in the provenance. The radiance
/// is that of the gas and of what is behind it, at the sensor; the atmosphere's own path radiance
/// is a column beside it. The coincidence of lines of gas and air (irsg::lineCorrelations) is taken
/// from a computed atmosphere; another is multiplied, with a warning. Throws InputError for what
/// irsg::gasSpectrum refuses, and for a band or path that the atmosphere has no transmittance or
/// path radiance for.
GasOutput gasOutput(const GasOutputRequest& request);

} // namespace smat
