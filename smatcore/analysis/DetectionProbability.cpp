#include "smatcore/analysis/DetectionProbability.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "smatcore/analysis/DetectionAspects.h"
#include "smatcore/analysis/DetectionProvenance.h"
#include "smatcore/analysis/SampleStatistics.h"
#include "smatcore/project/SceneScalings.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

/// The scene with the scales of each draw; itself where nothing is drawn.
std::vector<SceneDescription> drawnScenes(AnalysisData& data, const SceneDescription& scene,
                                          std::size_t draws) {
    if (draws == 0)
        return {scene};
    const std::vector<SceneScaling> scalings = sceneScalings(data.project, scene, data.warnings);
    const auto seed = static_cast<std::uint64_t>(data.settings[key::scalingSeed]);
    std::vector<SceneDescription> scenes(draws, scene);
    for (std::size_t draw = 0; draw < draws; ++draw)
        for (const SceneScaling& scaling : scalings) {
            irsg::Entity& entity =
                scenes[draw].entities[static_cast<std::size_t>(scaling.input.entity)];
            scalesOf(entity, scaling.input.kind)[scaling.input.index] = scaling.at(seed, draw);
        }
    return scenes;
}

/// The target at a range, or no signal where the scene refuses it, with the reason. No value is
/// assigned within the try block: GCC 12 lets the call write over the assigned one, which then is
/// lost when it throws.
TargetLook lookAt(TargetAspect& aspect, double range_m, std::string& refusal) {
    try {
        return aspect.at(range_m, false);
    } catch (const irsg::InputError& error) {
        refusal = error.what();
    }
    TargetLook nothing;
    nothing.nei_W_m2 = 1.0; // of no signal the ratio is 0
    return nothing;
}

/// What is known at a range: the sums of the aspects that were looked at.
struct AtRange {
    std::vector<double> byAspect, byDraw, reached;
    std::vector<double> probabilities, ratios; ///< by draw, of the aspect at hand
    std::string refusal;

    /// An aspect counts with all of its draws.
    void endAspect() {
        byAspect.push_back(meanOf(probabilities));
        reached.push_back(meanOf(ratios));
        byDraw.resize(probabilities.size());
        for (std::size_t draw = 0; draw < byDraw.size(); ++draw)
            byDraw[draw] += probabilities[draw];
        probabilities.clear();
        ratios.clear();
    }
    std::vector<double> row(double range_m, std::size_t draws) const {
        std::vector<double> row = {range_m, meanOf(byAspect), std::ranges::min(byAspect),
                                   std::ranges::max(byAspect), meanOf(reached)};
        if (draws > 0) {
            std::vector<double> means = byDraw;
            for (double& mean : means)
                mean /= static_cast<double>(byAspect.size());
            row.push_back(means.size() < 2 ? std::numeric_limits<double>::quiet_NaN()
                                           : standardDeviationOf(means));
        }
        return row;
    }
};

} // namespace

void runDetectionProbability(AnalysisData& data, const DetectionRequest& request,
                             const RenderDoor& door, const SceneFactory& scenes,
                             const RunControl& control) {
    DetectionProgress progress(control);
    DetectionAspects aspects(data, request, door, scenes);
    const DetectionScene& shared = aspects.shared();
    TargetSight& sight = aspects.sight();
    const std::vector<SceneDescription> drawn = drawnScenes(data, shared.scene, request.draws);
    if (control.isRehearsal)
        return shared.check(request.ranges_m.front());
    ResultTable& table = data.table;
    table.add(irsg::Quantity::range);
    table.add("probability", "");
    table.add("least_probability", "");
    table.add("greatest_probability", "");
    table.add(sight.isOfCycles() ? "cycles" : "snr", "");
    if (request.draws > 0)
        table.add("deviation_probability", "");

    progress.total = shared.plan.cases.size() * drawn.size();
    std::vector<AtRange> all(request.ranges_m.size());
    std::vector<double> clutters_K;
    aspects.each(drawn, progress, [&](const DetectionAspects::Case& one) {
        if (request.measuresClutter)
            clutters_K.push_back(one.clutter.deviation_K);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const TargetLook look = lookAt(one.aspect, request.ranges_m[i], all[i].refusal);
            all[i].probabilities.push_back(sight.probability(look));
            all[i].ratios.push_back(sight.reached(look));
            if (one.drawn + 1 == drawn.size())
                all[i].endAspect();
        }
    });
    const std::size_t done = all.front().byAspect.size();
    for (std::size_t i = 0; i < all.size() && done > 0; ++i)
        table.addRow(
            all[i].row(request.ranges_m[i], request.draws),
            all[i].refusal.empty() ? "" : "nothing is seen from some aspects: " + all[i].refusal);
    aspects.tellWarnings();
    const bool isComplete = done == shared.plan.cases.size();
    if (!isComplete)
        data.warnings.push_back(
            fmt::format("stopped after {} of {} aspects", done, shared.plan.cases.size()));
    data.state = isComplete ? AnalysisState::complete : AnalysisState::partial;
    data.elapsed_s = progress.elapsed_s();
    tellDetection(data, shared, request, sight);
    table.provenance.add("detection.aspects", std::to_string(done));
    if (request.draws > 0)
        table.provenance.add("detection.draws", std::to_string(request.draws));
    if (!clutters_K.empty())
        data.summary.push_back({"Clutter of the background, mean", meanOf(clutters_K), "K"});
}

} // namespace smat
