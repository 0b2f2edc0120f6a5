#include "irsg/signature/ReflectanceCsv.h"

#include <array>

#include "irsg/core/Collect.h"
#include "irsg/core/ColumnWords.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/Utf8.h"

namespace irsg {

namespace {

constexpr std::array<const char*, 3> angles = {"incidence_deg", "reflection_deg", "azimuth_deg"};

/// How many of the first columns are angles: 1 or 3.
std::size_t anglesOf(const CsvTable& table, const CsvRow& names,
                     std::vector<Diagnostic>& diagnostics) {
    std::size_t found = 0;
    while (found < angles.size() && found < names.cells.size() &&
           columnHead(names.cells[found].text) == columnHead(angles[found]))
        ++found;
    if (found == 0)
        diagnostics.push_back(
            table.diagnostic(names.cells.front(), "'incidence_deg', the head of the first column"));
    else if (found == 2)
        diagnostics.push_back(
            table.diagnostic(names.line, "two angles", "'azimuth_deg' behind 'reflection_deg'"));
    else if (found == names.cells.size())
        diagnostics.push_back(
            table.diagnostic(names.line, "no wavelength", "wavelengths in um behind the angles"));
    return found;
}

} // namespace

ReflectanceTable readReflectanceTable(const std::filesystem::path& file) {
    const std::string text = readFile(file);
    std::string decoded;
    const std::string zemax(utf8Of(text, decoded));
    if (isZemaxBsdf(zemax))
        return parseZemaxBsdf(zemax, file.string());
    const CsvTable table = CsvTable::parse(text, file.string());
    table.remark();
    std::vector<Diagnostic> diagnostics;
    if (table.rows().size() < 2)
        throw InputError(table.diagnostic("no rows", "a row of names and rows of numbers"));
    const CsvRow& names = table.rows().front();
    const std::size_t fixed = anglesOf(table, names, diagnostics);
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    std::vector<double> wavelengths_um;
    for (std::size_t i = fixed; i < names.cells.size(); ++i)
        wavelengths_um.push_back(
            table.number(names.cells[i], diagnostics, "a wavelength in um").value_or(0.0));
    std::vector<ReflectanceTable::Row> rows;
    for (std::size_t r = 1; r < table.rows().size(); ++r) {
        const CsvRow& row = table.rows()[r];
        if (row.cells.size() != names.cells.size()) {
            diagnostics.push_back(table.diagnostic(row.line,
                                                   std::to_string(row.cells.size()) + " cells",
                                                   std::to_string(names.cells.size())));
            continue;
        }
        std::vector<double> numbers;
        for (const CsvCell& cell : row.cells)
            numbers.push_back(table.number(cell, diagnostics).value_or(0.0));
        rows.push_back({numbers[0],
                        fixed == 3 ? numbers[1] : 0.0,
                        fixed == 3 ? numbers[2] : 0.0,
                        {numbers.begin() + static_cast<std::ptrdiff_t>(fixed), numbers.end()}});
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return editing(
        [&] {
            return ReflectanceTable{fixed == 3, std::move(wavelengths_um), std::move(rows)};
        },
        [&](Diagnostic& one) { one.file = file.string(); });
}

bool isReflectanceTable(const std::filesystem::path& file) {
    try {
        const std::string text = readFile(file);
        std::string decoded;
        if (isZemaxBsdf(std::string(utf8Of(text, decoded))))
            return true;
        const CsvTable table = CsvTable::parse(text, file.string());
        return !table.rows().empty() &&
               columnHead(table.rows().front().cells.front().text) == columnHead(angles[0]);
    } catch (const InputError&) {
        return false;
    }
}

void writeReflectanceCsv(const ReflectanceTable& table, const std::filesystem::path& file) {
    std::string text = table.isBrdf() ? "incidence_deg,reflection_deg,azimuth_deg" : angles[0];
    for (const double wavelength_um : table.wavelengths_um())
        text += "," + numberText(wavelength_um);
    text += "\n";
    for (const ReflectanceTable::Row& row : table.rows()) {
        text += numberText(row.incidence_deg);
        if (table.isBrdf())
            text += "," + numberText(row.reflection_deg) + "," + numberText(row.azimuth_deg);
        for (const double value : row.values)
            text += "," + numberText(value);
        text += "\n";
    }
    writeFileDurably(file, text);
}

} // namespace irsg
