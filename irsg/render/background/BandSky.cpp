#include "irsg/render/background/BandSky.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "irsg/atmosphere/NearestRun.h"

namespace irsg {

BandSky::BandSky(const Environment& environment, const SpectralSampling& sampling,
                 double raised_rad)
    : environment_(environment), sampling_(sampling), raised_rad_(raised_rad) {}

std::vector<double> BandSky::ask(const char* quantity, const AtmosphericQuery& query) const {
    auto answer = environment_.provide(query, sampling_);
    std::string line = quantity;
    line += ": ";
    line += answer.providedBy;
    addProvider(providedBy_, std::move(line));
    return std::move(answer.value);
}

double BandSky::radiance_W_m2_sr(const LineOfSight& sight) const {
    constexpr double zenith_rad = 0.5 * std::numbers::pi;
    LineOfSight apparent = sight;
    apparent.elevation_rad = std::clamp(sight.elevation_rad + raised_rad_, -zenith_rad, zenith_rad);
    const std::vector<double> values =
        ask("background", AtmosphericQuery::backgroundRadiance(apparent, environment_.sun));
    return sampling_.integrate(seen_ ? seen_(values) : values);
}

double BandSky::sun_W_m2(double altitude_m) const {
    return sampling_.integrate(
        ask("solar disc", AtmosphericQuery::solarIrradiance(altitude_m, environment_.sun)));
}

SunView BandSky::sunView(double altitude_m) const {
    SunView view = environment_.sunView(altitude_m, sampling_.range());
    view.elevation_rad -= raised_rad_;
    return view;
}

double BandSky::horizon_rad(double altitude_m) const {
    return apparentHorizon_rad(altitude_m) - raised_rad_;
}

double BandSky::apparentHorizon_rad(double altitude_m) const {
    return environment_.horizonElevation_rad(altitude_m, sampling_.range());
}

} // namespace irsg
