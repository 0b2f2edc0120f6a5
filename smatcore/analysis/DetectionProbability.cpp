#include "smatcore/analysis/DetectionProbability.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include <fmt/format.h>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "smatcore/analysis/DetectionProvenance.h"
#include "smatcore/analysis/SampleStatistics.h"
#include "smatcore/analysis/TargetAspect.h"
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

/// A row of the table: probabilities by aspect, then by draw.
struct AtRange {
    std::vector<std::vector<double>> probabilities;
    double reached = 0.0; ///< the mean

    std::vector<double> row(double range_m, bool hasDraws) const {
        std::vector<double> byAspect, byDraw(probabilities.front().size());
        for (const std::vector<double>& one : probabilities) {
            byAspect.push_back(meanOf(one));
            for (std::size_t draw = 0; draw < byDraw.size(); ++draw)
                byDraw[draw] += one[draw] / static_cast<double>(probabilities.size());
        }
        std::vector<double> row = {range_m, meanOf(byAspect), std::ranges::min(byAspect),
                                   std::ranges::max(byAspect), reached};
        if (hasDraws)
            row.push_back(standardDeviationOf(byDraw));
        return row;
    }
};

} // namespace

void runDetectionProbability(AnalysisData& data, const DetectionRequest& request,
                             const RenderDoor& door, const SceneFactory& scenes,
                             const RunControl& control) {
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed_s = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const DetectionScene shared(data, request, door, scenes);
    TargetSight sight(request);
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

    CaseWarnings warnings;
    const std::vector<SceneDescription> drawn = drawnScenes(data, shared.scene, request.draws);
    std::vector<std::unique_ptr<TargetAspect>> aspects; // by case, then by draw
    std::vector<double> clutters_K;
    for (const AnalysisCase& one : shared.plan.cases)
        for (const SceneDescription& scene : drawn) {
            aspects.push_back(
                std::make_unique<TargetAspect>(shared, scene, sight, one, data, warnings));
            if (request.measuresClutter)
                clutters_K.push_back(aspects.back()->measureClutter(request.sensor));
        }
    std::size_t done = 0;
    const std::size_t total = request.ranges_m.size() * aspects.size();
    for (const double range_m : request.ranges_m) {
        AtRange here;
        std::string refusal;
        for (std::size_t i = 0; i < aspects.size() && !control.stop.stop_requested(); ++i) {
            const std::size_t number = i / drawn.size();
            const std::string place =
                fmt::format("{}, {} m", shared.plan.place(shared.plan.cases[number]),
                            irsg::roundedText(range_m));
            if (control.progress)
                control.progress({done, total, elapsed_s(), "detection: " + place});
            warnings.beginCase(place);
            TargetLook look;
            look.nei_W_m2 = 1.0; // of no signal the ratio is 0
            try {
                look = aspects[i]->at(range_m, false);
            } catch (const irsg::InputError& error) {
                refusal = error.what();
            }
            if (i % drawn.size() == 0)
                here.probabilities.emplace_back();
            here.probabilities.back().push_back(sight.probability(look));
            here.reached += sight.reached(look) / static_cast<double>(aspects.size());
            ++done;
        }
        if (control.stop.stop_requested())
            break;
        table.addRow(here.row(range_m, request.draws > 0),
                     refusal.empty() ? "" : "nothing is seen from some aspects: " + refusal);
    }
    irsg::appendUnique(data.warnings, warnings.sentences());
    if (table.rowCount() < request.ranges_m.size())
        data.warnings.push_back(fmt::format("stopped after {} of {} ranges", table.rowCount(),
                                            request.ranges_m.size()));
    data.state = table.rowCount() == request.ranges_m.size() ? AnalysisState::complete
                                                             : AnalysisState::partial;
    data.elapsed_s = elapsed_s();
    tellDetection(data, shared, request, sight);
    table.provenance.add("detection.aspects", std::to_string(shared.plan.cases.size()));
    if (request.draws > 0)
        table.provenance.add("detection.draws", std::to_string(request.draws));
    if (!clutters_K.empty())
        data.summary.push_back({"Clutter of the background, mean", meanOf(clutters_K), "K"});
}

} // namespace smat
