#include "smatcore/analysis/CalculationChoice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/radiance/WidebandAir.h"
#include "irsg/scene/radiance/WidebandPoints.h"

namespace smat {

namespace {

/// What the terms of wideband-ck save and what training them costs, in units of transmittance and
/// radiance of a path at all nodes of the band. In processor time of computed air, whatever the
/// band (docs/atmosphere-accuracy.md):
constexpr double ofSky = 2.7,
                 ofGases = 2.4; ///< a row of the background; a case with spectra of gas
constexpr double training = 430.0, trainingWithGases = 1075.0;

/// Terms of air of a file are trained in a few lines of sight.
constexpr double fewestInAirOfAFile = 3.0;

/// Rows of a background that is as fine as half a percent needs, about.
constexpr int adaptiveRows = 16;

bool hasComputedAir(const SceneDescription& scene) {
    return std::ranges::any_of(scene.allBands(), [&](const irsg::Band& band) {
        return dynamic_cast<const irsg::AtmosphereSmart*>(
                   scene.environment.findWideband(band.range())) != nullptr;
    });
}

/// Skies that differ: by the camera's altitude and elevation, and by the range where rows of the
/// background are spread over the picture.
std::size_t skiesOf(const AnalysisPlan& plan, int rows) {
    std::set<std::array<double, 4>> skies;
    for (const AnalysisCase& one : plan.cases) {
        const double climb_m = one.range_m * std::sin(irsg::radians(one.shownElevation_deg));
        skies.insert({one.altitude_m.value_or(0.0), climb_m, one.shownElevation_deg,
                      rows == 1 ? 0.0 : one.range_m});
    }
    return skies.size();
}

/// How many different lines of sight like those of a plan pay for training.
std::size_t fewestToTrain(const SceneDescription& scene, const AnalysisPlan& plan) {
    if (!hasComputedAir(scene))
        return static_cast<std::size_t>(fewestInAirOfAFile);
    const bool hasGases = !irsg::widebandSpectraOf(scene.entities).radiances.empty();
    const auto lines = std::max(1.0, static_cast<double>(linesOfSight(plan)));
    double saved = lines;
    if (scene.render.background == irsg::BackgroundMode::environment) {
        const int rows = scene.render.backgroundRows;
        saved +=
            ofSky * static_cast<double>(skiesOf(plan, rows)) * (rows == 0 ? adaptiveRows : rows);
    }
    if (hasGases)
        saved += ofGases * static_cast<double>(plan.cases.size());
    return static_cast<std::size_t>(
        std::ceil((hasGases ? trainingWithGases : training) * lines / saved));
}

} // namespace

std::size_t linesOfSight(const AnalysisPlan& plan) {
    std::set<std::array<double, 3>> lines;
    for (const AnalysisCase& one : plan.cases)
        lines.insert({one.range_m, one.shownElevation_deg, one.altitude_m.value_or(0.0)});
    return lines.size();
}

CalculationChoice chooseCalculation(const SceneDescription& scene, const AnalysisPlan& plan) {
    using irsg::CalculationMode;
    const std::vector<irsg::Band> bands = scene.allBands();
    if (!std::all_of(bands.begin(), bands.end(), [&](const irsg::Band& band) {
            return irsg::hasWidebandAir(scene.environment, band, scene.render);
        })) {
        return {};
    }
    const std::size_t lines = linesOfSight(plan), fewest = fewestToTrain(scene, plan);
    if (lines < fewest) {
        return {CalculationMode::spectral,
                fmt::format("mode auto: spectral, as training wideband-ck pays from {} different "
                            "lines of sight on, not for {}",
                            fewest, lines)};
    }
    return {CalculationMode::wideband,
            fmt::format("mode auto: wideband-ck, as {} different lines of sight pay for training "
                        "it (from {} on)",
                        lines, fewest)};
}

} // namespace smat
