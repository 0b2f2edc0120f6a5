#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "irsg/radiometry/Units.h"
#include "irsg/signature/LintEntries.h"
#include "irsg/signature/LintTables.h"

namespace irsg {

namespace {

/// Letters and digits in lower case: what is left of a name when it is written carelessly.
std::string bare(const std::string& name) {
    std::string result;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 || std::isalnum(byte) != 0) {
            result += static_cast<char>(std::tolower(byte));
        }
    }
    return result;
}

/// The one name that is `wanted` but for case, blanks and signs; empty where there is none.
std::string meant(const std::string& wanted, const std::vector<std::string>& names) {
    std::string found;
    for (const std::string& name : names) {
        if (bare(name) == bare(wanted)) {
            if (!found.empty()) {
                return {};
            }
            found = name;
        }
    }
    return found;
}

std::vector<std::string> namesOf(const UserSpectrum& spectrum) {
    std::vector<std::string> names;
    for (const SpectrumComponent& component : spectrum.components) {
        names.push_back(component.name);
    }
    return names;
}

/// Changes one factor of one entry, as long as it is still that of the same component.
Finding::Repair onFactor(int index, std::size_t position, const std::string& component,
                         std::function<void(ComponentFactor&)> change) {
    return onTemperature(index, [=, change = std::move(change)](TemperatureEntry& entry) {
        if (position < entry.factors.size() && entry.factors[position].component == component) {
            change(entry.factors[position]);
        }
    });
}

LookupTable withoutNegatives(const LookupTable& table) {
    std::vector<double> values = table.y();
    for (double& value : values) {
        value = std::max(value, 0.0);
    }
    return {table.x(), values, table.loop()};
}

void refuseNegatives(const LintedTable& linted, Findings& findings) {
    if (linted.table.empty() || std::ranges::min(linted.table.y()) >= 0.0) {
        return;
    }
    Finding& found = findings.error(linted.place, numberText(std::ranges::min(linted.table.y())),
                                    "factors of at least 0");
    found.remedy = "set what is negative to 0";
    found.repair = linted.repairWith(withoutNegatives);
}

/// A full turn whose halves mirror each other says no more than its first half.
bool mirrorsAtHalfATurn(const LookupTable& table) {
    const auto& angles_deg = table.x();
    return angles_deg.front() == 0.0 && angles_deg.back() == 360.0 &&
           std::ranges::all_of(angles_deg, [&](double angle_deg) {
               return std::abs(table.at(angle_deg) - table.at(360.0 - angle_deg)) <= 1e-9;
           });
}

LookupTable firstHalf(const LookupTable& table) {
    std::vector<double> angles_deg;
    std::vector<double> factors;
    for (const double angle_deg : table.x()) {
        if (angle_deg < 180.0) {
            angles_deg.push_back(angle_deg);
            factors.push_back(table.at(angle_deg));
        }
    }
    angles_deg.push_back(180.0);
    factors.push_back(table.at(180.0));
    return {angles_deg, factors};
}

void lintAngles(const LintedTable& linted, Findings& findings) {
    const auto& angles_deg = linted.table.x();
    if (linted.table.empty()) {
        return;
    }
    if (angles_deg.front() < 0.0 || angles_deg.back() > 180.0) {
        Finding& found = findings.error(linted.place,
                                        numberText(angles_deg.front()) + " to " +
                                            numberText(angles_deg.back()) + " deg",
                                        "angles from 0 to 180 deg");
        if (mirrorsAtHalfATurn(linted.table)) {
            found.remedy = "keep the half from 0 to 180 deg: the other mirrors it";
            found.repair = linted.repairWith(firstHalf);
        }
    }
    suspectAxis(linted, pi / 2.0 - 0.01, pi + 0.01, "angles in degrees",
                "radians taken for degrees? Multiply the axis by 57.29578", degrees(1.0), findings);
}

void lintFactor(int index, std::size_t position, const ComponentFactor& factor,
                Findings& findings) {
    const std::string place = ".factors[" + std::to_string(position) + "]";
    if (!std::isfinite(factor.constant)) {
        findings.error(place + ".constant", numberText(factor.constant), "a finite number");
    } else if (factor.constant < 0.0) {
        findings.error(place + ".constant", numberText(factor.constant), "a factor of at least 0");
    }
    const auto linted = [&](const char* name, LookupTable ComponentFactor::*table) {
        return LintedTable{place + name, factor.*table,
                           [=, component = factor.component](
                               std::function<LookupTable(const LookupTable&)> change) {
                               return onFactor(index, position, component,
                                               [table, change](ComponentFactor& to) {
                                                   to.*table = change(to.*table);
                                               });
                           }};
    };
    const LintedTable time = linted(".time_s", &ComponentFactor::time);
    const LintedTable angle = linted(".angle_deg", &ComponentFactor::angle);
    refuseNegatives(time, findings);
    refuseNegatives(angle, findings);
    refuseLoop(angle, findings);
    lintLoop(time, findings);
    lintAngles(angle, findings);
}

} // namespace

void lintEmission(int index, const TemperatureEntry& entry, const SignatureDatabase& database,
                  std::vector<Finding>& into) {
    Findings findings(into, temperaturePath(index));
    const bool used = entry.mode == EmissionMode::userSpectrum;
    const auto spectrum = database.spectra.find(entry.userSpectrum);
    const bool known = spectrum != database.spectra.end();
    if (used && !known) {
        Finding& found = findings.error(".userSpectrum", "'" + entry.userSpectrum + "'",
                                        "the name of a user-defined spectrum of this database");
        std::vector<std::string> names;
        for (const auto& [name, each] : database.spectra) {
            names.push_back(name);
        }
        if (const std::string name = meant(entry.userSpectrum, names); !name.empty()) {
            found.remedy = "take '" + name + "'";
            found.repair =
                onTemperature(index, [name](TemperatureEntry& to) { to.userSpectrum = name; });
        }
    }

    std::set<std::string> seen;
    for (std::size_t i = 0; i < entry.factors.size(); ++i) {
        const ComponentFactor& factor = entry.factors[i];
        const std::string place = ".factors[" + std::to_string(i) + "].component";
        if (used && known && spectrum->second.find(factor.component) == nullptr) {
            Finding& found =
                findings.error(place, "'" + factor.component + "'",
                               "a component of the spectrum '" + entry.userSpectrum + "'");
            if (const std::string name = meant(factor.component, namesOf(spectrum->second));
                !name.empty()) {
                found.remedy = "take '" + name + "'";
                found.repair = onFactor(index, i, factor.component,
                                        [name](ComponentFactor& to) { to.component = name; });
            }
        }
        if (!seen.insert(factor.component).second) {
            Finding& found = findings.error(place, "'" + factor.component + "' a second time",
                                            "one factor a component");
            found.remedy = "delete this one";
            found.removes = true;
            found.repair =
                onTemperature(index, [i, component = factor.component](TemperatureEntry& to) {
                    if (i < to.factors.size() && to.factors[i].component == component) {
                        to.factors.erase(to.factors.begin() + static_cast<std::ptrdiff_t>(i));
                    }
                });
        }
        lintFactor(index, i, factor, findings);
    }
}

} // namespace irsg
