#include "irsg/gas/NarrowBandTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Interpolation.h"
#include "irsg/core/Wording.h"

namespace irsg {

namespace {

constexpr double standardTemperature_K = 273.0; // as NIST TN 1402 rounds it

/// Half widths at 273 K and 1 atm of the broadener, cm-1 (NIST TN 1402, table of NASA SP-3080). The
/// rows are CO2, H2O, CO, CH4, O2 and N2. Methane as an absorber: means of HITRAN's lines; as a
/// broadener it counts as nitrogen.
struct Widths {
    std::array<double, hotGasCount> byGas;
    double byOxygen, byNitrogen, resonant;
    double molarMass_g;
};
constexpr std::array<Widths, hotGasCount> widths = {{
    {{0.09, 0.07, 0.06, 0.07}, 0.055, 0.07, 0.01, 44.0},
    {{0.12, 0.09, 0.10, 0.09}, 0.04, 0.09, 0.44, 18.0},
    {{0.07, 0.06, 0.06, 0.06}, 0.05, 0.06, 0.0, 28.0},
    {{0.06, 0.06, 0.06, 0.06}, 0.06, 0.06, 0.02, 16.0},
}};

const Widths& widthsOf(HotGas gas) {
    return widths[static_cast<std::size_t>(gas)];
}

/// The comment lines at the head of a table: every diagnostic is collected.
class Head {
  public:
    explicit Head(const CsvTable& csv) : csv_(csv) {}

    std::string text(const char* key) {
        const CsvComment* const found = csv_.comment(key);
        if (found)
            return found->value;
        diagnostics_.push_back(csv_.diagnostic("no line '# " + std::string(key) + ": ...'",
                                               "one that names the " + std::string(key)));
        return {};
    }

    std::size_t word(const char* key, const std::vector<std::string>& words) {
        const std::string value = text(key);
        const auto place = std::ranges::find(words, value);
        if (place != words.end())
            return static_cast<std::size_t>(place - words.begin());
        if (const CsvComment* const found = csv_.comment(key))
            diagnostics_.push_back(csv_.diagnostic(found->line, value, alternatives(words)));
        return 0;
    }

    std::vector<double> temperatures_K() {
        std::vector<double> values;
        std::istringstream words(text("temperatures"));
        for (std::string word; words >> word;) {
            const auto value = parseNumber(word);
            if (!value || *value <= (values.empty() ? 0.0 : values.back())) {
                diagnostics_.push_back(csv_.diagnostic(csv_.comment("temperatures")->line, word,
                                                       "ascending temperatures in K"));
                break;
            }
            values.push_back(*value);
        }
        if (values.empty() && diagnostics_.empty())
            diagnostics_.push_back(csv_.diagnostic("no temperature", "temperatures in K"));
        return values;
    }

    void check() {
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
    }

  private:
    const CsvTable& csv_;
    std::vector<Diagnostic> diagnostics_;
};

} // namespace

NarrowBandTable NarrowBandTable::read(const std::filesystem::path& file) {
    const CsvTable csv = CsvTable::read(file);
    Head head(csv);
    const std::size_t gas = head.word("gas", {hotGasNames.begin(), hotGasNames.end()});
    const std::size_t law = head.word("law", {"goody", "malkmus"});
    const std::size_t between = head.word("between temperatures", {"straight", "boltzmann"});
    const std::string source = head.text("source");
    std::vector<double> temperatures_K = head.temperatures_K();
    head.check();
    std::vector<std::string> columns;
    for (const double T : temperatures_K)
        columns.push_back("k_" + numberText(T) + " [cm-1 atm-1]");
    for (const double T : temperatures_K)
        columns.push_back("inverse_spacing_" + numberText(T) + " [cm]");
    return {static_cast<HotGas>(gas),
            law == 0 ? StrengthLaw::goody : StrengthLaw::malkmus,
            between == 1,
            source,
            std::move(temperatures_K),
            EvenTable::read(file, columns)};
}

NarrowBandTable::Values NarrowBandTable::at(double wavenumber_per_cm, double temperature_K) const {
    const EvenTable::Place place = table_.place(wavenumber_per_cm);
    if (!place.inside)
        return {};
    const Bracket warm = bracket(temperatures_K_, temperature_K);
    const double below_K = temperatures_K_[warm.below], above_K = temperatures_K_[warm.above];
    double fraction = warm.fraction;
    if (isByBoltzmann_ && fraction > 0.0 && fraction < 1.0)
        fraction *= above_K / lerp(below_K, above_K, warm.fraction);
    const auto between = [&](std::size_t first) {
        const double below = table_.at(first + warm.below, place);
        const double above = table_.at(first + warm.above, place);
        return isByBoltzmann_ ? lerpByRatio(below, above, fraction) : lerp(below, above, fraction);
    };
    return {between(0), between(temperatures_K_.size())};
}

double collisionHalfWidth_per_cm(HotGas gas, const GasLayer& layer) {
    const Widths& own = widthsOf(gas);
    double sum = own.byOxygen * layer.oxygenFraction + own.byNitrogen * layer.nitrogenFraction();
    for (std::size_t other = 0; other < hotGasCount; ++other)
        sum += own.byGas[other] * layer.moleFraction[other];
    const double cold = standardTemperature_K / layer.temperature_K;
    return layer.pressure_atm * (sum * std::sqrt(cold) + own.resonant * layer.fraction(gas) * cold);
}

double dopplerHalfWidth_per_cm(HotGas gas, double wavenumber_per_cm, double temperature_K) {
    return 5.94e-6 * wavenumber_per_cm *
           std::sqrt(temperature_K / (standardTemperature_K * widthsOf(gas).molarMass_g));
}

NarrowBandLayer narrowBandLayer(const NarrowBandTable& table, const GasLayer& layer,
                                double collisionHalfWidth_per_cm, double wavenumber_per_cm) {
    const NarrowBandTable::Values values = table.at(wavenumber_per_cm, layer.temperature_K);
    const double amount_atm_cm =
        layer.column_atm_cm(table.gas()) * standardTemperature_K / layer.temperature_K;
    return {values.k_per_cm_atm * amount_atm_cm,
            collisionHalfWidth_per_cm * values.inverseSpacing_cm,
            dopplerHalfWidth_per_cm(table.gas(), wavenumber_per_cm, layer.temperature_K) *
                values.inverseSpacing_cm};
}

} // namespace irsg
