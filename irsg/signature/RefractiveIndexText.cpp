#include "irsg/signature/RefractiveIndexText.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "irsg/core/ColumnText.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Remarks.h"
#include "irsg/radiometry/CurveSampling.h"
#include "irsg/signature/DispersionFormula.h"
#include "irsg/signature/LibraryNodes.h"

namespace irsg {

namespace {

using Quantity = LibrarySpectrum::Quantity;
using Column = LibrarySpectrum::Column;

/// A data set on its way to columns.
struct IndexData {
    std::vector<Quantity> quantities; ///< of a table
    LibraryNodes first, second;
    int formula = 0; ///< 0 for a table
    int line = 0;    ///< of its type
    int coefficientsLine = 0;
    std::vector<double> range_um, coefficients;
};

/// Numbers between blanks behind a colon; refused where anything else stands there.
std::vector<double> numbersBehindColon(std::string_view line, int number, const std::string& file) {
    const std::string_view text = trimmed(line.substr(line.find(':') + 1));
    std::vector<double> numbers = numbersOfLine(text);
    if (numbers.empty())
        refuseLibrary(file, number, "'" + std::string(text.substr(0, 60)) + "'",
                      "numbers between blanks");
    return numbers;
}

void checkFormula(const IndexData& data, const std::string& file) {
    const std::vector<double>& range_um = data.range_um;
    if (range_um.size() != 2 || !(range_um[0] > 0.0) || !(range_um[1] > range_um[0]))
        refuseLibrary(file, data.line, "formula " + std::to_string(data.formula),
                      "a wavelength_range of two ascending wavelengths in um with it");
    const std::size_t most = mostCoefficients(data.formula);
    if (data.coefficients.empty() || data.coefficients.size() > most)
        refuseLibrary(file, data.coefficientsLine > 0 ? data.coefficientsLine : data.line,
                      std::to_string(data.coefficients.size()) + " coefficients",
                      "1 to " + std::to_string(most) + " for formula " +
                          std::to_string(data.formula));
}

/// A formula as a table whose straight pieces follow it to 1e-5, the last digit of such formulas.
Column formulaColumn(const IndexData& data, const std::string& file) {
    checkFormula(data, file);
    constexpr double greatestIndex = 1000.0, tolerance = 1e-5;
    constexpr std::size_t mostNodes = 200000;
    std::size_t nodes = 0;
    const auto index = [&](double wavelength_um) {
        const double n = dispersionIndex(data.formula, data.coefficients, wavelength_um);
        if (!(n > 0.0) || n > greatestIndex || ++nodes > mostNodes)
            refuseLibrary(file, data.coefficientsLine,
                          (std::isnan(n) ? "no n" : "n = " + numberText(n)) + " at " +
                              numberText(wavelength_um) + " um",
                          "a smooth index above 0, up to 1000, over its range");
        return n;
    };
    // Between few nodes a pole may hide.
    const std::vector<double>& range_um = data.range_um;
    constexpr int steps = 1000, parts = 8;
    std::vector<double> kinks;
    for (int i = 0; i <= steps; ++i) {
        const double wavelength_um = std::lerp(range_um[0], range_um[1], i / double{steps});
        index(wavelength_um);
        if (i % (steps / parts) == 0 && (kinks.empty() || wavelength_um > kinks.back()))
            kinks.push_back(wavelength_um);
    }
    const Spectrum sampled = sampledCurve(index, kinks, tolerance);
    remarkOn(file, "n is formula " + std::to_string(data.formula) +
                       " of refractiveindex.info from " + numberText(range_um[0]) + " to " +
                       numberText(range_um[1]) + " um");
    Column column;
    column.quantity = Quantity::refractiveIndex;
    column.wavelengths_um = sampled.wavelengths_um();
    column.values = sampled.values();
    column.lines.assign(column.values.size(), data.coefficientsLine);
    return column;
}

/// The columns of a data set behind those before it, each quantity once.
void addIndexColumns(IndexData& data, const std::string& file, std::vector<Column>& columns) {
    std::vector<Column> added;
    if (data.formula > 0)
        added.push_back(formulaColumn(data, file));
    for (std::size_t i = 0; i < data.quantities.size(); ++i)
        added.push_back(libraryColumn(i == 0 ? data.first : data.second, SpectralAxis::wavelength,
                                      data.quantities[i], 1.0, file));
    for (Column& column : added) {
        if (std::ranges::find(columns, column.quantity, &Column::quantity) != columns.end())
            refuseLibrary(file, data.line,
                          std::string(column.quantity == Quantity::extinction ? "k" : "n") +
                              " again",
                          "n and k once each");
        columns.push_back(std::move(column));
    }
    data = {};
}

/// What a data set is, by the words behind `type:`.
void takeType(std::string kind, int line, const std::string& file, IndexData& data) {
    std::erase_if(kind, [](char c) { return c == '"' || c == '\''; });
    data.line = line;
    if (kind.size() == 9 && kind.starts_with("formula ") && kind[8] >= '1' &&
        kind[8] < '1' + dispersionFormulas)
        data.formula = kind[8] - '0';
    else if (kind == "tabulated nk")
        data.quantities = {Quantity::refractiveIndex, Quantity::extinction};
    else if (kind == "tabulated n")
        data.quantities = {Quantity::refractiveIndex};
    else if (kind == "tabulated k")
        data.quantities = {Quantity::extinction};
    else
        refuseLibrary(file, line, "'" + kind + "'",
                      "tabulated n, tabulated k, tabulated nk, or formula 1 to " +
                          std::to_string(dispersionFormulas));
}

/// One line of a data set.
void takeIndexLine(std::string_view content, int line, const std::string& file, IndexData& data) {
    if (data.formula > 0) {
        if (content.starts_with("wavelength_range:") || content.starts_with("range:"))
            data.range_um = numbersBehindColon(content, line, file);
        if (content.starts_with("coefficients:")) {
            data.coefficients = numbersBehindColon(content, line, file);
            data.coefficientsLine = line;
        }
        return;
    }
    const std::vector<double> numbers = numbersOfLine(content);
    if (data.quantities.empty() || numbers.empty())
        return;
    if (numbers.size() != data.quantities.size() + 1)
        refuseLibrary(file, line, std::to_string(numbers.size()) + " numbers",
                      std::to_string(data.quantities.size() + 1) + ", as its type says");
    data.first.add(numbers[0], numbers[1], line);
    if (numbers.size() > 2)
        data.second.add(numbers[0], numbers[2], line);
}

/// A formula gives n alone: without a table beside it, k is 0.
void takeNoExtinction(const std::string& file, std::vector<Column>& columns) {
    if (std::ranges::find(columns, Quantity::extinction, &Column::quantity) != columns.end())
        return;
    Column none = columns.front();
    none.quantity = Quantity::extinction;
    none.wavelengths_um = {none.wavelengths_um.front(), none.wavelengths_um.back()};
    none.values = {0.0, 0.0};
    none.lines.resize(2);
    columns.push_back(std::move(none));
    remarkOn(file, "k is 0, as its formula gives n alone");
}

} // namespace

bool beginsAsRefractiveIndex(std::string_view text) {
    const std::string beginning = beginningOf(text, 200);
    return beginning.find("data:") != std::string::npos &&
           (beginning.find("type: tabulated") != std::string::npos ||
            beginning.find("type: formula") != std::string::npos ||
            beginning.find("type: \"tabulated") != std::string::npos ||
            beginning.find("type: \"formula") != std::string::npos);
}

LibrarySpectrum readRefractiveIndex(std::string_view text, const std::string& file) {
    LibrarySpectrum result{.format = "refractiveindex.info", .title = "", .columns = {}};
    IndexData data;
    bool hasFormula = false;
    for (int line = 1; !text.empty(); ++line) {
        const std::string_view content = trimmed(takeLine(text));
        const std::size_t type = content.find("type:");
        if (type == std::string_view::npos) {
            takeIndexLine(content, line, file, data);
            continue;
        }
        addIndexColumns(data, file, result.columns);
        takeType(std::string(trimmed(content.substr(type + 5))), line, file, data);
        hasFormula = hasFormula || data.formula > 0;
    }
    addIndexColumns(data, file, result.columns);
    if (hasFormula)
        takeNoExtinction(file, result.columns);
    return result;
}

} // namespace irsg
