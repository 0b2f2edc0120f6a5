#include <cmath>

#include "irsg/signature/ClampedTables.h"
#include "irsg/signature/Findings.h"
#include "irsg/signature/LintEntries.h"
#include "irsg/signature/SurfaceTemperature.h"

namespace irsg {

namespace {

std::string stateText(const SweptState& swept) {
    const EntityState& state = swept.state;
    return "at time " + numberText(state.time_s) + " s, power " + numberText(state.power) +
           ", Mach " + numberText(state.mach) + ", altitude " + numberText(state.altitude_m) +
           " m in air of " + numberText(std::round(state.ambient_K * 100.0) / 100.0) + " K (" +
           swept.analysis + ")";
}

std::string kelvinText(double temperature_K) {
    return numberText(std::round(temperature_K * 100.0) / 100.0) + " K ";
}

/// One finding at the coldest state and one at the hottest.
void lintEntry(int index, const TemperatureTerms& terms, const std::vector<SweptState>& states,
               std::vector<Finding>& into) {
    const SweptState* coldest = &states.front();
    const SweptState* hottest = &states.front();
    const auto at_K = [&](const SweptState* swept) {
        return surfaceTemperature_K(terms, swept->state);
    };
    for (const SweptState& swept : states) {
        coldest = at_K(&swept) < at_K(coldest) ? &swept : coldest;
        hottest = at_K(&swept) > at_K(hottest) ? &swept : hottest;
    }
    Findings findings(into, temperaturePath(index));
    if (!(at_K(coldest) > 0.0)) {
        findings.error("", kelvinText(at_K(coldest)) + stateText(*coldest),
                       "a temperature above 0 K");
    } else if (at_K(coldest) < coldestSurface_K) {
        findings.warning("", kelvinText(at_K(coldest)) + stateText(*coldest),
                         "a temperature of at least 100 K");
    }
    if (!(at_K(hottest) <= hottestSurface_K)) {
        findings.warning("", kelvinText(at_K(hottest)) + stateText(*hottest),
                         "a temperature of at most 4000 K");
    }
}

/// How often a table was clamped to its end value, and where first.
struct ClampedTable {
    std::size_t count = 0;
    const SweptState* first = nullptr;
};

} // namespace

void lintStates(const SignatureDatabase& database, const std::vector<SweptState>& states,
                std::vector<Finding>& findings) {
    if (states.empty())
        return;
    for (const auto& [index, entry] : database.temperatures)
        if (entry.mode == EmissionMode::temperature)
            lintEntry(index, entry.terms, states, findings);
    std::map<std::string, ClampedTable> clamped;
    for (const SweptState& swept : states) {
        for (const std::string& table : clampedTables(database, swept.state)) {
            ClampedTable& one = clamped[table];
            one.first = one.count == 0 ? &swept : one.first;
            ++one.count;
        }
    }
    for (const auto& [table, one] : clamped) {
        const auto entryEnd = table.find('.', table.find('.') + 1);
        Findings ofEntry(findings, table.substr(0, entryEnd));
        ofEntry.warning(table.substr(entryEnd),
                        "an end value held in " + std::to_string(one.count) + " of " +
                            std::to_string(states.size()) + " states, first " +
                            stateText(*one.first),
                        "nodes that reach every state of the analyses");
    }
}

} // namespace irsg
