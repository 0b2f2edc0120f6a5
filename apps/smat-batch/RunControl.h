#pragma once

#include <stop_token>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "smatcore/jobs/AnalysisJobs.h"

namespace smat::batch {

/// What a command gives a JobRunner: a line of progress while this lives, and an end by Ctrl-C.
class RunControl {
  public:
    explicit RunControl(Context& context) : context_(context) {}

    operator JobControl();

  private:
    Context& context_;
    ProgressLine line_;
    std::stop_source stop_;
};

/// Warns of what the outcome of a job remarks.
void warnOf(const JobOutcome& outcome);
/// Says of a run that was stopped that it was, unless it came to its end all the same. Gives the
/// exit code of the command.
int endOfRun(bool isComplete);

} // namespace smat::batch
