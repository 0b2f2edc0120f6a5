#include "smatcore/analysis/Detection.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Quantity.h"
#include "irsg/core/Wording.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/CommandSettings.h"
#include "smatcore/analysis/DetectionAspects.h"
#include "smatcore/analysis/DetectionCheck.h"
#include "smatcore/analysis/DetectionComparison.h"
#include "smatcore/analysis/DetectionProbability.h"
#include "smatcore/analysis/DetectionProvenance.h"
#include "smatcore/analysis/RangeSensitivity.h"
#include "smatcore/analysis/SampleStatistics.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/ShellText.h"

namespace smat {

namespace {

const std::string sensitivityPrefix = "sensitivity_";

void addColumns(ResultTable& table, const DetectionScene& shared, const DetectionRequest& request) {
    const AnalysisPlan& plan = shared.plan;
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
    if (request.measuresClutter) {
        table.add("clutter", "K");
        table.add("error_clutter", "K");
    }
    if (request.findsSensitivity)
        for (const SensitivityName& number : sensitivityNames(request, shared.scene))
            table.add(sensitivityPrefix + number.key, "");
}

void summariseRanges(AnalysisData& data) {
    const ResultColumn* ranges = data.table.find("detection_range");
    if (ranges == nullptr || ranges->values.empty())
        return;
    const auto& columns = data.table.columns();
    const auto [least, most] = std::ranges::minmax_element(ranges->values);
    const auto where = [&](auto it) {
        const auto row = static_cast<std::size_t>(it - ranges->values.begin());
        std::string place = fmt::format(" at {:.6g} {}", columns[0].values[row], columns[0].unit);
        if (data.table.columns()[0].key == irsg::info(irsg::Quantity::azimuth).key)
            place += fmt::format(", elevation {:.6g} deg", columns[1].values[row]);
        return place;
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
void summariseSensitivities(AnalysisData& data, const std::vector<SensitivityName>& names) {
    std::vector<SummaryItem> items;
    for (const SensitivityName& number : names)
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
    if (request.cases != RangeCases::aspects)
        command += " --cases " + rangeCasesWords()[static_cast<std::size_t>(request.cases)];
    if (request.comparison)
        command += comparisonOptions(*request.comparison);
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
    Settings own = settings;
    for (const std::string& key : idleSettings(request))
        if (project.settings.isSet(key))
            own.set(key, project.settings.text(key));
        else
            own.reset(key);
    return command +
           settingOptions(project, own, project.settings, kindOf(request.cases),
                          request.cases != RangeCases::aspects) +
           " --out " + shellQuoted(outputFile);
}

void runDetection(AnalysisData& data, const DetectionRequest& request, const RenderDoor& door,
                  const SceneFactory& scenes, const RunControl& control) {
    if (!request.ranges_m.empty())
        return runDetectionProbability(data, request, door, scenes, control);
    if (request.comparison)
        return runDetectionComparison(data, request, door, scenes, control);
    DetectionProgress progress(control);
    DetectionAspects aspects(data, request, door, scenes);
    const DetectionScene& shared = aspects.shared();
    const AnalysisPlan& plan = shared.plan;
    TargetSight& sight = aspects.sight();
    RangeSearch search(request, sight);
    addColumns(data.table, shared, request);
    std::optional<RangeSensitivity> sensitivity;
    if (request.findsSensitivity)
        sensitivity.emplace(shared, request);
    if (control.isRehearsal)
        return shared.check(request.limits.nearest_m);
    progress.total = plan.cases.size();
    std::vector<std::vector<double>> rows;
    std::vector<std::string> rowWarnings;
    std::vector<FoundRange> found;
    aspects.each({shared.scene}, progress, [&](const DetectionAspects::Case& one) {
        const AspectRange seen = search.find(one.aspect);
        const TargetLook& look = seen.look;
        std::vector<double> row;
        for (const irsg::Quantity quantity : plan.columns)
            row.push_back(one.place.value(quantity));
        row.insert(row.end(), {seen.found.range_m, seen.error_m, seen.outcome(),
                               static_cast<double>(seen.found.crossings), look.snr(),
                               look.contrast_W_m2, look.contrast_W_sr, look.nei_W_m2, seen.extent});
        if (sight.isOfCycles())
            row.insert(row.end(), {look.difference_K, look.cycles});
        if (sight.isOfCycles() || request.pointProbability)
            row.push_back(sight.probability(look));
        if (!shared.leftOut.empty())
            row.push_back(look.contrast_W_m2 == 0.0 ? 0.0
                                                    : 1.0 - look.counted_W_m2 / look.contrast_W_m2);
        if (request.measuresClutter)
            row.insert(row.end(), {one.clutter.deviation_K, one.clutter.error_K});
        if (sensitivity) {
            found.push_back({one.place, seen.found, look, seen.sampledFrom_m});
            std::ranges::copy(sensitivity->at(found.back(), one.aspect, data, aspects.warnings()),
                              std::back_inserter(row));
        }
        rows.push_back(std::move(row));
        rowWarnings.push_back(seen.warning());
    });
    if (sensitivity) {
        const auto ofAir = sensitivity->ofAir(found, data, aspects.warnings());
        for (std::size_t i = 0; i < rows.size(); ++i)
            std::ranges::copy(ofAir[i], std::back_inserter(rows[i]));
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        data.table.addRow(rows[i], rowWarnings[i]);
    aspects.tellWarnings();
    search.tell(data.warnings);
    const bool isComplete = progress.done == plan.cases.size();
    if (!isComplete)
        data.warnings.push_back(
            fmt::format("stopped after {} of {} cases", progress.done, plan.cases.size()));
    data.state = isComplete ? AnalysisState::complete : AnalysisState::partial;
    data.elapsed_s = progress.elapsed_s();
    tellDetection(data, shared, request, sight);
    summariseRanges(data);
    if (request.measuresClutter)
        data.summary.push_back(
            {"Clutter of the background, mean", meanOfNumbers(*data.table.find("clutter")), "K"});
    if (request.findsSensitivity)
        summariseSensitivities(data, sensitivityNames(request, shared.scene));
}

} // namespace smat
