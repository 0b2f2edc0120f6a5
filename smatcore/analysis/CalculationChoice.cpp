#include "smatcore/analysis/CalculationChoice.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/scene/radiance/WidebandAir.h"
#include "irsg/scene/radiance/WidebandPoints.h"

namespace smat {

namespace {

/// Lines of sight that pay for training. The terms of computed air follow from seventy paths
/// at all nodes of a band; spectra of gases make training twice as dear, and each line in the
/// spectral mode six times.
std::size_t fewestToTrain(const SceneDescription& scene) {
    const auto isComputed = [&](const irsg::Band& band) {
        return dynamic_cast<const irsg::AtmosphereSmart*>(
                   scene.environment.findWideband(band.range())) != nullptr;
    };
    if (std::ranges::none_of(scene.allBands(), isComputed))
        return 3;
    return irsg::widebandSpectraOf(scene.entities).radiances.empty() ? 120 : 100;
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
    const std::size_t lines = linesOfSight(plan), fewest = fewestToTrain(scene);
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
