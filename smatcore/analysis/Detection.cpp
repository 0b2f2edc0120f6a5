#include "smatcore/analysis/Detection.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "irsg/atmosphere/EnvironmentVariants.h"
#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Quantity.h"
#include "irsg/core/Wording.h"
#include "irsg/sensor/NormalQuantile.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisProvenance.h"
#include "smatcore/analysis/CaseWarnings.h"
#include "smatcore/analysis/CommandSettings.h"
#include "smatcore/analysis/PartColumns.h"
#include "smatcore/analysis/TargetSight.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/ShellText.h"

namespace smat {

namespace {

using Found = irsg::DetectionRange::Found;

/// The surfaces of an object that do not count.
struct LeftOut {
    std::set<int> temperatures, materials;

    bool has(const irsg::SurfaceRadiometry& surface) const {
        return temperatures.contains(surface.temperature) || materials.contains(surface.material);
    }
};

/// By entity; none where nothing is left out. Throws InputError for names that no entry has.
std::vector<LeftOut> leftOutOf(const SceneDescription& scene,
                               const std::vector<std::string>& names) {
    if (names.empty())
        return {};
    std::vector<LeftOut> out(scene.entities.size());
    std::vector<std::string> known;
    std::set<std::string> met;
    const auto take = [&](const irsg::Entity& entity, PartsBy by, std::set<int>& indices) {
        for (const ObjectPart& part : partsOf(entity, by)) {
            irsg::appendUnique(known, {part.label});
            if (std::ranges::find(names, part.label) == names.end())
                continue;
            indices.insert(part.index);
            met.insert(part.label);
        }
    };
    for (std::size_t i = 0; i < out.size(); ++i) {
        take(scene.entities[i], PartsBy::temperature, out[i].temperatures);
        take(scene.entities[i], PartsBy::material, out[i].materials);
    }
    std::vector<irsg::Diagnostic> diagnostics;
    for (const std::string& name : names)
        if (!met.contains(name))
            diagnostics.push_back(
                {"", "surfaces that are left out", name, irsg::alternatives(known)});
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return out;
}

/// One aspect at any range.
class Aspect {
  public:
    Aspect(TargetSight& seeing, const CasePlacer& placer, const SceneDescription& scene,
           const RenderDoor& door, AnalysisCase one, const std::vector<LeftOut>& leftOut,
           AnalysisData& data, CaseWarnings& warnings)
        : seeing_(seeing),
          placer_(placer),
          scene_(scene),
          door_(door),
          case_(std::move(one)),
          leftOut_(leftOut),
          data_(data),
          warnings_(warnings) {}

    TargetLook at(double range_m, bool withErrors) {
        const auto key = std::pair(range_m, withErrors);
        if (const auto known = known_.find(key); known != known_.end())
            return known->second;
        case_.range_m = range_m;
        const PlacedCase placed = placer_.place(scene_, case_);
        const irsg::Outputs outputs = irsg::Outputs::reports()
                                          .alongRange()
                                          .withErrors(withErrors)
                                          .bySurface(!leftOut_.empty());
        const irsg::RenderReport report = placed.render(door_, outputs).reports.front();
        irsg::addProvider(data_.providedBy, report.providedBy);
        warnings_.addReport(report, data_.settings[key::renderLayers]);
        TargetLook look;
        look.contrast_W_m2 = report.all.irradiance_W_m2;
        look.contrast_W_sr = report.all.contrastIntensity_W_sr;
        look.solidAngle_sr = report.all.solidAngle_sr;
        for (const irsg::ObjectRadiometry& object : report.objects)
            if (report.all.solidAngle_sr == 0.0)
                look.solidAngle_sr += object.solidAngle_sr;
        look.counted_W_m2 = look.contrast_W_m2;
        for (std::size_t i = 0; i < leftOut_.size(); ++i)
            for (const irsg::SurfaceRadiometry& surface : report.objects.at(i).surfaces)
                if (leftOut_[i].has(surface)) {
                    look.counted_W_m2 -= surface.irradiance_W_m2;
                    look.solidAngle_sr -= surface.solidAngle_sr;
                }
        if (report.all.errors)
            look.error_W_m2 = report.all.errors->irradiance_W_m2.sum();
        seeing_.see(look, report.background_W_m2_sr);
        return known_[key] = look;
    }

    /// At the range that was found, interpolated on the grid; the relative error is that of the
    /// nearest range there.
    TargetLook between(const irsg::DetectionRange& found) {
        std::vector<TargetLook> looks;
        for (const auto& node : found.around)
            looks.push_back(at(node.range_m, false));
        // By logarithms, which bend little, where there are some.
        const auto mean = [&](double TargetLook::*member) {
            double sum = 0.0, logarithms = 0.0;
            bool isOfOneSign = true;
            for (std::size_t i = 0; i < looks.size(); ++i) {
                const double value = looks[i].*member, weight = found.around[i].weight;
                sum += weight * value;
                isOfOneSign = isOfOneSign && value * looks.front().*member > 0.0;
                if (isOfOneSign)
                    logarithms += weight * std::log(std::abs(value));
            }
            return isOfOneSign ? std::copysign(std::exp(logarithms), looks.front().*member) : sum;
        };
        TargetLook look;
        for (double TargetLook::*const member :
             {&TargetLook::contrast_W_m2, &TargetLook::contrast_W_sr, &TargetLook::counted_W_m2,
              &TargetLook::solidAngle_sr, &TargetLook::nei_W_m2, &TargetLook::difference_K,
              &TargetLook::cycles})
            look.*member = mean(member);
        look.isFull = std::ranges::any_of(looks, &TargetLook::isFull);
        const auto nearest =
            std::ranges::max_element(found.around, {}, &irsg::DetectionRange::Node::weight);
        const TargetLook known = at(nearest->range_m, true);
        if (known.contrast_W_m2 != 0.0)
            look.error_W_m2 = known.error_W_m2 * std::abs(look.contrast_W_m2 / known.contrast_W_m2);
        return look;
    }

  private:
    TargetSight& seeing_;
    const CasePlacer& placer_;
    const SceneDescription& scene_;
    const RenderDoor& door_;
    AnalysisCase case_;
    const std::vector<LeftOut>& leftOut_;
    AnalysisData& data_;
    CaseWarnings& warnings_;
    std::map<std::pair<double, bool>, TargetLook> known_;
};

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

} // namespace

AnalysisKind detectionKind() {
    return resultKindFromName("detection");
}

const std::vector<std::string>& pointPlaceWords() {
    static const std::vector<std::string> words = {"centre", "mean", "corner"};
    return words;
}

const std::vector<std::string>& criterionWords() {
    static const std::vector<std::string> words = {"point", "johnson", "ttp"};
    return words;
}

const std::vector<irsg::JohnsonTask>& tasksOf(RangeCriterion criterion) {
    return criterion == RangeCriterion::targeting ? irsg::targetingTasks() : irsg::johnsonTasks();
}

const irsg::TaskLaw& lawOf(RangeCriterion criterion) {
    return criterion == RangeCriterion::targeting ? irsg::targetingLaw : irsg::johnsonLaw;
}

double thresholdOfFalseAlarms(double probability) {
    if (!(probability > 0.0 && probability < 0.5))
        throw irsg::InputError({"", "probability of a false alarm", irsg::numberText(probability),
                                "a number between 0 and 0.5, both exclusive"});
    return -irsg::normalQuantile(probability);
}

std::vector<std::string> rangeTaskWords() {
    std::vector<std::string> words;
    for (const irsg::JohnsonTask& task : irsg::johnsonTasks())
        words.emplace_back(task.name);
    return words;
}

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
        if (request.place != usual.place)
            command += " --point " + pointPlaceWords()[static_cast<std::size_t>(request.place)];
    }
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
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed_s = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    // What a polar plot says of where its cases are holds here, too.
    data.kind = AnalysisKind::polar;
    const Settings settings = withFixedSteps(data.kind, data.settings);
    AnalysisPlan plan = planAnalysis(data.kind, data.project, settings);
    SceneDescription scene = scenes(data.project, settings);
    scene.environment = irsg::onTheFly(scene.environment);
    // Contrast is of the whole target, whatever the sensor's frame is at its range.
    scene.sensor.band = request.sensor.band();
    scene.moreBands.clear();
    // Far away a target is smaller than a pixel, which other modes miss.
    if (!scene.settings.usesAlignedTiles()) {
        scene.settings.tileStrategy = irsg::TileStrategy::aligned;
        scene.settings.tileSide_samples = irsg::RenderSettings().tileSide_samples;
        data.warnings.push_back(
            fmt::format("the antialiasing of the settings misses targets below a pixel: ranges are "
                        "sought with tiles of {} samples",
                        scene.settings.tileSide_samples));
    }
    const CasePlacer placer(door, scene);
    for (const irsg::Entity& entity : scene.entities)
        data.databases.push_back(entity.database);
    data.renderer = door.description(scene);
    irsg::appendUnique(data.warnings, scene.remarks);

    const std::vector<LeftOut> leftOut = leftOutOf(scene, request.leftOut);
    TargetSight seeing(request);
    const double wanted = seeing.wanted();
    const bool isOfCycles = seeing.isOfCycles();
    addColumns(data.table, plan, request);
    CaseWarnings warnings;
    std::size_t done = 0, resolved = 0, never = 0, beyond = 0, full = 0;
    if (control.isRehearsal) {
        AnalysisCase first = plan.cases.front();
        first.range_m = request.limits.nearest_m;
        const PlacedCase placed = placer.place(scene, first);
        door.check(placed.scene, placed.view, irsg::Outputs::reports());
        return;
    }
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
        Aspect aspect(seeing, placer, scene, door, one, leftOut, data, warnings);
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
        if (!leftOut.empty())
            row.push_back(look.contrast_W_m2 == 0.0 ? 0.0
                                                    : 1.0 - look.counted_W_m2 / look.contrast_W_m2);
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
    writeProvenance(data, scene);
    data.kind = detectionKind();
    Provenance& provenance = data.table.provenance;
    // A polar plot of these settings has other numbers.
    for (auto& [key, value] : provenance.entries)
        if (key == "analysis")
            value = name(data.kind);
    provenance.add("detection.sensor", request.sensor.title);
    provenance.add("detection.criterion",
                   criterionWords()[static_cast<std::size_t>(request.criterion)]);
    if (isOfCycles) {
        provenance.add("detection.cyclesOfHalf", irsg::numberText(request.task.cyclesOfHalf));
        provenance.add("detection.probability", irsg::numberText(request.task.probability));
        provenance.add("detection.cycles", irsg::numberText(wanted));
        provenance.add("detection.observer",
                       fmt::format("threshold {}, {} s, {} Hz", request.observer.threshold,
                                   request.observer.integration_s,
                                   request.sensor.electronics.frameRate_Hz));
        for (const std::string& name : request.leftOut)
            provenance.add("detection.leftOut", name);
        if (request.criterion == RangeCriterion::targeting)
            provenance.add("detection.display",
                           fmt::format("{} mrad a pixel, {} cd m-2, {} K of scene contrast",
                                       request.display.pixel_mrad, request.display.luminance_cd_m2,
                                       request.display.sceneContrast_K));
    } else {
        provenance.add("detection.snr", irsg::numberText(request.threshold));
        provenance.add("detection.ensquaredEnergy", irsg::numberText(seeing.energy()));
        if (request.pointProbability) {
            provenance.add("detection.probability", irsg::numberText(*request.pointProbability));
            provenance.add("detection.snrOfProbability", irsg::numberText(wanted));
        }
        if (request.clutter_K > 0.0)
            provenance.add("detection.clutter", irsg::numberText(request.clutter_K) + " K");
    }
    provenance.add("detection.background", request.background_K
                                               ? irsg::numberText(*request.background_K) + " K"
                                               : "of the scene");
    summariseRanges(data);
}

} // namespace smat
