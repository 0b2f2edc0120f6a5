#include "irsg/atmosphere/engine/Profile.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"

namespace irsg {

namespace {

bool isWithin(double value, double least, double most) {
    return value >= least && value <= most; // false for nan
}

void checkLevel(const AtmosphericState& level, const std::string& position, const std::string& name,
                std::vector<Diagnostic>& diagnostics) {
    if (!std::isfinite(level.altitude_m))
        diagnostics.push_back(
            {name, position, numberText(level.altitude_m), "a finite altitude in m"});
    if (!isWithin(level.pressure_hPa, 1e-12, 2000.0))
        diagnostics.push_back({name, position, "pressure " + numberText(level.pressure_hPa),
                               "more than 0 and at most 2000 hPa"});
    if (!isWithin(level.temperature_K, 100.0, 400.0))
        diagnostics.push_back(
            {name, position, "temperature " + numberText(level.temperature_K), "100 to 400 K"});
    for (std::size_t gas = 0; gas < gasCount; ++gas)
        if (!isWithin(level.moleFraction[gas], 0.0, 1.0))
            diagnostics.push_back(
                {name, position,
                 std::string(gasNames[gas]) + " " + numberText(level.moleFraction[gas]),
                 "a mole fraction of 0 to 1"});
}

} // namespace

Profile::Profile(std::vector<AtmosphericState> levels, std::string name)
    : levels_(std::move(levels)), name_(std::move(name)) {
    std::vector<Diagnostic> diagnostics;
    if (levels_.size() < 2)
        diagnostics.push_back(
            {name_, "", std::to_string(levels_.size()) + " levels", "at least two levels"});
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const std::string position = "level " + std::to_string(i + 1);
        checkLevel(levels_[i], position, name_, diagnostics);
        if (i == 0) {
            if (levels_[i].altitude_m != 0.0)
                diagnostics.push_back({name_, position,
                                       "altitude " + numberText(levels_[i].altitude_m),
                                       "the lowest level at 0 m"});
            continue;
        }
        if (levels_[i].altitude_m <= levels_[i - 1].altitude_m)
            diagnostics.push_back({name_, position, "altitude " + numberText(levels_[i].altitude_m),
                                   "more than " + numberText(levels_[i - 1].altitude_m) +
                                       " m: altitudes ascend strictly"});
        if (levels_[i].pressure_hPa >= levels_[i - 1].pressure_hPa)
            diagnostics.push_back({name_, position,
                                   "pressure " + numberText(levels_[i].pressure_hPa),
                                   "less than " + numberText(levels_[i - 1].pressure_hPa) +
                                       " hPa: pressure falls with altitude"});
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
}

Profile Profile::withScaled(Gas gas, double factor) const {
    if (!(factor >= 0.0 && std::isfinite(factor)))
        throw LogicError("a gas was to be multiplied by " + numberText(factor));
    std::vector<AtmosphericState> levels = levels_;
    for (AtmosphericState& air : levels) {
        double& fraction = air.moleFraction[static_cast<std::size_t>(gas)];
        double most = 1.0;
        if (gas == Gas::H2O)
            most = std::max(fraction, saturationPressure_hPa(air.temperature_K) / air.pressure_hPa);
        fraction = std::min({fraction * factor, most, 1.0});
    }
    return Profile(std::move(levels), name_);
}

Profile Profile::withGroundAt(double ground_m) const {
    if (!(ground_m >= 0.0 && ground_m < top_m()))
        throw LogicError("a ground at " + numberText(ground_m) + " m");
    std::vector<AtmosphericState> levels{at(ground_m)};
    // A level that is nearly the ground is the ground.
    for (const AtmosphericState& level : levels_)
        if (level.altitude_m > ground_m + 1e-3)
            levels.push_back(level);
    for (AtmosphericState& level : levels)
        level.altitude_m -= ground_m;
    return Profile(std::move(levels), name_);
}

AtmosphericState Profile::at(double altitude_m) const {
    const auto [below, above, fraction] =
        bracket(levels_, altitude_m, Beyond::clamp, &AtmosphericState::altitude_m);
    const AtmosphericState& a = levels_[below];
    const AtmosphericState& b = levels_[above];
    AtmosphericState result;
    result.altitude_m = altitude_m;
    result.pressure_hPa = lerpByRatio(a.pressure_hPa, b.pressure_hPa, fraction);
    result.temperature_K = lerp(a.temperature_K, b.temperature_K, fraction);
    for (std::size_t gas = 0; gas < gasCount; ++gas)
        result.moleFraction[gas] = lerpByRatio(a.moleFraction[gas], b.moleFraction[gas], fraction);
    return result;
}

double saturationPressure_hPa(double temperature_K) {
    const double t = temperature_K;
    const double logarithm_Pa = 54.842763 - 6763.22 / t - 4.210 * std::log(t) + 0.000367 * t +
                                std::tanh(0.0415 * (t - 218.8)) *
                                    (53.878 - 1331.22 / t - 9.44523 * std::log(t) + 0.014025 * t);
    return 0.01 * std::exp(logarithm_Pa);
}

double relativeHumidity(const AtmosphericState& air) {
    return air.fraction(Gas::H2O) * air.pressure_hPa / saturationPressure_hPa(air.temperature_K);
}

} // namespace irsg
