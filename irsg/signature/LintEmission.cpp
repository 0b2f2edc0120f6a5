#include <algorithm>
#include <cctype>
#include <set>

#include "irsg/signature/LintEntries.h"
#include "irsg/signature/LintFields.h"

namespace irsg {

namespace {

/// Letters and digits in lower case: what is left of a name when it is written carelessly.
std::string bare(const std::string& name) {
    std::string result;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 || std::isalnum(byte) != 0)
            result += static_cast<char>(std::tolower(byte));
    }
    return result;
}

/// The one name that is `wanted` but for case, blanks and signs; empty where there is none.
std::string meant(const std::string& wanted, const std::vector<std::string>& names) {
    std::string found;
    for (const std::string& name : names) {
        if (bare(name) == bare(wanted)) {
            if (!found.empty())
                return {};
            found = name;
        }
    }
    return found;
}

std::vector<std::string> namesOf(const UserSpectrum& spectrum) {
    std::vector<std::string> names;
    for (const SpectrumComponent& component : spectrum.components)
        names.push_back(component.name);
    return names;
}

/// Changes one factor of one entry, as long as it is still that of the same component.
Finding::Repair onFactor(int index, std::size_t position, const std::string& component,
                         std::function<void(ComponentFactor&)> change) {
    return onTemperature(index, [=, change = std::move(change)](TemperatureEntry& entry) {
        if (position < entry.factors.size() && entry.factors[position].component == component)
            change(entry.factors[position]);
    });
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
        for (const auto& [name, each] : database.spectra)
            names.push_back(name);
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
                    if (i < to.factors.size() && to.factors[i].component == component)
                        to.factors.erase(to.factors.begin() + static_cast<std::ptrdiff_t>(i));
                });
        }
        lintFields<ComponentFactor>(
            ".factors[" + std::to_string(i) + "]", factor, geometryBuffers(),
            [index, i, component = factor.component](auto change) {
                return onFactor(index, i, component, std::move(change));
            },
            findings);
    }
}

} // namespace irsg
