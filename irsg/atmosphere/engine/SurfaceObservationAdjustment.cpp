#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "irsg/atmosphere/engine/Hydrostatics.h"
#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/core/Errors.h"

namespace irsg {

namespace {

constexpr double ceiling_m = 1000.0;
/// Of the logarithm of pressure: what the lowest kilometre may take up of a measured pressure that
/// does not fit the air above. Its steepest change, 1.5 times this per km, stays below the fall of
/// pressure in any air colder than 333 K (0.103 per km).
constexpr double greatestPressureMisfit = 0.05;

double smoothStep(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double hermite(double x, double width, double y0, double y1, double slope0, double slope1) {
    const double t = x / width;
    return y0 * (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t) + slope0 * x * (1.0 - t) * (1.0 - t) +
           y1 * t * t * (3.0 - 2.0 * t) + slope1 * width * t * t * (t - 1.0);
}

/// What is added to the temperature: a monotone piecewise cubic (Fritsch and Butland 1984) through
/// its values at 0 and at the measurement height, and 0 with slope 0 at the ceiling.
class TemperatureShift {
  public:
    TemperatureShift(double height_m, double atZero_K, double atHeight_K)
        : height_m_(height_m), atZero_K_(atZero_K), atHeight_K_(atHeight_K) {
        const double upper_m = ceiling_m - height_m;
        const double below = (atHeight_K - atZero_K) / height_m;
        const double above = -atHeight_K / upper_m;
        if (below * above > 0.0) {
            const double w1 = 2.0 * upper_m + height_m;
            const double w2 = upper_m + 2.0 * height_m;
            slopeAtHeight_ = (w1 + w2) / (w1 / below + w2 / above);
        }
        // The three-point slope at the end, held between 0 and three times the secant.
        const double end =
            ((2.0 * height_m + upper_m) * below - height_m * above) / (height_m + upper_m);
        slopeAtZero_ = end * below <= 0.0                      ? 0.0
                       : std::abs(end) > 3.0 * std::abs(below) ? 3.0 * below
                                                               : end;
    }

    double at(double altitude_m) const {
        if (altitude_m >= ceiling_m)
            return 0.0;
        if (altitude_m < height_m_)
            return hermite(altitude_m, height_m_, atZero_K_, atHeight_K_, slopeAtZero_,
                           slopeAtHeight_);
        return hermite(altitude_m - height_m_, ceiling_m - height_m_, atHeight_K_, 0.0,
                       slopeAtHeight_, 0.0);
    }

  private:
    double height_m_;
    double atZero_K_;
    double atHeight_K_;
    double slopeAtHeight_ = 0.0;
    double slopeAtZero_ = 0.0;
};

void check(const SurfaceObservation& measured, const Profile& profile) {
    std::vector<Diagnostic> diagnostics;
    const auto require = [&](const char* what, double value, double least, double most,
                             const char* unit) {
        if (!(value >= least && value <= most))
            diagnostics.push_back({"weather", what, numberText(value),
                                   numberText(least) + " to " + numberText(most) + unit});
    };
    require("height_m", measured.height_m, 2.0, 40.0, " m");
    require("temperature_K", measured.temperature_K, 213.15, 333.15, " K");
    require("pressure_hPa", measured.pressure_hPa, 800.0, 1200.0, " hPa");
    require("relativeHumidity", measured.relativeHumidity, 0.0, 1.0, "");
    require("temperatureAtZero_K", measured.temperatureAtZero_K, 213.15, 333.15, " K");
    if (profile.top_m() < ceiling_m)
        diagnostics.push_back({profile.name(), "", "top at " + numberText(profile.top_m()) + " m",
                               "a profile of at least 1000 m"});
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
}

/// The measured heights, a ladder that follows the curves, and the levels that were there.
std::vector<double> altitudesOf(const Profile& profile, double height_m) {
    std::vector<double> altitudes = {0.0, 0.5 * height_m, height_m, ceiling_m};
    for (const double rung : {10.0, 20.0, 40.0, 70.0, 100.0, 150.0, 200.0, 300.0, 400.0, 500.0,
                              600.0, 700.0, 800.0, 900.0, 950.0})
        if (rung > 1.4 * height_m)
            altitudes.push_back(rung);
    for (const AtmosphericState& level : profile.levels())
        if (std::ranges::none_of(altitudes, [&](double altitude_m) {
                return std::abs(altitude_m - level.altitude_m) < 1.0;
            }))
            altitudes.push_back(level.altitude_m);
    std::ranges::sort(altitudes);
    return altitudes;
}

void setWater(AtmosphericState& air, double humidity) {
    air.moleFraction[static_cast<std::size_t>(Gas::H2O)] =
        humidity * saturationPressure_hPa(air.temperature_K) / air.pressure_hPa;
}

} // namespace

Profile Profile::adjustedToSurfaceObservation(const SurfaceObservation& measured) const {
    check(measured, *this);
    const double height_m = measured.height_m;
    const AtmosphericState atHeight = at(height_m);
    const TemperatureShift shift(height_m,
                                 measured.temperatureAtZero_K - levels_.front().temperature_K,
                                 measured.temperature_K - atHeight.temperature_K);

    // Temperature and humidity first.
    std::vector<AtmosphericState> air;
    std::vector<double> humidity;
    std::size_t measuredLevel = 0;
    for (const double altitude_m : altitudesOf(*this, height_m)) {
        AtmosphericState level = at(altitude_m);
        const double weight = 1.0 - smoothStep((altitude_m - height_m) / (ceiling_m - height_m));
        humidity.push_back((1.0 - weight) * std::min(relativeHumidity(level), 1.0) +
                           weight * measured.relativeHumidity);
        if (altitude_m == height_m)
            measuredLevel = air.size();
        level.temperature_K += shift.at(altitude_m);
        air.push_back(level);
    }

    // Pressure by hydrostatics from the measured one, downwards and up to the ceiling. Water
    // follows pressure and has its own small weight in it: each level is done twice.
    air[measuredLevel].pressure_hPa = measured.pressure_hPa;
    setWater(air[measuredLevel], humidity[measuredLevel]);
    const auto step = [&](std::size_t from, std::size_t to) {
        for (int pass = 0; pass < 2; ++pass) {
            air[to].pressure_hPa = hydrostaticPressure_hPa(air[from], air[to]);
            setWater(air[to], humidity[to]);
        }
    };
    for (std::size_t i = measuredLevel; i > 0; --i)
        step(i, i - 1);
    std::size_t last = measuredLevel;
    for (; air[last].altitude_m < ceiling_m; ++last)
        step(last, last + 1);

    // The misfit at the ceiling is taken up between the measurement and the ceiling; what is more
    // than that stays with all the air above as a constant factor.
    const double misfit = std::log(at(ceiling_m).pressure_hPa / air[last].pressure_hPa);
    const double taken = std::clamp(misfit, -greatestPressureMisfit, greatestPressureMisfit);
    for (std::size_t i = measuredLevel + 1; i < air.size(); ++i) {
        const double altitude_m = air[i].altitude_m;
        if (altitude_m < ceiling_m) {
            air[i].pressure_hPa *=
                std::exp(taken * smoothStep((altitude_m - height_m) / (ceiling_m - height_m)));
            setWater(air[i], humidity[i]);
        } else {
            const AtmosphericState unchanged = at(altitude_m);
            air[i] = unchanged;
            air[i].pressure_hPa *= std::exp(taken - misfit);
        }
    }
    return Profile(std::move(air), name_ + " with measured weather");
}

} // namespace irsg
