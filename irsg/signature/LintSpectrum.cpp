#include <algorithm>
#include <cmath>
#include <set>

#include "irsg/signature/Findings.h"
#include "irsg/signature/LintEntries.h"
#include "irsg/signature/LintFields.h"
#include "irsg/signature/LintUnits.h"

namespace irsg {

namespace {

void lintNegatives(const std::string& key, const SpectrumComponent& component, Findings& findings) {
    const double lowest = component.radiance.minimum();
    if (lowest >= 0.0)
        return;
    Finding& found = findings.warning("." + component.name, numberText(lowest) + " W m-2 sr-1 um-1",
                                      "radiance of at least 0");
    found.remedy = "noise of a measurement? Set what is negative to 0";
    found.repair = onSpectrum(key, [name = component.name](UserSpectrum& to) {
        for (SpectrumComponent& each : to.components) {
            if (each.name == name) {
                each.radiance =
                    each.radiance.mapped([](double value) { return std::max(value, 0.0); });
            }
        }
    });
}

bool isOneLine(const std::string& name) {
    return !name.empty() &&
           std::ranges::none_of(name, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

} // namespace

void lintSpectrum(const std::string& key, const UserSpectrum& spectrum,
                  const std::vector<SpectralRange>& bands, std::vector<Finding>& into) {
    Findings findings(into, spectrumPath(key));
    if (key.empty() || spectrum.name != key) {
        Finding& found =
            findings.error("", "the name '" + spectrum.name + "'",
                           "the name it is filed under, '" + key + "', and not an empty one");
        if (!key.empty()) {
            found.remedy = "name it '" + key + "'";
            found.repair = onSpectrum(key, [key](UserSpectrum& to) { to.name = key; });
        }
    }
    lintFields<UserSpectrum>(
        "", spectrum, spectrumFields(),
        [key](auto change) { return onSpectrum(key, std::move(change)); }, findings);
    if (spectrum.components.empty()) {
        findings.error(".components", "none", "at least one component");
        return;
    }

    const bool absurdAxis = lintSpectrumAxis(key, spectrum, bands, findings);
    std::set<std::string> names;
    for (std::size_t i = 0; i < spectrum.components.size(); ++i) {
        const SpectrumComponent& component = spectrum.components[i];
        const Spectrum& radiance = component.radiance;
        const std::string place = "." + component.name;
        if (!isOneLine(component.name)) {
            findings.error(".components", "the name '" + component.name + "'",
                           "a name of one line, not empty");
        }
        if (!names.insert(component.name).second)
            findings.error(place, "a second component of this name", "each name once");
        if (radiance.isConstant() || radiance.outside() != Spectrum::Outside::zero) {
            findings.error(place, "a curve without end",
                           "nodes, and nothing emitted outside of them");
        } else if (radiance.wavelengths_um() !=
                   spectrum.components.front().radiance.wavelengths_um()) {
            findings.error(place, "an axis of its own", "the axis that all components share");
        } else {
            lintNegatives(key, component, findings);
            if (!absurdAxis)
                lintRadianceUnit(key, spectrum, i, findings);
        }
    }
}

} // namespace irsg
