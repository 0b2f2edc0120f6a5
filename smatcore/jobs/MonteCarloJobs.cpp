#include <optional>

#include "irsg/core/Collect.h"
#include "irsg/core/FileReplacement.h"
#include "smatcore/analysis/MonteCarlo.h"
#include "smatcore/analysis/MonteCarloFile.h"
#include "smatcore/jobs/AnalysisJobs.h"
#include "smatcore/jobs/CaseTeam.h"
#include "smatcore/project/SceneScalings.h"
#include "smatcore/support/PartialFile.h"

namespace smat {

namespace {

template <typename Files>
void append(std::vector<std::filesystem::path>& list, const Files& files) {
    list.insert(list.end(), files.begin(), files.end());
}

irsg::InputError noPart(const std::string& option, const std::filesystem::path& file,
                        const std::string& expected) {
    return irsg::InputError(
        {.file = option, .position = "", .value = file.string(), .expected = expected});
}

/// With its scales read, so that they are refused before anything is drawn, and are there before
/// inputHashes() is asked; the run says what they remark.
SceneDescription sceneOf(const MonteCarloJob& job, SceneBuilder& scenes) {
    job.data.options.check();
    const Project& project = job.data.analysis.project;
    SceneDescription scene = scenes.build(project, MonteCarlo::settingsOf(job.data.analysis));
    std::vector<std::string> remarks;
    sceneScalings(project, scene, remarks);
    return scene;
}

/// All files that the run may write.
std::vector<std::filesystem::path> filesOf(const MonteCarloJob& job) {
    std::vector<std::filesystem::path> all;
    for (const std::filesystem::path& file : job.files)
        append(all, monteCarloFiles(file, job.data.options.ranking));
    append(all, job.realisationFiles);
    return all;
}

std::vector<std::filesystem::path> filesOf(const ScenarioMonteCarloJob& job) {
    std::vector<std::filesystem::path> all;
    for (const std::filesystem::path& file : job.files)
        append(all, distributionFiles(job.run, file));
    for (const std::filesystem::path& file : job.realisationFiles)
        append(all, realisationFiles(job.run, file));
    return all;
}

/// What a run in parts cannot give.
void checkParts(const MonteCarloJob& job) {
    if (job.files.empty() && job.realisationFiles.empty())
        throw irsg::LogicError("a run in parts needs a file for its table");
    if (!job.realisationFiles.empty())
        throw noPart("--draws", job.realisationFiles.front(),
                     "no raw draws of a run in parts: each has those of its cases alone");
    for (const std::filesystem::path& file : job.files)
        if (file.extension() != ".csv")
            throw noPart("--out", file,
                         "a .csv of a run in parts: a .json has the draws of all cases");
}

void save(const MonteCarloJob& job, JobOutcome& outcome) {
    const bool isComplete = job.data.analysis.state == AnalysisState::complete;
    for (const std::filesystem::path& file : job.files)
        savedResult(file, isComplete, [&](const auto& place) {
            append(outcome.files, saveMonteCarlo(job.data, place));
        });
    for (const std::filesystem::path& file : job.realisationFiles)
        outcome.files.push_back(savedResult(
            file, isComplete, [&](const auto& place) { realisationsTable(job.data).save(place); }));
}

/// Case by case, by one process or a team.
void runParts(MonteCarloJob& job, MonteCarlo& monteCarlo, const JobControl& control,
              JobOutcome& outcome) {
    CasePlace place{job.files.front(), job.share, job.resumes, inputHashes()};
    const auto work = [&](CaseStore& store, const ProgressCallback& progress,
                          std::stop_token stop) {
        monteCarlo.run(job.data, store, progress, std::move(stop), control.timer);
    };
    if (control.team != nullptr) {
        outcome.isLed = renderedByTeam(place, *control.team, work, control.progress);
        if (!outcome.isLed)
            return;
        place.resumes = true; // all of them are there
    }
    CaseFile cases(CaseFile::besides(place.result, place.share), place.options());
    work(cases, control.progress, control.stop);
    const StageTimer::Scope scope(control.timer, "save");
    cases.flush();
    if (!place.share.isAll()) {
        outcome.files.push_back(cases.file());
    } else if (!job.data.analysis.table.empty()) {
        const bool isComplete = job.data.analysis.state == AnalysisState::complete;
        for (const std::filesystem::path& file : job.files)
            outcome.files.push_back(savedResult(
                file, isComplete, [&](const auto& place) { job.data.analysis.table.save(place); }));
        if (isComplete)
            cases.remove();
    }
    outcome.remarks = cases.remarksOn("cases");
}

} // namespace

AnalysisPlan JobRunner::rehearse(MonteCarloJob& job, bool byTeam) {
    const bool isInParts = job.isInParts || byTeam;
    if (isInParts)
        checkParts(job);
    AnalysisPlan plan;
    std::vector<irsg::Diagnostic> diagnostics;
    irsg::collect(diagnostics, [&] {
        SceneDescription scene = sceneOf(job, scenes_);
        MonteCarlo monteCarlo(door(), [&](const Project&, const Settings&) { return scene; });
        std::optional<CaseFile> cases;
        if (isInParts) {
            const CasePlace place{job.files.front(), job.share, job.resumes, inputHashes()};
            cases.emplace(CaseFile::besides(place.result, place.share), place.options());
        }
        plan = monteCarlo.rehearse(job.data, cases ? &*cases : nullptr);
    });
    // Inputs are known by now.
    irsg::collect(diagnostics, [&] { checkOutputs(filesOf(job)); });
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return plan;
}

void JobRunner::rehearse(ScenarioMonteCarloJob& job) {
    std::vector<irsg::Diagnostic> diagnostics;
    irsg::collect(diagnostics, [&] { rehearseScenarioMonteCarlo(job.run, door()); });
    irsg::collect(diagnostics, [&] { checkOutputs(filesOf(job)); });
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
}

JobOutcome JobRunner::run(MonteCarloJob& job, const JobControl& control) {
    const bool isInParts = job.isInParts || control.team != nullptr;
    if (isInParts)
        checkParts(job);
    SceneDescription scene;
    {
        const StageTimer::Scope scope(control.timer, "load");
        scene = sceneOf(job, scenes_);
    }
    checkOutputs(filesOf(job));
    MonteCarlo monteCarlo(door(), [&](const Project&, const Settings&) { return scene; });
    JobOutcome outcome;
    if (isInParts) {
        runParts(job, monteCarlo, control, outcome);
        return outcome;
    }
    monteCarlo.run(job.data, control.progress, control.stop, control.timer);
    const StageTimer::Scope scope(control.timer, "save");
    save(job, outcome);
    return outcome;
}

JobOutcome JobRunner::run(ScenarioMonteCarloJob& job, const JobControl& control) {
    checkOutputs(filesOf(job));
    runScenarioMonteCarlo(job.run, door(), control.progress, control.stop, control.timer);
    JobOutcome outcome;
    const StageTimer::Scope scope(control.timer, "save");
    for (const std::filesystem::path& file : job.files)
        append(outcome.files, saveDistributions(job.run, file));
    for (const std::filesystem::path& file : job.realisationFiles)
        append(outcome.files, saveScenarioRealisations(job.run, file));
    return outcome;
}

} // namespace smat
