#include "smatcore/analysis/CaseFile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/JsonReader.h"
#include "smatcore/analysis/InputFiles.h"
#include "smatcore/analysis/ResultFile.h"

namespace smat {

namespace {

namespace fs = std::filesystem;
using irsg::JsonReader;
using OrderedJson = nlohmann::ordered_json;

constexpr const char* format = "smat cases 1";
/// Runs of cases that each part has at least: so that parts take alike, wherever cases are slow.
constexpr std::size_t runsOfPart = 16;
/// Of a sweep, and of its parts.
constexpr double mostCasesOfFile = 1e7;

[[noreturn]] void refuse(const fs::path& file, std::string position, std::string value,
                         std::string expected) {
    throw irsg::InputError({.file = file.string(),
                            .position = std::move(position),
                            .value = std::move(value),
                            .expected = std::move(expected)});
}

std::string line(const OrderedJson& json) {
    return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

/// Numbers that read back exactly, those that are none included.
std::string rowText(const std::vector<double>& row) {
    return fmt::format("{}", fmt::join(row, ","));
}

JsonReader caseLineOf(const std::string& text, const std::string& where) {
    return {text, where, {.expected = "a line of cases (JSON)"}, irsg::JsonErrors::throwFirst};
}

std::vector<double> rowOf(const JsonReader& json) {
    const std::string text = json.text();
    std::vector<double> row;
    if (text.empty())
        return row; // of a case without a row
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        constexpr double infinity = std::numeric_limits<double>::infinity();
        if (const auto number = irsg::parseNumber(word))
            row.push_back(*number);
        else if (word == "nan" || word == "-nan")
            row.push_back(std::numeric_limits<double>::quiet_NaN());
        else if (word == "inf" || word == "-inf")
            row.push_back(word == "inf" ? infinity : -infinity);
        else
            json.refuse("numbers separated by commas");
        begin = end + 1;
    }
    return row;
}

double numberOf(const JsonReader& json) {
    const std::vector<double> one = rowOf(json);
    if (one.size() != 1)
        json.refuse("a number");
    return one.front();
}

/// What a result says of itself before its first case.
OrderedJson headOf(const AnalysisData& data, std::size_t cases, const CaseFile::Options& options) {
    OrderedJson columns = OrderedJson::array(), provenance = OrderedJson::array();
    for (const ResultColumn& column : data.table.columns())
        columns.push_back({{"name", column.key}, {"unit", column.unit}});
    for (const auto& [key, value] : data.table.provenance.entries)
        provenance.push_back({{"key", key}, {"value", value}});
    return {{"format", format},        {"part", options.share.part}, {"parts", options.share.parts},
            {"cases", cases},          {"columns", columns},         {"inputs", options.inputs},
            {"provenance", provenance}};
}

/// A file of cases as it was read.
struct Read {
    fs::path file;
    OrderedJson head;
    std::map<std::size_t, CaseRecord> records;
    std::uintmax_t whole_B = 0;
    CaseShare share() const { return {head["part"], head["parts"]}; }
    std::size_t cases() const { return head["cases"]; }
};

CaseRecord recordOf(const JsonReader& json, const std::vector<std::string>& lastAnswers) {
    CaseRecord record{json.at("place").text(), rowOf(json.at("row")), lastAnswers, {}};
    if (json.has("answered"))
        record.providedBy = json.at("answered").texts();
    for (const JsonReader& remark : json.at("remarks").listOrNone()) {
        const CaseRemark one{remark.at("kind").text(), remark.at("sentence").text(),
                             numberOf(remark.at("value"))};
        record.remarks.push_back(one);
    }
    return record;
}

OrderedJson jsonOf(std::size_t i, const CaseRecord& record, bool withAnswers) {
    OrderedJson json{{"case", i}, {"place", record.place}, {"row", rowText(record.row)}};
    if (withAnswers)
        json["answered"] = record.providedBy;
    for (const CaseRemark& remark : record.remarks)
        json["remarks"].push_back({{"kind", remark.kind},
                                   {"sentence", remark.sentence},
                                   {"value", fmt::format("{}", remark.value)}});
    return json;
}

void checkHead(const JsonReader& head) {
    const JsonReader version = head.at("format");
    if (version.text() != format)
        version.refuse(format);
    for (const char* key : {"part", "parts", "cases"}) {
        const JsonReader number = head.at(key);
        const double value = number.number();
        if (!(value >= 1.0 && value <= mostCasesOfFile && value == std::floor(value)))
            number.refuse("a whole number from 1 to 1e7");
    }
    for (const JsonReader& column : head.at("columns").list()) {
        column.at("name").text();
        column.at("unit").text();
    }
    for (const JsonReader& entry : head.at("provenance").list()) {
        entry.at("key").text();
        entry.at("value").text();
    }
    if (!head.has("inputs"))
        head.refuse("the files that the cases follow from");
    for (const auto& [file, hash] : head.at("inputs").members())
        hash.text();
}

Read readCases(const fs::path& file) {
    const std::string text = irsg::readFile(file);
    Read read;
    read.file = file;
    std::vector<std::string> lastAnswers;
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin);
        if (end == std::string::npos)
            break; // cut off when its run was ended
        const std::string where = fmt::format("{}:{}", file.string(), ++number);
        const JsonReader json = caseLineOf(text.substr(begin, end - begin), where);
        if (number == 1) {
            checkHead(json);
            read.head = OrderedJson::parse(text.substr(begin, end - begin));
        } else {
            CaseRecord record = recordOf(json, lastAnswers);
            const JsonReader place = json.at("case");
            const double i = place.number();
            if (!(i >= 0.0 && i < static_cast<double>(read.cases()) && i == std::floor(i)))
                place.refuse(fmt::format("a case from 0 to {}", read.cases() - 1));
            if (!record.row.empty() && record.row.size() != read.head["columns"].size())
                json.at("row").refuse(fmt::format("{} numbers", read.head["columns"].size()));
            lastAnswers = record.providedBy;
            read.records[static_cast<std::size_t>(i)] = std::move(record);
        }
        read.whole_B = begin = end + 1;
    }
    return read;
}

/// What two runs of one sweep have in common.
OrderedJson identityOf(OrderedJson head) {
    head.erase("part");
    head.erase("parts");
    std::erase_if(head["provenance"].get_ref<OrderedJson::array_t&>(),
                  [](const OrderedJson& entry) {
                      return entry["key"] == "command" || entry["key"] == "project";
                  });
    return head;
}

std::string brief(const OrderedJson& json) {
    const std::string text = json.is_string() ? json.get<std::string>() : json.dump();
    return text.size() > 120 ? text.substr(0, 117) + "..." : text;
}

/// The first thing in which two sweeps differ: what it is, the one's and the other's.
struct Mismatch {
    std::string what, one, other;
};
std::optional<Mismatch> mismatchOf(const OrderedJson& oneHead, const OrderedJson& otherHead) {
    const OrderedJson one = identityOf(oneHead), other = identityOf(otherHead);
    if (one == other)
        return std::nullopt;
    for (const char* key : {"cases", "columns"})
        if (one[key] != other[key])
            return Mismatch{key, brief(one[key]), brief(other[key])};
    std::map<std::string, std::pair<std::string, std::string>> values;
    const auto collect = [&](const OrderedJson& head, bool isFirst) {
        for (const auto& [file, hash] : head["inputs"].items()) {
            auto& both = values["content of " + file];
            (isFirst ? both.first : both.second) = "SHA-256 " + hash.get<std::string>();
        }
        for (const OrderedJson& entry : head["provenance"]) {
            auto& both = values[entry["key"]];
            (isFirst ? both.first : both.second) += entry["value"].get<std::string>() + " ";
        }
    };
    collect(one, true);
    collect(other, false);
    for (const auto& [key, both] : values)
        if (both.first != both.second) {
            const auto orNone = [](const std::string& text) {
                return text.empty() ? std::string("nothing") : std::string(irsg::trimmed(text));
            };
            return Mismatch{key, orNone(both.first), orNone(both.second)};
        }
    return Mismatch{"provenance", "entries in one order", "another"};
}

} // namespace

std::size_t CaseShare::partOf(std::size_t i, std::size_t cases) const {
    const std::size_t runs = std::min(cases, parts * runsOfPart);
    return (i * runs / cases) % parts + 1;
}

bool CaseShare::has(std::size_t i, std::size_t cases) const {
    return i < cases && partOf(i, cases) == part;
}

CaseShare CaseShare::fromText(std::string_view text, const std::string& option) {
    const std::size_t slash = text.find('/');
    const auto part = irsg::parseNumber(text.substr(0, slash));
    const auto parts =
        slash == std::string_view::npos ? std::nullopt : irsg::parseNumber(text.substr(slash + 1));
    const auto isCount = [](double value) {
        return value >= 1.0 && value <= 1e6 && value == std::floor(value);
    };
    if (!part || !parts || !isCount(*part) || !isCount(*parts) || *part > *parts)
        throw irsg::InputError({.file = option,
                                .position = "",
                                .value = std::string(text),
                                .expected = "PART/PARTS, such as 2/4, from 1/4 to 4/4"});
    return {static_cast<std::size_t>(*part), static_cast<std::size_t>(*parts)};
}

fs::path CaseFile::besides(const fs::path& result, const CaseShare& share) {
    fs::path file = result;
    file +=
        share.isAll() ? std::string(".cases") : fmt::format(".part{}of{}", share.part, share.parts);
    return file;
}

CaseFile::CaseFile(fs::path file, Options options)
    : file_(std::move(file)), options_(std::move(options)) {
    existed_ = fs::exists(file_);
    if (!existed_ || !options_.resumes)
        return;
    Read read = readCases(file_);
    whole_B_ = read.whole_B;
    known_ = std::move(read.records);
    head_ = read.head.is_null() ? "" : line(read.head);
    if (head_.empty())
        existed_ = false; // ended before the first line was whole
    else if (read.share() != options_.share)
        refuse(file_, "part", fmt::format("{}/{}", read.share().part, read.share().parts),
               fmt::format("part {}/{}", options_.share.part, options_.share.parts));
}

void CaseFile::begin(const AnalysisData& data, std::size_t cases) {
    cases_ = cases;
    const OrderedJson head = headOf(data, cases, options_);
    if (options_.resumes && existed_) {
        checkResumed(line(head));
        fs::resize_file(file_, whole_B_);
        out_.open(file_, std::ios::app | std::ios::binary);
        options_.waits_s = 0.0;
        return;
    }
    if (existed_) {
        fs::rename(file_, oldFile());
        keptOld_ = true;
    }
    write(head_ = line(head));
}

void CaseFile::rehearse(const AnalysisData& data, std::size_t cases) {
    cases_ = cases;
    if (options_.resumes && existed_)
        checkResumed(headText(data, cases, options_));
}

void CaseFile::checkResumed(const std::string& head) const {
    if (const auto mismatch = mismatchOf(OrderedJson::parse(head_), OrderedJson::parse(head)))
        refuse(file_, mismatch->what, mismatch->one,
               mismatch->other + ", as this run has it: what is resumed must be the same");
}

const CaseRecord* CaseFile::known(std::size_t i) const {
    const auto found = known_.find(i);
    return found == known_.end() ? nullptr : &found->second;
}

void CaseFile::add(std::size_t i, const CaseRecord& record) {
    // What is as in the line before is not said again.
    const bool isSaid = record.providedBy != std::exchange(lastAnswers_, record.providedBy);
    write(line(jsonOf(i, record, isSaid)));
}

std::string CaseFile::headText(const AnalysisData& data, std::size_t cases,
                               const Options& options) {
    return line(headOf(data, cases, options));
}

std::string CaseFile::recordText(std::size_t i, const CaseRecord& record) {
    return line(jsonOf(i, record, true));
}

std::pair<std::size_t, CaseRecord> CaseFile::recordFrom(const std::string& text,
                                                        const std::string& who) {
    const JsonReader json = caseLineOf(text, who);
    return {json.at("case").count(static_cast<std::size_t>(mostCasesOfFile)), recordOf(json, {})};
}

void CaseFile::checkSameSweep(const std::string& head, const std::string& who) const {
    if (const auto mismatch = mismatchOf(OrderedJson::parse(head_), OrderedJson::parse(head)))
        throw irsg::InputError(
            {who, mismatch->what, mismatch->other, mismatch->one + ", as all others have it"});
}

void CaseFile::write(const std::string& text) {
    pending_ += text;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    if (out_.is_open() || passed.count() >= options_.waits_s)
        flush();
}

void CaseFile::flush() {
    if (!out_.is_open())
        out_.open(file_, std::ios::binary);
    out_ << pending_ << std::flush;
    pending_.clear();
    if (!out_)
        refuse(file_, "", "a place that takes no more", "room for the cases of a sweep");
}

void CaseFile::remove() {
    out_.close();
    pending_.clear();
    std::error_code ignored;
    fs::remove(file_, ignored);
    fs::remove(oldFile(), ignored);
    keptOld_ = false;
}

fs::path CaseFile::oldFile() const {
    fs::path old = file_;
    old += ".old";
    return old;
}

std::vector<std::string> CaseFile::remarksOn(const std::string& cases) const {
    if (!keptOld_)
        return {};
    return {cases + " of an earlier run are kept as " + file_.string() +
            ".old; --resume goes on with them"};
}

AnalysisData joinedCases(const std::vector<fs::path>& files) {
    if (files.empty())
        throw irsg::LogicError("no files of cases to join");
    std::vector<Read> parts;
    for (const fs::path& file : files) {
        parts.push_back(readCases(file));
        if (parts.back().head.is_null())
            refuse(file, "line 1", "a file that was cut off", "the cases of a sweep");
        if (const auto mismatch = mismatchOf(parts.front().head, parts.back().head))
            refuse(file, mismatch->what, mismatch->other,
                   mismatch->one + ", as in " + files.front().string());
    }
    const OrderedJson& head = parts.front().head;
    ResultTable table;
    for (const OrderedJson& column : head["columns"])
        table.add(column["name"].get<std::string>(), column["unit"].get<std::string>());
    std::vector<std::string> providedBy, before;
    for (const OrderedJson& entry : head["provenance"])
        if (entry["key"] == "answered by")
            providedBy.push_back(entry["value"]);
        else if (entry["key"] == "warning")
            before.push_back(entry["value"]);
    // Frames of a scenario are no sweep, whose warnings name their cases.
    const bool isOfScenario = std::ranges::any_of(head["provenance"], [](const OrderedJson& entry) {
        return entry["key"] == "analysis" && entry["value"] == name(AnalysisKind::simulation);
    });
    CaseWarnings warnings(isOfScenario ? CaseWarnings::Telling::once
                                       : CaseWarnings::Telling::byCase);
    std::size_t missing = 0;
    const CaseShare share = parts.front().share();
    std::vector<bool> isOpen(share.parts);
    for (std::size_t i = 0; i < parts.front().cases(); ++i) {
        const CaseRecord* found = nullptr;
        for (const Read& part : parts) {
            const auto own = part.records.find(i);
            if (own == part.records.end())
                continue;
            if (found && found->row != own->second.row &&
                rowText(found->row) != rowText(own->second.row))
                refuse(part.file, fmt::format("case {} ({})", i, found->place),
                       rowText(own->second.row), rowText(found->row) + ", as in another file");
            found = &own->second;
        }
        if (!found) {
            ++missing;
            isOpen[share.partOf(i, parts.front().cases()) - 1] = true;
            continue;
        }
        if (!found->row.empty())
            table.addRow(found->row, rowWarning(found->remarks));
        irsg::addProvider(providedBy, found->providedBy);
        warnings.addCase(found->place, found->remarks);
    }
    if (missing > 0) {
        constexpr std::size_t mostNames = 100;
        const std::size_t of = share.parts;
        std::string names;
        std::size_t named = 0;
        for (std::size_t part = 0; part < of; ++part)
            if (isOpen[part] && ++named <= mostNames)
                names += fmt::format("{}{}/{}", named > 1 ? ", " : "", part + 1, of);
        if (named > mostNames)
            names += fmt::format(" and {} more", named - mostNames);
        refuse(files.front(), "",
               fmt::format("{} of {} cases without a result", missing, parts.front().cases()),
               "every case once; " +
                   (of == 1 ? std::string("the run is not finished")
                            : "not finished or not given: part " + names) +
                   " (--resume goes on with it)");
    }
    irsg::appendUnique(before, warnings.sentences());
    for (const OrderedJson& entry : head["provenance"]) {
        const std::string key = entry["key"];
        if (key == "state")
            table.provenance.add(key, "complete");
        else if (key != "command" && key != "answered by" && key != "warning")
            table.provenance.add(key, entry["value"]);
    }
    for (const std::string& answer : providedBy)
        table.provenance.add("answered by", answer);
    for (const std::string& warning : before)
        table.provenance.add("warning", warning);
    return resultOf(std::move(table), files.front().string());
}

std::map<std::string, std::string> inputHashes() {
    std::map<std::string, std::string> hashes;
    for (const fs::path& file : irsg::inputsRead()) {
        std::string& hash = hashes[file.filename().string()];
        hash += (hash.empty() ? "" : " ") + fileHash(file);
    }
    return hashes;
}

} // namespace smat
