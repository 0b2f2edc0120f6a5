#include "apps/smat-batch/Analyses.h"

#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/StopSignal.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/FileReading.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::batch {

namespace {

/// Everything that can be wrong with the plans of all jobs, at once.
std::vector<AnalysisPlan> planned(const std::vector<Job>& jobs) {
    std::vector<AnalysisPlan> plans;
    std::vector<irsg::Diagnostic> diagnostics;
    for (const Job& job : jobs) {
        try {
            for (const std::filesystem::path& file : job.files)
                checkResultFile(job.data.kind, file);
            plans.push_back(planAnalysis(job.data.kind, job.data.project, job.data.settings));
        } catch (const irsg::InputError& error) {
            diagnostics.insert(diagnostics.end(), error.diagnostics().begin(),
                               error.diagnostics().end());
        }
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return plans;
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

/// Where the cases of a sweep go; null for anything else.
std::unique_ptr<CaseFile> caseFileOf(const Job& job) {
    if (job.data.kind->form != AnalysisForm::sweep)
        return nullptr;
    constexpr double worthAFile_s = 2.0;
    const bool isAlone = job.share.isAll() && !job.resumes;
    return std::make_unique<CaseFile>(
        CaseFile::besides(job.files.front(), job.share),
        CaseFile::Options{job.share, job.resumes, inputHashes(), isAlone ? worthAFile_s : 0.0});
}

} // namespace

int runJobs(std::vector<Job> jobs, Context& context) {
    jobs = eachBandItsImage(jobs);
    planned(jobs);
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
        if (!source) {
            const StageTimer::Scope scope(&context.timer, "start renderer");
            source = makeIrsgImageSource();
        }
        const std::unique_ptr<CaseFile> cases = caseFileOf(job);
        std::stop_source stop;
        {
            ProgressLine line;
            AnalysisGenerator(*source,
                              [&](const Project& project, const Settings& settings) {
                                  return builder.build(project, settings);
                              })
                .run(
                    job.data,
                    [&](const Progress& progress) {
                        line.show(progress);
                        if (stopWasAsked())
                            stop.request_stop();
                    },
                    stop.get_token(), &context.timer, cases.get());
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
    fmt::print("{}", context.json ? summaryJson(outcomes) : summaryText(outcomes));
    return stopWasAsked() ? warned : done;
}

int describeJobs(const std::vector<Job>& given, const Context& context) {
    const std::vector<Job> jobs = eachBandItsImage(given);
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    const std::vector<AnalysisPlan> plans = planned(jobs);
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
