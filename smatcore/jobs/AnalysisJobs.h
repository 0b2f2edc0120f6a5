#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/analysis/CaseFile.h"
#include "smatcore/analysis/CostAccuracyStudy.h"
#include "smatcore/analysis/Detection.h"
#include "smatcore/data/RenderDoor.h"
#include "smatcore/jobs/MonteCarloJob.h"
#include "smatcore/jobs/SimulationJob.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/simulate/SimulationOutputs.h"

namespace smat {

class CaseTeam;

/// An analysis with the files its result goes to.
struct Job {
    AnalysisData data;
    std::vector<std::filesystem::path> files; ///< none: the result stays in the data
    /// Of a sweep: which of its cases are drawn, and whether a run that was ended is gone on with.
    CaseShare share;
    bool resumes = false;
};

/// A job with its cases.
struct PlannedJob : Job {
    AnalysisPlan plan;
};

/// What is drawn for these jobs: an image of several bands becomes an image a band, FILE@BAND.exr,
/// and parts of a sweep have the fixed steps that its settings leave open, as which cases an
/// adaptive one has follows from all of them. `byTeam`: several processes draw each sweep. Throws
/// InputError with everything that is wrong with the plans of all jobs.
std::vector<PlannedJob> planJobs(const std::vector<Job>& jobs, bool byTeam = false);

/// Throws InputError with all of these files that could not be written when a job ends, inputs
/// included.
void checkOutputs(const std::vector<std::filesystem::path>& files);

/// What goes on while a job runs.
struct JobControl {
    ProgressCallback progress = {};
    std::stop_token stop = {};
    StageTimer* timer = nullptr;
    CaseTeam* team = nullptr; ///< whose processes draw a sweep together; none: this one alone
    /// Is told each scene when it was built, the first before the first drawing.
    std::function<void(const SceneDescription&)> loaded = {};
};

/// What became of one, beside its data.
struct JobOutcome {
    bool isLed = true; ///< false: another process of the team makes the result
    std::vector<std::filesystem::path> files;
    std::vector<std::string> remarks; ///< on its files
};

/// What became of a simulation.
struct SimulationOutcome : JobOutcome {
    SimulationResult result;
    /// Its frames, where a film or strips were asked for and they were written with their values.
    std::vector<FilmStrip> strips;
    /// Those that were written, each with its files (filmFiles); all are in `files`, too.
    std::vector<std::vector<std::filesystem::path>> films;
};

/// Runs jobs one after the other, of window, command line and MPI, with one renderer and the models
/// that it has loaded. A stop keeps and marks what was done. All functions throw InputError.
class JobRunner {
  public:
    /// `loader` stands in for irsg::Model::load.
    explicit JobRunner(DoorMaker makeDoor = openRenderDoor, SceneBuilder::ModelLoader loader = {})
        : makeDoor_(std::move(makeDoor)), scenes_(std::move(loader)) {}

    SceneBuilder& scenes() { return scenes_; }
    /// Opened by the first who asks.
    const RenderDoor& door();
    bool hasDoor() const { return door_.isOpen(); }

    /// Does all that run() of the same job does before it calculates, and refuses what it would
    /// refuse by then, outputs included. Changes no file; the data hold what there is to warn of.
    void rehearse(PlannedJob& job);
    /// Returns the files that it would write.
    SimulationOutputs rehearse(const PlannedSimulation& job);
    void rehearse(AnalysisData& data, const CostAccuracyStudy::Options& options);

    /// Builds the scene, runs the plan, saves. The cases of a sweep stand beside its first file
    /// until it is saved (CaseFile); of a part they are the result.
    JobOutcome run(PlannedJob& job, const JobControl& control = {});
    /// Builds the scene, draws, saves (MonteCarlo).
    JobOutcome run(MonteCarloJob& job, const JobControl& control = {});
    /// Draws and saves (runScenarioMonteCarlo).
    JobOutcome run(ScenarioMonteCarloJob& job, const JobControl& control = {});
    /// Counts the steps of a simulation and reads its files. Nothing is written yet.
    PlannedSimulation plan(SimulationJob job);
    /// Writes folders, frames, tables and the film. `heed` is given each frame after it was
    /// written, where one process draws them all.
    SimulationOutcome run(const PlannedSimulation& job, const JobControl& control = {},
                          const FrameSink& heed = {});
    /// See CostAccuracyStudy; the result stays in the data.
    void run(AnalysisData& data, const CostAccuracyStudy::Options& options,
             const JobControl& control = {});
    /// See runDetection; the result stays in the data.
    void run(AnalysisData& data, const DetectionRequest& request, const JobControl& control = {});
    void rehearse(AnalysisData& data, const DetectionRequest& request);
    /// Return what would be drawn. `byTeam`: as of several processes.
    AnalysisPlan rehearse(MonteCarloJob& job, bool byTeam = false);
    void rehearse(ScenarioMonteCarloJob& job);

  private:
    /// `loaded` may be empty; see JobControl.
    SceneFactory factory(const std::function<void(const SceneDescription&)>& loaded = {}) {
        return [this, loaded](const Project& project, const Settings& settings) {
            SceneDescription scene = scenes_.build(project, settings);
            if (loaded)
                loaded(scene);
            return scene;
        };
    }

    DoorMaker makeDoor_;
    RenderDoor door_;
    SceneBuilder scenes_;
};

} // namespace smat
