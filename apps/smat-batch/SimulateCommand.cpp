#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/NumberOptions.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/PartOptions.h"
#include "apps/smat-batch/RunControl.h"
#include "apps/smat-batch/ScenarioOptions.h"
#include "apps/smat-batch/SettingOptions.h"
#include "apps/smat-batch/StopSignal.h"
#include "irsg/core/Errors.h"
#include "smatcore/jobs/CaseTeam.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/simulate/ScenarioFile.h"

namespace smat::batch {

namespace {

using Json = nlohmann::ordered_json;

/// Those but the file of image.sensor, whose option is the name of a sensor here.
bool hasOption(const SettingInfo& setting) {
    return isScenarioSetting(setting) && setting.key != key::imageSensor;
}

/// "3-5 um, 8-12 um".
std::string bandsText(const SceneDescription& scene) {
    std::string text;
    for (const irsg::Band& band : scene.allBands())
        text += (text.empty() ? "" : ", ") + band.name();
    return text;
}

/// `smat-batch simulate SCENARIO --out DIR`: the frames of an engagement, one folder a sensor.
class SimulateCommand {
  public:
    explicit SimulateCommand(CLI::App& command)
        : numbers_(command), settings_(command, hasOption), parts_(command, "the steps") {
        command.add_option("SCENARIO", scenario_, "Scenario file (JSON)")
            ->required()
            ->type_name("");
        command
            .add_option("--out", folder_,
                        "Folder for the frames, one in it for each sensor, and the tables; made "
                        "where it is missing")
            ->type_name("DIR");
        command.add_option("--sensor", sensors_, "Only this one; may be given more than once")
            ->type_name("NAME")
            ->expected(1)
            ->take_all();
        numbers_.add("--from", "s", "Time of the first frame; that of the scenario when not given");
        numbers_.add("--to", "s", "Time of the last frame; that of the scenario when not given");
        command
            .add_option("--format", formats_,
                        "Form of the frames: exr, csv or png; may be given more than once")
            ->type_name("FORM")
            ->expected(1)
            ->take_all();
        command
            .add_option("--film", film_,
                        "A film of the frames in one scale of colours: .mp4 or .gif where ffmpeg "
                        "is on PATH, or .png for numbered pictures; one for each sensor and band, "
                        "FILE-SENSOR where there are several")
            ->type_name("FILE");
        addDryRun(command, dryRun_);
    }

    int run(Context& context) const {
        if (!dryRun_)
            checkFolderGiven(folder_, "the frames");
        numbers_.check();
        checkFilmGiven(context);
        JobRunner runner;
        const PlannedSimulation job = [&] {
            const StageTimer::Scope scope(&context.timer, "load");
            PlannedSimulation planned = runner.plan({.scenario = openScenario(scenario_),
                                                     .overrides = scenarioOverrides(settings_),
                                                     .request = {.sensors = sensors_,
                                                                 .from_s = numbers_.value("--from"),
                                                                 .to_s = numbers_.value("--to")},
                                                     .folder = folder_,
                                                     .extensions = extensions(),
                                                     .film = film_,
                                                     .commandLine = context.commandLine,
                                                     .share = parts_.share(),
                                                     .isInParts = parts_.isGiven(),
                                                     .resumes = parts_.resumes()});
            for (const std::size_t sensor : planned.plan.sensors)
                settings_.requireNamed(planned.loaded.sensors[sensor].settings);
            return planned;
        }();
        for (const std::size_t sensor : job.plan.sensors)
            for (const std::string& warning : job.loaded.sensors[sensor].warnings)
                warn(job.scenario.sensors[sensor].name + ": " + warning);
        if (dryRun_) {
            const SimulationOutputs outputs = runner.rehearse(job);
            if (context.team == nullptr || context.team->isLeader())
                describe(job, outputs, context);
            return done;
        }
        catchStopSignal();
        for (const std::string& sentence : job.files().makeFolders(job.plan.sensors))
            if (!job.isInParts && context.team == nullptr)
                warn(sentence);
        const SimulationOutcome outcome = runner.run(job, RunControl(context));
        if (!outcome.isLed)
            return done;
        warnOf(outcome);
        splitTimes(runner.door(), context);
        fmt::print("{}", context.json ? jsonOf(outcome.result, job.loaded) : textOf(outcome, job));
        return endOfRun(outcome.result.state == AnalysisState::complete);
    }

  private:
    std::vector<std::string> extensions() const {
        std::vector<std::string> list;
        for (const std::string& format : formats_)
            list.push_back("." + format);
        return list.empty() ? std::vector<std::string>{".exr"} : list;
    }

    void checkFilmGiven(const Context& context) const {
        if (film_.empty())
            return;
        if (context.team != nullptr)
            throw refusal("--film", film_, "no film where several processes draw the frames");
        parts_.refuse("all frames in one run for a film");
    }

    static void splitTimes(const RenderDoor& door, Context& context) {
        std::vector<StageTimer::Stage> parts;
        for (const irsg::StageTimes::Stage& stage : door.stageTimes().stages)
            parts.push_back({stage.name, stage.seconds, stage.calls});
        context.timer.split("frames", parts);
    }

    static Json namesJson(const std::vector<std::filesystem::path>& files) {
        Json names = Json::array();
        for (const std::filesystem::path& file : files)
            names.push_back(file.string());
        return names;
    }

    static void describe(const PlannedSimulation& job, const SimulationOutputs& outputs,
                         const Context& context) {
        Json list = Json::array();
        for (const SimulationOutputs::OfSensor& of : outputs.sensors) {
            const irsg::Sensor& detector = job.loaded.sensors[of.sensor].scene.sensor;
            const std::string& name = job.loaded.scenario.sensors[of.sensor].name;
            const std::string bands = bandsText(job.loaded.sensors[of.sensor].scene);
            if (context.json) {
                list.push_back({{"sensor", name},
                                {"steps", of.steps.size()},
                                {"width", detector.width_px},
                                {"height", detector.height_px},
                                {"band", bands},
                                {"table", of.table.string()},
                                {"settings", of.settings.string()},
                                {"frames", namesJson(of.frames)}});
                if (!of.steps.empty())
                    list.back().update({{"from_s", of.steps.front().time_s},
                                        {"to_s", of.steps.back().time_s},
                                        {"first", of.frames.front().string()},
                                        {"last", of.frames.back().string()}});
                continue;
            }
            fmt::print("{}: {} steps{}, {} x {} px, {}", name, of.steps.size(),
                       of.steps.empty()
                           ? ""
                           : fmt::format(" from {:g} to {:g} s", of.steps.front().time_s,
                                         of.steps.back().time_s),
                       detector.width_px, detector.height_px, bands);
            if (of.steps.empty())
                fmt::print(", no frame: the sensor, or what it looks at, is not there\n");
            else
                fmt::print(", {}\n", firstToLast({of.frames.front().filename(),
                                                  of.frames.back().filename()}));
        }
        Json films = Json::array();
        for (const std::vector<std::filesystem::path>& film : outputs.films) {
            films.push_back(namesJson(film));
            if (!context.json)
                fmt::print("film: {}\n", firstToLast(film));
        }
        if (context.json)
            fmt::print("{}\n", jsonText(Json{{"plans", list}, {"films", films}}));
    }

    static std::string textOf(const SimulationOutcome& outcome, const PlannedSimulation& job) {
        const SimulationResult& result = outcome.result;
        const FrameFiles files = job.files();
        std::string text;
        for (const SensorResult& sensor : result.sensors) {
            text += fmt::format("{}: {} frames, {}\n", sensor.name, sensor.frames,
                                result.state == AnalysisState::complete ? "complete" : "partial");
            // What the files of the sensor ask in vain was said before the first frame.
            for (std::size_t i = job.loaded.sensors[sensor.sensor].warnings.size();
                 i < sensor.warnings.size(); ++i) {
                text += "  note: " + sensor.warnings[i] + "\n";
            }
            text += "  -> " + sensor.folder.string() + "\n";
            text +=
                "  -> " +
                (job.share.isAll() ? sensor.tableFile
                                   : CaseFile::besides(files.tableFile(sensor.sensor), job.share))
                    .string() +
                "\n";
        }
        text += fmt::format("{:.2f} s\n", result.elapsed_s);
        for (const std::vector<std::filesystem::path>& film : outcome.films)
            text += "  -> " + firstToLast(film) + "\n";
        return text;
    }

    static std::string jsonOf(const SimulationResult& result, const LoadedScenario& loaded) {
        Json list = Json::array();
        for (const SensorResult& sensor : result.sensors) {
            Json settings = Json::object();
            for (const SettingInfo& setting : settingTable()) {
                if (isScenarioSetting(setting)) {
                    settings[setting.key] =
                        loaded.sensors[sensor.sensor].settings.text(setting.key);
                }
            }
            list.push_back({{"name", sensor.name},
                            {"frames", sensor.frames},
                            {"frames_missing", sensor.framesMissing},
                            {"folder", sensor.folder.string()},
                            {"answered_by", sensor.providedBy},
                            {"warnings", sensor.warnings},
                            {"settings", settings},
                            {"table", Json::parse(sensor.table.toJson())}});
        }
        const char* state = result.state == AnalysisState::complete ? "complete" : "partial";
        return jsonText(Json{{"scenario", loaded.scenario.displayName()},
                             {"state", state},
                             {"elapsed_s", result.elapsed_s},
                             {"sensors", list}}) +
               "\n";
    }

    NumberOptions numbers_;
    SettingOptions settings_;
    PartOptions parts_;
    std::string scenario_;
    std::string folder_;
    std::vector<std::string> sensors_;
    std::vector<std::string> formats_;
    std::string film_;
    bool dryRun_ = false;
};

} // namespace

void addSimulateCommand(CLI::App& app, Context& context) {
    addCommand<SimulateCommand>(app, context, AnalysisKind::simulation);
}

} // namespace smat::batch
