#include "irsg/sensor/SensorNumbers.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Quadrature.h"
#include "irsg/radiometry/Units.h"
#include "irsg/sensor/RequirePositive.h"

namespace irsg {

namespace {

double rootSum(std::initializer_list<double> parts) {
    double sum = 0.0;
    for (const double part : parts)
        sum += part * part;
    return std::sqrt(sum);
}

} // namespace

double PixelNoise::temporal() const {
    return rootSum({photon, dark, read, quantisation, thermal});
}

double PixelNoise::total() const {
    return rootSum({temporal(), pattern});
}

PixelResponse::PixelResponse(const SensorDescription& sensor, ConeConvention convention)
    : sensor_(sensor),
      cone_sr_(sensor.optics.cone_sr(convention)),
      time_(sensor.detector.isThermal() ? 1.0 : sensor.detector.integrationTime_s) {
    const double perPower = time_ * sensor.peakSignalPerJoule();
    perRadiance_ = sensor.activeArea_m2() * cone_sr_ * perPower;
    perIrradiance_ = sensor.optics.apertureArea_m2() * perPower;
    if (sensor.detector.isThermal())
        thermalNoise_ = sensor.detector.thermalNetd_K.value_or(0.0) *
                        contrast_per_K(sensor.detector.thermalNetdTemperature_K);
    const SensorNoise& parts = sensor.noise;
    patternNoise_ = noise(signal(parts.referenceTemperature_K)).temporal() *
                    rootSum({parts.tv, parts.th, parts.t, parts.vh, parts.v, parts.h});
}

double PixelResponse::blackBodySignal(double temperature_K, bool throughOptics,
                                      bool derivative) const {
    if (temperature_K <= 0.0)
        return 0.0;
    constexpr double coldest_K = 1.0; // below it no nodes are dense enough for what radiates
    const SpectralRange& range = sensor_.detector.band;
    const Spectrum* const spectra[] = {&sensor_.optics.transmission, &sensor_.detector.response};
    const SpectralQuadrature quadrature(Band::topHat(range.min_um, range.max_um), spectra,
                                        std::clamp(temperature_K, coldest_K, 200.0));
    std::vector<double> values;
    for (const double wavelength_um : quadrature.wavelengths_um()) {
        const double source = derivative
                                  ? planckDerivative_W_m2_sr_um_K(wavelength_um, temperature_K)
                                  : planckRadiance_W_m2_sr_um(wavelength_um, temperature_K);
        const double passed = throughOptics ? sensor_.optics.transmission.at(wavelength_um) : 1.0;
        values.push_back(source * passed * sensor_.signalPerJoule(wavelength_um));
    }
    return sensor_.activeArea_m2() * time_ * quadrature.integrate(values);
}

PixelSignal PixelResponse::offset() const {
    const SensorOptics& optics = sensor_.optics;
    const double beside_sr = pi - cone_sr_;
    return {.optics =
                optics.emissivity * cone_sr_ * blackBodySignal(optics.temperature_K, false, false),
            .housing = (1.0 - optics.coldShieldEfficiency) * beside_sr *
                       blackBodySignal(optics.housingTemperature_K, false, false),
            .dark = sensor_.detector.darkCurrent_e_per_s * sensor_.detector.integrationTime_s};
}

PixelSignal PixelResponse::signal(double background_K) const {
    PixelSignal signal = offset();
    signal.scene = cone_sr_ * blackBodySignal(background_K, true, false);
    return signal;
}

double PixelResponse::contrast_per_K(double background_K) const {
    return cone_sr_ * blackBodySignal(background_K, true, true);
}

PixelNoise PixelResponse::noise(const PixelSignal& signal) const {
    PixelNoise noise;
    if (sensor_.detector.isThermal()) {
        noise.thermal = thermalNoise_;
    } else {
        noise.photon = std::sqrt(std::max(0.0, signal.scene + signal.optics + signal.housing));
        noise.dark = std::sqrt(signal.dark);
        noise.read = sensor_.electronics.readNoise_e;
    }
    noise.quantisation = sensor_.electronics.gain / std::sqrt(12.0);
    noise.pattern = patternNoise_;
    return noise;
}

double PixelResponse::fullSignal() const {
    const SensorElectronics& electronics = sensor_.electronics;
    const double converter =
        electronics.gain * (std::ldexp(1.0, electronics.bits) - 1.0 - electronics.offset_counts);
    return std::min(converter, sensor_.detector.well_e.value_or(converter));
}

SensorNumbers sensorNumbers(const SensorDescription& sensor, double background_K,
                            ConeConvention convention, double ensquaredEnergy) {
    requirePositive(background_K, "background temperature", "a temperature above 0 K");
    const PixelResponse response(sensor, convention);
    SensorNumbers numbers;
    numbers.convention = convention;
    numbers.signal = response.signal(background_K);
    numbers.noise = response.noise(numbers.signal);
    numbers.contrast_per_K = response.contrast_per_K(background_K);
    const double temporal = numbers.noise.temporal(), total = numbers.noise.total();
    numbers.netd_K = temporal / numbers.contrast_per_K;
    numbers.totalNetd_K = total / numbers.contrast_per_K;
    numbers.ner_W_m2_sr = temporal / response.signalPerRadiance();
    // On the detector: without the optics.
    const Spectrum* const spectra[] = {&sensor.detector.response};
    double peak = 0.0;
    for (const double wavelength_um : mergeAxes(spectra, sensor.detector.band))
        peak = std::max(peak, sensor.signalPerJoule(wavelength_um));
    const double time_s = sensor.detector.integrationTime_s;
    numbers.nep_W = temporal / (peak * (sensor.detector.isThermal() ? 1.0 : time_s));
    numbers.dStar_cm_sqrtHz_W =
        std::sqrt(1e4 * sensor.activeArea_m2() / (2.0 * time_s)) / numbers.nep_W;
    numbers.ensquaredEnergy = ensquaredEnergy;
    numbers.neiWholePoint_W_m2 = temporal / response.signalPerIrradiance();
    numbers.nei_W_m2 = numbers.neiWholePoint_W_m2 / ensquaredEnergy;
    numbers.totalNei_W_m2 = total / response.signalPerIrradiance() / ensquaredEnergy;
    numbers.wellFill = numbers.signal.total() / response.fullSignal();
    const PixelSignal dark = response.offset();
    numbers.dynamicRange_dB = 20.0 * std::log10((response.fullSignal() - dark.offset()) /
                                                response.noise(dark).temporal());
    return numbers;
}

} // namespace irsg
