#include "smatcore/data/ResultTable.h"

#include <algorithm>
#include <cctype>
#include <fstream>

#include <fmt/format.h>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/JsonReader.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/support/TextFile.h"

namespace smat {

namespace {

/// "range [m]" -> {"range", "m"}.
std::pair<std::string, std::string> splitHeader(const std::string& header) {
    const std::size_t open = header.rfind(" [");
    if (open == std::string::npos || header.back() != ']')
        return {header, ""};
    return {header.substr(0, open), header.substr(open + 2, header.size() - open - 3)};
}

/// The name of the column of texts.
constexpr std::string_view warningColumn = "warning";

/// A text as one cell on one line.
std::string quotedCell(const std::string& text) {
    if (text.empty())
        return text;
    std::string cell = "\"";
    for (const char letter : text) {
        if (letter == '"')
            cell += '"';
        cell += letter == '\n' || letter == '\r' ? ' ' : letter;
    }
    return cell + '"';
}

/// A name as a cell, in quotes where it needs them.
std::string headCell(const std::string& name) {
    return name.find_first_of(",;\t\"#'") == std::string::npos ? name : quotedCell(name);
}

} // namespace

std::string ResultColumn::header() const {
    // A name that ends in brackets has no unit in them.
    return unit.empty() && splitHeader(key).first == key ? key : key + " [" + unit + "]";
}

std::string ResultColumn::axisTitle() const {
    // "error_contrast_intensity" is the error of what the rest of the key names.
    static constexpr std::pair<std::string_view, std::string_view> prefixes[] = {
        {"error_", "Error of "},
        {"error_sampling_", "Error by sampling of "},
        {"error_air_", "Error by air of "},
        {"error_background_", "Error by background of "},
        {"error_exchange_", "Error by inter-reflection of "},
        {"relative_difference_", "Relative difference of "},
        {"difference_", "Difference of "}};
    const ColumnName parts = ColumnName::of(key);
    std::string label;
    for (const auto& [prefix, words] : prefixes)
        if (parts.prefix == prefix)
            label = words;
    const std::optional<irsg::Quantity> known = irsg::quantityOfKey(parts.quantity);
    const irsg::QuantityInfo* quantity = known ? &irsg::info(*known) : nullptr;
    std::string name(quantity != nullptr ? quantity->label : std::string_view(parts.quantity));
    if (quantity == nullptr && !name.empty()) {
        // A key of somebody else's file is read as words: "time_per_frame" is "Time per frame".
        std::ranges::replace(name, '_', ' ');
        name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    }
    if (!label.empty() && !name.empty())
        name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    label += name;
    if (const std::string which = parts.which(); !which.empty())
        label += ", " + which;
    const std::string pretty =
        quantity != nullptr && quantity->unit == unit ? std::string(quantity->prettyUnit) : unit;
    return pretty.empty() ? label : label + " (" + pretty + ")";
}

ResultColumn& ResultTable::add(irsg::Quantity quantity) {
    const irsg::QuantityInfo& entry = irsg::info(quantity);
    return add(std::string(entry.key), std::string(entry.unit));
}

ResultColumn& ResultTable::add(std::string key, std::string unit) {
    columns_.push_back({std::move(key), std::move(unit), std::vector<double>(rowCount(), 0.0)});
    return columns_.back();
}

const ResultColumn* ResultTable::find(std::string_view key) const {
    const auto found = std::find_if(columns_.begin(), columns_.end(),
                                    [&](const ResultColumn& column) { return column.key == key; });
    return found == columns_.end() ? nullptr : &*found;
}

const ResultColumn* ResultTable::find(irsg::Quantity quantity) const {
    return find(irsg::info(quantity).key);
}

void ResultTable::addRow(const std::vector<double>& values, std::string warning) {
    insertRow(rowCount(), values, std::move(warning));
}

void ResultTable::insertRow(std::size_t at, const std::vector<double>& values,
                            std::string warning) {
    if (values.size() != columns_.size() || at > rowCount())
        throw irsg::LogicError("a row of a result table needs one value per column, and a place");
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::vector<double>& column = columns_[i].values;
        column.insert(column.begin() + static_cast<std::ptrdiff_t>(at), values[i]);
    }
    if (!warnings_.empty())
        warnings_.insert(warnings_.begin() + static_cast<std::ptrdiff_t>(at), std::string());
    setWarning(at, std::move(warning));
}

std::string ResultTable::warningOf(std::size_t row) const {
    if (row >= rowCount())
        throw irsg::LogicError("a result table has no such row");
    return warnings_.empty() ? std::string() : warnings_[row];
}

void ResultTable::setWarning(std::size_t row, std::string warning) {
    if (row >= rowCount())
        throw irsg::LogicError("a result table has no such row");
    if (warnings_.empty() && warning.empty())
        return;
    warnings_.resize(rowCount());
    warnings_[row] = std::move(warning);
}

std::string ResultTable::toCsv() const {
    std::string text = provenance.toCsvLines();
    for (std::size_t i = 0; i < columns_.size(); ++i)
        text += (i == 0 ? "" : ",") + headCell(columns_[i].header());
    text += warnings_.empty() ? "\n" : fmt::format(",{}\n", warningColumn);
    for (std::size_t row = 0; row < rowCount(); ++row) {
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            // The shortest digits that read back as the same double.
            text += fmt::format("{}{}", i == 0 ? "" : ",", columns_[i].values[row]);
        }
        text += warnings_.empty() ? "\n" : "," + quotedCell(warnings_[row]) + "\n";
    }
    return text;
}

void ResultTable::save(const std::filesystem::path& file) const {
    writeTextFile(file, file.extension() == ".json" ? toJson() : toCsv());
}

ResultTable ResultTable::load(const std::filesystem::path& file) {
    if (file.extension() != ".json")
        return fromCsv(file);
    return fromJson({readTextFile(file),
                     file.string(),
                     {.expected = "a result table (JSON)"},
                     irsg::JsonErrors::throwFirst});
}

ResultTable ResultTable::fromCsv(const std::filesystem::path& file) {
    const irsg::CsvTable csv = irsg::CsvTable::read(file);
    std::vector<irsg::Diagnostic> diagnostics;
    ResultTable table;
    for (const irsg::CsvComment& comment : csv.comments())
        table.provenance.add(comment.key, comment.value);
    if (csv.rows().empty())
        throw irsg::InputError(csv.diagnostic("no rows", "a header row of names with units"));

    // A header row names columns; one made of a number was meant as data.
    const std::vector<irsg::CsvCell>& header = csv.rows().front().cells;
    const bool hasWarnings = header.size() > 1 && header.back().text == warningColumn;
    for (const irsg::CsvCell& cell : header) {
        if (hasWarnings && &cell == &header.back())
            continue;
        if (cell.text.empty() || irsg::parseNumber(cell.text))
            diagnostics.push_back(csv.diagnostic(cell, "the name of a column"));
        else if (table.find(splitHeader(cell.text).first) != nullptr)
            diagnostics.push_back(csv.diagnostic(cell, "a name that no other column has"));
        const auto [key, unit] = splitHeader(cell.text);
        table.add(key, unit);
    }
    for (std::size_t row = 1; row < csv.rows().size(); ++row) {
        const irsg::CsvRow& line = csv.rows()[row];
        if (line.cells.size() != header.size()) {
            diagnostics.push_back(csv.diagnostic(line.line,
                                                 fmt::format("{} cells", line.cells.size()),
                                                 fmt::format("{} cells", header.size())));
            continue;
        }
        for (std::size_t i = 0; i < table.columns_.size(); ++i) {
            const irsg::CsvCell& cell = line.cells[i];
            // A quantity without a value (a temperature of no radiance) is written as nan.
            const std::optional<double> value = cell.text == "nan"
                                                    ? std::numeric_limits<double>::quiet_NaN()
                                                    : csv.number(cell, diagnostics, "a number");
            table.columns_[i].values.push_back(value.value_or(0.0));
        }
        if (hasWarnings)
            table.setWarning(table.rowCount() - 1, line.cells.back().text);
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return table;
}

} // namespace smat
