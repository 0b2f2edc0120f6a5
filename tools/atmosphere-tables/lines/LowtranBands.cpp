#include "tools/atmosphere-tables/lines/LowtranBands.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "irsg/core/CsvTable.h"

namespace irsg::lbl {

namespace {

constexpr double avogadro = 6.02214076e23, waterMass_g = 18.01528;
constexpr double loschmidt_per_cm3 = 2.686780111e19; // an atm-cm holds so many per cm2

struct Band {
    std::string gas;
    double lower_per_cm = 0.0, upper_per_cm = 0.0, a = 0.0, n = 0.0, m = 0.0;
};

/// A table with a header, of which rows of another length are diagnostics.
struct HeadedTable {
    explicit HeadedTable(const std::filesystem::path& path) : csv(CsvTable::read(path)) {
        if (csv.rows().size() < 2)
            throw InputError(csv.diagnostic("no rows", "a header and rows"));
        for (std::size_t r = 1; r < csv.rows().size(); ++r)
            if (csv.rows()[r].cells.size() != csv.rows()[0].cells.size())
                diagnostics.push_back(csv.diagnostic(
                    csv.rows()[r].line, std::to_string(csv.rows()[r].cells.size()) + " cells",
                    std::to_string(csv.rows()[0].cells.size()) + " cells"));
        finish();
    }
    std::size_t column(const std::string& name) {
        const auto& header = csv.rows()[0].cells;
        const auto found = std::ranges::find(header, name, &CsvCell::text);
        if (found == header.end())
            diagnostics.push_back(csv.diagnostic("no column " + name, name));
        return static_cast<std::size_t>(found - header.begin()) % header.size();
    }
    double number(std::size_t row, std::size_t column_) {
        return csv.number(csv.rows()[row].cells[column_], diagnostics).value_or(0.0);
    }
    void finish() {
        if (!diagnostics.empty())
            throw InputError(std::move(diagnostics));
    }

    CsvTable csv;
    std::vector<Diagnostic> diagnostics;
};

std::vector<Band> readBands(const std::filesystem::path& file) {
    HeadedTable table(file);
    const std::size_t gas = table.column("gas"), low = table.column("v_low_cm-1"),
                      high = table.column("v_high_cm-1"), a = table.column("a"),
                      n = table.column("n_pressure"), m = table.column("m_temperature");
    table.finish();
    std::vector<Band> bands;
    for (std::size_t r = 1; r < table.csv.rows().size(); ++r)
        bands.push_back({table.csv.rows()[r].cells[gas].text, table.number(r, low),
                         table.number(r, high), table.number(r, a), table.number(r, n),
                         table.number(r, m)});
    table.finish();
    return bands;
}

} // namespace

double BandPoint::opticalDepth(double column_per_cm2, double pressure_hPa,
                               double temperature_K) const {
    if (coefficient_cm2 <= 0.0)
        return 0.0;
    return std::pow(coefficient_cm2 * column_per_cm2 *
                        std::pow(pressure_hPa / 1013.25, pressureExponent) *
                        std::pow(273.15 / temperature_K, temperatureExponent),
                    exponent);
}

LowtranBands LowtranBands::read(const std::filesystem::path& folder) {
    const std::vector<Band> bands = readBands(folder / "bandmodel_bands.csv");
    HeadedTable table(folder / "bandmodel_cprime.csv");
    const std::size_t wavenumber = table.column("wavenumber_cm-1");
    LowtranBands result;
    for (std::size_t g = 0; g < lineGasCount; ++g) {
        const std::string name = gasNames[g];
        const std::size_t column = table.column("Cprime_" + name);
        const double perUnit = name == "H2O" ? avogadro / waterMass_g : loschmidt_per_cm3;
        for (std::size_t r = 1; r < table.csv.rows().size(); ++r) {
            BandPoint point;
            point.wavenumber_per_cm = table.number(r, wavenumber);
            const auto band = std::ranges::find_if(bands, [&](const Band& b) {
                return b.gas == name && point.wavenumber_per_cm >= b.lower_per_cm &&
                       point.wavenumber_per_cm <= b.upper_per_cm;
            });
            if (band != bands.end() && !table.csv.rows()[r].cells[column].text.empty()) {
                point.coefficient_cm2 = std::pow(10.0, table.number(r, column)) / perUnit;
                point.exponent = band->a;
                point.pressureExponent = band->n;
                point.temperatureExponent = band->m;
            }
            result.points_[g].push_back(point);
        }
    }
    table.finish();
    return result;
}

std::vector<BandPoint> LowtranBands::points(Gas gas, double lower_per_cm,
                                            double upper_per_cm) const {
    std::vector<BandPoint> inside;
    for (const BandPoint& point : points_[static_cast<std::size_t>(gas)])
        if (point.wavenumber_per_cm >= lower_per_cm && point.wavenumber_per_cm <= upper_per_cm)
            inside.push_back(point);
    return inside;
}

} // namespace irsg::lbl
