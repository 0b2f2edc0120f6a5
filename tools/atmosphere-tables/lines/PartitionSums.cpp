#include "tools/atmosphere-tables/lines/PartitionSums.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Interpolation.h"
#include "tools/atmosphere-tables/lines/Line.h"

namespace irsg::lbl {

namespace {

/// Fundamentals, cm-1, each with its degeneracy, and the exponent of temperature of the rotation.
struct HotMolecule {
    Gas gas;
    double rotation;
    std::vector<std::pair<double, int>> fundamentals_per_cm;
};

/// Q as of a rigid rotor and harmonic vibrations, but for a factor that does not depend on
/// temperature (G. Herzberg 1945, Infrared and Raman Spectra); 0 for a gas without constants.
double harmonicSum(Gas gas, double temperature_K) {
    static const std::vector<HotMolecule> molecules = {
        {Gas::H2O, 1.5, {{3657.05, 1}, {1594.75, 1}, {3755.93, 1}}},
        {Gas::CO2, 1.0, {{1388.18, 1}, {667.38, 2}, {2349.14, 1}}},
        {Gas::CO, 1.0, {{2143.27, 1}}},
        {Gas::CH4, 1.5, {{2916.5, 1}, {1533.3, 2}, {3019.5, 3}, {1310.8, 3}}}};
    const auto found = std::ranges::find(molecules, gas, &HotMolecule::gas);
    if (found == molecules.end())
        return 0.0;
    double sum = std::pow(temperature_K, found->rotation);
    for (const auto& [fundamental_per_cm, degeneracy] : found->fundamentals_per_cm)
        sum /= std::pow(
            -std::expm1(-secondRadiationConstant_cm_K * fundamental_per_cm / temperature_K),
            degeneracy);
    return sum;
}

} // namespace

PartitionSums PartitionSums::read(const std::filesystem::path& folder) {
    const CsvTable table = CsvTable::read(folder / "tips_12_molecules.csv");
    std::vector<Diagnostic> diagnostics;
    if (table.rows().size() < 3)
        throw InputError(table.diagnostic("no rows", "temperatures and partition sums"));
    const std::vector<CsvCell>& header = table.rows().front().cells;

    PartitionSums sums;
    std::vector<std::vector<double>*> columns(header.size(), nullptr);
    bool temperatures = false;
    for (std::size_t g = 0; g < lineGasCount; ++g)
        for (int isotopologue = 1; isotopologue <= 20; ++isotopologue) {
            const std::string wanted =
                std::string(gasNames[g]) + "_" + std::to_string(isotopologue);
            if (std::ranges::any_of(header, [&](const CsvCell& c) { return c.text == wanted; }))
                sums.sums_[g].resize(static_cast<std::size_t>(isotopologue));
        }
    for (std::size_t c = 0; c < header.size(); ++c) {
        if (header[c].text == "temperature_K" && !temperatures) {
            columns[c] = &sums.temperatures_K_;
            temperatures = true;
        }
        for (std::size_t g = 0; g < lineGasCount; ++g)
            for (std::size_t i = 0; i < sums.sums_[g].size(); ++i)
                if (header[c].text == std::string(gasNames[g]) + "_" + std::to_string(i + 1))
                    columns[c] = &sums.sums_[g][i];
    }
    if (!temperatures)
        diagnostics.push_back(table.diagnostic("no column", "temperature_K"));
    for (std::size_t r = 1; r < table.rows().size(); ++r) {
        const CsvRow& row = table.rows()[r];
        if (row.cells.size() != header.size()) {
            diagnostics.push_back(table.diagnostic(row.line,
                                                   std::to_string(row.cells.size()) + " cells",
                                                   std::to_string(header.size()) + " cells"));
            continue;
        }
        for (std::size_t c = 0; c < header.size(); ++c)
            if (columns[c])
                if (const auto value =
                        table.number(row.cells[c], diagnostics, "a number above 0")) {
                    if (!(*value > 0.0))
                        diagnostics.push_back(table.diagnostic(row.cells[c], "a number above 0"));
                    columns[c]->push_back(*value);
                }
        const auto& ascending = sums.temperatures_K_;
        if (ascending.size() > 1 && !(ascending.back() > ascending[ascending.size() - 2]))
            diagnostics.push_back(table.diagnostic(row.line, numberText(ascending.back()) + " K",
                                                   "temperatures that ascend"));
    }
    for (std::size_t g = 0; g < lineGasCount; ++g)
        if (sums.sums_[g].empty() || sums.sums_[g].front().empty())
            diagnostics.push_back(table.diagnostic("no column", std::string(gasNames[g]) + "_1"));
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return sums;
}

PartitionSums PartitionSums::rigidRotor() {
    PartitionSums sums;
    for (double temperature_K = 20.0; temperature_K <= 1000.0; temperature_K += 1.0)
        sums.temperatures_K_.push_back(temperature_K);
    std::vector<double> q;
    for (const double temperature_K : sums.temperatures_K_)
        q.push_back(std::pow(temperature_K, 1.5));
    for (auto& gas : sums.sums_)
        gas = {q};
    return sums;
}

double PartitionSums::ratioTo296(Gas gas, int isotopologue, double temperature_K) const {
    const auto& own = sums_[static_cast<std::size_t>(gas)];
    auto index = static_cast<std::size_t>(std::max(isotopologue, 1) - 1);
    if (index >= own.size() || own[index].empty())
        index = 0;
    const double last_K = temperatures_K_.back(), atLast = harmonicSum(gas, last_K);
    auto at = [&](double temperature) {
        if (temperature > last_K && atLast > 0.0)
            return own[index].back() * harmonicSum(gas, temperature) / atLast;
        return interpolate(temperatures_K_, own[index], temperature, Beyond::extrapolate);
    };
    return at(296.0) / at(temperature_K);
}

double molarMass_g(Gas gas, int isotopologue) {
    static const std::array<std::vector<double>, lineGasCount> masses = {{
        {18.0106, 20.0148, 19.0148, 19.0167, 21.0210, 20.0210, 20.0229},
        {43.9898, 44.9932, 45.9941, 44.9940, 46.9974, 45.9974, 47.9983, 46.9983, 45.9982, 48.9974,
         47.9974, 46.9974},
        {47.9847, 49.9890, 49.9890, 48.9889, 48.9889},
        {44.0011, 44.9981, 44.9981, 46.0053, 45.0053},
        {27.9949, 28.9983, 29.9992, 28.9991, 31.0025, 30.0025},
        {16.0313, 17.0347, 17.0375, 18.0408},
        {31.9898, 33.9941, 32.9940},
    }};
    const auto& own = masses[static_cast<std::size_t>(gas)];
    const auto index = static_cast<std::size_t>(std::max(isotopologue, 1) - 1);
    return index < own.size() ? own[index] : own.front();
}

} // namespace irsg::lbl
