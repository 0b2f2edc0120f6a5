#include "tools/atmosphere-tables/DataTable.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iostream>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"

namespace smat::tables {

namespace {

using irsg::Diagnostic;
using irsg::InputError;

/// Seven digits: more than any of the sources has, without the noise of a change of unit.
std::string digits(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 7);
    return {text, end.ptr};
}

} // namespace

const std::vector<double>& Table::column(const std::string& name) const {
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        throw InputError(Diagnostic{file, "header", "no column " + name, name});
    return columns[static_cast<std::size_t>(found - names.begin())];
}

double Table::at(const std::string& name, double first) const {
    const std::vector<double>& axis = columns.front();
    const std::vector<double>& values = column(name);
    if (axis.empty() || first < axis.front() || first > axis.back())
        return 0.0;
    return irsg::interpolate(axis, values, first);
}

Table readTable(const std::filesystem::path& file) {
    const irsg::CsvTable csv = irsg::CsvTable::read(file);
    Table table;
    table.file = file.string();
    std::vector<Diagnostic> diagnostics;
    for (const irsg::CsvRow& row : csv.rows()) {
        if (table.names.empty()) {
            for (const irsg::CsvCell& cell : row.cells)
                table.names.push_back(cell.text);
            table.columns.resize(table.names.size());
            continue;
        }
        if (row.cells.size() != table.names.size()) {
            diagnostics.push_back(csv.diagnostic(row.line,
                                                 std::to_string(row.cells.size()) + " cells",
                                                 std::to_string(table.names.size()) + " cells"));
            continue;
        }
        for (std::size_t i = 0; i < row.cells.size(); ++i)
            if (const auto value = csv.number(row.cells[i], diagnostics))
                table.columns[i].push_back(*value);
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return table;
}

void Writer::add(std::string name, std::vector<double> values) {
    names_.push_back(std::move(name));
    columns_.push_back(std::move(values));
}

void Writer::write(const std::filesystem::path& file, const std::string& header, double lowest,
                   double highest) const {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream stream(file);
    stream << header << source_;
    for (std::size_t i = 0; i < names_.size(); ++i)
        stream << (i ? "," : "") << names_[i];
    stream << "\n";
    std::size_t rows = 0;
    for (std::size_t row = 0; row < columns_.front().size(); ++row) {
        if (columns_.front()[row] < lowest || columns_.front()[row] > highest)
            continue;
        for (std::size_t i = 0; i < columns_.size(); ++i)
            stream << (i ? "," : "") << digits(columns_[i].at(row));
        stream << "\n";
        ++rows;
    }
    stream.close();
    if (!stream)
        throw InputError(Diagnostic{file.string(), "", "cannot be written", "a writable folder"});
    std::cout << file.string() << ": " << rows << " rows of " << names_.size() << " columns\n";
}

} // namespace smat::tables
