#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/radiometry/Errors.h"
#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/support/Progress.h"

namespace smat::batch {

/// One sentence a line on standard error.
void warn(const std::string& sentence);
void complain(const irsg::InputError& error);

/// Throws InputError where `--out` names no folder for `what`.
void checkFolderGiven(const std::string& folder, const std::string& what);

/// One line on a terminal that is written over and over, nothing elsewhere.
class ProgressLine {
  public:
    ~ProgressLine();
    void show(const Progress& progress);

  private:
    std::size_t width_ = 0;
};

/// What became of one analysis, for the summary.
struct Outcome {
    const AnalysisData* data = nullptr;
    std::vector<std::filesystem::path> files;
};

/// A table for people: what, value, unit; then files and warnings.
std::string summaryText(const std::vector<Outcome>& outcomes);
/// The same as JSON, with the settings in effect.
std::string summaryJson(const std::vector<Outcome>& outcomes);

} // namespace smat::batch
