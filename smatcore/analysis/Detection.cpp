#include "smatcore/analysis/Detection.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "irsg/atmosphere/EnvironmentVariants.h"
#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Quantity.h"
#include "irsg/core/Wording.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/sensor/PointSpread.h"
#include "irsg/sensor/SensorNumbers.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisProvenance.h"
#include "smatcore/analysis/CaseWarnings.h"
#include "smatcore/analysis/CommandSettings.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/ShellText.h"

namespace smat {

namespace {

using Found = irsg::DetectionRange::Found;

double ensquaredEnergy(const irsg::SensorDescription& sensor, PointPlace place, double source_K) {
    const irsg::PointSpread spread(sensor, source_K);
    if (place == PointPlace::centre)
        return spread.energyAt(0.0, 0.0);
    if (place == PointPlace::corner)
        return spread.energyAt(0.5, 0.5);
    const irsg::GaussRule& rule = irsg::gaussLegendre(6);
    double mean = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        for (std::size_t j = 0; j < rule.nodes.size(); ++j)
            mean += rule.weights[i] * rule.weights[j] *
                    spread.energyAt(0.5 * rule.nodes[i], 0.5 * rule.nodes[j]);
    return mean;
}

/// What is known of a case at a range.
struct Look {
    double contrast_W_m2 = 0.0, contrast_W_sr = 0.0, error_W_m2 = 0.0, solidAngle_sr = 0.0;
    double nei_W_m2 = 0.0;
    double difference_K = 0.0, cycles = 0.0; ///< of bars
    bool isFull = false;                     ///< the pixel, of the background alone
    double snr() const { return std::abs(contrast_W_m2) / nei_W_m2; }
};

/// What the sensor makes of a background and of a target before it.
class Seeing {
  public:
    explicit Seeing(const DetectionRequest& request)
        : request_(request),
          response_(request.sensor),
          energy_(ensquaredEnergy(request.sensor, request.place, usual_K())) {
        if (request.criterion == RangeCriterion::bars)
            resolvable_.emplace(request.sensor, usual_K(), request.observer);
    }

    double energy() const { return energy_; }

    /// Sets what follows from contrast, solid angle and the background's radiance.
    void see(Look& look, double background_W_m2_sr) {
        const Background& behind = background(background_W_m2_sr);
        look.isFull = behind.isFull;
        look.nei_W_m2 = behind.noise.total() / (response_.signalPerIrradiance() * energy_);
        if (!resolvable_ || look.solidAngle_sr <= 0.0)
            return;
        look.difference_K = std::abs(look.contrast_W_m2) / look.solidAngle_sr *
                            response_.signalPerRadiance() / behind.contrast_per_K;
        look.cycles = resolvable_->frequency_per_rad(look.difference_K, behind.perceived_K) *
                      std::sqrt(look.solidAngle_sr);
    }

    double wanted() const {
        return resolvable_ ? irsg::taskCycles(request_.task.probability, request_.task.cyclesOfHalf)
                           : request_.threshold;
    }
    double reached(const Look& look) const { return resolvable_ ? look.cycles : look.snr(); }

  private:
    struct Background {
        irsg::PixelNoise noise;
        bool isFull = false;
        double contrast_per_K = 0.0, perceived_K = 0.0; ///< of bars
    };

    /// Of which the optics' spectrum is.
    double usual_K() const { return request_.background_K.value_or(300.0); }

    const Background& background(double radiance_W_m2_sr) {
        const double key = request_.background_K.value_or(radiance_W_m2_sr);
        const auto [known, isNew] = known_.try_emplace(key);
        if (isNew)
            known->second = made(radiance_W_m2_sr);
        return known->second;
    }

    Background made(double radiance_W_m2_sr) const {
        Background made;
        irsg::PixelSignal signal = response_.offset();
        signal.scene = request_.background_K ? response_.signal(*request_.background_K).scene
                                             : radiance_W_m2_sr * response_.signalPerRadiance();
        made.isFull = signal.total() >= response_.fullSignal();
        made.noise = response_.noise(signal);
        if (!resolvable_)
            return made;
        const std::optional<double> background_K =
            request_.background_K
                ? request_.background_K
                : irsg::apparentTemperature_K(request_.sensor.band(), radiance_W_m2_sr);
        if (!background_K || *background_K < leastBackground_K)
            throw irsg::InputError(
                {"", "background of the scene",
                 irsg::numberText(background_K.value_or(0.0)) + " K in the sensor's band",
                 "at least " + irsg::numberText(leastBackground_K) +
                     " K, before which bars have a temperature difference, or a background "
                     "temperature that is given"});
        made.contrast_per_K = response_.contrast_per_K(*background_K);
        made.perceived_K = irsg::perceivedNoise_K(request_.sensor, made.noise, made.contrast_per_K,
                                                  request_.observer);
        return made;
    }

    static constexpr double leastBackground_K = 50.0;

    const DetectionRequest& request_;
    irsg::PixelResponse response_;
    double energy_;
    std::optional<irsg::ResolvableTemperature> resolvable_;
    std::map<double, Background> known_; ///< by its temperature, or radiance
};

/// One aspect at any range.
class Aspect {
  public:
    Aspect(Seeing& seeing, const CasePlacer& placer, const SceneDescription& scene,
           const RenderDoor& door, AnalysisCase one, AnalysisData& data, CaseWarnings& warnings)
        : seeing_(seeing),
          placer_(placer),
          scene_(scene),
          door_(door),
          case_(std::move(one)),
          data_(data),
          warnings_(warnings) {}

    Look at(double range_m, bool withErrors) {
        const auto key = std::pair(range_m, withErrors);
        if (const auto known = known_.find(key); known != known_.end())
            return known->second;
        case_.range_m = range_m;
        const PlacedCase placed = placer_.place(scene_, case_);
        const irsg::Outputs outputs = irsg::Outputs::reports().alongRange().withErrors(withErrors);
        const irsg::RenderReport report = placed.render(door_, outputs).reports.front();
        irsg::addProvider(data_.providedBy, report.providedBy);
        warnings_.addReport(report, data_.settings[key::renderLayers]);
        Look look;
        look.contrast_W_m2 = report.all.irradiance_W_m2;
        look.contrast_W_sr = report.all.contrastIntensity_W_sr;
        look.solidAngle_sr = report.all.solidAngle_sr;
        for (const irsg::ObjectRadiometry& object : report.objects)
            if (report.all.solidAngle_sr == 0.0)
                look.solidAngle_sr += object.solidAngle_sr;
        if (report.all.errors)
            look.error_W_m2 = report.all.errors->irradiance_W_m2.sum();
        seeing_.see(look, report.background_W_m2_sr);
        return known_[key] = look;
    }

    /// At the range that was found, interpolated on the grid; the relative error is that of the
    /// nearest range there.
    Look between(const irsg::DetectionRange& found) {
        std::vector<Look> looks;
        for (const auto& node : found.around)
            looks.push_back(at(node.range_m, false));
        // By logarithms, which bend little, where there are some.
        const auto mean = [&](double Look::*member) {
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
        Look look;
        for (double Look::*const member :
             {&Look::contrast_W_m2, &Look::contrast_W_sr, &Look::solidAngle_sr, &Look::nei_W_m2,
              &Look::difference_K, &Look::cycles})
            look.*member = mean(member);
        look.isFull = std::ranges::any_of(looks, &Look::isFull);
        const auto nearest =
            std::ranges::max_element(found.around, {}, &irsg::DetectionRange::Node::weight);
        const Look known = at(nearest->range_m, true);
        if (known.contrast_W_m2 != 0.0)
            look.error_W_m2 = known.error_W_m2 * std::abs(look.contrast_W_m2 / known.contrast_W_m2);
        return look;
    }

  private:
    Seeing& seeing_;
    const CasePlacer& placer_;
    const SceneDescription& scene_;
    const RenderDoor& door_;
    AnalysisCase case_;
    AnalysisData& data_;
    CaseWarnings& warnings_;
    std::map<std::pair<double, bool>, Look> known_;
};

void addColumns(ResultTable& table, const AnalysisPlan& plan, RangeCriterion criterion) {
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
    if (criterion == RangeCriterion::bars) {
        table.add("temperature_difference", "K");
        table.add("cycles", "");
        table.add("probability", "");
    }
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
    static const std::vector<std::string> words = {"point", "johnson"};
    return words;
}

std::vector<std::string> johnsonTaskWords() {
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
    if (request.criterion == RangeCriterion::bars) {
        command += " --criterion johnson";
        const auto& tasks = irsg::johnsonTasks();
        const auto task =
            std::ranges::find(tasks, request.task.cyclesOfHalf, &irsg::JohnsonTask::cyclesOfHalf);
        command += task != tasks.end()
                       ? fmt::format(" --task {}", task->name)
                       : fmt::format(" --cycles {}", irsg::numberText(request.task.cyclesOfHalf));
        number("--probability", 100.0 * request.task.probability, 50.0);
    } else {
        number("--snr", request.threshold, usual.threshold);
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

    Seeing seeing(request);
    const double wanted = seeing.wanted();
    const bool isOfBars = request.criterion == RangeCriterion::bars;
    addColumns(data.table, plan, request.criterion);
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
        Aspect aspect(seeing, placer, scene, door, one, data, warnings);
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
        const Look look = aspect.between(found);
        double error_m = 0.0;
        if (found.found == Found::atRange) {
            error_m = request.limits.tolerance * found.range_m;
            if (found.slope != 0.0 && look.contrast_W_m2 != 0.0)
                error_m = std::hypot(error_m, look.error_W_m2 / std::abs(look.contrast_W_m2) *
                                                  found.range_m / std::abs(found.slope));
        }
        const double extent =
            std::sqrt(std::max(0.0, look.solidAngle_sr)) / request.sensor.pixelAngle_rad();
        const bool isResolved = !isOfBars && found.found != Found::nowhere && extent > 1.0;
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
        if (isOfBars)
            row.insert(row.end(), {look.difference_K, look.cycles,
                                   irsg::taskProbability(look.cycles, request.task.cyclesOfHalf)});
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
    if (isOfBars) {
        provenance.add("detection.cyclesOfHalf", irsg::numberText(request.task.cyclesOfHalf));
        provenance.add("detection.probability", irsg::numberText(request.task.probability));
        provenance.add("detection.cycles", irsg::numberText(wanted));
        provenance.add("detection.observer",
                       fmt::format("threshold {}, {} s, {} Hz", request.observer.threshold,
                                   request.observer.integration_s,
                                   request.sensor.electronics.frameRate_Hz));
    } else {
        provenance.add("detection.snr", irsg::numberText(request.threshold));
        provenance.add("detection.ensquaredEnergy", irsg::numberText(seeing.energy()));
    }
    provenance.add("detection.background", request.background_K
                                               ? irsg::numberText(*request.background_K) + " K"
                                               : "of the scene");
    summariseRanges(data);
}

} // namespace smat
