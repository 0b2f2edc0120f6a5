#include "irsg/sensor/SensorDescription.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr double elementaryCharge_C = 1.602176634e-19;

/// Projected solid angle of a square of this half side at unit distance, seen along its axis: four
/// times that of a rectangle with a corner on the axis (Howell, configuration factor B-3).
double squareCone_sr(double halfSide) {
    const double part = halfSide / std::hypot(1.0, halfSide);
    return 4.0 * part * std::atan(part);
}

/// Collects what cannot be.
class Checks {
  public:
    void range(const char* key, double value, double least, double most) {
        if (!(value >= least && value <= most))
            refuse(key, numberText(value),
                   std::isinf(most)
                       ? "a number of at least " + numberText(least)
                       : "a number from " + numberText(least) + " to " + numberText(most));
    }
    void positive(const char* key, double value, double most) {
        if (!(value > 0.0 && value <= most))
            refuse(key, numberText(value), "a number above 0, at most " + numberText(most));
    }
    void spectrum(const char* key, const Spectrum& spectrum, const SpectralRange& band,
                  double most) {
        if (!(spectrum.minimum() >= 0.0 && spectrum.maximum() <= most))
            refuse(key, numberText(spectrum.minimum()) + " to " + numberText(spectrum.maximum()),
                   std::isinf(most) ? "values of at least 0"
                                    : "values from 0 to " + numberText(most));
        if (!spectrum.covers(band))
            refuse(key,
                   "values from " + numberText(spectrum.wavelengths_um().front()) + " to " +
                       numberText(spectrum.wavelengths_um().back()) + " um",
                   "a spectrum over the whole band, " + numberText(band.min_um) + " to " +
                       numberText(band.max_um) + " um");
    }
    void refuse(const char* key, std::string value, std::string expected) {
        diagnostics_.push_back({"", key, std::move(value), std::move(expected)});
    }
    void end() {
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
    }

  private:
    std::vector<Diagnostic> diagnostics_;
};

/// Of the response that images are rendered in; each of its nodes costs time.
constexpr double bandTolerance = 1e-5;

void checkOptics(const SensorOptics& optics, const SpectralRange& band, Checks& checks) {
    checks.positive("optics.aperture_m", optics.aperture_m, 100.0);
    checks.positive("optics.focalLength_m", optics.focalLength_m, 1000.0);
    if (optics.aperture_m > 0.0 && optics.focalLength_m > 0.0 && optics.fNumber() < 0.5)
        checks.refuse("optics.focalLength_m",
                      "F/" + numberText(std::round(1e4 * optics.fNumber()) / 1e4),
                      "at least F/0.5, the least f-number of optics without coma");
    if (optics.pupil == PupilShape::annular) {
        if (!(optics.obscuration > 0.0 && optics.obscuration < 1.0))
            checks.refuse("optics.obscuration", numberText(optics.obscuration),
                          "a number between 0 and 1, exclusive, for an annular pupil");
    } else if (optics.obscuration != 0.0) {
        checks.refuse("optics.obscuration", numberText(optics.obscuration),
                      "0, since only an annular pupil is obscured");
    }
    checks.spectrum("optics.transmission", optics.transmission, band, 1.0);
    if (optics.transmission.maximum() <= 0.0)
        checks.refuse("optics.transmission", "0", "values above 0");
    checks.range("optics.temperature_K", optics.temperature_K, 0.0, 1e4);
    checks.range("optics.emissivity", optics.emissivity, 0.0, 1.0);
    if (optics.transmission.maximum() + optics.emissivity > 1.0 + 1e-9)
        checks.refuse("optics.emissivity", numberText(optics.emissivity),
                      "at most what the transmission leaves, " +
                          numberText(1.0 - optics.transmission.maximum()));
    checks.range("optics.coldShieldEfficiency", optics.coldShieldEfficiency, 0.0, 1.0);
    checks.range("optics.housingTemperature_K", optics.housingTemperature_K, 0.0, 1e4);
    checks.range("optics.defocus_waves", optics.defocus_waves, -20.0, 20.0);
    if (optics.defocus_waves != 0.0)
        checks.positive("optics.defocusWavelength_um", optics.defocusWavelength_um, 1000.0);
    checks.range("optics.aberrationBlur_urad", optics.aberrationBlur_urad, 0.0, 1e6);
}

void checkDetector(const SensorDetector& detector, Checks& checks) {
    checks.positive("detector.pitch_um", detector.pitch_um, 1e6);
    if (!(detector.fillFactor > 0.0 && detector.fillFactor <= 1.0))
        checks.refuse("detector.fillFactor", numberText(detector.fillFactor),
                      "a number above 0, at most 1");
    checks.range("detector.columns", detector.columns, 1, largestResolution_px);
    checks.range("detector.rows", detector.rows, 1, largestResolution_px);
    checks.positive("detector.integrationTime_s", detector.integrationTime_s, 1e4);
    const char* key = detector.responseKind == ResponseKind::quantumEfficiency
                          ? "detector.quantumEfficiency"
                      : detector.isThermal() ? "detector.absorptance"
                                             : "detector.responsivity_A_per_W";
    const bool isFraction = detector.responseKind != ResponseKind::responsivity_A_per_W;
    checks.spectrum(key, detector.response, detector.band, isFraction ? 1.0 : 1e6);
    if (detector.response.maximum() <= 0.0)
        checks.refuse(key, "0", "values above 0");
    checks.range("detector.timeConstant_s", detector.timeConstant_s, 0.0, 1e3);
    if (detector.isThermal()) {
        if (detector.well_e)
            checks.refuse("detector.well_e", numberText(*detector.well_e),
                          "nothing: a thermal detector stores no electrons");
        if (detector.darkCurrent_e_per_s != 0.0)
            checks.refuse("detector.darkCurrent_e_per_s", numberText(detector.darkCurrent_e_per_s),
                          "nothing: a thermal detector has no dark electrons");
        checks.positive("detector.netd_K", detector.thermalNetd_K.value_or(0.0), 1e4);
        checks.range("detector.netdTemperature_K", detector.thermalNetdTemperature_K, 1.0, 1e4);
        return;
    }
    if (detector.thermalNetd_K)
        checks.refuse("detector.netd_K", numberText(*detector.thermalNetd_K),
                      "nothing: the noise of a photon detector follows from its electrons");
    checks.range("detector.darkCurrent_e_per_s", detector.darkCurrent_e_per_s, 0.0, 1e15);
    if (!detector.well_e)
        checks.refuse("detector.well_e", "nothing", "the electrons that a pixel holds");
    else if (!(*detector.well_e >= 1.0 && *detector.well_e <= 1e15))
        checks.refuse("detector.well_e", numberText(*detector.well_e),
                      "at least 1 electron, at most 1e15");
}

void checkNoise(const SensorNoise& noise, Checks& checks) {
    checks.positive("noise.referenceTemperature_K", noise.referenceTemperature_K, 1e4);
    const std::array<std::pair<const char*, double>, 6> parts{{{"noise.tv", noise.tv},
                                                               {"noise.th", noise.th},
                                                               {"noise.t", noise.t},
                                                               {"noise.vh", noise.vh},
                                                               {"noise.v", noise.v},
                                                               {"noise.h", noise.h}}};
    for (const auto& [key, value] : parts)
        checks.range(key, value, 0.0, 1e4);
    checks.range("noise.deadPixelFraction", noise.deadPixelFraction, 0.0, 1.0);
    checks.range("noise.hotPixelFraction", noise.hotPixelFraction, 0.0, 1.0);
    if (noise.deadPixelFraction + noise.hotPixelFraction > 1.0)
        checks.refuse("noise.hotPixelFraction", numberText(noise.hotPixelFraction),
                      "with the dead pixels at most 1");
}

} // namespace

double SensorOptics::apertureArea_m2() const {
    const double square = aperture_m * aperture_m;
    return pupil == PupilShape::square ? square
                                       : 0.25 * pi * square * (1.0 - obscuration * obscuration);
}

double SensorOptics::cone_sr(ConeConvention convention) const {
    if (convention == ConeConvention::smallAngle)
        return apertureArea_m2() / (focalLength_m * focalLength_m);
    const double tangent = 0.5 * aperture_m / focalLength_m;
    if (pupil == PupilShape::square)
        return squareCone_sr(tangent);
    const auto disc_sr = [](double t) { return pi * t * t / (1.0 + t * t); };
    return disc_sr(tangent) - disc_sr(obscuration * tangent);
}

double SensorDetector::activeWidth_um() const {
    return pitch_um * std::sqrt(fillFactor);
}

void SensorDescription::check() const {
    Checks checks;
    if (!(detector.band.min_um > 0.0 && detector.band.max_um > detector.band.min_um &&
          detector.band.max_um <= 1000.0)) {
        checks.refuse("detector.band_um",
                      numberText(detector.band.min_um) + " to " + numberText(detector.band.max_um),
                      "two ascending wavelengths above 0, at most 1000 um");
        checks.end();
    }
    checkOptics(optics, detector.band, checks);
    checkDetector(detector, checks);
    checks.range("motion.jitter_urad", motion.jitter_urad, 0.0, 1e6);
    checks.range("motion.lineOfSightRate_urad_per_s", motion.lineOfSightRate_urad_per_s, 0.0, 1e9);
    const bool isThermal = detector.isThermal();
    checks.positive(isThermal ? "electronics.gain_W_per_count" : "electronics.gain_e_per_count",
                    electronics.gain, 1e15);
    checks.range("electronics.offset_counts", electronics.offset_counts, -1e9, 1e9);
    const double largest_counts = std::ldexp(1.0, electronics.bits) - 1.0;
    if (electronics.bits >= 1 && electronics.offset_counts >= largest_counts)
        checks.refuse("electronics.offset_counts", numberText(electronics.offset_counts),
                      "less than the largest number that the converter tells, " +
                          numberText(largest_counts));
    checks.range("electronics.readNoise_e", electronics.readNoise_e, 0.0, 1e12);
    if (isThermal && electronics.readNoise_e != 0.0)
        checks.refuse("electronics.readNoise_e", numberText(electronics.readNoise_e),
                      "nothing: a thermal detector's noise is its netd_K");
    checks.range("electronics.bits", electronics.bits, 1, 32);
    checks.positive("electronics.frameRate_Hz", electronics.frameRate_Hz, 1e9);
    checkNoise(noise, checks);
    checks.end();
    // What the rendered image needs: the field of view, and a response with an area.
    pinhole().check();
}

double SensorDescription::activeArea_m2() const {
    const double width_m = 1e-6 * detector.activeWidth_um();
    return width_m * width_m;
}

double SensorDescription::signalPerJoule(double wavelength_um) const {
    const double response = detector.response.at(wavelength_um);
    switch (detector.responseKind) {
    case ResponseKind::quantumEfficiency:
        return response * 1e-6 * wavelength_um / (planckConstant_J_s * speedOfLight_m_s);
    case ResponseKind::responsivity_A_per_W:
        return response / elementaryCharge_C;
    case ResponseKind::absorptance:
        return response;
    }
    throw LogicError("a response of no kind");
}

double SensorDescription::peakSignalPerJoule() const {
    const Spectrum* const spectra[] = {&optics.transmission, &detector.response};
    std::vector<double> axis = mergeAxes(spectra, detector.band);
    double peak = 0.0;
    // Between nodes it is a product of three lines: looked at closely enough for a scale.
    for (std::size_t i = 0; i + 1 < axis.size(); ++i)
        for (int part = 0; part <= 8; ++part) {
            const double wavelength_um = std::lerp(axis[i], axis[i + 1], part / 8.0);
            peak = std::max(peak,
                            optics.transmission.at(wavelength_um) * signalPerJoule(wavelength_um));
        }
    return peak;
}

Band SensorDescription::band() const {
    const double scale = 1.0 / peakSignalPerJoule();
    const SpectralRange& range = detector.band;
    Spectrum relative = detector.response;
    if (detector.responseKind == ResponseKind::quantumEfficiency) {
        const Spectrum wavelength({range.min_um, range.max_um}, {range.min_um, range.max_um});
        relative = product(relative, wavelength, range, bandTolerance);
    }
    relative = product(relative, optics.transmission, range, bandTolerance);
    const double unit = detector.responseKind == ResponseKind::quantumEfficiency
                            ? 1e-6 / (planckConstant_J_s * speedOfLight_m_s)
                        : detector.isThermal() ? 1.0
                                               : 1.0 / elementaryCharge_C;
    relative = relative.mapped([&](double value) { return value * unit * scale; });
    if (relative.isConstant())
        relative =
            Spectrum({range.min_um, range.max_um}, {relative.values()[0], relative.values()[0]});
    return Band::fromResponse(Spectrum(relative.wavelengths_um(), relative.values(),
                                       Spectrum::Outside::zero, "response of the sensor"),
                              title.empty() ? "sensor" : title);
}

Sensor SensorDescription::pinhole() const {
    const double halfWidth = 0.5 * detector.columns * pixelAngle_rad();
    return {.width_px = detector.columns,
            .height_px = detector.rows,
            .horizontalFieldOfView_rad = 2.0 * std::atan(halfWidth),
            .band = band()};
}

} // namespace irsg
