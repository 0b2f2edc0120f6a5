#pragma once

#include <optional>
#include <string>
#include <vector>

#include "smatcore/analysis/CalculationConfigurations.h"

namespace smat {

/// How a scene is calculated so that its errors stay below a target, and why.
struct TargetChoice {
    CalculationConfiguration configuration;
    /// What was left out of the light, with the bound of each; as a part.
    double skipped = 0.0;
    /// Stated errors of the views that were looked at and what was left out; as a part.
    double reached = 0.0;
    bool isMet = false;
    std::vector<double> leastContrasts_W_sr; ///< by band, see ProbedViews::leastContrasts_W_sr
    std::vector<std::string> sentences;      ///< "target error 0.5 %: windows of ...", ...
};

/// What is known of the sweep that a choice is for; 1 and 1 of a single view.
struct TargetUse {
    std::size_t cases = 1;
    std::size_t linesOfSight = 1; ///< that differ in what the air answers
    /// Quadrature points of wideband-ck may be trained, in place of bins of the spectral mode.
    bool mayTrain = false;
    bool mayUseBins = true;
    /// What is set may stay where it meets the target; else the cheapest way is searched in any
    /// case.
    bool mayStay = true;
    /// How bands are integrated without a target, where that is not as the scene has it.
    std::optional<irsg::CalculationMode> usualMode = {};
};

/// The cheapest way whose stated errors are at most `target`, a part of intensity and contrast, in
/// every view that is probed: windows of 64 to 2048 samples, bins of 15, 5 or 1 cm-1 or
/// wideband-ck, one or more rows of background. Light that is at most a part of the target is left
/// out: sun, shadows, inter-reflection, that of sky and ground. Modes 0 to 2 of antialiasing
/// are not among them: what their samples miss is in no stated error.
///
/// What is set is looked at first. Where it meets the target and a cheaper way would save less than
/// the search for it takes, it is chosen.
///
/// Cheap is what a model of costs says, not a clock, so that equal inputs have equal results. Where
/// no way meets the target, the one with the least error is chosen and told so.
TargetChoice chooseForTarget(ProbedViews& views, double target, const TargetUse& use);

/// The views of `count` cases that are looked at: both ends and some between.
std::vector<std::size_t> probedCases(std::size_t count);

} // namespace smat
