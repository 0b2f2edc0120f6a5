#include "irsg/gas/RoundJet.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

constexpr double carbon_g_mol = 12.011, hydrogen_g_mol = 1.008, air_g_mol = 28.964;
constexpr double oxygenOfAir = 0.2095;
constexpr double coreOverDiameter = 5.0, velocityOverPart = 6.2 / 5.0;
constexpr double velocityPower = (0.11 / 0.086) * (0.11 / 0.086);
constexpr double longestOverDiameter = 500.0;
constexpr std::size_t alongNodes = 60, acrossNodes = 40;

/// The part of the nozzle's gas across the jet, at one distance from the nozzle.
struct Across {
    double onAxis = 1.0, core_m = 0.0, half_m = 0.0; ///< the bell begins at the core's edge

    double bell(double r_m) const {
        if (r_m <= core_m)
            return 1.0;
        const double part = (r_m - core_m) / half_m;
        return std::exp(-std::numbers::ln2 * part * part);
    }
    /// Where it is `least` of that on the axis.
    double reach_m(double least) const {
        return core_m + half_m * std::sqrt(std::log(1.0 / least) / std::numbers::ln2);
    }
};

double flow(const RoundJet& jet, const Across& across) {
    constexpr int steps = 400;
    const double to_m = across.reach_m(1e-6), step_m = to_m / steps;
    const double coflow = jet.coflow_m_s / jet.velocity_m_s;
    const double axisExcess = std::min(1.0, velocityOverPart * across.onAxis);
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double r_m = (i + 0.5) * step_m, bell = across.bell(r_m);
        const double part = across.onAxis * bell;
        const double here_K = jet.air_K + part * (jet.temperature_K - jet.air_K);
        const double velocity =
            coflow + (1.0 - coflow) * axisExcess * std::pow(bell, velocityPower);
        sum += jet.temperature_K / here_K * velocity * part * 2.0 * r_m * step_m;
    }
    return sum;
}

/// As wide as the flow of the nozzle's gas is that of the nozzle.
Across acrossAt(const RoundJet& jet, double x_m, double core_m) {
    const double radius_m = 0.5 * jet.diameter_m;
    Across across;
    across.onAxis = std::min(1.0, core_m / std::max(x_m, 1e-9));
    across.core_m = radius_m * std::max(0.0, 1.0 - x_m / core_m);
    double least_m = 1e-6 * radius_m, most_m = radius_m + x_m;
    for (int i = 0; i < 60; ++i) {
        across.half_m = 0.5 * (least_m + most_m);
        (flow(jet, across) < radius_m * radius_m ? least_m : most_m) = across.half_m;
    }
    return across;
}

} // namespace

GasLayer RoundJet::air() const {
    GasLayer gas;
    gas.temperature_K = air_K;
    gas.pressure_atm = pressure_atm;
    gas.fraction(HotGas::CO2) = airCO2;
    gas.fraction(HotGas::H2O) = airWater;
    gas.oxygenFraction = oxygenOfAir * (1.0 - airWater);
    return gas;
}

GasLayer RoundJet::nozzleGas() const {
    std::vector<Diagnostic> diagnostics;
    const auto check = [&](const char* name, double value, bool isGood, const char* expected) {
        if (!isGood)
            diagnostics.push_back({"jet", name, numberText(value), expected});
    };
    const auto checkRange = [&](const char* name, double value, double least, double most,
                                const char* unit) {
        if (!(value >= least && value <= most))
            diagnostics.push_back({"jet", name, numberText(value),
                                   numberText(least) + " to " + numberText(most) + unit});
    };
    using Limits = GasLayerLimits;
    check("D_m", diameter_m, diameter_m > 0.0, "above 0");
    check("velocity_m_s", velocity_m_s, velocity_m_s > 0.0, "above 0");
    check("coflow_m_s", coflow_m_s, coflow_m_s >= 0.0 && coflow_m_s <= 0.9 * velocity_m_s,
          "0 to 0.9 of the velocity at the nozzle");
    check("T_K", temperature_K, temperature_K > air_K, "above the temperature of the air");
    checkRange("T_K", temperature_K, Limits::coldest_K, Limits::hottest_K, " K");
    checkRange("air_K", air_K, Limits::coldest_K, Limits::hottest_K, " K");
    checkRange("p_atm", pressure_atm, Limits::thinnest_atm, Limits::densest_atm, " atm");
    checkRange("air_H2O", airWater, 0.0, 1.0, "");
    checkRange("air_CO2", airCO2, 0.0, 1.0, "");
    checkRange("soot_ppmv", soot_ppmv, 0.0, Limits::mostSoot_ppmv, " ppmv");
    check("carbon", carbon, carbon >= 0.0 && carbon + hydrogen > 0.0, "atoms of the fuel");
    check("hydrogen", hydrogen, hydrogen >= 0.0, "atoms of the fuel");
    check("ends_at", endsAt, endsAt >= 0.01 && endsAt < 1.0, "0.01 to below 1");
    const double dry = 1.0 - airWater - airCO2;
    const double fuel = fuelAirRatio * air_g_mol /
                        (carbon * carbon_g_mol + hydrogen * hydrogen_g_mol); // mol per mol of air
    const double oxygen = oxygenOfAir * dry - fuel * (carbon + 0.25 * hydrogen);
    check("fuel_air", fuelAirRatio, fuelAirRatio > 0.0 && oxygen >= 0.0,
          "above 0, and no more than the oxygen of the air burns");
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    const double all = 1.0 + 0.25 * hydrogen * fuel;
    GasLayer gas;
    gas.temperature_K = temperature_K;
    gas.pressure_atm = pressure_atm;
    gas.fraction(HotGas::CO2) = (airCO2 + carbon * fuel) / all;
    gas.fraction(HotGas::H2O) = (airWater + 0.5 * hydrogen * fuel) / all;
    gas.oxygenFraction = oxygen / all;
    gas.soot_ppmv = soot_ppmv;
    return gas;
}

GasLayer ExhaustInAir::at(double part) const {
    GasLayer gas = cold_;
    gas.temperature_K = std::lerp(cold_.temperature_K, hot_.temperature_K, part);
    for (std::size_t g = 0; g < hotGasCount; ++g)
        gas.moleFraction[g] = part * std::max(0.0, hot_.moleFraction[g] - cold_.moleFraction[g]);
    gas.oxygenFraction = std::lerp(cold_.oxygenFraction, hot_.oxygenFraction, part);
    // Thinned by volume, too, since hot gas shrinks as it cools.
    gas.soot_ppmv = hot_.soot_ppmv * part * hot_.temperature_K / gas.temperature_K;
    return gas;
}

PlumeTable RoundJet::table() const {
    const ExhaustInAir exhaust(*this);
    const double coflow = coflow_m_s / velocity_m_s;
    const double core_m = coreOverDiameter * diameter_m * std::sqrt(air_K / temperature_K) *
                          (1.0 + coflow) / (1.0 - coflow);
    const double length_m = core_m / endsAt;
    if (length_m > longestOverDiameter * diameter_m)
        throw InputError(
            {"jet", "ends_at", numberText(endsAt),
             numberText(std::ceil(100.0 * core_m / diameter_m / longestOverDiameter) / 100.0) +
                 " at least: with this co-flow the jet is " +
                 numberText(std::round(length_m / diameter_m)) +
                 " diameters long there, and 500 are the most"});
    std::vector<double> x_m, r_m;
    std::vector<Across> acrosses;
    for (std::size_t i = 0; i < alongNodes; ++i) { // by squares: it is short-lived at the nozzle
        const double part = static_cast<double>(i) / (alongNodes - 1);
        x_m.push_back(length_m * part * part);
        acrosses.push_back(acrossAt(*this, x_m.back(), core_m));
    }
    double widest_m = 0.0;
    for (const Across& across : acrosses)
        widest_m = std::max(widest_m, across.reach_m(0.01));
    for (std::size_t j = 0; j < acrossNodes; ++j) {
        const double part = static_cast<double>(j) / (acrossNodes - 1);
        r_m.push_back(widest_m * part * part);
    }
    std::vector<GasLayer> nodes;
    for (const Across& across : acrosses)
        for (const double r : r_m)
            nodes.push_back(exhaust.at(across.onAxis * across.bell(r)));
    return PlumeTable::ofNodes(std::move(x_m), std::move(r_m), std::move(nodes));
}

} // namespace irsg
