#pragma once

#include <vector>

#include "apps/smat-batch/Command.h"
#include "smatcore/jobs/AnalysisJobs.h"

namespace smat::batch {

/// Runs jobs (JobRunner) with a line of progress and prints the summary; warnings go to standard
/// error, too. Ctrl-C ends the job that runs, keeps and marks what it has, and leaves the others
/// out. All plans are checked before the first drawing.
int runJobs(const std::vector<Job>& jobs, Context& context);
/// Rehearses the jobs and prints what would be drawn. Throws InputError with all that runJobs would
/// refuse before it draws.
int describeJobs(const std::vector<Job>& jobs, const Context& context);

} // namespace smat::batch
