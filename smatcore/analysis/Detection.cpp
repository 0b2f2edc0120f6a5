#include "smatcore/analysis/Detection.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Quantity.h"
#include "irsg/core/Wording.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/CaseWarnings.h"
#include "smatcore/analysis/CommandSettings.h"
#include "smatcore/analysis/DetectionProbability.h"
#include "smatcore/analysis/DetectionProvenance.h"
#include "smatcore/analysis/RangeSensitivity.h"
#include "smatcore/analysis/SampleStatistics.h"
#include "smatcore/analysis/TargetAspect.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/ShellText.h"

namespace smat {

namespace {

using Found = irsg::DetectionRange::Found;

const std::string sensitivityPrefix = "sensitivity_";

void addColumns(ResultTable& table, const AnalysisPlan& plan, const DetectionRequest& request) {
    for (const irsg::Quantity quantity : plan.columns)
        table.add(quantity);
    table.add("detection_range", "m");
    table.add("error_detection_range", "m");
    table.add("outcome", "");
    table.add("crossings", "");
    table.add("snr", "");
    table.add("contrast_irradiance", "W m-2");
    table.add(irsg::Quantity::contrastIntensity);
    table.add("nei", "W m-2");
    table.add("extent", "px");
    if (request.criterion != RangeCriterion::point) {
        table.add("temperature_difference", "K");
        table.add("cycles", "");
    }
    if (request.criterion != RangeCriterion::point || request.pointProbability)
        table.add("probability", "");
    if (!request.leftOut.empty())
        table.add("left_out", "");
    if (request.measuresClutter)
        table.add("clutter", "K");
    if (request.findsSensitivity)
        for (const SensitivityName& number : sensitivityNames(request))
            table.add(sensitivityPrefix + number.key, "");
}

/// What an aspect warns of, "" for nothing.
std::string warningOf(const std::vector<std::pair<bool, const char*>>& all) {
    std::string text;
    for (const auto& [isSo, words] : all)
        if (isSo)
            text += (text.empty() ? "" : "; ") + std::string(words);
    return text;
}

double outcomeOf(Found found) {
    return found == Found::atRange ? 0.0 : found == Found::beyond ? 1.0 : -1.0;
}

void summariseRanges(AnalysisData& data) {
    const ResultColumn* ranges = data.table.find("detection_range");
    if (ranges == nullptr || ranges->values.empty())
        return;
    const auto& angles = data.table.columns().front();
    const auto [least, most] = std::ranges::minmax_element(ranges->values);
    const auto where = [&](auto it) {
        return fmt::format(" at {:.6g} {}",
                           angles.values[static_cast<std::size_t>(it - ranges->values.begin())],
                           angles.unit);
    };
    data.summary.push_back({"Longest detection range" + where(most), *most, "m"});
    data.summary.push_back({"Shortest detection range" + where(least), *least, "m"});
}

/// Of the values that are numbers; NaN of none.
double meanOfNumbers(const ResultColumn& column) {
    std::vector<double> values = column.values;
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : meanOf(values);
}

/// The means over the aspects, the largest first.
void summariseSensitivities(AnalysisData& data, const DetectionRequest& request) {
    std::vector<SummaryItem> items;
    for (const SensitivityName& number : sensitivityNames(request))
        if (const double mean = meanOfNumbers(*data.table.find(sensitivityPrefix + number.key));
            std::isfinite(mean))
            items.push_back({"Sensitivity of the range to: " + number.title, mean, ""});
    std::ranges::stable_sort(items, std::greater<>(),
                             [](const SummaryItem& item) { return std::abs(item.value); });
    data.summary.insert(data.summary.end(), items.begin(), items.end());
}

} // namespace

std::string detectionCommand(const Project& project, const Settings& settings,
                             const DetectionRequest& request, const std::string& outputFile) {
    const DetectionRequest usual;
    std::string command =
        "smat-batch detection " +
        shellQuoted(project.file.empty() ? "PROJECT.smat" : project.file.string()) + " --sensor " +
        shellQuoted(request.sensorFile.string());
    const auto number = [&](const char* option, double value, double otherwise) {
        if (value != otherwise)
            command += fmt::format(" {} {}", option, irsg::numberText(value));
    };
    if (request.criterion != RangeCriterion::point) {
        command += " --criterion " + criterionWords()[static_cast<std::size_t>(request.criterion)];
        const auto& tasks = tasksOf(request.criterion);
        const auto task =
            std::ranges::find(tasks, request.task.cyclesOfHalf, &irsg::JohnsonTask::cyclesOfHalf);
        command += task != tasks.end()
                       ? fmt::format(" --task {}", task->name)
                       : fmt::format(" --cycles {}", irsg::numberText(request.task.cyclesOfHalf));
        number("--probability", 100.0 * request.task.probability, 50.0);
        for (const std::string& name : request.leftOut)
            command += " --leave-out " + shellQuoted(name);
        if (request.criterion == RangeCriterion::targeting) {
            const irsg::SensorDisplay &display = request.display, &plain = usual.display;
            number("--scene-contrast", display.sceneContrast_K, plain.sceneContrast_K);
            number("--display-pixel", display.pixel_mrad, plain.pixel_mrad);
            number("--display-luminance", display.luminance_cd_m2, plain.luminance_cd_m2);
        }
    } else {
        number("--snr", request.threshold, usual.threshold);
        if (request.pointProbability)
            number("--probability", 100.0 * *request.pointProbability, 0.0);
        number("--clutter", request.clutter_K, 0.0);
        if (request.measuresClutter)
            command += " --clutter auto";
        if (request.place != usual.place)
            command += " --point " + pointPlaceWords()[static_cast<std::size_t>(request.place)];
    }
    if (request.findsSensitivity)
        command += " --sensitivity";
    for (std::size_t i = 0; i < request.ranges_m.size(); ++i)
        command += (i == 0 ? " --ranges " : ",") + irsg::numberText(request.ranges_m[i]);
    number("--draws", static_cast<double>(request.draws), 0.0);
    number("--nearest", request.limits.nearest_m, usual.limits.nearest_m);
    number("--farthest", request.limits.farthest_m, usual.limits.farthest_m);
    number("--looks", request.limits.looksPerDecade, usual.limits.looksPerDecade);
    if (request.background_K)
        number("--background-temperature", *request.background_K, 0.0);
    return command + settingOptions(project, settings, project.settings, AnalysisKind::polar) +
           " --out " + shellQuoted(outputFile);
}

void runDetection(AnalysisData& data, const DetectionRequest& request, const RenderDoor& door,
                  const SceneFactory& scenes, const RunControl& control) {
    if (!request.ranges_m.empty())
        return runDetectionProbability(data, request, door, scenes, control);
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed_s = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const DetectionScene shared(data, request, door, scenes);
    const AnalysisPlan& plan = shared.plan;
    TargetSight seeing(request);
    const double wanted = seeing.wanted();
    const bool isOfCycles = seeing.isOfCycles();
    addColumns(data.table, plan, request);
    std::optional<RangeSensitivity> sensitivity;
    if (request.findsSensitivity)
        sensitivity.emplace(shared, request);
    CaseWarnings warnings;
    std::size_t done = 0, resolved = 0, never = 0, beyond = 0, full = 0;
    if (control.isRehearsal)
        return shared.check(request.limits.nearest_m);
    // Paths into the ground, say.
    double leastRefused_m = std::numeric_limits<double>::infinity();
    std::string refusal;
    for (const AnalysisCase& one : plan.cases) {
        if (control.stop.stop_requested())
            break;
        const std::string place = plan.place(one);
        if (control.progress)
            control.progress({done, plan.cases.size(), elapsed_s(), "detection: " + place});
        warnings.beginCase(place);
        TargetAspect aspect(shared, shared.scene, seeing, one, data, warnings);
        const double clutter_K =
            request.measuresClutter ? aspect.measureClutter(request.sensor) : 0.0;
        (void)aspect.at(request.limits.nearest_m, false); // refuses what no range would change
        const auto ratio = [&](double range_m) {
            try {
                return seeing.reached(aspect.at(range_m, false));
            } catch (const irsg::InputError& error) {
                if (range_m < leastRefused_m) {
                    leastRefused_m = range_m;
                    refusal = error.what();
                }
                return 0.0;
            }
        };
        const irsg::DetectionRange found = irsg::detectionRange(ratio, wanted, request.limits);
        const TargetLook look = aspect.between(found);
        double error_m = 0.0;
        if (found.found == Found::atRange) {
            error_m = request.limits.tolerance * found.range_m;
            if (found.slope != 0.0 && look.counted_W_m2 != 0.0)
                error_m = std::hypot(error_m, look.error_W_m2 / std::abs(look.counted_W_m2) *
                                                  found.range_m / std::abs(found.slope));
        }
        const double extent =
            std::sqrt(std::max(0.0, look.solidAngle_sr)) / request.sensor.pixelAngle_rad();
        const bool isResolved = !isOfCycles && found.found != Found::nowhere && extent > 1.0;
        never += found.found == Found::nowhere;
        beyond += found.found == Found::beyond;
        full += look.isFull;
        resolved += isResolved;
        const std::string warning =
            warningOf({{found.found == Found::nowhere, "below the threshold at every range"},
                       {found.found == Found::beyond, "above the threshold at the farthest range"},
                       {isResolved, "an image larger than a pixel: the range is overstated"},
                       {look.isFull, "a background that fills the pixels"}});
        std::vector<double> row;
        for (const irsg::Quantity quantity : plan.columns)
            row.push_back(one.value(quantity));
        row.insert(row.end(), {found.range_m, error_m, outcomeOf(found.found),
                               static_cast<double>(found.crossings), look.snr(), look.contrast_W_m2,
                               look.contrast_W_sr, look.nei_W_m2, extent});
        if (isOfCycles)
            row.insert(row.end(), {look.difference_K, look.cycles});
        if (isOfCycles || request.pointProbability)
            row.push_back(seeing.probability(look));
        if (!shared.leftOut.empty())
            row.push_back(look.contrast_W_m2 == 0.0 ? 0.0
                                                    : 1.0 - look.counted_W_m2 / look.contrast_W_m2);
        if (request.measuresClutter)
            row.push_back(clutter_K);
        if (sensitivity)
            std::ranges::copy(sensitivity->at(found, look, aspect, one, data, warnings),
                              std::back_inserter(row));
        data.table.addRow(row, warning);
        ++done;
    }
    irsg::appendUnique(data.warnings, warnings.sentences());
    const auto tell = [&](std::size_t count, const char* what) {
        if (count > 0)
            data.warnings.push_back(fmt::format("{} of {} aspects {}", count, done, what));
    };
    tell(never, "are below the threshold at every range: their range is 0");
    tell(beyond, "are above the threshold at the farthest range, which is given for them");
    tell(resolved, "have an image larger than a pixel at that range: the ratio of a point, which "
                   "collects the whole target in one pixel, overstates it");
    tell(full, "have a background that fills the pixels: their noise is that of a larger well");
    if (!refusal.empty())
        data.warnings.push_back(fmt::format("nothing is seen over {} m or more: {}",
                                            irsg::roundedText(leastRefused_m, 3), refusal));
    if (done < plan.cases.size())
        data.warnings.push_back(
            fmt::format("stopped after {} of {} cases", done, plan.cases.size()));
    data.state = done == plan.cases.size() ? AnalysisState::complete : AnalysisState::partial;
    data.elapsed_s = elapsed_s();
    tellDetection(data, shared, request, seeing);
    summariseRanges(data);
    if (request.measuresClutter)
        data.summary.push_back(
            {"Clutter of the background, mean", meanOfNumbers(*data.table.find("clutter")), "K"});
    if (request.findsSensitivity)
        summariseSensitivities(data, request);
}

} // namespace smat
