#include "apps/smat-batch/Analyses.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/RunControl.h"
#include "apps/smat-batch/StopSignal.h"
#include "irsg/core/Collect.h"
#include "smatcore/jobs/CaseTeam.h"

namespace smat::batch {

int runJobs(const std::vector<Job>& jobs, Context& context) {
    std::vector<PlannedJob> planned = planJobs(jobs, context.team != nullptr);
    catchStopSignal();
    JobRunner runner;
    std::vector<Outcome> outcomes;
    for (PlannedJob& job : planned) {
        const JobOutcome outcome = runner.run(job, RunControl(context));
        if (!outcome.isLed)
            continue;
        warnOf(outcome);
        for (const std::string& warning : job.data.warnings)
            warn(job.data.name + ": " + warning);
        // What is written need not wait for the end of all.
        job.data.image = {};
        outcomes.push_back({&job.data, outcome.files});
        if (stopWasAsked())
            break;
    }
    const bool isComplete =
        outcomes.size() == planned.size() && std::ranges::all_of(outcomes, [](const Outcome& one) {
            return one.data->state == AnalysisState::complete;
        });
    const int end = endOfRun(isComplete);
    if (context.team == nullptr || context.team->isLeader())
        fmt::print("{}", context.json ? summaryJson(outcomes) : summaryText(outcomes));
    return end;
}

int describeJobs(const std::vector<Job>& jobs, const Context& context) {
    std::vector<PlannedJob> planned = planJobs(jobs, context.team != nullptr);
    if (context.team != nullptr && !context.team->isLeader())
        return done;
    JobRunner runner;
    std::vector<irsg::Diagnostic> diagnostics;
    for (PlannedJob& job : planned)
        irsg::collectOnce(diagnostics, [&] { runner.rehearse(job); });
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const PlannedJob& job : planned) {
        for (const std::string& warning : job.data.warnings)
            warn(job.data.name + ": " + warning);
        if (context.json) {
            list.push_back({{"name", job.data.name},
                            {"kind", name(job.plan.kind)},
                            {"cases", job.plan.cases.size()},
                            {"description", job.plan.description}});
        } else {
            fmt::print("{}: {}\n", job.data.name, job.plan.description);
        }
    }
    if (context.json)
        fmt::print("{}\n", jsonText(nlohmann::ordered_json{{"plans", list}}));
    return done;
}

} // namespace smat::batch
