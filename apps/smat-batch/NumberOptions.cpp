#include "apps/smat-batch/NumberOptions.h"
#include "apps/smat-batch/Output.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "smatcore/jobs/AnalysisJobs.h"
#include "smatcore/support/PartialFile.h"

namespace smat::batch {

void NumberOptions::add(const std::string& option, const std::string& unit,
                        const std::string& help) {
    command_.add_option(option, texts_[option], help)
        ->type_name(unit)
        ->take_last(); // as those of settings
}

std::optional<double> NumberOptions::value(const std::string& option) const {
    return irsg::parseNumber(texts_.at(option));
}

double NumberOptions::positive(const std::string& option, double otherwise,
                               const char* expected) const {
    const double number = value(option).value_or(otherwise);
    if (!(number > 0.0))
        throw irsg::InputError({option, "", irsg::numberText(number), expected});
    return number;
}

std::optional<double> NumberOptions::wholeNumber(const std::string& option, double least,
                                                 double most) const {
    const std::optional<double> given = value(option);
    if (given && !(*given >= least && *given <= most && *given == std::floor(*given))) {
        throw irsg::InputError(
            {.file = option,
             .position = "",
             .value = irsg::numberText(*given),
             .expected = fmt::format("a whole number from {:.0f} to {:.0f}", least, most)});
    }
    return given;
}

void NumberOptions::check() const {
    std::vector<irsg::Diagnostic> diagnostics;
    for (const auto& [option, text] : texts_)
        if (!text.empty() && !irsg::parseNumber(text))
            diagnostics.push_back({option, "", text, "a finite number"});
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
}

TableFiles::TableFiles(CLI::App& command) {
    command.add_option("--out", files_, "Result file, .csv or .json; may be given more than once")
        ->type_name("FILE")
        ->expected(1)
        ->take_all();
}

void TableFiles::check(const std::string& example, bool isPrinted) const {
    if (files_.empty() && !isPrinted) {
        throw irsg::InputError(irsg::Diagnostic{.file = "--out",
                                                .position = "",
                                                .value = "nothing",
                                                .expected = "a result file, such as --out " +
                                                            example + ", or --json"});
    }
    for (const std::string& file : files_)
        checkResultFile(AnalysisKind::other, file);
}

void TableFiles::checkWritable() const {
    checkOutputs({files_.begin(), files_.end()});
}

JobControl TableFiles::checkedOn(JobControl control) const {
    control.loaded = [this](const SceneDescription&) { checkWritable(); };
    return control;
}

void TableFiles::write(const std::string& kind, const ResultTable& table,
                       const std::vector<SummaryItem>& summary,
                       const std::vector<std::string>& warnings, bool json, bool isComplete) const {
    std::vector<std::string> files;
    for (const std::string& file : files_)
        files.push_back(savedResult(file, isComplete, [&](const std::filesystem::path& place) {
                            table.save(place);
                        }).string());
    if (json) {
        using Json = nlohmann::ordered_json;
        Json items = Json::array();
        for (const SummaryItem& item : summary)
            items.push_back(jsonOf(item));
        fmt::print("{}\n", jsonText(Json{{"kind", kind},
                                         {"files", files},
                                         {"warnings", warnings},
                                         {"summary", items},
                                         {"table", Json::parse(table.toJson())}}));
        return;
    }
    std::size_t widest = 20;
    for (const SummaryItem& item : summary)
        widest = std::max(widest, item.label.size() + 2);
    fmt::print("{}: {} rows\n", kind, table.rowCount());
    for (const SummaryItem& item : summary)
        fmt::print("{}", summaryLine(item, widest));
    for (const std::string& warning : warnings)
        fmt::print("  note: {}\n", warning);
    for (const std::string& file : files)
        fmt::print("  -> {}\n", file);
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        words.emplace_back(irsg::trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return words;
}

std::vector<double> numbersOf(const char* option, const std::string& text) {
    std::vector<double> list;
    for (const std::string& word : wordsOf(text)) {
        const auto value = irsg::parseNumber(word);
        if (!value || *value < 0.0)
            throw refusal(option, word.empty() ? "nothing" : word,
                          "numbers of at least 0, separated by commas");
        list.push_back(*value);
    }
    return list;
}

} // namespace smat::batch
