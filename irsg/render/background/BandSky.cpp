#include "irsg/render/background/BandSky.h"

#include "irsg/atmosphere/NearestRun.h"

namespace irsg {

BandSky::BandSky(const Environment& environment, const SpectralSampling& sampling)
    : environment_(environment), sampling_(sampling) {}

double BandSky::ask(const char* quantity, const AtmosphericQuery& query) const {
    const auto answer = environment_.provide(query, sampling_);
    std::string line = quantity;
    line += ": ";
    line += answer.providedBy;
    addProvider(providedBy_, std::move(line));
    return sampling_.integrate(answer.value);
}

double BandSky::radiance_W_m2_sr(const LineOfSight& sight) const {
    return ask("background", AtmosphericQuery::backgroundRadiance(sight, environment_.sun));
}

double BandSky::sun_W_m2(double altitude_m) const {
    return ask("solar disc", AtmosphericQuery::solarIrradiance(altitude_m, environment_.sun));
}

SunView BandSky::sunView(double altitude_m) const {
    return environment_.sunView(altitude_m, sampling_.range());
}

double BandSky::horizon_rad(double altitude_m) const {
    return environment_.horizonElevation_rad(altitude_m, sampling_.range());
}

} // namespace irsg
