#pragma once

#include <filesystem>
#include <vector>

#include "apps/smat-batch/Command.h"
#include "smatcore/analysis/AnalysisData.h"

namespace smat::batch {

/// An analysis with the files its result goes to.
struct Job {
    AnalysisData data;
    std::vector<std::filesystem::path> files;
};

/// Runs jobs one after the other with one renderer, saves each as soon as it is done, and prints
/// the summary; warnings go to standard error, too. An image of several bands becomes an image a
/// band: FILE@BAND.exr. Ctrl-C ends the job that runs, keeps and marks what it has, and leaves the
/// others out. All plans are checked before the first drawing.
int runJobs(std::vector<Job> jobs, Context& context);
/// Prints what would be drawn.
int describeJobs(const std::vector<Job>& given, const Context& context);

} // namespace smat::batch
