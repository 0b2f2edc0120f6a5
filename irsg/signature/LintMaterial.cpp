#include <algorithm>
#include <cmath>

#include "irsg/gas/GasLayer.h"
#include "irsg/signature/Findings.h"
#include "irsg/signature/LintAxis.h"
#include "irsg/signature/LintEntries.h"
#include "irsg/signature/LintFields.h"

namespace irsg {

namespace {

/// Rounding that emissivity + transmissivity may carry above 1.
constexpr double sumTolerance = 1e-9;
/// A measurement may pass 0 or 1 by this much; more is not noise.
constexpr double noise = 0.02;
/// Above this, a fraction is a percentage.
constexpr double leastSpectrumPercent = 1.5;
constexpr double mostPercent = 100.0;

using Property = Spectrum Material::*;

std::string at(const Spectrum& spectrum, std::size_t node) {
    return spectrum.isConstant() ? ""
                                 : " at " + numberText(spectrum.wavelengths_um()[node]) + " um";
}

/// The node that is furthest outside of 0 to 1, if any is.
std::optional<std::size_t> worstNode(const Spectrum& spectrum) {
    std::optional<std::size_t> where;
    double worst = 0.0;
    for (std::size_t i = 0; i < spectrum.size(); ++i) {
        const double value = spectrum.values()[i];
        const double excess = std::isfinite(value) ? std::max(-value, value - 1.0) : HUGE_VAL;
        if (excess > worst) {
            worst = excess;
            where = i;
        }
    }
    return where;
}

bool lintFraction(int index, const std::string& place, const Material& material, Property property,
                  Findings& findings) {
    const Spectrum& spectrum = material.*property;
    if (!spectrum.isConstant() && spectrum.outside() != Spectrum::Outside::hold) {
        Finding& found = findings.error(place, "a spectrum that is zero outside its axis",
                                        "a surface property that holds its end values");
        found.remedy = "hold the end values";
        found.repair = onMaterial(index, [property](Material& to) {
            to.*property = Spectrum((to.*property).wavelengths_um(), (to.*property).values());
        });
    }
    const auto node = worstNode(spectrum);
    if (!node)
        return true;
    Finding& found = findings.error(place + at(spectrum, *node),
                                    numberText(spectrum.values()[*node]), "a value from 0 to 1");
    const double lowest = spectrum.minimum();
    const double highest = spectrum.maximum();
    if (lowest >= 0.0 && highest > leastSpectrumPercent && highest <= mostPercent) {
        found.remedy = "percent taken for fractions? Divide by 100";
        found.repair = onMaterial(index, [property](Material& to) {
            to.*property = (to.*property).mapped([](double value) { return value / mostPercent; });
        });
    } else if (lowest >= -noise && highest <= 1.0 + noise) {
        found.remedy = "noise of a measurement? Cut off at 0 and 1";
        found.repair = onMaterial(index, [property](Material& to) {
            to.*property =
                (to.*property).mapped([](double value) { return std::clamp(value, 0.0, 1.0); });
        });
    }
    return false;
}

std::vector<double> nodesOf(const Material& material) {
    std::vector<double> nodes_um;
    for (const Spectrum* const each : {&material.emissivity, &material.transmissivity}) {
        nodes_um.insert(nodes_um.end(), each->wavelengths_um().begin(),
                        each->wavelengths_um().end());
    }
    std::ranges::sort(nodes_um);
    nodes_um.erase(std::ranges::unique(nodes_um).begin(), nodes_um.end());
    return nodes_um;
}

/// At every node of both, and so everywhere: both are linear between these.
void lowerTransmissivity(Material& material) {
    const std::vector<double> nodes_um = nodesOf(material);
    if (nodes_um.empty()) {
        material.transmissivity = Spectrum::constant(
            std::clamp(1.0 - material.emissivity.at(1.0), 0.0, material.transmissivity.at(1.0)));
        return;
    }
    std::vector<double> values;
    for (const double node_um : nodes_um) {
        values.push_back(std::clamp(1.0 - material.emissivity.at(node_um), 0.0,
                                    material.transmissivity.at(node_um)));
    }
    material.transmissivity = Spectrum(nodes_um, values);
}

void lintSum(int index, const Material& material, Findings& findings) {
    std::vector<double> nodes_um = nodesOf(material);
    const bool grey = nodes_um.empty();
    if (grey)
        nodes_um.push_back(1.0);
    const double worst_um = *std::ranges::min_element(
        nodes_um, {}, [&](double node_um) { return material.reflectivityAt(node_um); });
    const double reflectivity = material.reflectivityAt(worst_um);
    if (reflectivity >= -sumTolerance)
        return;
    Finding& found = findings.error(
        grey ? "" : " at " + numberText(worst_um) + " um",
        "emissivity + transmissivity = " + numberText(1.0 - reflectivity), "a sum of at most 1");
    found.remedy = "lower the transmissivity to 1 - emissivity where the sum is above 1";
    found.repair = onMaterial(index, lowerTransmissivity);
}

/// Returns whether the axis can be one of the infrared.
bool lintAxis(int index, const std::string& place, const Material& material, Property property,
              const std::vector<SpectralRange>& bands, Findings& findings) {
    const Spectrum& spectrum = material.*property;
    if (spectrum.isConstant())
        return true;
    const double first_um = spectrum.wavelengths_um().front();
    const double last_um = spectrum.wavelengths_um().back();
    if (!isAbsurdAxis(first_um, last_um))
        return true;
    Finding& found =
        findings.warning(place, numberText(first_um) + " to " + numberText(last_um) + " um",
                         "wavelengths from 0.1 to 200 um");
    const auto readings = otherReadings(first_um, last_um, bands);
    const bool clear = isClear(readings, first_um, last_um, bands);
    found.remedy = axisRepair(readings, clear);
    if (clear) {
        found.repair = onMaterial(index, [property, reading = readings.front()](Material& to) {
            std::vector<std::size_t> order;
            auto axis_um = readOtherwise((to.*property).wavelengths_um(), reading, order);
            std::vector<double> values;
            for (const std::size_t i : order)
                values.push_back((to.*property).values()[i]);
            to.*property = Spectrum(std::move(axis_um), std::move(values));
        });
    }
    return false;
}

/// A gas is in the reach of the tables, and no fraction of it stands without a pressure.
void lintGas(const Material& material, Findings& findings) {
    const double sum =
        material.gasCO2 + material.gasH2O + material.gasCO + material.gasCH4 + material.gasO2;
    if (sum > 1.0 + sumTolerance)
        findings.error(".gasCO2", "mole fractions of " + numberText(sum) + " in sum",
                       "a sum of at most 1: the rest is nitrogen");
    if (material.isGas() && material.gasPressure_atm < GasLayerLimits::thinnest_atm)
        findings.error(".gasPressure_atm", numberText(material.gasPressure_atm),
                       "0 for a surface, or a pressure from 0.05 to 10 atm");
    if (!material.isGas() && (sum > 0.0 || material.gasSoot_ppmv > 0.0))
        findings
            .warning(".gasPressure_atm", "0 beside what a gas holds",
                     "a pressure: without one the material is a surface")
            .remedy = "set the pressure, 1 atm at sea level";
    if (material.isGas() && sum - material.gasO2 == 0.0 && material.gasSoot_ppmv == 0.0)
        findings.warning(".gasPressure_atm", "a gas of nitrogen and oxygen alone",
                         "CO2, H2O, CO, CH4 or soot: nothing else emits");
}

} // namespace

void lintMaterial(int index, const Material& material, const std::vector<SpectralRange>& bands,
                  std::vector<Finding>& into) {
    Findings findings(into, materialPath(index));
    lintFields<Material>(
        "", material, materialFields(),
        [index](auto change) { return onMaterial(index, std::move(change)); }, findings);
    bool sound = true;
    forEachField<Spectrum>(materialFields(), [&](const auto& field, auto property) {
        const std::string place = std::string(".") + field.key;
        if (property == &Material::refractiveIndex || property == &Material::extinction) {
            lintAxis(index, place, material, property, bands, findings);
            return;
        }
        // Each is looked at, whatever the others are.
        const bool fits = lintFraction(index, place, material, property, findings);
        const bool overAxis = lintAxis(index, place, material, property, bands, findings);
        sound = sound && fits && overAxis;
    });
    // A sum of values at different wavelengths says nothing.
    if (sound)
        lintSum(index, material, findings);
    lintSurface(index, material, findings);
    lintGas(material, findings);
}

} // namespace irsg
