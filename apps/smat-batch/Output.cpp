#include "apps/smat-batch/Output.h"
#include "smatcore/settings/AnalysisSections.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace smat::batch {

namespace {

using Json = nlohmann::ordered_json;

const char* stateName(AnalysisState state) {
    switch (state) {
    case AnalysisState::notRun:
        return "not run";
    case AnalysisState::complete:
        return "complete";
    case AnalysisState::partial:
        return "partial";
    }
    return "";
}

} // namespace

void tell(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

void warn(const std::string& sentence) {
    tell("warning: " + sentence + "\n");
}

void warnOnce(const std::vector<std::string>& sentences) {
    static std::mutex mutex; // readers may remark in threads
    static std::vector<std::string> told;
    const std::scoped_lock lock(mutex);
    for (const std::string& sentence : sentences) {
        if (std::ranges::find(told, sentence) != told.end())
            continue;
        told.push_back(sentence);
        warn(sentence);
    }
}

void complain(const irsg::InputError& error, const std::string& speaker) {
    for (const irsg::Diagnostic& diagnostic : error.diagnostics())
        tell(speaker + "error: " + diagnostic.message() + "\n");
}

void checkFolderGiven(const std::string& folder, const std::string& what) {
    if (folder.empty()) {
        throw irsg::InputError(irsg::Diagnostic{.file = "--out",
                                                .position = "",
                                                .value = "nothing",
                                                .expected = "a folder for " + what});
    }
}

ProgressLine::~ProgressLine() {
    redraws_ = {};
    if (width_ > 0)
        tell(fmt::format("\r{:{}}\r", "", width_));
}

void ProgressLine::show(const Progress& progress) {
    if (isatty(STDERR_FILENO) == 0)
        return;
    {
        const std::scoped_lock lock(mutex_);
        progress_ = progress;
        told_ = std::chrono::steady_clock::now();
        draw();
    }
    if (!listening_)
        begin();
}

void ProgressLine::begin() {
    constexpr std::chrono::milliseconds pause(100);
    listening_.emplace(stage_);
    redraws_ = std::jthread([this, pause](const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        while (!ends_.wait_for(lock, stop, pause, [&] { return stop.stop_requested(); }))
            draw();
    });
}

void ProgressLine::draw() {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - told_;
    Progress now = progress_;
    now.elapsed_s += since.count();
    const std::string line = now.text(stage_.text());
    tell(fmt::format("\r{:<{}}", line, width_));
    width_ = std::max(width_, line.size());
}

namespace {

/// With six digits at most, and none behind the second one of its error: "510.2" for 1.8.
std::string warrantedNumber(double value, const std::optional<double>& error) {
    constexpr int most = 6, ofError = 2;
    if (!error || !(*error > 0.0) || !std::isfinite(*error) || value == 0.0)
        return fmt::format("{:.{}g}", value, most);
    const auto magnitude = [](double x) {
        return static_cast<int>(std::floor(std::log10(std::abs(x))));
    };
    const int warranted = std::min(magnitude(value) - magnitude(*error) + ofError, most);
    const int wholes = magnitude(value) + 1;
    // Zeros that are warranted are printed, too; a whole number has no point.
    return warranted > wholes ? fmt::format("{:#.{}g}", value, std::max(warranted, 1))
                              : fmt::format("{:.{}g}", value, std::clamp(wholes, 1, most));
}

} // namespace

std::string summaryLine(const SummaryItem& item, std::size_t widest) {
    return fmt::format("  {:<{}} {:>12} {}{}\n", item.label, widest,
                       warrantedNumber(item.value, item.error),
                       item.error ? fmt::format("± {:.2g} ", *item.error) : "", item.unit);
}

Json jsonOf(const SummaryItem& item) {
    Json json = {{"label", item.label}, {"value", item.value}, {"unit", item.unit}};
    if (item.error)
        json["error"] = *item.error;
    return json;
}

std::string summaryText(const std::vector<Outcome>& outcomes) {
    std::size_t widest = 20;
    for (const Outcome& outcome : outcomes)
        for (const SummaryItem& item : outcome.data->summary)
            widest = std::max(widest, item.label.size() + 2);
    std::string text;
    for (const Outcome& outcome : outcomes) {
        const AnalysisData& data = *outcome.data;
        const std::string heading =
            data.name == name(data.kind) ? data.name : data.name + " (" + name(data.kind) + ")";
        text += fmt::format("{}: {}, {:.2f} s\n", heading, stateName(data.state), data.elapsed_s);
        for (const SummaryItem& item : data.summary)
            text += summaryLine(item, widest);
        for (const std::string& warning : data.warnings)
            text += "  note: " + warning + "\n";
        for (const std::filesystem::path& file : outcome.files)
            text += "  -> " + file.string() + "\n";
    }
    return text;
}

std::string summaryJson(const std::vector<Outcome>& outcomes) {
    Json list = Json::array();
    for (const Outcome& outcome : outcomes) {
        const AnalysisData& data = *outcome.data;
        Json settings = Json::object();
        for (const SettingInfo& setting : settingTable())
            if (concerns(setting, name(data.kind)))
                settings[setting.key] = data.settings.text(setting.key);
        Json summary = Json::array();
        for (const SummaryItem& item : data.summary)
            summary.push_back(jsonOf(item));
        Json files = Json::array();
        for (const std::filesystem::path& file : outcome.files)
            files.push_back(file.string());
        list.push_back({{"name", data.name},
                        {"kind", name(data.kind)},
                        {"state", stateName(data.state)},
                        {"elapsed_s", data.elapsed_s},
                        {"renderer", data.renderer},
                        {"answered_by", data.providedBy},
                        {"warnings", data.warnings},
                        {"summary", summary},
                        {"files", files},
                        {"settings", settings},
                        {"table", Json::parse(data.table.toJson())}});
    }
    return jsonText(Json{{"analyses", list}}) + "\n";
}

} // namespace smat::batch
