#include "smatcore/analysis/CalculationChoice.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "irsg/scene/radiance/WidebandAir.h"

namespace smat {

namespace {

constexpr std::size_t fewestToTrain = 400; ///< lines of sight that pay for training

std::size_t linesOfSight(const AnalysisPlan& plan) {
    std::set<std::array<double, 3>> lines;
    for (const AnalysisCase& one : plan.cases)
        lines.insert({one.range_m, one.shownElevation_deg, one.altitude_m.value_or(0.0)});
    return lines.size();
}

} // namespace

CalculationChoice chooseCalculation(const SceneDescription& scene, const AnalysisPlan& plan) {
    using irsg::CalculationMode;
    const std::vector<irsg::Band> bands = scene.allBands();
    if (!std::all_of(bands.begin(), bands.end(), [&](const irsg::Band& band) {
            return irsg::hasWidebandAir(scene.environment, band);
        })) {
        return {};
    }
    const std::size_t lines = linesOfSight(plan);
    if (lines < fewestToTrain) {
        return {CalculationMode::spectral,
                fmt::format("mode auto: spectral, as training wideband-ck pays from {} different "
                            "lines of sight on, not for {}",
                            fewestToTrain, lines)};
    }
    return {CalculationMode::wideband,
            fmt::format("mode auto: wideband-ck, as {} different lines of sight pay for training "
                        "it (from {} on)",
                        lines, fewestToTrain)};
}

} // namespace smat
