#include "smatcore/jobs/AnalysisJobs.h"

#include <chrono>
#include <map>
#include <memory>
#include <set>
#include <system_error>
#include <utility>

#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/ImageSensor.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/jobs/CaseTeam.h"
#include "smatcore/support/PartialFile.h"

namespace smat {

namespace {

std::vector<Job> eachBandItsImage(const std::vector<Job>& jobs) {
    std::vector<Job> list;
    for (Job job : jobs) {
        followSensor(job.data);
        const std::vector<Settings> each = eachBand(job.data.settings);
        if (job.data.kind->form != AnalysisForm::image || each.size() < 2) {
            list.push_back(job);
            continue;
        }
        const auto labels = bandLabels(bandsOf(job.data.project, job.data.settings));
        const auto ofFiles = distinctFileLabels(labels);
        for (std::size_t i = 0; i < each.size(); ++i) {
            Job one = job;
            one.data.settings = each[i];
            one.data.name += "@" + labels[i];
            for (std::filesystem::path& file : one.files) {
                file.replace_filename(file.stem().string() + "@" + ofFiles[i] +
                                      file.extension().string());
            }
            list.push_back(std::move(one));
        }
    }
    return list;
}

AnalysisPlan planned(const Job& job, bool isInParts) {
    for (const std::filesystem::path& file : job.files)
        checkResultFile(job.data.kind, file);
    AnalysisPlan plan = planAnalysis(job.data.kind, job.data.project, job.data.settings);
    if (!plan.refined.empty() && isInParts)
        throw irsg::InputError(irsg::Diagnostic{
            .file = job.share.isAll() ? "several processes" : "--shard",
            .position = key::stepsOf(name(job.data.kind)),
            .value = "adaptive",
            .expected = "fixed: which cases an adaptive sweep has follows from all of its cases, "
                        "so that it has no parts"});
    return plan;
}

/// Where the cases of a sweep go; null for anything else. `isDrawn` where they are all there.
std::unique_ptr<CaseFile> caseFileOf(const Job& job, std::map<std::string, std::string> inputs,
                                     bool isDrawn) {
    if (job.data.kind->form != AnalysisForm::sweep || job.files.empty())
        return nullptr;
    constexpr double worthAFile_s = 2.0;
    const bool resumes = job.resumes || isDrawn;
    const bool isAlone = job.share.isAll() && !resumes;
    return std::make_unique<CaseFile>(
        CaseFile::besides(job.files.front(), job.share),
        CaseFile::Options{job.share, resumes, std::move(inputs), isAlone ? worthAFile_s : 0.0});
}

/// Writes the result, and takes its cases away where they are in it.
void save(const Job& job, CaseFile* cases, JobOutcome& outcome) {
    if (!job.share.isAll()) {
        cases->flush();
        outcome.files.push_back(cases->file());
        return;
    }
    const bool hasResult = job.data.kind->form == AnalysisForm::image ? !job.data.image.empty()
                                                                      : !job.data.table.empty();
    for (const std::filesystem::path& file : job.files)
        if (hasResult)
            outcome.files.push_back(
                savedResult(file, job.data.state == AnalysisState::complete,
                            [&](const auto& place) { saveResult(job.data, place); }));
    if (cases == nullptr)
        return;
    if (job.data.state == AnalysisState::complete)
        cases->remove();
    else
        cases->flush();
}

} // namespace

std::vector<PlannedJob> planJobs(const std::vector<Job>& jobs, bool byTeam) {
    std::vector<PlannedJob> list;
    std::vector<irsg::Diagnostic> diagnostics;
    for (Job& job : eachBandItsImage(jobs)) {
        const bool isInParts = !job.share.isAll() || byTeam;
        if (isInParts)
            job.data.settings = withFixedSteps(job.data.kind, job.data.settings);
        irsg::collect(diagnostics, [&] {
            AnalysisPlan plan = planned(job, isInParts);
            list.push_back({std::move(job), std::move(plan)});
        });
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return list;
}

void checkOutputs(const std::vector<std::filesystem::path>& files) {
    std::vector<irsg::Diagnostic> diagnostics;
    std::set<std::filesystem::path> places;
    for (const std::filesystem::path& file : files) {
        std::error_code unknown;
        const auto place =
            std::filesystem::weakly_canonical(std::filesystem::absolute(file, unknown), unknown);
        if (!unknown && !places.insert(place).second)
            diagnostics.push_back(
                {file.string(), "", "two results", "a file for each, of a name of its own"});
        irsg::collect(diagnostics, [&] { irsg::checkWritable(file); });
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
}

const RenderDoor& JobRunner::door() {
    if (!door_.isOpen())
        door_ = makeDoor_();
    return door_;
}

void JobRunner::rehearse(PlannedJob& job) {
    std::vector<irsg::Diagnostic> diagnostics;
    irsg::collect(diagnostics, [&] {
        SceneDescription scene = scenes_.build(job.data.project, job.data.settings);
        const std::unique_ptr<CaseFile> cases = caseFileOf(job, inputHashes(), false);
        runAnalysis(job.data, job.plan, std::move(scene), door(),
                    {.store = cases.get(), .isRehearsal = true});
    });
    // Inputs are known by now.
    irsg::collect(diagnostics, [&] { checkOutputs(job.files); });
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
}

JobOutcome JobRunner::run(PlannedJob& job, const JobControl& control) {
    SceneDescription scene;
    {
        const StageTimer::Scope scope(control.timer, "load");
        scene = scenes_.build(job.data.project, job.data.settings);
    }
    checkOutputs(job.files);
    if (control.loaded)
        control.loaded(scene);
    // Of a sweep, as they are before anything is drawn, which reads more.
    const bool hasCases = job.data.kind->form == AnalysisForm::sweep && !job.files.empty();
    const auto inputs = hasCases ? inputHashes() : std::map<std::string, std::string>();
    const auto start = std::chrono::steady_clock::now();
    JobOutcome outcome;
    if (control.team != nullptr) {
        const CaseWork work = [&](CaseStore& store, const ProgressCallback& progress,
                                  std::stop_token stop) {
            runAnalysis(job.data, job.plan, scene, door(),
                        {progress, std::move(stop), nullptr, &store});
        };
        outcome.isLed = renderedByTeam({job.files.front(), job.share, job.resumes, inputs},
                                       *control.team, work, control.progress);
        if (!outcome.isLed)
            return outcome;
    }
    const std::unique_ptr<CaseFile> cases = caseFileOf(job, inputs, control.team != nullptr);
    runAnalysis(job.data, std::move(job.plan), std::move(scene), door(),
                {control.progress, control.stop, control.timer, cases.get()});
    if (control.team != nullptr) {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        job.data.elapsed_s = passed.count();
    }
    const StageTimer::Scope scope(control.timer, "save");
    save(job, cases.get(), outcome);
    if (cases)
        outcome.remarks = cases->remarksOn("cases");
    return outcome;
}

void JobRunner::rehearse(AnalysisData& data, const CostAccuracyStudy::Options& options) {
    CostAccuracyStudy::rehearse(data, door(), factory(), options);
}

void JobRunner::run(AnalysisData& data, const CostAccuracyStudy::Options& options,
                    const JobControl& control) {
    CostAccuracyStudy::run(data, door(), factory(control.loaded), options, control.progress,
                           control.stop);
}

void JobRunner::run(AnalysisData& data, const DetectionRequest& request,
                    const JobControl& control) {
    runDetection(data, request, door(), factory(control.loaded),
                 {.progress = control.progress, .stop = control.stop, .timer = control.timer});
}

void JobRunner::rehearse(AnalysisData& data, const DetectionRequest& request) {
    runDetection(data, request, door(), factory(), {.isRehearsal = true});
}

} // namespace smat
