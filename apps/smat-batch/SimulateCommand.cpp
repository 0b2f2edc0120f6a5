#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/NumberOptions.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/PartOptions.h"
#include "apps/smat-batch/ScenarioOptions.h"
#include "apps/smat-batch/SettingOptions.h"
#include "apps/smat-batch/StopSignal.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/CaseFile.h"
#include "smatcore/simulate/Film.h"
#include "smatcore/simulate/FrameFiles.h"
#include "smatcore/simulate/ScenarioFile.h"

namespace smat::batch {

namespace {

using Json = nlohmann::ordered_json;
using Hashes = std::map<std::string, std::string>; ///< of inputs, by name

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
        : numbers_(command), settings_(command, isScenarioSetting), parts_(command, "the steps") {
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
        command.add_flag("--dry-run", dryRun_, "Say what would be drawn, and stop");
    }

    int run(Context& context) const {
        if (!dryRun_)
            checkFolderGiven(folder_, "the frames");
        numbers_.check();
        SceneBuilder builder;
        LoadedScenario loaded;
        SimulationPlan plan;
        {
            const StageTimer::Scope scope(&context.timer, "load");
            const Scenario scenario = openScenario(scenario_);
            plan = planSimulation(scenario, {.sensors = sensors_,
                                             .from_s = numbers_.value("--from"),
                                             .to_s = numbers_.value("--to")});
            loaded = loadScenarioFiles(scenario, builder, scenarioOverrides(settings_));
            for (const std::size_t sensor : plan.sensors)
                settings_.requireNamed(loaded.sensors[sensor].settings);
        }
        const FrameFiles files(loaded, folder_, extensions(), context.commandLine);
        files.checkExtensions();
        checkFilmGiven(context);
        const CaseShare share = parts_.share();
        for (const std::size_t sensor : plan.sensors)
            for (const std::string& warning : loaded.sensors[sensor].warnings)
                warn(loaded.scenario.sensors[sensor].name + ": " + warning);
        if (dryRun_) {
            if (context.team == nullptr || context.team->isLeader())
                describe(loaded, plan, files, context);
            return done;
        }
        return simulate(loaded, plan, files, share, context);
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
        checkFilm(film_);
        const std::vector<std::string> forms = extensions();
        if (std::ranges::find(forms, ".exr") == forms.end()) {
            throw irsg::InputError(irsg::Diagnostic{.file = "--film",
                                                    .position = "",
                                                    .value = "frames without their values",
                                                    .expected = "--format exr among the forms"});
        }
    }

    /// Sentences with the files.
    std::string writeFilms(const FilmRecorder& recorder, const std::string& whose) const {
        std::string text;
        std::stop_source stop;
        if (stopWasAsked())
            stop.request_stop();
        ProgressLine line;
        for (const FilmStrip& strip : recorder.strips()) {
            const std::filesystem::path file = filmFile(film_, strip, recorder.strips().size());
            const std::string sentence =
                writeFilm(strip, file, whose, stop.get_token(), [&](const Progress& progress) {
                    line.show(progress);
                    if (stopWasAsked())
                        stop.request_stop();
                });
            if (sentence.empty())
                text += "  -> " + file.string() + "\n";
            else
                warn(sentence);
        }
        return text;
    }

    /// A file of steps beside the table of each sensor, where the run has parts.
    std::vector<std::unique_ptr<CaseFile>> stepFiles(const SimulationPlan& plan,
                                                     const FrameFiles& files,
                                                     const CaseShare& share, const Hashes& inputs,
                                                     bool isDrawn) const {
        std::vector<std::unique_ptr<CaseFile>> steps;
        if (!parts_.isGiven() && !isDrawn)
            return steps;
        for (const std::size_t sensor : plan.sensors)
            steps.push_back(std::make_unique<CaseFile>(
                CaseFile::besides(files.tableFile(sensor), share),
                CaseFile::Options{share, parts_.resumes() || isDrawn, inputs, 0.0}));
        return steps;
    }

    /// Draws with all processes of a team, sensor by sensor; gives the seconds that it took.
    double renderedByAll_s(const LoadedScenario& loaded, const SimulationPlan& plan,
                           const FrameFiles& files, const Hashes& inputs, const RenderDoor& door,
                           CaseTeam& team) const {
        const auto start = std::chrono::steady_clock::now();
        for (const std::size_t sensor : plan.sensors) {
            SimulationPlan ofSensor = plan;
            ofSensor.sensors = {sensor};
            renderedByTeam(
                {files.tableFile(sensor), parts_.share(), parts_.resumes(), inputs}, team,
                [&](CaseStore& store, const ProgressCallback& progress, std::stop_token stop) {
                    const SimulationParts parts{{&store}, true};
                    SimulationResult result;
                    writeSimulation(loaded, ofSensor, files, door, result, progress,
                                    std::move(stop), nullptr, {}, &parts);
                });
            team.meet();
        }
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    int simulate(const LoadedScenario& loaded, const SimulationPlan& plan, const FrameFiles& files,
                 const CaseShare& share, Context& context) const {
        catchStopSignal();
        for (const std::string& sentence : files.makeFolders(plan.sensors))
            if (!parts_.isGiven() && context.team == nullptr)
                warn(sentence);
        const Hashes inputs = inputHashes(); // before frames read more
        const RenderDoor door = openRenderDoor();
        double ofTeam_s = 0.0;
        if (context.team != nullptr) {
            const StageTimer::Scope scope(&context.timer, "frames of all processes");
            ofTeam_s = renderedByAll_s(loaded, plan, files, inputs, door, *context.team);
            if (!context.team->isLeader())
                return done;
        }
        const std::vector<std::unique_ptr<CaseFile>> steps =
            stepFiles(plan, files, share, inputs, context.team != nullptr);
        SimulationParts parts{{}, !share.isAll()};
        for (const std::unique_ptr<CaseFile>& file : steps)
            parts.stores.push_back(file.get());
        SimulationResult result;
        FilmRecorder recorder(loaded, files);
        FrameSink heed;
        if (!film_.empty())
            heed = [&](SensorFrame& frame, std::size_t number) { recorder.heed(frame, number); };
        std::stop_source stop;
        {
            ProgressLine line;
            writeSimulation(
                loaded, plan, files, door, result,
                [&](const Progress& progress) {
                    line.show(progress);
                    if (stopWasAsked())
                        stop.request_stop();
                },
                stop.get_token(), &context.timer, heed, steps.empty() ? nullptr : &parts);
        }
        result.elapsed_s += ofTeam_s;
        for (const std::unique_ptr<CaseFile>& file : steps) {
            file->flush();
            if (file->keptOld())
                warn("steps of an earlier run are kept as " + file->file().string() +
                     ".old; --resume goes on with them");
            if (share.isAll() && result.state == AnalysisState::complete)
                file->remove();
        }
        std::string films;
        {
            const StageTimer::Scope scope(&context.timer, "film");
            films = writeFilms(recorder, loaded.scenario.displayName());
        }
        splitTimes(door, context);
        fmt::print("{}", context.json ? jsonOf(result, loaded, files)
                                      : textOf(result, loaded, files, share) + films);
        if (stopWasAsked())
            warn("stopped; what was done so far is kept");
        return stopWasAsked() ? warned : done;
    }

    static void splitTimes(const RenderDoor& door, Context& context) {
        std::vector<StageTimer::Stage> parts;
        for (const irsg::StageTimes::Stage& stage : door.stageTimes().stages)
            parts.push_back({stage.name, stage.seconds, stage.calls});
        context.timer.split("frames", parts);
    }

    static void describe(const LoadedScenario& loaded, const SimulationPlan& plan,
                         const FrameFiles& files, const Context& context) {
        Json list = Json::array();
        for (const std::size_t sensor : plan.sensors) {
            const irsg::Sensor& detector = loaded.sensors[sensor].scene.sensor;
            const std::string& name = loaded.scenario.sensors[sensor].name;
            const auto &first = plan.steps.front(), &last = plan.steps.back();
            if (context.json) {
                list.push_back({{"sensor", name},
                                {"steps", plan.steps.size()},
                                {"from_s", first.time_s},
                                {"to_s", last.time_s},
                                {"width", detector.width_px},
                                {"height", detector.height_px},
                                {"band", bandsText(loaded.sensors[sensor].scene)},
                                {"first", files.frameFile(sensor, first.number, "").string()},
                                {"last", files.frameFile(sensor, last.number, "").string()}});
            } else {
                fmt::print("{}: {} steps from {:g} to {:g} s, {} x {} px, {}, {} to {}\n", name,
                           plan.steps.size(), first.time_s, last.time_s, detector.width_px,
                           detector.height_px, bandsText(loaded.sensors[sensor].scene),
                           files.frameFile(sensor, first.number, "").filename().string(),
                           files.frameFile(sensor, last.number, "").filename().string());
            }
        }
        if (context.json)
            fmt::print("{}\n", jsonText(Json{{"plans", list}}));
    }

    static std::string textOf(const SimulationResult& result, const LoadedScenario& loaded,
                              const FrameFiles& files, const CaseShare& share) {
        std::string text;
        for (const SensorResult& sensor : result.sensors) {
            text += fmt::format("{}: {} frames, {}\n", sensor.name, sensor.frames,
                                result.state == AnalysisState::complete ? "complete" : "partial");
            // What the files of the sensor ask in vain was said before the first frame.
            for (std::size_t i = loaded.sensors[sensor.sensor].warnings.size();
                 i < sensor.warnings.size(); ++i) {
                text += "  note: " + sensor.warnings[i] + "\n";
            }
            text += "  -> " + files.frameFile(sensor.sensor, 0, "").parent_path().string() + "\n";
            const std::filesystem::path table = files.tableFile(sensor.sensor);
            text +=
                "  -> " + (share.isAll() ? table : CaseFile::besides(table, share)).string() + "\n";
        }
        return text + fmt::format("{:.2f} s\n", result.elapsed_s);
    }

    static std::string jsonOf(const SimulationResult& result, const LoadedScenario& loaded,
                              const FrameFiles& files) {
        Json list = Json::array();
        for (const SensorResult& sensor : result.sensors) {
            Json settings = Json::object();
            for (const SettingInfo& setting : settingTable()) {
                if (isScenarioSetting(setting)) {
                    settings[setting.key] =
                        loaded.sensors[sensor.sensor].settings.text(setting.key);
                }
            }
            list.push_back(
                {{"name", sensor.name},
                 {"frames", sensor.frames},
                 {"frames_missing", sensor.framesMissing},
                 {"folder", files.frameFile(sensor.sensor, 0, "").parent_path().string()},
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
