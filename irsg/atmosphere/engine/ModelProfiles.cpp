#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"

namespace irsg {

namespace {

constexpr double tabulatedCo2_ppmv = 330.0;
constexpr std::array modelNames = {"tropical",         "midlatitude summer", "midlatitude winter",
                                   "subarctic summer", "subarctic winter",   "US standard 1976"};

using LevelsOfModels = std::map<int, std::vector<AtmosphericState>>;

std::vector<std::string> columnsOfTable() {
    std::vector<std::string> columns = {"atmosphere", "altitude [m]", "pressure [hPa]",
                                        "temperature [K]"};
    for (const char* gas : gasNames)
        columns.push_back(std::string(gas) + " [ppmv]");
    return columns;
}

void readRow(const CsvTable& table, const CsvRow& row, LevelsOfModels& models,
             std::vector<Diagnostic>& diagnostics) {
    std::array<double, 4 + gasCount> values{};
    if (row.cells.size() != values.size()) {
        diagnostics.push_back(table.diagnostic(row.line,
                                               std::to_string(row.cells.size()) + " cells",
                                               std::to_string(values.size()) + " cells"));
        return;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = table.number(row.cells[i], diagnostics);
        if (!value)
            return;
        values[i] = *value;
    }
    const int model = static_cast<int>(std::clamp(values[0], 0.0, 7.0));
    if (model < 1 || model > 6 || model != values[0]) {
        diagnostics.push_back(table.diagnostic(row.cells[0], "an atmosphere from 1 to 6"));
        return;
    }
    AtmosphericState level{values[1], values[2], values[3], {}};
    for (std::size_t gas = 0; gas < gasCount; ++gas)
        level.moleFraction[gas] = 1e-6 * values[4 + gas];
    models[model].push_back(level);
}

LevelsOfModels readModels() {
    const CsvTable table = CsvTable::read(atmosphereResource("profiles.csv"));
    std::vector<Diagnostic> diagnostics;
    LevelsOfModels models;
    const std::vector<std::string> columns = columnsOfTable();
    if (table.rows().empty() ||
        !std::ranges::equal(table.rows().front().cells, columns, {}, &CsvCell::text)) {
        std::string wanted;
        for (const std::string& column : columns)
            wanted += (wanted.empty() ? "" : ", ") + column;
        throw InputError(table.diagnostic("another header", "the columns " + wanted));
    }
    for (std::size_t i = 1; i < table.rows().size(); ++i)
        readRow(table, table.rows()[i], models, diagnostics);
    for (int model = 1; model <= 6; ++model)
        if (!models.contains(model))
            diagnostics.push_back(table.diagnostic("no rows of atmosphere " + std::to_string(model),
                                                   "levels of atmospheres 1 to 6"));
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return models;
}

} // namespace

Profile Profile::model(ModelAtmosphere model, double co2_ppmv) {
    if (!(co2_ppmv >= 0.0 && co2_ppmv <= 1e5))
        throw InputError(
            Diagnostic{"atmosphere", "co2_ppmv", numberText(co2_ppmv), "0 to 100000 ppmv"});
    static const LevelsOfModels models = readModels();
    const int number = static_cast<int>(model);
    if (number < 1 || number > 6)
        throw InputError(
            Diagnostic{"atmosphere", "model", std::to_string(number), "an atmosphere from 1 to 6"});

    std::vector<AtmosphericState> levels = models.at(number);
    for (AtmosphericState& level : levels)
        level.moleFraction[static_cast<std::size_t>(Gas::CO2)] *= co2_ppmv / tabulatedCo2_ppmv;
    return Profile(std::move(levels), modelNames[static_cast<std::size_t>(number - 1)]);
}

} // namespace irsg
