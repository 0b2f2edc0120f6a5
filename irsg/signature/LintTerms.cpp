#include <algorithm>
#include <cmath>

#include "irsg/radiometry/Units.h"
#include "irsg/signature/LintEntries.h"
#include "irsg/signature/LintTables.h"

namespace irsg {

namespace {

/// Speed of sound in air of 288.15 K, m/s.
constexpr double soundSpeed_m_s = 340.3;
/// The highest Mach number, altitude axis in km and percentage that are taken for what they are.
constexpr double highestMach = 30.0;
constexpr double highestAltitude_km = 30.0;
constexpr double wholePercent = 100.0;

using TermTable = LookupTable TemperatureTerms::*;

LintedTable termTable(int index, const TemperatureTerms& terms, const char* name, TermTable table) {
    return {std::string(".terms.") + name, terms.*table,
            [index, table](std::function<LookupTable(const LookupTable&)> change) {
                return onTemperature(index, [table, change](TemperatureEntry& entry) {
                    entry.terms.*table = change(entry.terms.*table);
                });
            }};
}

bool checkFinite(const std::string& name, double value, Findings& findings) {
    if (!std::isfinite(value)) {
        findings.error(".terms." + name, numberText(value), "a finite number");
    }
    return std::isfinite(value);
}

void lintFactors(int index, const TemperatureTerms& terms, Findings& findings) {
    if (terms.ambientFactor < 0.0) {
        findings.warning(".terms.ambientFactor", numberText(terms.ambientFactor),
                         "a share of the air's temperature of at least 0");
    }
    if (terms.recoveryFactor < 0.0 || terms.recoveryFactor > 1.0) {
        Finding& found =
            findings.warning(".terms.recoveryFactor", numberText(terms.recoveryFactor),
                             "a recovery factor from 0 to 1 (0.85 laminar, 0.89 turbulent)");
        if (terms.recoveryFactor > 2.0 && terms.recoveryFactor <= wholePercent) {
            found.remedy = "percent taken for a fraction? Divide by 100";
            found.repair = onTemperature(
                index, [](TemperatureEntry& entry) { entry.terms.recoveryFactor /= wholePercent; });
        }
    }
}

/// At rest the surface should be warmer than anything in the open air is.
bool lintRest(int index, const TemperatureTerms& terms, Findings& findings) {
    const double rest_K = surfaceTemperature_K(terms, EntityState{});
    if (rest_K >= coldestAtRest_K && rest_K <= hottestSurface_K) {
        return true;
    }
    const std::string value = numberText(rest_K) + " K at rest";
    const bool possible = rest_K > 0.0;
    Finding& found =
        possible
            ? findings.warning("", value, "a temperature from 200 to 4000 K in air of 288.15 K")
            : findings.error("", value, "a temperature above 0 K");
    if (rest_K >= coldestAtRest_K) {
        return false;
    }
    found.remedy = "degrees Celsius taken for K? Add 273.15 to base_K";
    const double kelvin_K = kelvinFromCelsius(rest_K);
    if (kelvin_K >= coldestAtRest_K && kelvin_K <= hottestSurface_K) {
        found.repair = onTemperature(index, [](TemperatureEntry& entry) {
            entry.terms.base_K = kelvinFromCelsius(entry.terms.base_K);
        });
    }
    return false;
}

/// The coldest and the hottest that the tables allow around the temperature at rest.
void lintExtremes(const TemperatureTerms& terms, Findings& findings) {
    double coldest_K = surfaceTemperature_K(terms, EntityState{});
    double hottest_K = coldest_K;
    const std::pair<const LookupTable*, double> tables_K[] = {
        {&terms.time, timeTerm_K(terms, EntityState{})},
        {&terms.power, powerTerm_K(terms, EntityState{})},
        {&terms.altitude, altitudeTerm_K(terms, EntityState{})},
        {&terms.mach, machTerm_K(terms, EntityState{})}};
    for (const auto& [table, now_K] : tables_K) {
        if (!table->empty()) {
            coldest_K += std::ranges::min(table->y()) - now_K;
            hottest_K += std::ranges::max(table->y()) - now_K;
        }
    }
    if (coldest_K < coldestSurface_K) {
        findings.warning("", numberText(coldest_K) + " K where the tables are lowest",
                         "a temperature of at least 100 K");
    }
    if (hottest_K > hottestSurface_K) {
        findings.warning("", numberText(hottest_K) + " K where the tables are highest",
                         "a temperature of at most 4000 K");
    }
}

} // namespace

void lintTerms(int index, const TemperatureEntry& entry, std::vector<Finding>& into) {
    Findings findings(into, temperaturePath(index));
    const TemperatureTerms& terms = entry.terms;
    bool finite = true;
    const auto check = [&](const char* name, double value) {
        finite = checkFinite(name, value, findings) && finite;
    };
    check("base_K", terms.base_K);
    check("ambientFactor", terms.ambientFactor);
    check("recoveryFactor", terms.recoveryFactor);
    check("ambientOffset_K", terms.ambientOffset_K);

    const auto time = termTable(index, terms, "time_s", &TemperatureTerms::time);
    const auto power = termTable(index, terms, "power", &TemperatureTerms::power);
    const auto altitude = termTable(index, terms, "altitude_m", &TemperatureTerms::altitude);
    const auto mach = termTable(index, terms, "mach", &TemperatureTerms::mach);
    for (const LintedTable* const table : {&power, &altitude, &mach}) {
        refuseLoop(*table, findings);
    }
    lintLoop(time, findings);
    suspectAxis(altitude, 1e-3, highestAltitude_km, "an altitude in m",
                "km taken for m? Multiply the axis by 1000", 1e3, findings);
    suspectAxis(mach, highestMach, HUGE_VAL, "a Mach number of at most 30",
                "m/s taken for Mach? Divide the axis by 340.3", 1.0 / soundSpeed_m_s, findings);

    if (finite) {
        lintFactors(index, terms, findings);
    }
    if (finite && entry.mode == EmissionMode::temperature && lintRest(index, terms, findings)) {
        lintExtremes(terms, findings);
    }
}

} // namespace irsg
