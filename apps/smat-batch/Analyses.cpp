#include "apps/smat-batch/Analyses.h"

#include <chrono>
#include <cstdio>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/CaseTeam.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/PartOptions.h"
#include "apps/smat-batch/StopSignal.h"
#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::batch {

namespace {

/// Everything that can be wrong with the plans of all jobs, at once.
std::vector<AnalysisPlan> planned(const std::vector<Job>& jobs, const Context& context) {
    std::vector<AnalysisPlan> plans;
    std::vector<irsg::Diagnostic> diagnostics;
    for (const Job& job : jobs) {
        irsg::collect(diagnostics, [&] {
            for (const std::filesystem::path& file : job.files)
                checkResultFile(job.data.kind, file);
            plans.push_back(planAnalysis(job.data.kind, job.data.project, job.data.settings));
            if (!plans.back().refined.empty() && (!job.share.isAll() || context.team != nullptr))
                throw irsg::InputError(irsg::Diagnostic{
                    .file = job.share.isAll() ? "several processes" : "--shard",
                    .position = key::stepsOf(name(job.data.kind)),
                    .value = "adaptive",
                    .expected = "fixed: which cases an adaptive sweep has follows from all of its "
                                "cases, so that it has no parts"});
        });
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return plans;
}

/// Parts of a sweep have the fixed steps that its settings leave open: which cases an adaptive one
/// has follows from all of them.
void fixStepsOfParts(std::vector<Job>& jobs, const Context& context) {
    for (Job& job : jobs)
        if (!job.share.isAll() || context.team != nullptr)
            job.data.settings = withFixedSteps(job.data.kind, job.data.settings);
}

/// Images of several bands become an image a band, its label behind the names of result and files.
std::vector<Job> eachBandItsImage(const std::vector<Job>& jobs) {
    std::vector<Job> list;
    for (const Job& job : jobs) {
        const std::vector<Settings> each = eachBand(job.data.settings);
        if (job.data.kind->form != AnalysisForm::image || each.size() < 2) {
            list.push_back(job);
            continue;
        }
        const auto labels = bandLabels(bandsOf(job.data.project, job.data.settings));
        for (std::size_t i = 0; i < each.size(); ++i) {
            Job one = job;
            one.data.settings = each[i];
            one.data.name += "@" + labels[i];
            for (std::filesystem::path& file : one.files) {
                file.replace_filename(file.stem().string() + "@" + labels[i] +
                                      file.extension().string());
            }
            list.push_back(std::move(one));
        }
    }
    return list;
}

using Inputs = std::map<std::string, std::string>;

/// Where the cases of a sweep go; null for anything else. `isDrawn` where they are all there.
std::unique_ptr<CaseFile> caseFileOf(const Job& job, Inputs inputs, bool isDrawn) {
    if (job.data.kind->form != AnalysisForm::sweep)
        return nullptr;
    constexpr double worthAFile_s = 2.0;
    const bool resumes = job.resumes || isDrawn;
    const bool isAlone = job.share.isAll() && !resumes;
    return std::make_unique<CaseFile>(
        CaseFile::besides(job.files.front(), job.share),
        CaseFile::Options{job.share, resumes, std::move(inputs), isAlone ? worthAFile_s : 0.0});
}

} // namespace

int runJobs(std::vector<Job> jobs, Context& context) {
    jobs = eachBandItsImage(jobs);
    fixStepsOfParts(jobs, context);
    planned(jobs, context);
    catchStopSignal();
    SceneBuilder builder;
    std::unique_ptr<ImageSource> source;
    std::vector<Outcome> outcomes;
    for (Job& job : jobs) {
        // Inputs are read, and refused, before a renderer is made.
        {
            const StageTimer::Scope scope(&context.timer, "load");
            builder.build(job.data.project, job.data.settings);
        }
        for (const std::filesystem::path& file : job.files)
            irsg::refuseInputAsOutput(file);
        if (!source)
            source = startedImageSource(context);
        AnalysisGenerator generator(*source, [&](const Project& project, const Settings& settings) {
            return builder.build(project, settings);
        });
        // Of a sweep, as they are before anything is drawn, which reads more.
        const bool isSweep = job.data.kind->form == AnalysisForm::sweep;
        const Inputs inputs = isSweep ? inputHashes() : Inputs();
        const auto start = std::chrono::steady_clock::now();
        const CaseWork work = [&](CaseStore& store, const ProgressCallback& progress,
                                  std::stop_token stop) {
            generator.run(job.data, progress, std::move(stop), nullptr, &store);
        };
        if (context.team != nullptr &&
            !drawnByTeam({job.files.front(), job.share, job.resumes, inputs}, *context.team, work))
            continue;
        const std::unique_ptr<CaseFile> cases = caseFileOf(job, inputs, context.team != nullptr);
        std::stop_source stop;
        {
            ProgressLine line;
            generator.run(
                job.data,
                [&](const Progress& progress) {
                    line.show(progress);
                    if (stopWasAsked())
                        stop.request_stop();
                },
                stop.get_token(), &context.timer, cases.get());
        }
        if (context.team != nullptr) {
            const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
            job.data.elapsed_s = passed.count();
        }
        if (cases && cases->keptOld())
            warn("cases of an earlier run are kept as " + cases->file().string() +
                 ".old; --resume goes on with them");
        for (const std::string& warning : job.data.warnings)
            warn(job.data.name + ": " + warning);
        const StageTimer::Scope scope(&context.timer, "save");
        const bool hasResult = job.data.kind->form == AnalysisForm::image ? !job.data.image.empty()
                                                                          : !job.data.table.empty();
        Outcome outcome{&job.data, {}};
        if (!job.share.isAll()) {
            cases->flush();
            outcome.files.push_back(cases->file());
        }
        for (const std::filesystem::path& file : job.files) {
            if (hasResult && job.share.isAll()) {
                saveResult(job.data, file);
                outcome.files.push_back(file);
            }
        }
        if (cases && job.share.isAll()) {
            if (job.data.state == AnalysisState::complete)
                cases->remove();
            else
                cases->flush();
        }
        // What is written need not wait for the end of all.
        job.data.image = {};
        outcomes.push_back(outcome);
        if (stopWasAsked()) {
            warn("stopped; what was done so far is kept");
            break;
        }
    }
    if (context.team == nullptr || context.team->isLeader())
        fmt::print("{}", context.json ? summaryJson(outcomes) : summaryText(outcomes));
    return stopWasAsked() ? warned : done;
}

int describeJobs(const std::vector<Job>& given, const Context& context) {
    std::vector<Job> jobs = eachBandItsImage(given);
    fixStepsOfParts(jobs, context);
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    const std::vector<AnalysisPlan> plans = planned(jobs, context);
    for (std::size_t i = 0; i < plans.size(); ++i) {
        if (context.json) {
            list.push_back({{"name", jobs[i].data.name},
                            {"kind", name(plans[i].kind)},
                            {"cases", plans[i].cases.size()},
                            {"description", plans[i].description}});
        } else {
            fmt::print("{}: {}\n", jobs[i].data.name, plans[i].description);
        }
    }
    if (context.json)
        fmt::print("{}\n", jsonText(nlohmann::ordered_json{{"plans", list}}));
    return done;
}

} // namespace smat::batch
