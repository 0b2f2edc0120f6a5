#include "smatcore/results/ResultFolder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/image/ExrFile.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/MonteCarloFile.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/project/JsonReading.h"
#include "smatcore/project/JsonWriting.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/support/Folders.h"
#include "smatcore/support/TextFile.h"

namespace smat {

namespace {

using irsg::JsonReader;
using Json = nlohmann::json;
using Origin = ResultDocument::Origin;

constexpr int resultFileVersion = 1;
constexpr const char* wordsEnding = ".result";
constexpr const char* tableEnding = ".json";
constexpr const char* imageEnding = ".exr";
constexpr const char* realisationsEnding = "-draws.exr";

constexpr std::array<std::pair<Origin, const char*>, 4> originWords = {
    {{Origin::run, "run"},
     {Origin::file, "file"},
     {Origin::difference, "difference"},
     {Origin::tool, "tool"}}};

const char* word(Origin origin) {
    for (const auto& [one, text] : originWords)
        if (one == origin)
            return text;
    return "run";
}

/// The number a stem begins with; 0 of others.
int numberOf(const std::string& stem) {
    int number = 0;
    std::from_chars(stem.data(), stem.data() + stem.size(), number);
    return number;
}

Json summaryJson(const std::vector<SummaryItem>& summary) {
    Json list = Json::array();
    for (const SummaryItem& item : summary) {
        list.push_back({{"label", item.label}, {"value", item.value}, {"unit", item.unit}});
        if (item.error)
            list.back()["error"] = *item.error;
    }
    return list;
}

/// What the file says apart from the numbers, before they are read.
struct Words {
    ResultDocument document;
    std::string name, project, analysis;
    std::filesystem::path file;
    bool isMonteCarlo = false, isImage = false;
    double elapsed_s = 0.0;
    std::vector<SummaryItem> summary;
    std::vector<std::shared_ptr<const irsg::SignatureDatabase>> databases;
};

std::vector<SummaryItem> summaryOf(const JsonReader& list) {
    std::vector<SummaryItem> summary;
    for (const JsonReader& item : list.listOrNone())
        if (item.isObject("an object with label, value and unit")) {
            summary.push_back({item.at("label").textOr(""), item.at("value").numberOrNull(),
                               item.at("unit").textOr("")});
            if (item.has("error"))
                summary.back().error = item.at("error").number();
        }
    return summary;
}

/// Those of the models as they were; a result of a version that did not keep them has none.
std::vector<std::shared_ptr<const irsg::SignatureDatabase>> databasesOf(const JsonReader& list) {
    std::vector<std::shared_ptr<const irsg::SignatureDatabase>> databases;
    for (const JsonReader& one : list.listOrNone()) {
        databases.push_back(
            one.json().is_null()
                ? nullptr
                : std::make_shared<const irsg::SignatureDatabase>(irsg::signatureFromJson(
                      one.json().dump(), list.file(), irsg::LintErrors::accept)));
    }
    return databases;
}

Json databasesJson(const AnalysisData& data) {
    Json list = Json::array();
    for (const auto& database : data.databases)
        list.push_back(database == nullptr ? Json() : Json::parse(irsg::draftToJson(*database)));
    return list;
}

Words readWords(const std::filesystem::path& file) {
    const JsonReader root = readVersioned(readTextFile(file), file.string(), "a result (JSON)",
                                          resultFileVersion, "version, title, origin and asked");
    Words words;
    ResultDocument& document = words.document;
    document.title = root.at("title").textOr("");
    document.notes = root.at("notes").textOr("");
    document.madeAt = root.at("made").textOr("");
    std::vector<std::string> origins;
    for (const auto& [origin, word] : originWords)
        origins.emplace_back(word);
    document.origin = originWords[root.at("origin").word(origins)].first;
    words.name = root.at("name").textOr("");
    words.analysis = root.at("analysis").textOr("");
    words.file = root.at("file").textOr("");
    words.isImage = root.at("image").booleanOr(false);
    words.isMonteCarlo = root.at("monteCarlo").booleanOr(false);
    words.elapsed_s = root.at("elapsed_s").numberOr(0.0, {0.0, 1e12});
    words.summary = summaryOf(root.at("summary"));
    words.databases = databasesOf(root.at("databases"));
    if (const JsonReader asked = root.at("asked"); asked.json().is_object())
        words.project = asked.json().dump();
    else if (document.origin == Origin::run)
        asked.refuse("the project that was asked");
    root.throwRefused();
    return words;
}

/// Puts back what was asked: the project with its settings, and those of the analysis on top.
void takeAsked(AnalysisData& data, const Words& words, const std::filesystem::path& resultFile,
               const std::filesystem::path& projectFile) {
    data.project = projectFromJson(words.project, resultFile);
    data.project.file = projectFile;
    const NamedAnalysis* asked = data.project.find(words.analysis);
    if (asked == nullptr) {
        throw irsg::InputError({.file = resultFile.string(),
                                .position = "analysis",
                                .value = words.analysis,
                                .expected = "an analysis of what was asked"});
    }
    data.kind = asked->kind;
    data.settings = data.project.settings.with(asked->settings);
    // Where adaptive steps are not told there were none.
    if (data.table.provenance.value(key::stepsOf(name(data.kind))).empty())
        data.settings = withFixedSteps(data.kind, data.settings);
    std::erase_if(data.project.analyses,
                  [&](const NamedAnalysis& one) { return one.name == words.analysis; });
}

void takeWords(AnalysisData& data, const Words& words, const std::filesystem::path& resultFile,
               const std::filesystem::path& projectFile) {
    data.name = words.name;
    data.elapsed_s = words.elapsed_s;
    data.databases = words.databases;
    if (!words.summary.empty())
        data.summary = words.summary;
    if (words.document.origin == Origin::run)
        takeAsked(data, words, resultFile, projectFile);
}

} // namespace

ResultFolder::ResultFolder(const std::filesystem::path& projectFile, const std::string& name)
    : projectFile_(projectFile),
      folder_(projectFile.parent_path() / (name.empty() ? usualName(projectFile) : name)) {}

std::string ResultFolder::usualName(const std::filesystem::path& projectFile) {
    return projectFile.filename().replace_extension(".results").string();
}

std::filesystem::path ResultFolder::file(const std::string& stem, const char* ending) const {
    return folder_ / (stem + ending);
}

std::vector<std::string> ResultFolder::documents() const {
    std::vector<std::string> stems;
    std::error_code failure;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, failure))
        if (entry.path().extension() == wordsEnding)
            stems.push_back(entry.path().stem().string());
    std::ranges::sort(stems, {}, [](const auto& stem) { return std::pair(numberOf(stem), stem); });
    return stems;
}

bool ResultFolder::holds(const std::string& stem) const {
    std::error_code failure;
    return std::filesystem::is_regular_file(file(stem, wordsEnding), failure);
}

ResultDocument ResultFolder::load(const std::string& stem) const {
    const std::filesystem::path wordsFile = file(stem, wordsEnding);
    const Words words = readWords(wordsFile);
    ResultDocument document = words.document;
    if (words.isMonteCarlo) {
        auto run = std::make_shared<MonteCarloData>(
            loadMonteCarlo(file(stem, tableEnding), irsg::readExr(file(stem, realisationsEnding))));
        takeWords(run->analysis, words, wordsFile, projectFile_);
        document.data = {run, &run->analysis};
        document.monteCarlo = run;
        return document;
    }
    AnalysisData data;
    if (document.origin == Origin::file) {
        document.file = words.file.is_absolute() ? words.file : folder_.parent_path() / words.file;
        data = loadResult(document.file);
    } else if (words.isImage) {
        data = loadResult(file(stem, imageEnding));
        data.table = ResultTable::load(file(stem, tableEnding));
    } else {
        data = loadResult(file(stem, tableEnding));
    }
    takeWords(data, words, wordsFile, projectFile_);
    document.data = std::make_shared<const AnalysisData>(std::move(data));
    return document;
}

std::string ResultFolder::freeStem(const ResultDocument& document, int number) const {
    int last = 0;
    for (const std::string& stem : documents())
        last = std::max(last, numberOf(stem));
    return fmt::format(
        "{:03}-{}", std::max(last + 1, number),
        smat::name(document.monteCarlo ? AnalysisKind::monteCarlo : document.data->kind));
}

std::string ResultFolder::save(const ResultDocument& document, int number) const {
    makeFolder(folder_, "the results of a project");
    const std::string stem = freeStem(document, number);
    const AnalysisData& data = *document.data;
    if (document.monteCarlo) {
        irsg::writeExr(realisationsImage(*document.monteCarlo), file(stem, realisationsEnding));
        saveMonteCarlo(*document.monteCarlo, file(stem, tableEnding));
    } else if (document.origin != Origin::file) {
        if (!data.image.empty())
            irsg::writeExr(data.image, file(stem, imageEnding));
        data.table.save(file(stem, tableEnding));
    }
    saveWords(document, stem);
    return stem;
}

void ResultFolder::saveWords(const ResultDocument& document, const std::string& stem) const {
    const AnalysisData& data = *document.data;
    const JsonPaths paths({}, std::filesystem::absolute(folder_).lexically_normal().parent_path());
    Json json = {{"version", resultFileVersion}, {"program", irsg::programWithVersion()},
                 {"title", document.title},      {"origin", word(document.origin)},
                 {"made", document.madeAt},      {"name", data.name},
                 {"elapsed_s", data.elapsed_s},  {"summary", summaryJson(data.summary)}};
    if (!document.notes.empty())
        json["notes"] = document.notes;
    if (document.origin == Origin::file)
        json["file"] = paths.text(std::filesystem::absolute(document.file));
    else if (!data.image.empty())
        json["image"] = true;
    if (document.monteCarlo)
        json["monteCarlo"] = true;
    if (document.origin == Origin::run) {
        // What was asked is a project with one more analysis, whose settings are all in effect.
        Project project = data.project;
        std::string analysis = "asked";
        while (project.find(analysis) != nullptr)
            analysis += "-";
        project.analyses.push_back(
            {.name = analysis, .kind = data.kind, .settings = data.settings});
        json["analysis"] = analysis;
        json["asked"] = Json::parse(projectToJson(project, projectFile_));
        json["databases"] = databasesJson(data);
    }
    writeTextFile(file(stem, wordsEnding),
                  json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void ResultFolder::remove(const std::string& stem) const {
    for (const char* ending : {wordsEnding, tableEnding, imageEnding, realisationsEnding}) {
        std::error_code failure;
        std::filesystem::remove(file(stem, ending), failure);
        if (failure) {
            throw irsg::InputError({.file = file(stem, ending).string(),
                                    .position = "",
                                    .value = "a file that cannot be removed",
                                    .expected = "leave to remove it"});
        }
    }
}

} // namespace smat
