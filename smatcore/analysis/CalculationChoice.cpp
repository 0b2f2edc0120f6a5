#include "smatcore/analysis/CalculationChoice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/radiance/WidebandAtmosphere.h"
#include "irsg/radiance/WidebandPoints.h"
#include "irsg/radiometry/Units.h"

namespace smat {

namespace {

/// What the quadrature points of wideband-ck save and what training them costs, in units of
/// transmittance and radiance of a path at all nodes of the band: a row of the background, and a
/// case with spectra of gas, which make training dearer. In processor time of computed air
/// (docs/atmosphere-accuracy.md).
constexpr double ofSky = 2.5, ofGases = 4.4, dearerWithGases = 3.3;

/// Points of air of a file are trained in a few lines of sight.
constexpr double fewestInAtmosphereOfAFile = 3.0;

/// About as many points as a fit has: where many bands have no more nodes each, points save
/// nothing.
constexpr double fewestNodesOfABand = 40.0;

/// Lines of sight behind an object where rows are automatic, about.
constexpr int automaticRows = 4;

/// Nodes of bins of 1 and of 15 cm-1, of those of 5 cm-1 over the same band.
double nodesBeside5(int resolution_per_cm) {
    return resolution_per_cm == 1 ? 2.55 : resolution_per_cm == 15 ? 0.37 : 1.0;
}

/// Of bands in computed air.
struct Training {
    double cost = 0.0;         ///< by node of all bands; 0 where no air is computed
    double nodesOfABand = 0.0; ///< on the average
};

/// What training in computed air costs.
/// Nodes that lie dense are of many lines of several gases, whose fit needs more points: 165 to 200
/// units at 1.1 to 1.3 nodes of bins of 5 cm-1 per cm-1, 250 at 1.5, 330 to 400 at 1.9.
Training training(const SceneDescription& scene) {
    double cost = 0.0, all = 0.0, bands = 0.0;
    for (const irsg::Band& band : scene.allBands()) {
        const auto* air = dynamic_cast<const irsg::AtmosphereSmart*>(
            scene.environment.findWideband(band.range()));
        const auto sampling = air ? air->nodesOf({band}) : nullptr;
        if (!sampling)
            continue;
        const int bin_per_cm = air->parameters().resolution_per_cm;
        const double beside5 = nodesBeside5(bin_per_cm);
        const auto nodes = static_cast<double>(sampling->size());
        const double width_per_cm = 1e4 / band.range().min_um - 1e4 / band.range().max_um;
        const double density = nodes / (width_per_cm + 2.0 * bin_per_cm) / beside5;
        constexpr double ofAtmosphere = 90.0, ofFit = 95.0, ofDenseFit = 380.0, sparse = 1.4;
        cost += nodes *
                (ofAtmosphere + (ofFit + ofDenseFit * std::max(0.0, density - sparse)) / beside5);
        all += nodes;
        ++bands;
    }
    return all > 0.0 ? Training{cost / all, all / bands} : Training();
}

/// Skies that differ: by the camera's altitude and elevation, and by the range, as a target appears
/// the lower the farther it is.
std::size_t skiesOf(const AnalysisPlan& plan) {
    std::set<std::array<double, 4>> skies;
    for (const AnalysisCase& one : plan.cases) {
        const double climb_m = one.range_m * std::sin(irsg::radians(one.shownElevation_deg));
        skies.insert({one.altitude_m.value_or(0.0), climb_m, one.shownElevation_deg, one.range_m});
    }
    return skies.size();
}

/// How many different lines of sight like those of a plan pay for training.
std::size_t fewestToTrain(const SceneDescription& scene, const Training& computed,
                          const AnalysisPlan& plan, std::size_t linesOfPlan) {
    if (computed.cost == 0.0)
        return static_cast<std::size_t>(fewestInAtmosphereOfAFile);
    const bool hasGases = !irsg::widebandSpectraOf(scene.entities).radiances.empty();
    const auto lines = std::max(1.0, static_cast<double>(linesOfPlan));
    double saved = lines;
    if (scene.settings.background == irsg::BackgroundMode::environment) {
        const int rows = scene.settings.backgroundRows;
        saved += ofSky * static_cast<double>(skiesOf(plan)) * (rows == 0 ? automaticRows : rows);
    }
    if (hasGases)
        saved += ofGases * static_cast<double>(plan.cases.size());
    return static_cast<std::size_t>(
        std::ceil((hasGases ? dearerWithGases : 1.0) * computed.cost * lines / saved));
}

bool holdsGas(const irsg::Entity& entity) {
    return std::ranges::any_of(entity.model->codes(), [&](const auto& use) {
        const irsg::Material* material = irsg::materialEntry(entity, use.first.material);
        return material != nullptr && material->isGas();
    });
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
            return irsg::hasWidebandAtmosphere(scene.environment, band, scene.settings);
        })) {
        return {};
    }
    if (std::ranges::any_of(scene.entities, holdsGas))
        return {CalculationMode::spectral,
                "mode auto: spectral, as wideband-ck has no quadrature points for zones of gas"};
    const Training computed = training(scene);
    if (computed.cost > 0.0 && bands.size() > 1 && computed.nodesOfABand < fewestNodesOfABand) {
        return {CalculationMode::spectral,
                fmt::format("mode auto: spectral, as bands of {:.0f} nodes have no more of them "
                            "than wideband-ck has quadrature points",
                            computed.nodesOfABand)};
    }
    const std::size_t lines = linesOfSight(plan),
                      fewest = fewestToTrain(scene, computed, plan, lines);
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
