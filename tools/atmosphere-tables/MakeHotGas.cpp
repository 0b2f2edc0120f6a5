#include "tools/atmosphere-tables/Command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "irsg/atmosphere/engine/GasTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/gas/NarrowBandTable.h"
#include "tools/atmosphere-tables/DataTable.h"
#include "tools/atmosphere-tables/HotGasTable.h"
#include "tools/atmosphere-tables/lines/CarbonDioxidePolyads.h"
#include "tools/atmosphere-tables/lines/CarbonMonoxideLines.h"
#include "tools/atmosphere-tables/lines/CompleteLines.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"
#include "tools/atmosphere-tables/lines/NarrowBandFit.h"

namespace smat::tables {

namespace {

/// From every row that has a spacing to those that have none: nothing absorbs there, but between
/// the two values are interpolated.
void fillSpacings(std::vector<std::vector<double>>& spacings) {
    for (std::vector<double>& column : spacings) { // along the wavenumbers
        const auto isGiven = [](double value) { return value > 0.0; };
        const auto first = std::ranges::find_if(column, isGiven);
        double last = first == column.end() ? 0.0 : *first;
        for (double& value : column)
            last = value = isGiven(value) ? value : last;
    }
}

void makeRadcal(const Folders& folders, const std::string& gas) {
    const Table table =
        readTable(folders.data.parent_path() / "hotgas" / ("nist_radcal_" + gas + ".csv"));
    const std::vector<double>& wavenumbers = table.column("wavenumber_cm-1");
    const std::vector<double>& temperatures = table.column("temperature_K");
    HotGasTable wide;
    for (double T = 300.0; T <= 2500.0; T += 100.0)
        wide.temperatures_K.push_back(T);
    const double step_per_cm = gas == "h2o" ? 25.0 : 5.0;
    for (double nu = wavenumbers.front(); nu <= wavenumbers.back(); nu += step_per_cm)
        wide.wavenumbers_per_cm.push_back(nu);
    wide.resize();
    for (std::size_t i = 0; i < wavenumbers.size(); ++i) {
        const auto row = static_cast<std::size_t>(
            std::lround((wavenumbers[i] - wavenumbers.front()) / step_per_cm));
        const auto t = static_cast<std::size_t>(std::lround((temperatures[i] - 300.0) / 100.0));
        wide.k.at(t).at(row) = table.column("k_stp_per_cm_atm")[i];
        wide.inverseSpacings.at(t).at(row) = table.column("inverse_line_spacing_cm")[i];
    }
    fillSpacings(wide.inverseSpacings);
    wide.write(
        folders.out / ("hotgas-radcal-" + gas + ".csv"),
        "# Narrow-band parameters of hot gas as in RADCAL\n# gas: " +
            std::string(gas == "h2o"   ? "H2O"
                        : gas == "co2" ? "CO2"
                                       : "CO") +
            "\n# law: goody\n# between temperatures: " + (gas == "h2o" ? "straight" : "boltzmann") +
            "\n",
        "# recipe: atmosphere-tables hotgas; the numbers of the source, where it leaves rows "
        "out k is 0 and the spacing that of the row before\n"
        "# units: cm-1; cm-1 atm-1 at 273 K and 1 atm of the gas; cm\n"
        "# expected error: docs/gas.md\n"
        "# source: RADCAL of NIST (W. L. Grosshandler 1993, NIST Technical Note 1402; "
        "firemodels/radcal commit abe2a8f, a work of the United States government, not "
        "subject to copyright there), on C. B. Ludwig et al. 1973, NASA SP-3080\n");
}

/// A table to fit to line by line.
struct LinesTable {
    irsg::HotGas gas;
    irsg::Gas listed;
    double lower_per_cm, upper_per_cm; ///< middle of the first and the last band
    std::vector<double> temperatures_K;
    double linesTo_K; ///< beyond, the table of RADCAL says how the coefficients grow
    /// Where they do from another temperature on.
    double otherFrom_per_cm, otherTo_per_cm, otherLinesTo_K;
    irsg::lbl::LineShape shape;
    const char* expectedError;
};

/// Farther out than this nothing is seen of the wings in the columns of plumes.
constexpr irsg::lbl::LineShape carbonDioxideShape{60.0, false, true};

/// Up to where the lists of lines suffice. Wings of water are whole: its continuum, which is made
/// for lines without their pedestal, is not in the table.
std::vector<LinesTable> linesTables() {
    const std::vector<double> all = {300, 400, 500, 600, 800, 1000, 1250, 1600, 2000, 2500, 3000};
    const std::vector<double> warm = {300, 400, 500, 600, 800, 1000};
    constexpr irsg::lbl::LineShape whole{25.0, false, false};
    const char* const stated = "docs/gas.md";
    return {{irsg::HotGas::CO2, irsg::Gas::CO2, 600.0, 5200.0, all, 3000.0, 780.0, 1300.0, 1000.0,
             carbonDioxideShape, stated},
            {irsg::HotGas::H2O, irsg::Gas::H2O, 530.0, 5350.0, all, 800.0, 0.0, 0.0, 0.0, whole,
             stated},
            {irsg::HotGas::CO, irsg::Gas::CO, 1600.0, 2400.0, all, 3000.0, 0.0, 0.0, 0.0, whole,
             stated},
            {irsg::HotGas::CH4, irsg::Gas::CH4, 1000.0, 4600.0, warm, 1000.0, 0.0, 0.0, 0.0, whole,
             stated}};
}

/// Of a gas in trace amounts in nitrogen at 1 atm.
irsg::GasLayer trace(double temperature_K) {
    irsg::GasLayer layer;
    layer.temperature_K = temperature_K;
    return layer;
}

irsg::lbl::LineList linesOf(const Folders& folders, irsg::Gas gas) {
    using namespace irsg::lbl;
    if (gas == irsg::Gas::CO)
        return carbonMonoxideLines();
    LineList list = completeLineList(gas, folders.data);
    if (gas == irsg::Gas::CO2) {
        const auto file = folders.data / "lines" / "CO2.par.gz";
        const CarbonDioxideLevels levels(readTextLines(file), file.string());
        addMissingLines(list, hotCarbonDioxide(levels, 14000.0, 2000.0, 2e-23));
    }
    return list;
}

/// Beyond the last temperature for which lines suffice, coefficients and spacings grow from there
/// as those of RADCAL do.
void growAsRadcal(HotGasTable& table, const irsg::NarrowBandTable& radcal, double linesTo_K,
                  double lower_per_cm, double upper_per_cm) {
    const auto last =
        static_cast<std::size_t>(std::ranges::upper_bound(table.temperatures_K, linesTo_K) -
                                 table.temperatures_K.begin() - 1);
    const double from_K = table.temperatures_K[last];
    for (std::size_t row = 0; row < table.wavenumbers_per_cm.size(); ++row) {
        const double nu = table.wavenumbers_per_cm[row];
        if (nu < lower_per_cm || nu > upper_per_cm)
            continue;
        const auto from = radcal.at(nu, from_K);
        for (std::size_t t = last + 1; t < table.temperatures_K.size(); ++t) {
            const auto to = radcal.at(nu, table.temperatures_K[t]);
            const bool isKnown = from.k_per_cm_atm > 0.0 && from.inverseSpacing_cm > 0.0;
            table.k[t][row] =
                table.k[last][row] * (isKnown ? to.k_per_cm_atm / from.k_per_cm_atm : 1.0);
            table.inverseSpacings[t][row] =
                table.inverseSpacings[last][row] *
                (isKnown ? to.inverseSpacing_cm / from.inverseSpacing_cm : 1.0);
        }
    }
}

std::string sourceOf(const LinesTable& wanted) {
    std::string text = "# source: line by line to " + irsg::numberText(wanted.linesTo_K) +
                       " K from HITRAN's lines and generated bands";
    if (wanted.temperatures_K.back() > wanted.linesTo_K)
        text += ", beyond growing as in RADCAL (NIST TN 1402)";
    if (wanted.otherLinesTo_K > 0.0)
        text += ", at " + irsg::numberText(wanted.otherFrom_per_cm) + "-" +
                irsg::numberText(wanted.otherTo_per_cm) + " cm-1 to " +
                irsg::numberText(wanted.otherLinesTo_K) +
                " K, beyond growing as in RADCAL (NIST TN 1402)";
    return text + "\n";
}

void makeLines(const Folders& folders, const LinesTable& wanted, const irsg::lbl::LineList& list,
               const irsg::lbl::PartitionSums& partition) {
    constexpr double step_per_cm = 5.0;
    constexpr double molecules_per_cm3 = 101325.0 / (1.380649e-23 * 273.0) * 1e-6;
    const std::string name = irsg::hotGasNames[static_cast<std::size_t>(wanted.gas)];
    HotGasTable table;
    table.temperatures_K = wanted.temperatures_K;
    for (double nu = wanted.lower_per_cm; nu <= wanted.upper_per_cm; nu += step_per_cm)
        table.wavenumbers_per_cm.push_back(nu);
    table.resize();
    for (std::size_t t = 0; t < table.temperatures_K.size(); ++t) {
        const double T = table.temperatures_K[t];
        if (T > wanted.linesTo_K)
            break;
        irsg::lbl::NarrowBandTask task;
        task.centres_per_cm = table.wavenumbers_per_cm;
        task.width_per_cm = step_per_cm;
        task.step_per_cm = 0.02;
        task.temperature_K = T;
        task.collision_per_cm = irsg::collisionHalfWidth_per_cm(wanted.gas, trace(T));
        task.dopplerPerWavenumber = irsg::dopplerHalfWidth_per_cm(wanted.gas, 1.0, T);
        task.shape = wanted.shape;
        task.weakest_cm2 = 1e-26;
        const auto bands = irsg::lbl::fitNarrowBands(list, partition, task);
        double squares = 0.0;
        for (std::size_t row = 0; row < bands.size(); ++row) {
            table.k[t][row] = bands[row].crossSection_cm2 * molecules_per_cm3;
            table.inverseSpacings[t][row] = bands[row].inverseSpacing_cm;
            squares += bands[row].rmsError * bands[row].rmsError;
        }
        std::cout << name << " " << T << " K: fitted to (relative) "
                  << std::sqrt(squares / static_cast<double>(bands.size())) << std::endl;
    }
    const auto grow = [&](double linesTo_K, double lower_per_cm, double upper_per_cm) {
        growAsRadcal(table,
                     irsg::NarrowBandTable::read(
                         folders.out / ("hotgas-radcal-" + irsg::lowerCase(name) + ".csv")),
                     linesTo_K, lower_per_cm, upper_per_cm);
    };
    if (table.temperatures_K.back() > wanted.linesTo_K)
        grow(wanted.linesTo_K, wanted.lower_per_cm, wanted.upper_per_cm);
    if (wanted.otherLinesTo_K > 0.0)
        grow(wanted.otherLinesTo_K, wanted.otherFrom_per_cm, wanted.otherTo_per_cm);
    fillSpacings(table.inverseSpacings);
    std::string origins;
    for (const std::string& origin : list.origins)
        origins += "# lines: " + origin + "\n";
    table.write(folders.out / ("hotgas-lines-" + irsg::lowerCase(name) + ".csv"),
                "# Narrow-band parameters of hot gas fitted to line by line\n# gas: " + name +
                    "\n# law: malkmus\n# between temperatures: boltzmann\n",
                "# recipe: atmosphere-tables hotgas; at 1 atm in nitrogen, bands of 5 cm-1\n"
                "# units: cm-1; cm-1 atm-1 at 273 K and 1 atm of the gas; cm\n# expected error: " +
                    std::string(wanted.expectedError) + "\n" + origins + sourceOf(wanted));
}

/// Cross sections of CO2, H2O and CO, cold and hot, at single wavenumbers 0.2 cm-1 apart: how far
/// the lines of hot gas coincide with those of air.
void makeSamples(const Folders& folders, const std::vector<irsg::lbl::LineList>& lists,
                 const irsg::lbl::PartitionSums& partition) {
    constexpr double step_per_cm = 0.2, width_per_cm = 5.0;
    constexpr std::array<std::pair<double, double>, 2> ranges = {
        {{827.5, 1302.5}, {1897.5, 4202.5}}};
    irsg::CrossSectionGrid grid;
    grid.pressures_hPa = {1100, 550, 250, 100};
    grid.temperatures_K = {250, 300, 400, 550, 800, 1200, 2000};
    std::vector<double> wavenumbers;
    std::vector<irsg::GasTable::Block> blocks;
    std::array<irsg::BinSet, 3> bins;
    for (std::size_t r = 0; r < bins.size(); ++r)
        bins[r].resolution_per_cm = irsg::GasTable::resolutions_per_cm[r];
    for (const auto& [from, to] : ranges) {
        irsg::lbl::WavenumberGrid fine;
        fine.first_per_cm = from + 0.5 * step_per_cm;
        fine.step_per_cm = step_per_cm;
        fine.count = static_cast<std::size_t>(std::lround((to - from) / step_per_cm));
        const auto first = static_cast<std::uint32_t>(wavenumbers.size());
        for (std::size_t i = 0; i < fine.count; ++i)
            wavenumbers.push_back(fine.at(i));
        for (const irsg::lbl::LineList& list : lists) {
            std::vector<irsg::GasTable::Block> own(fine.count);
            for (std::uint32_t i = 0; i < own.size(); ++i)
                own[i] = {first + i, list.gas, {}};
            for (const double p : grid.pressures_hPa)
                for (const double T : grid.temperatures_K) {
                    const auto values = crossSection_cm2(
                        list, partition, fine, T, p, 0.0,
                        list.gas == irsg::Gas::CO2 ? carbonDioxideShape
                                                   : irsg::lbl::defaultLineShape(list.gas),
                        1e-26);
                    for (std::size_t i = 0; i < own.size(); ++i)
                        own[i].lnCrossSection.push_back(
                            static_cast<float>(std::log(std::max(values[i], 1e-33))));
                }
            std::erase_if(own, [](const auto& block) {
                return std::ranges::max(block.lnCrossSection) < std::log(1e-27);
            });
            std::ranges::move(own, std::back_inserter(blocks));
        }
        const auto perBin = static_cast<std::uint32_t>(std::lround(width_per_cm / step_per_cm));
        for (irsg::BinSet& set : bins)
            for (std::uint32_t i = 0; i < fine.count; i += perBin) {
                const double lower = from + step_per_cm * i;
                set.bins.push_back({lower, lower + width_per_cm,
                                    static_cast<std::uint32_t>(set.nodes.size()), perBin});
                for (std::uint32_t n = 0; n < perBin; ++n) {
                    set.nodes.push_back(first + i + n);
                    set.weights.push_back(1.0f / static_cast<float>(perBin));
                }
            }
    }
    std::string header =
        "Absorption cross sections of CO2, H2O and CO from 250 to 2000 K at wavenumbers 0.2 cm-1 "
        "apart, computed line by line by `atmosphere-tables hotgas-samples`: samples for the "
        "correlation "
        "of hot gas with air, not for absorption itself.\n";
    for (const irsg::lbl::LineList& list : lists)
        for (const std::string& origin : list.origins)
            header += origin + "\n";
    const irsg::GasTable table(grid, std::move(wavenumbers), std::move(blocks), std::move(bins),
                               header);
    table.write(folders.out / "hotgas-samples.gastable");
    std::cout << "hotgas-samples.gastable: " << table.nodeCount() << " nodes" << std::endl;
}

} // namespace

void HotGasTable::resize() {
    k.assign(temperatures_K.size(), std::vector<double>(wavenumbers_per_cm.size(), 0.0));
    inverseSpacings = k;
}

void HotGasTable::write(const std::filesystem::path& file, const std::string& head,
                        const std::string& origin) const {
    std::string temperatures = "# temperatures:";
    for (const double T : temperatures_K)
        temperatures += " " + irsg::numberText(T);
    Writer writer("");
    writer.add("wavenumber [cm-1]", wavenumbers_per_cm);
    for (std::size_t t = 0; t < k.size(); ++t)
        writer.add("k_" + irsg::numberText(temperatures_K[t]) + " [cm-1 atm-1]", k[t]);
    for (std::size_t t = 0; t < k.size(); ++t)
        writer.add("inverse_spacing_" + irsg::numberText(temperatures_K[t]) + " [cm]",
                   inverseSpacings[t]);
    writer.write(file, head + temperatures + "\n" + origin, 0.0, 1e9);
}

void makeHotGas(const Folders& folders) {
    for (const char* gas : {"co2", "h2o", "co"})
        makeRadcal(folders, gas);
    const auto partition = irsg::lbl::PartitionSums::read(folders.data / "lines" / "partition");
    for (const LinesTable& table : linesTables())
        makeLines(folders, table, linesOf(folders, table.listed), partition);
}

void makeHotGasSamples(const Folders& folders) {
    const auto partition = irsg::lbl::PartitionSums::read(folders.data / "lines" / "partition");
    std::vector<irsg::lbl::LineList> lists;
    for (const irsg::Gas gas : {irsg::Gas::CO2, irsg::Gas::H2O, irsg::Gas::CO})
        lists.push_back(linesOf(folders, gas));
    makeSamples(folders, lists, partition);
}

} // namespace smat::tables
