#include <algorithm>
#include <chrono>
#include <memory>

#include "irsg/core/Collect.h"
#include "irsg/core/FileReading.h"
#include "smatcore/jobs/AnalysisJobs.h"
#include "smatcore/jobs/CaseTeam.h"

namespace smat {

namespace {

using Hashes = std::map<std::string, std::string>; ///< of inputs, by name

bool hasValues(const SimulationJob& job) {
    return std::ranges::find(job.extensions, ".exr") != job.extensions.end();
}

/// Draws with all processes of a team, sensor by sensor. Gives the seconds that it took.
double renderedByAll_s(const PlannedSimulation& job, const FrameFiles& files, const Hashes& inputs,
                       const RenderDoor& door, const JobControl& control) {
    const StageTimer::Scope scope(control.timer, "frames of all processes");
    const auto start = std::chrono::steady_clock::now();
    for (const std::size_t sensor : job.plan.sensors) {
        SimulationPlan ofSensor = job.plan;
        ofSensor.sensors = {sensor};
        renderedByTeam(
            {files.tableFile(sensor), job.share, job.resumes, inputs}, *control.team,
            [&](CaseStore& store, const ProgressCallback& progress, std::stop_token stop) {
                const SimulationParts parts{{&store}, true};
                SimulationResult result;
                writeSimulation(job.loaded, ofSensor, files, door, result, progress,
                                std::move(stop), nullptr, {}, &parts);
            },
            control.progress);
        control.team->meet();
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A file of steps beside the table of each sensor, where the run has parts.
std::vector<std::unique_ptr<CaseFile>> stepFiles(const PlannedSimulation& job,
                                                 const FrameFiles& files, const Hashes& inputs,
                                                 bool isDrawn) {
    std::vector<std::unique_ptr<CaseFile>> steps;
    if (!job.isInParts && !isDrawn)
        return steps;
    for (const std::size_t sensor : job.plan.sensors)
        steps.push_back(std::make_unique<CaseFile>(
            CaseFile::besides(files.tableFile(sensor), job.share),
            CaseFile::Options{job.share, job.resumes || isDrawn, inputs, 0.0}));
    return steps;
}

/// Of the steps of this run's part.
SimulationOutputs plannedOutputs(const PlannedSimulation& job, const SceneGenerator3D& generator,
                                 const FrameFiles& files) {
    return outputsOf(generator, job.plan, files, job.film,
                     [&](std::size_t step) { return job.share.has(step, job.plan.steps.size()); });
}

/// `films`: how many there are in a whole run.
void writeFilms(const PlannedSimulation& job, std::size_t films, const JobControl& control,
                SimulationOutcome& outcome) {
    const StageTimer::Scope scope(control.timer, "film");
    for (const FilmStrip& strip : outcome.strips) {
        const std::filesystem::path file = filmFile(job.film, strip, films);
        const std::string sentence = writeFilm(strip, file, job.loaded.scenario.displayName(),
                                               control.stop, control.progress);
        if (!sentence.empty()) {
            outcome.remarks.push_back(sentence);
            continue;
        }
        outcome.films.push_back(filmFiles(file, strip));
        outcome.files.insert(outcome.files.end(), outcome.films.back().begin(),
                             outcome.films.back().end());
    }
}

} // namespace

PlannedSimulation JobRunner::plan(SimulationJob job) {
    PlannedSimulation planned{std::move(job), {}, {}};
    planned.plan = planSimulation(planned.scenario, planned.request);
    planned.loaded =
        loadScenarioFiles(planned.scenario, scenes_, planned.overrides, planned.trajectories);
    planned.files().checkExtensions();
    if (planned.film.empty())
        return planned;
    checkFilm(planned.film);
    if (!hasValues(planned))
        throw irsg::InputError({.file = "--film",
                                .position = "",
                                .value = "frames without their values",
                                .expected = "--format exr among the forms"});
    return planned;
}

SimulationOutputs JobRunner::rehearse(const PlannedSimulation& job) {
    std::vector<irsg::Diagnostic> diagnostics;
    const FrameFiles files = job.files();
    SimulationOutputs outputs;
    irsg::collect(diagnostics, [&] {
        const SceneGenerator3D generator(job.loaded, door());
        generator.check(job.plan.sensors, job.plan.times_s());
        outputs = plannedOutputs(job, generator, files);
        for (const std::size_t sensor : job.plan.sensors) {
            const SceneDescription& scene = job.loaded.sensors[sensor].scene;
            static_cast<void>(door().description(scene));
            for (const SimulationPlan::Step& step : job.plan.steps) {
                if (!generator.sees(sensor, step.time_s))
                    continue;
                const PlacedCase placed = generator.place(sensor, step.time_s).second;
                door().check(placed.scene, placed.view, irsg::Outputs::reports(scene.allBands()));
                door().check(placed.scene, placed.view, irsg::Outputs::image());
            }
        }
        stepFiles(job, files, inputHashes(), false); // reads those that are resumed
    });
    if (!job.folder.empty())
        irsg::collect(diagnostics, [&] { files.checkOutputs(job.plan.sensors); });
    // A folder that the run makes was looked at above.
    const std::filesystem::path ofFilm = job.film.parent_path().lexically_normal();
    if (!job.film.empty() &&
        (std::filesystem::exists(ofFilm) || ofFilm != job.folder.lexically_normal()))
        for (const std::vector<std::filesystem::path>& film : outputs.films)
            irsg::collectOnce(diagnostics, [&] { checkFilmPlace(film.front()); });
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return outputs;
}

SimulationOutcome JobRunner::run(const PlannedSimulation& job, const JobControl& control,
                                 const FrameSink& heed) {
    SimulationOutcome outcome;
    const FrameFiles files = job.files();
    files.makeFolders(job.plan.sensors);
    files.checkOutputs(job.plan.sensors);
    const auto films = plannedOutputs(job, SceneGenerator3D(job.loaded, door()), files).films;
    for (const std::vector<std::filesystem::path>& film : films)
        checkFilmPlace(film.front());
    const Hashes inputs = inputHashes(); // before frames read more
    double ofTeam_s = 0.0;
    if (control.team != nullptr) {
        ofTeam_s = renderedByAll_s(job, files, inputs, door(), control);
        outcome.isLed = control.team->isLeader();
        if (!outcome.isLed)
            return outcome;
    }
    const auto steps = stepFiles(job, files, inputs, control.team != nullptr);
    SimulationParts parts{{}, !job.share.isAll()};
    for (const std::unique_ptr<CaseFile>& file : steps)
        parts.stores.push_back(file.get());
    FilmRecorder recorder(job.loaded, files);
    const bool isFilmed = (job.keepsStrips || !job.film.empty()) && hasValues(job) &&
                          control.team == nullptr && !job.isInParts;
    writeSimulation(
        job.loaded, job.plan, files, door(), outcome.result, control.progress, control.stop,
        control.timer,
        [&](SensorFrame& frame, std::size_t number) {
            if (isFilmed)
                recorder.heed(frame, number);
            if (heed)
                heed(frame, number);
        },
        steps.empty() ? nullptr : &parts);
    outcome.result.elapsed_s += ofTeam_s;
    for (const std::unique_ptr<CaseFile>& file : steps) {
        file->flush();
        if (job.share.isAll() && outcome.result.state == AnalysisState::complete)
            file->remove();
        for (std::string& remark : file->remarksOn("steps"))
            outcome.remarks.push_back(std::move(remark));
    }
    outcome.strips = recorder.strips();
    // Those of a run that was stopped may lie beside.
    for (FilmStrip& strip : outcome.strips)
        for (const SensorResult& sensor : outcome.result.sensors)
            if (sensor.sensor == strip.sensor)
                for (FilmStrip::Frame& frame : strip.frames)
                    frame.file = sensor.folder / frame.file.filename();
    if (!job.film.empty())
        writeFilms(job, films.size(), control, outcome);
    return outcome;
}

} // namespace smat
