#include "irsg/signature/LibraryNodes.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "irsg/core/ColumnText.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"

namespace irsg {

void refuseLibrary(const std::string& file, int line, const std::string& value,
                   const std::string& expected) {
    throw InputError({file, line > 0 ? "line " + std::to_string(line) : "", value, expected});
}

std::vector<double> numbersOfLine(std::string_view line) {
    std::vector<ColumnCell> cells;
    std::vector<double> numbers;
    const char separator = line.find(',') != std::string_view::npos ? ',' : ' ';
    if (!splitColumns(trimmed(line), separator, cells))
        return {};
    for (const ColumnCell& cell : cells) {
        const std::optional<std::string> plain = plainNumber(cell.text, '.');
        const std::optional<double> number = plain ? parseNumber(*plain) : std::nullopt;
        if (!number)
            return {};
        numbers.push_back(*number);
    }
    return numbers;
}

std::string beginningOf(std::string_view text, int lines) {
    std::string beginning;
    for (int i = 0; i < lines && !text.empty(); ++i)
        (beginning += lowerCase(std::string(takeLine(text)))) += '\n';
    return beginning;
}

LibrarySpectrum::Column libraryColumn(LibraryNodes nodes, SpectralAxis axis,
                                      LibrarySpectrum::Quantity quantity, double factor,
                                      const std::string& file) {
    if (nodes.positions.size() < 2)
        refuseLibrary(file, 0, std::to_string(nodes.positions.size()) + " rows of numbers",
                      "at least two rows of numbers");
    for (std::size_t i = 0; i < nodes.positions.size(); ++i)
        if (!(nodes.positions[i] > 0.0))
            refuseLibrary(file, nodes.lines[i], numberText(nodes.positions[i]),
                          "a positive axis value");
    LibrarySpectrum::Column column;
    column.quantity = quantity;
    for (std::size_t i = 0; i < nodes.positions.size(); ++i) {
        column.wavelengths_um.push_back(wavelengthOn_um(axis, nodes.positions[i]));
        column.values.push_back(factor * nodes.values[i]);
        column.lines.push_back(nodes.lines[i]);
    }
    if (column.wavelengths_um.back() < column.wavelengths_um.front()) {
        std::ranges::reverse(column.wavelengths_um);
        std::ranges::reverse(column.values);
        std::ranges::reverse(column.lines);
    }
    for (std::size_t i = 1; i < column.wavelengths_um.size(); ++i)
        if (!(column.wavelengths_um[i] > column.wavelengths_um[i - 1]))
            refuseLibrary(file, column.lines[i], numberText(column.wavelengths_um[i]) + " um",
                          "a strictly monotonic axis");
    return column;
}

} // namespace irsg
