#include "irsg/scene/background/BandSky.h"

#include <algorithm>

#include "irsg/atmosphere/ck/SensorCkData.h"

namespace irsg {

BandSky::BandSky(const Environment& environment, const SpectralRange& range,
                 const std::vector<double>& wavelengths_um, const std::vector<double>& weights_um,
                 const SensorCkData* ck)
    : environment_(environment),
      range_(range),
      wavelengths_um_(wavelengths_um),
      weights_um_(weights_um),
      ck_(ck) {}

double BandSky::integrate(const std::vector<double>& values) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
        sum += weights_um_[i] * values[i];
    return sum;
}

double BandSky::integrate(const Spectrum& spectrum) const {
    return integrate(spectrum.sample(wavelengths_um_));
}

void BandSky::note(const char* quantity, const std::string& who) const {
    const std::string line = std::string(quantity) + ": " + who;
    if (std::ranges::find(answeredBy_, line) == answeredBy_.end())
        answeredBy_.push_back(line);
}

double BandSky::radiance_W_m2_sr(const LineOfSight& sight) const {
    const auto taken = [&](const auto& answer) {
        note("background", answer.answeredBy);
        return integrate(answer.value);
    };
    return ck_ ? taken(environment_.ckBackgroundRadiance(sight, *ck_))
               : taken(environment_.backgroundRadiance(sight, range_));
}

double BandSky::sun_W_m2(double altitude_m) const {
    const auto taken = [&](const auto& answer) {
        note("solar disc", answer.answeredBy);
        return integrate(answer.value);
    };
    return ck_ ? taken(environment_.ckSolarIrradiance(altitude_m, *ck_))
               : taken(environment_.solarIrradiance(altitude_m, range_));
}

double BandSky::horizon_rad(double altitude_m) const {
    return environment_.horizonElevation_rad(altitude_m, range_);
}

} // namespace irsg
