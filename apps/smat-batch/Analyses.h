#pragma once

#include <filesystem>
#include <vector>

#include "apps/smat-batch/Command.h"
#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/CaseFile.h"

namespace smat::batch {

/// An analysis with the files its result goes to.
struct Job {
    AnalysisData data;
    std::vector<std::filesystem::path> files;
    /// Of a sweep: which of its cases are drawn, and whether a run that was ended is gone on with.
    CaseShare share;
    bool resumes = false;
};

/// Runs jobs one after the other with one renderer, saves each as soon as it is done, and prints
/// the summary; warnings go to standard error, too. An image of several bands becomes an image a
/// band: FILE@BAND.exr. Ctrl-C ends the job that runs, keeps and marks what it has, and leaves the
/// others out. All plans are checked before the first drawing. The cases of a sweep stand beside
/// its first file until it is saved (CaseFile); of a part they are the result.
int runJobs(std::vector<Job> jobs, Context& context);
/// Prints what would be drawn.
int describeJobs(const std::vector<Job>& given, const Context& context);

} // namespace smat::batch
