#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/tools/PathGeometry.h"

namespace smat {

/// What a radiative output (F51) is asked.
struct RadiativeRequest {
    /// Spectral quantities, each once; not the ambient temperature, which has no spectrum.
    std::vector<irsg::AtmosphereProperty> quantities;
    /// Leave out, with a warning, what the air or the geometry has no value for; otherwise that is
    /// refused.
    bool leaveOutMissing = false;
    PathGeometryInput geometry;
    /// Distances that spectra of plumes were measured from, m: beside the transmittance of the path
    /// that of its last so many metres. Those that are not shorter than the path are left out, as
    /// nothing is added to or taken off such a spectrum.
    std::vector<double> referenceDistances_m = {};
    irsg::SpectralRange band;
    std::string commandLine = {}; ///< goes into the provenance where it is not empty
};

/// The words of the command line: "transmittance", "path", "background", "sun", "up", "down",
/// "scattering".
struct RadiativeQuantity {
    std::string_view word;
    irsg::AtmosphereProperty property;
    irsg::Quantity quantity;
};
const std::vector<RadiativeQuantity>& radiativeQuantities();

struct RadiativeOutput {
    /// `wavenumber [cm-1]` (ascending), `wavelength [um]`, then a column a quantity. Spectra are
    /// linear in wavelength between rows, with all nodes of all of them: SpectraAtmosphere reads
    /// the file back as the same spectra.
    ResultTable table;
    std::vector<SummaryItem> summary; ///< band means of ratios, integrals of densities
    std::vector<std::string> providedBy;
    std::vector<std::string> warnings;
};

/// Spectra of the air for one geometry, with everything that made them in the provenance: geometry,
/// sun, band, who answered, the ambient temperature at the target where an atmosphere has one, and
/// the numbers of the band. Sun and fluxes are those at the target's altitude. The background is
/// that of the whole line of sight.
///
/// Throws InputError for what solveGeometry refuses, for a quantity that the geometry says too
/// little for, and for a band or quantity that no atmosphere answers for.
RadiativeOutput radiativeOutput(const irsg::Environment& environment,
                                const RadiativeRequest& request);

} // namespace smat
