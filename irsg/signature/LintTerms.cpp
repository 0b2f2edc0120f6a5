#include <algorithm>

#include "irsg/radiometry/Units.h"
#include "irsg/signature/LintEntries.h"
#include "irsg/signature/LintFields.h"
#include "irsg/signature/SurfaceTemperature.h"

namespace irsg {

namespace {

/// At rest the surface should be warmer than anything in the open air is.
bool lintRest(int index, const TemperatureTerms& terms, Findings& findings) {
    const double rest_K = surfaceTemperature_K(terms, EntityState{});
    if (rest_K >= coldestAtRest_K && rest_K <= hottestSurface_K)
        return true;
    const std::string value = numberText(rest_K) + " K at rest";
    const bool possible = rest_K > 0.0;
    Finding& found =
        possible
            ? findings.warning("", value, "a temperature from 200 to 4000 K in air of 288.15 K")
            : findings.error("", value, "a temperature above 0 K");
    if (rest_K >= coldestAtRest_K)
        return false;
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
    forEachField<LookupTable>(termFields(), [&](const auto& field, auto member) {
        const LookupTable& table = terms.*member;
        if (!table.empty()) {
            const double now_K = table.at(field.table.position(EntityState{}));
            coldest_K += std::ranges::min(table.y()) - now_K;
            hottest_K += std::ranges::max(table.y()) - now_K;
        }
    });
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
    lintFields<TemperatureEntry>(
        "", entry, temperatureFields(),
        [index](auto change) { return onTemperature(index, std::move(change)); }, findings);
    const TemperatureTerms& terms = entry.terms;
    const bool finite = lintFields<TemperatureTerms>(
        ".terms", terms, termFields(),
        [index](auto change) {
            return onTemperature(
                index, [change = std::move(change)](TemperatureEntry& to) { change(to.terms); });
        },
        findings);
    if (finite && entry.mode == EmissionMode::temperature && lintRest(index, terms, findings))
        lintExtremes(terms, findings);
}

} // namespace irsg
