#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "irsg/atmosphere/engine/AtmosphericState.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/Command.h"

namespace smat::tables {

namespace {

constexpr std::array sources = {"tropical", "mls", "mlw", "sas", "saw", "us76"};
constexpr double top_km = 100.0;

constexpr const char* recipe =
    "# The six model atmospheres: 1 tropical, 2 midlatitude summer, 3 midlatitude winter,\n"
    "# 4 subarctic summer, 5 subarctic winter, 6 US standard 1976\n"
    "# recipe: atmosphere-tables profiles; the stored levels of LOWTRAN 7 up to 100 km, altitudes\n"
    "# in m, other numbers unchanged\n"
    "# source: G. P. Anderson, S. A. Clough, F. X. Kneizys, J. H. Chetwynd, E. P. Shettle, AFGL\n"
    "# Atmospheric Constituent Profiles (0-120 km), AFGL-TR-86-0110, 1986, as stored in LOWTRAN 7\n"
    "# (F. X. Kneizys et al., AFGL-TR-88-0177, 1988); both US Air Force, public domain\n"
    "# units: altitude m, pressure hPa, temperature K, gases ppmv of moist air\n"
    "# error: climatologies of 3 or 4 digits; CO2 is that of 1980 (330 ppmv below 80 km), HNO3 is\n"
    "# the same in all six\n";

std::vector<std::string> wantedColumns() {
    std::vector<std::string> columns = {"altitude_km", "pressure_hPa", "temperature_K"};
    for (const char* gas : irsg::gasNames)
        columns.push_back(std::string(gas) + "_ppmv");
    return columns;
}

/// Where each wanted column stands in a row of the source.
std::vector<std::size_t> positionsOf(const std::vector<std::string>& columns,
                                     const irsg::CsvTable& table) {
    if (table.rows().empty())
        throw irsg::InputError(table.diagnostic("no rows", "a header and levels"));
    const auto& header = table.rows().front().cells;
    std::vector<std::size_t> positions;
    for (const std::string& column : columns) {
        const auto found = std::ranges::find(header, column, &irsg::CsvCell::text);
        if (found == header.end())
            throw irsg::InputError(table.diagnostic("no column " + column, "a column " + column));
        positions.push_back(static_cast<std::size_t>(found - header.begin()));
    }
    return positions;
}

int copyLevels(const irsg::CsvTable& table, std::size_t number, std::ostream& out) {
    const std::vector<std::size_t> positions = positionsOf(wantedColumns(), table);
    std::vector<irsg::Diagnostic> diagnostics;
    int count = 0;
    for (std::size_t i = 1; i < table.rows().size(); ++i) {
        const irsg::CsvRow& row = table.rows()[i];
        if (row.cells.size() != table.rows().front().cells.size()) {
            diagnostics.push_back(table.diagnostic(row.line,
                                                   std::to_string(row.cells.size()) + " cells",
                                                   "as many cells as the header"));
            continue;
        }
        std::vector<double> values;
        for (const std::size_t position : positions)
            values.push_back(table.number(row.cells[position], diagnostics).value_or(0.0));
        if (values.front() > top_km)
            break;
        out << number << "," << irsg::numberText(1000.0 * values.front());
        for (std::size_t k = 1; k < values.size(); ++k)
            out << "," << irsg::numberText(values[k]);
        out << "\n";
        ++count;
    }
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
    return count;
}

} // namespace

void makeProfiles(const Folders& folders) {
    std::filesystem::create_directories(folders.out);
    const std::filesystem::path file = folders.out / "profiles.csv";
    std::ofstream out(file);
    out << recipe << "atmosphere,altitude [m],pressure [hPa],temperature [K]";
    for (const char* gas : irsg::gasNames)
        out << "," << gas << " [ppmv]";
    out << "\n";

    int levels = 0;
    for (std::size_t i = 0; i < sources.size(); ++i)
        levels +=
            copyLevels(irsg::CsvTable::read(folders.data / "lowtran" /
                                            ("atmosphere_" + std::string(sources[i]) + ".csv")),
                       i + 1, out);
    out.close();
    if (!out)
        throw irsg::InputError(irsg::Diagnostic{file.string(), "", "cannot be written", "a file"});
    std::cout << recipe << levels << " levels of six atmospheres: " << file.string() << "\n";
}

} // namespace smat::tables
