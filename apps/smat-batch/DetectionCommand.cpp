#include <fmt/format.h>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/NumberOptions.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/ProjectInput.h"
#include "apps/smat-batch/RunControl.h"
#include "apps/smat-batch/SettingOptions.h"
#include "apps/smat-batch/StopSignal.h"
#include "irsg/core/CsvTable.h"
#include "irsg/sensor/SensorFile.h"
#include "smatcore/analysis/DetectionCheck.h"
#include "smatcore/jobs/AnalysisJobs.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::batch {

namespace {

/// `smat-batch detection PROJECT --sensor FILE --step 10 --snr 5 --out FILE`.
class DetectionCommand {
  public:
    explicit DetectionCommand(CLI::App& command)
        : command_(command),
          project_(command),
          settings_(command, AnalysisKind::polar),
          numbers_(command),
          files_(command) {
        command
            .add_option("--sensor", sensor_, "Sensor (.smatsensor) that is to detect the target")
            ->type_name("FILE");
        command
            .add_option("--criterion", criterion_,
                        "point: all light of the target falls into one pixel, judged by --snr; "
                        "johnson, ttp: cycles across its image, judged by --task and --probability")
            ->type_name("WORD")
            ->capture_default_str();
        numbers_.add("--snr", "",
                     "Signal to noise ratio at which a point is detected; 5 by default");
        command
            .add_option("--task", task_,
                        "For johnson and ttp: detection, recognition or identification, which need "
                        "0.75, 3 and 6 cycles (ttp: 2.7, 14.5 and 18.8) for a probability of 50 %")
            ->type_name("WORD")
            ->capture_default_str();
        numbers_.add("--cycles", "", "In place of --task: the cycles for a probability of 50 %");
        numbers_.add(
            "--probability", "%",
            "Probability of the task, 50 by default; for a point, the probability that its signal "
            "with noise exceeds --snr, averaged over all positions of its image in a pixel");
        command
            .add_option(
                "--leave-out", leftOut_,
                "For johnson and ttp: the name of a temperature or material whose surfaces are not "
                "counted, such as hot parts and plumes; may be given more than once")
            ->type_name("NAME")
            ->expected(1)
            ->take_all();
        numbers_.add("--false-alarms", "",
                     "In place of --snr: the probability that noise alone exceeds the threshold in "
                     "one pixel of one frame, such as 1e-6");
        command
            .add_option("--clutter", clutter_,
                        "For a point: standard deviation of the background's apparent temperature "
                        "from pixel to pixel in K, which counts as noise, 0 by default; auto: that "
                        "of the rendered background beside the target")
            ->type_name("K");
        command
            .add_option("--cases", cases_,
                        "aspects: those of a polar plot; directions: azimuths and elevations of a "
                        "signature table, given by --set table.azimuthStep=30 and the other "
                        "settings of table")
            ->type_name("WORD")
            ->capture_default_str();
        command
            .add_option("--against", against_,
                        "One row for each of --values instead of one for each case, with the mean, "
                        "shortest and longest range of all cases: wind (m/s), visibility (m), "
                        "humidity (%), hour (local solar time), band (um) or paint")
            ->type_name("WORD");
        command
            .add_option("--values", values_,
                        "For --against: numbers, bands such as 3.7-4.2 or, for paint, emissivities "
                        "or names of materials, separated by commas")
            ->type_name("LIST");
        command
            .add_option("--paint", paint_,
                        "For --against paint: the material of the target that is replaced")
            ->type_name("NAME");
        command
            .add_option(
                "--sun-of", sunOf_,
                "For --against hour: day and place that give the sun, such as 2025-06-21,54.3,10.1 "
                "(latitude and longitude in deg); without it the sun does not move")
            ->type_name("DATE,LAT,LON");
        command
            .add_option("--ranges", ranges_,
                        "Instead of searching for a range: the probability at these ranges in m, "
                        "separated by commas, averaged over the aspects")
            ->type_name("m");
        numbers_.add("--draws", "",
                     "With --ranges: draws from the scaling files beside the models, over which "
                     "the probability is averaged as well; 0 by default");
        command.add_flag("--sensitivity", sensitivity_,
                         "Adds the relative change of the range per relative change of each number "
                         "of the sensor, of the extinction, and of temperatures and emissivities "
                         "of the target");
        numbers_.add("--scene-contrast", "K",
                     "For ttp: temperature difference that the display shows from black to white, "
                     "10 by default");
        numbers_.add("--display-pixel", "mrad",
                     "For ttp: angle at which the observer sees one pixel of the sensor on the "
                     "display, 0.8 by default");
        numbers_.add("--display-luminance", "cd/m2",
                     "For ttp: mean luminance of the display, 34 by default");
        numbers_.add("--nearest", "m", "Range at which the search begins, 100 by default");
        numbers_.add("--farthest", "m", "Range at which it ends, 1000000 by default");
        numbers_.add(
            "--looks", "",
            "Ranges per decade at which the ratio is computed where it may cross the threshold, 4 "
            "by default; more of them find crossings that lie closer together");
        numbers_.add("--background-temperature", "K",
                     "Temperature of the background whose photons cause noise; by default that of "
                     "the scene behind the target");
        command
            .add_option("--point", place_,
                        "Where the image of the target lies on a pixel: centre, mean or corner")
            ->type_name("WORD")
            ->capture_default_str();
        addDryRun(command, dryRun_);
        command.footer("Columns: the case, the detection range with its error, what was found, and "
                       "signal and noise at that range (docs/sensor.md).");
    }

    int run(Context& context) const {
        if (!dryRun_ || files_.isGiven())
            files_.check("detection.csv", context.json);
        numbers_.check();
        DetectionRequest request = requestOf();
        const Settings given = settings_.values();
        checkDetection(request, givenOptions(given));
        AnalysisData data;
        {
            const StageTimer::Scope scope(&context.timer, "load");
            Project project = project_.load();
            settings_.place(project);
            data = AnalysisData::of(project, kindOf(request.cases));
            data.name = "detection";
            data.settings = data.settings.with(given);
            settings_.requireNamed(data.settings);
            data.commandLine = context.commandLine;
            request.sensor = irsg::loadSensor(sensor_);
            request.sensorFile = sensor_;
        }
        const std::string description =
            planAnalysis(kindOf(request.cases), data.project,
                         withFixedSteps(kindOf(request.cases), data.settings))
                .description;
        files_.checkWritable();
        if (dryRun_) {
            JobRunner().rehearse(data, request);
            files_.checkWritable(); // inputs are known by now
            for (const std::string& warning : data.warnings)
                warn(warning);
            fmt::print("detection: {}\n", description);
            return done;
        }
        catchStopSignal();
        {
            const StageTimer::Scope scope(&context.timer, "search");
            RunControl control(context);
            JobRunner().run(data, request, files_.checkedOn(control));
        }
        for (const std::string& warning : data.warnings)
            warn(warning);
        const StageTimer::Scope scope(&context.timer, "save");
        const bool isComplete = data.state == AnalysisState::complete;
        files_.write(data.name, data.table, data.summary, {}, context.json, isComplete);
        return endOfRun(isComplete);
    }

  private:
    DetectionRequest requestOf() const {
        if (sensor_.empty())
            throw refusal("--sensor", "nothing", "a sensor, such as --sensor one.smatsensor");
        DetectionRequest request;
        request.criterion =
            static_cast<RangeCriterion>(chosen("--criterion", criterion_, criterionWords()));
        if (request.criterion == RangeCriterion::point)
            takePoint(request);
        else
            takeTask(request.task, request.criterion);
        request.leftOut = leftOut_;
        irsg::SensorDisplay& display = request.display;
        display.sceneContrast_K = numbers_.positive("--scene-contrast", display.sceneContrast_K);
        display.pixel_mrad = numbers_.positive("--display-pixel", display.pixel_mrad);
        display.luminance_cd_m2 = numbers_.positive("--display-luminance", display.luminance_cd_m2);
        request.limits.nearest_m = numbers_.positive("--nearest", request.limits.nearest_m);
        request.limits.farthest_m = numbers_.positive("--farthest", request.limits.farthest_m);
        numbers_.takeWhole("--looks", request.limits.looksPerDecade, 1.0, 1000.0);
        if (numbers_.value("--background-temperature"))
            request.background_K = numbers_.positive("--background-temperature", 300.0);
        request.place = static_cast<PointPlace>(chosen("--point", place_, pointPlaceWords()));
        request.cases = static_cast<RangeCases>(chosen("--cases", cases_, rangeCasesWords()));
        takeComparison(request);
        takeRanges(request);
        return request;
    }

    static std::size_t chosen(const char* option, const std::string& word,
                              const std::vector<std::string>& words) {
        const auto found = std::ranges::find(words, word);
        if (found == words.end())
            throw wordRefusal(option, word, words);
        return static_cast<std::size_t>(found - words.begin());
    }

    void takePoint(DetectionRequest& request) const {
        request.threshold = numbers_.positive("--snr", request.threshold);
        if (const auto probability = numbers_.value("--false-alarms"))
            request.threshold = thresholdOfFalseAlarms(*probability);
        if (numbers_.value("--probability"))
            request.pointProbability = probability();
        if (clutter_ == "auto") {
            request.measuresClutter = true;
        } else if (!clutter_.empty()) {
            const auto clutter_K = irsg::parseNumber(irsg::trimmed(clutter_));
            if (!clutter_K || *clutter_K <= 0.0)
                throw refusal("--clutter", clutter_, "a number of K above 0, or auto");
            request.clutter_K = *clutter_K;
        }
    }

    void takeComparison(DetectionRequest& request) const {
        if (against_.empty())
            return;
        RangeComparison comparison;
        comparison.against =
            static_cast<RangeAgainst>(chosen("--against", against_, rangeAgainstWords()));
        comparison.values = wordsOf(values_);
        comparison.paint = paint_;
        if (!sunOf_.empty())
            comparison.place = rangePlaceOf("--sun-of", sunOf_);
        request.comparison = std::move(comparison);
    }

    void takeRanges(DetectionRequest& request) const {
        request.findsSensitivity = sensitivity_;
        numbers_.takeWhole("--draws", request.draws, 1.0, 1e6);
        if (!ranges_.empty())
            request.ranges_m = numbersOf("--ranges", ranges_);
    }

    /// What of its own and of the settings was given.
    GivenOptions givenOptions(const Settings& settings) const {
        GivenOptions given{[](const std::string& option) {
            const SettingInfo* const setting = findSetting(option);
            return setting != nullptr ? setting->option : "--" + option;
        }};
        for (const CLI::Option* option : command_.get_options())
            if (option->count() > 0 && !option->get_lnames().empty())
                given.values[option->get_lnames().front()] =
                    fmt::format("{}", fmt::join(option->results(), ","));
        for (const auto& [key, value] : settings.values())
            given.values[key] = value;
        return given;
    }

    void takeTask(RangeTask& task, RangeCriterion criterion) const {
        task.cyclesOfHalf = numbers_.positive(
            "--cycles",
            tasksOf(criterion).at(chosen("--task", task_, rangeTaskWords())).cyclesOfHalf);
        task.probability = probability();
    }

    double probability() const {
        const double percent = numbers_.value("--probability").value_or(50.0);
        if (!(percent > 0.0 && percent < 100.0))
            throw refusal("--probability", irsg::numberText(percent),
                          "a number between 0 and 100 %, both exclusive");
        return 0.01 * percent;
    }

    CLI::App& command_;
    ProjectInput project_;
    SettingOptions settings_;
    NumberOptions numbers_;
    TableFiles files_;
    std::string sensor_, place_ = "centre", criterion_ = "point", task_ = "detection";
    std::vector<std::string> leftOut_;
    std::string clutter_, ranges_, cases_ = "aspects", against_, values_, paint_, sunOf_;
    bool dryRun_ = false, sensitivity_ = false;
};

} // namespace

void addDetectionCommand(CLI::App& app, Context& context) {
    addCommand<DetectionCommand>(app, context, "detection",
                                 "Range at which a sensor detects the target, over one turn or all "
                                 "directions, or against wind, hour, band or paint");
}

} // namespace smat::batch
