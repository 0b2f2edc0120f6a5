#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace key {
constexpr RealKey spectrumResolution{"spectrum.resolution"};
} // namespace key

namespace {

std::vector<SettingInfo> spectrumSettings() {
    return {rows::number(key::spectrumResolution, "--resolution", "Resolution", "cm-1", 0.01, 1000,
                         "5", "Distance between two wavenumbers.")};
}

void planSpectrum(AnalysisPlan& plan, const Project& project, const Settings& settings,
                  std::vector<irsg::Diagnostic>& diagnostics) {
    const irsg::SpectralRange range = sensorOf(project, settings).band.range();
    const double lowest_per_cm = irsg::wavenumberFromWavelength_per_cm(range.max_um);
    const double highest_per_cm = irsg::wavenumberFromWavelength_per_cm(range.min_um);
    const double step_per_cm = settings[key::spectrumResolution];
    plan.coordinate = irsg::Quantity::wavenumber;
    plan.columns = {irsg::Quantity::wavenumber, irsg::Quantity::wavelength};
    plan.cases.push_back(startingCase(settings));
    const double count = std::floor((highest_per_cm - lowest_per_cm) / step_per_cm + 1e-9) + 1.0;
    if (count > mostCases) {
        diagnostics.push_back(
            {.file = "",
             .position = key::spectrumResolution,
             .value = settings.text(key::spectrumResolution),
             .expected = fmt::format("at most {:.0f} wavenumbers, not {:.0f}", mostCases, count)});
        return;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        plan.wavenumbers_per_cm.push_back(
            std::min(lowest_per_cm + static_cast<double>(i) * step_per_cm, highest_per_cm));
    }
    // The band ends at its end, also where the last step is shorter.
    if (highest_per_cm - plan.wavenumbers_per_cm.back() > 1e-6 * step_per_cm)
        plan.wavenumbers_per_cm.push_back(highest_per_cm);
}

} // namespace

extern constinit const AnalysisDefinition spectrumAnalysis{
    .name = "spectrum",
    .title = "Intensity spectrum",
    .help = "Intensity of the target over wavenumber and wavelength",
    .icon = "spectrum",
    .form = AnalysisForm::spectrum,
    .settings = spectrumSettings,
    .plan = planSpectrum};

} // namespace smat
