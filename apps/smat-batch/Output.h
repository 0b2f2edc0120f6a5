#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/support/CurrentStage.h"
#include "smatcore/support/Progress.h"

namespace smat::batch {

/// Text on standard error. What nobody can be told is lost, and changes nothing else.
void tell(std::string_view text);
/// JSON as the commands print it. A text that is no UTF-8, of a file of others, has its wrong bytes
/// replaced.
template <typename Json>
std::string jsonText(const Json& json) {
    return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

/// One sentence a line on standard error.
void warn(const std::string& sentence);
/// The same of those that this process has not warned of yet.
void warnOnce(const std::vector<std::string>& sentences);
/// `speaker` before each line says who, where several processes tell.
void complain(const irsg::InputError& error, const std::string& speaker = "");

/// Throws InputError where `--out` names no folder for `what`.
void checkFolderGiven(const std::string& folder, const std::string& what);

/// One line on a terminal that is written over and over while it lives, nothing elsewhere. What
/// takes long after the first `show` tells its stages, where that was called in the same thread.
class ProgressLine {
  public:
    ProgressLine() = default;
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const Progress& progress);

  private:
    void begin();
    void draw();

    std::mutex mutex_; ///< of what stands before the stage
    Progress progress_;
    std::chrono::steady_clock::time_point told_;
    std::size_t width_ = 0;
    CurrentStage stage_;
    std::optional<CurrentStage::Listening> listening_;
    std::condition_variable_any ends_;
    std::jthread redraws_;
};

/// What became of one analysis, for the summary.
struct Outcome {
    const AnalysisData* data = nullptr;
    std::vector<std::filesystem::path> files;
};

/// A line for people: what, value, its error where that is known, unit; labels fill `widest`
/// characters.
std::string summaryLine(const SummaryItem& item, std::size_t widest);
/// The same as an object: label, value, unit and, where it is known, error.
nlohmann::ordered_json jsonOf(const SummaryItem& item);

/// A table for people: what, value, unit; then files and warnings.
std::string summaryText(const std::vector<Outcome>& outcomes);
/// The same as JSON, with the settings in effect.
std::string summaryJson(const std::vector<Outcome>& outcomes);

} // namespace smat::batch
