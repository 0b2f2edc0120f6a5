#include <fmt/format.h>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/NumberOptions.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/ProjectInput.h"
#include "apps/smat-batch/RunControl.h"
#include "apps/smat-batch/SettingOptions.h"
#include "apps/smat-batch/StopSignal.h"
#include "irsg/sensor/SensorFile.h"
#include "smatcore/jobs/AnalysisJobs.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::batch {

namespace {

const std::vector<std::string> placeWords = {"centre", "mean", "corner"};

/// `smat-batch detection PROJECT --sensor FILE --step 10 --snr 5 --out FILE`.
class DetectionCommand {
  public:
    explicit DetectionCommand(CLI::App& command)
        : project_(command),
          settings_(command, AnalysisKind::polar),
          numbers_(command),
          files_(command) {
        command.add_option("--sensor", sensor_, "Sensor (.smatsensor) that looks for the target")
            ->type_name("FILE");
        numbers_.add("--snr", "", "Signal to noise ratio at which the target is detected, 5");
        numbers_.add("--nearest", "m", "Where the search begins, 100");
        numbers_.add("--farthest", "m", "Where it ends, 1000000");
        numbers_.add("--looks", "",
                     "Ranges per decade at which the ratio is looked at before its root is found, "
                     "4; more find crossings that lie closer");
        numbers_.add("--background-temperature", "K",
                     "Of the background whose photons make noise; when not given that of the "
                     "scene behind the target");
        command
            .add_option("--point", place_,
                        "Where the image of the target lies on a pixel: centre, mean or corner")
            ->type_name("WORD")
            ->capture_default_str();
        addDryRun(command, dryRun_);
        command.footer("Columns: where the case is, the detection range with its error, what was "
                       "found, and signal and noise at that range (docs/sensor.md).");
    }

    int run(Context& context) const {
        if (!dryRun_ || files_.isGiven())
            files_.check("detection.csv");
        numbers_.check();
        DetectionRequest request = requestOf();
        AnalysisData data;
        {
            const StageTimer::Scope scope(&context.timer, "load");
            const Settings given = settings_.values();
            Project project = project_.load();
            settings_.place(project);
            data = AnalysisData::of(project, AnalysisKind::polar);
            data.name = "detection";
            data.settings = data.settings.with(given);
            settings_.requireNamed(data.settings);
            data.commandLine = context.commandLine;
            request.sensor = irsg::loadSensor(sensor_);
        }
        const std::string description =
            planAnalysis(data.kind, data.project, withFixedSteps(data.kind, data.settings))
                .description;
        files_.checkWritable();
        if (dryRun_) {
            JobRunner().rehearse(data, request);
            for (const std::string& warning : data.warnings)
                warn(warning);
            fmt::print("detection: {}\n", description);
            return done;
        }
        catchStopSignal();
        {
            const StageTimer::Scope scope(&context.timer, "search");
            JobRunner().run(data, request, RunControl(context));
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
        const auto positive = [&](const char* option, double otherwise) {
            const double value = numbers_.value(option).value_or(otherwise);
            if (!(value > 0.0))
                throw refusal(option, irsg::numberText(value), "a number above 0");
            return value;
        };
        request.threshold = positive("--snr", request.threshold);
        request.limits.nearest_m = positive("--nearest", request.limits.nearest_m);
        request.limits.farthest_m = positive("--farthest", request.limits.farthest_m);
        if (request.limits.farthest_m <= request.limits.nearest_m)
            throw refusal("--farthest", irsg::numberText(request.limits.farthest_m),
                          "a range beyond the nearest, " +
                              irsg::numberText(request.limits.nearest_m) + " m");
        numbers_.takeWhole("--looks", request.limits.looksPerDecade, 1.0, 1000.0);
        if (numbers_.value("--background-temperature"))
            request.background_K = positive("--background-temperature", 300.0);
        const auto word = std::ranges::find(placeWords, place_);
        if (word == placeWords.end())
            throw wordRefusal("--point", place_, placeWords);
        request.place = static_cast<PointPlace>(word - placeWords.begin());
        return request;
    }

    ProjectInput project_;
    SettingOptions settings_;
    NumberOptions numbers_;
    TableFiles files_;
    std::string sensor_, place_ = "centre";
    bool dryRun_ = false;
};

} // namespace

void addDetectionCommand(CLI::App& app, Context& context) {
    addCommand<DetectionCommand>(app, context, "detection",
                                 "How far a sensor sees the target, over one turn");
}

} // namespace smat::batch
