#include "irsg/atmosphere/engine/ParticleTable.h"

#include <algorithm>
#include <optional>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"

namespace irsg {

namespace {

bool contains(const std::string& name, const char* part) {
    return name.find(part) != std::string::npos;
}

/// "rural_abs_rh70" belongs to "rural_ext_rh70".
std::string extinctionOf(std::string absorption) {
    return absorption.replace(absorption.find("_abs"), 4, "_ext");
}

struct Limits {
    double lowest;
    double highest;
    const char* words;
};

Limits limitsOf(ParticleTable::Kind kind, const std::string& column) {
    if (kind == ParticleTable::Kind::logarithms)
        return {-20.0, 20.0, "a logarithm from -20 to 20"};
    if (kind == ParticleTable::Kind::profile)
        return {0.0, 1e6, "a number from 0 to 1e6"};
    if (contains(column, "_asym"))
        return {-1.0, 1.0, "an asymmetry from -1 to 1"};
    if (contains(column, "_ext"))
        return {1e-12, 1e6, "an extinction from 1e-12 to 1e6"};
    return {0.0, 1e6, "an absorption from 0 to 1e6"};
}

/// Where the wanted columns stand in the header row.
std::vector<std::size_t> places(const CsvTable& csv, const CsvRow& header,
                                const std::vector<std::string>& columns) {
    std::vector<std::size_t> result = {0};
    std::vector<Diagnostic> diagnostics;
    for (const std::string& name : columns) {
        const auto found = std::ranges::find(header.cells, name, &CsvCell::text);
        if (found == header.cells.end())
            diagnostics.push_back(
                csv.diagnostic(header.line, "no column " + name, "a column " + name));
        result.push_back(static_cast<std::size_t>(found - header.cells.begin()));
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return result;
}

} // namespace

ParticleTable ParticleTable::read(const std::filesystem::path& file, Kind kind,
                                  const std::vector<std::string>& columns) {
    const CsvTable csv = CsvTable::read(file);
    if (csv.rows().empty())
        throw InputError(csv.diagnostic("no rows", "a header and rows of numbers"));
    const CsvRow& header = csv.rows().front();
    const std::vector<std::size_t> place = places(csv, header, columns);

    ParticleTable table;
    table.names_ = {header.cells.front().text};
    table.names_.insert(table.names_.end(), columns.begin(), columns.end());
    table.columns_.resize(table.names_.size());

    std::vector<Diagnostic> diagnostics;
    for (std::size_t r = 1; r < csv.rows().size(); ++r) {
        const CsvRow& row = csv.rows()[r];
        if (row.cells.size() != header.cells.size()) {
            diagnostics.push_back(csv.diagnostic(row.line,
                                                 std::to_string(row.cells.size()) + " cells",
                                                 std::to_string(header.cells.size()) + " cells"));
            continue;
        }

        // The first column ascends.
        std::vector<double> values;
        const auto first = csv.number(row.cells[0], diagnostics);
        if (first && !table.first().empty() && *first <= table.first().back())
            diagnostics.push_back(csv.diagnostic(
                row.cells[0], "more than the " + numberText(table.first().back()) + " before it"));

        // The others keep to their limits.
        for (std::size_t i = 1; i < place.size(); ++i) {
            const Limits limits = limitsOf(kind, table.names_[i]);
            const CsvCell& cell = row.cells[place[i]];
            const auto value = csv.number(cell, diagnostics, limits.words);
            if (value && (*value < limits.lowest || *value > limits.highest))
                diagnostics.push_back(csv.diagnostic(cell, limits.words));
            values.push_back(value.value_or(0.0));
        }
        table.columns_[0].push_back(first.value_or(0.0));
        for (std::size_t i = 0; i < values.size(); ++i)
            table.columns_[i + 1].push_back(values[i]);

        // Absorption is a part of extinction.
        for (std::size_t i = 1; kind == Kind::optics && i < place.size(); ++i) {
            if (!contains(table.names_[i], "_abs"))
                continue;
            const double extinction = table.column(extinctionOf(table.names_[i])).back();
            if (table.columns_[i].back() > extinction)
                diagnostics.push_back(csv.diagnostic(
                    row.cells[place[i]], "at most the extinction " + numberText(extinction)));
        }
    }

    // What the table covers.
    const bool covers =
        table.first().size() >= 2 &&
        (kind == Kind::profile ? table.first().front() == 0.0
                               : table.first().front() <= 0.2 && table.first().back() >= 40.0);
    if (diagnostics.empty() && !covers)
        diagnostics.push_back(csv.diagnostic(
            std::to_string(table.first().size()) + " rows that do not cover the whole range",
            kind == Kind::profile ? "altitudes from 0 m" : "wavelengths of 0.2 to 40 um"));
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return table;
}

const std::vector<double>& ParticleTable::column(const std::string& name) const {
    const auto found = std::ranges::find(names_, name);
    if (found == names_.end())
        throw LogicError("the table of particles was not asked for a column " + name);
    return columns_[static_cast<std::size_t>(found - names_.begin())];
}

} // namespace irsg
