#include "smatcore/analysis/SweepTarget.h"

#include <fmt/format.h>

#include "irsg/core/Wording.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/CalculationChoice.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

std::optional<SweepTarget> SweepTarget::choose(const RenderDoor& door, const CasePlacer& placer,
                                               SceneDescription& scene, const AnalysisPlan& plan,
                                               const Settings& settings) {
    const std::optional<double> target_percent = settings[key::renderTargetError];
    if (!target_percent || plan.kind->form == AnalysisForm::spectrum)
        return std::nullopt;
    TargetUse use{plan.cases.size(), linesOfSight(plan), false, true};
    const std::string& mode = settings[key::sensorMode];
    if (mode == "auto") {
        if (plan.kind->form == AnalysisForm::sweep)
            use.usualMode = chooseCalculation(scene, plan).mode;
        use.mayTrain = use.usualMode == irsg::CalculationMode::wideband;
        scene.settings.mode = irsg::CalculationMode::spectral;
    }
    const std::vector<std::size_t> probed = probedCases(plan.cases.size());
    ProbedViews views(door, scene, probed.size(), plan.isAlongRange,
                      [&](const SceneDescription& inSomeWay, std::size_t i) {
                          return placer.place(inSomeWay, plan.cases[probed[i]]);
                      });
    SweepTarget made;
    made.target_ = 0.01 * *target_percent;
    made.choice_ = chooseForTarget(views, made.target_, use);
    scene = made.choice_.configuration.applied(scene);
    return made;
}

void SweepTarget::check(const std::vector<irsg::RenderReport>& reports,
                        CaseWarnings& warnings) const {
    const auto bands = static_cast<std::ptrdiff_t>(choice_.leastContrasts_W_sr.size());
    const double error =
        choice_.skipped +
        ProbedViews::stated({reports.begin(), reports.begin() + bands}, choice_.leastContrasts_W_sr)
            .sum;
    if (error > target_)
        warnings.addWorst("target error", error,
                          fmt::format("errors of up to {} %, where the target is {} %",
                                      irsg::roundedText(100.0 * error, 2),
                                      irsg::roundedText(100.0 * target_, 4)));
}

} // namespace smat
