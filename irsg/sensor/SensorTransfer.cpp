#include "irsg/sensor/SensorTransfer.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/sensor/PupilTransfer.h"
#include "irsg/sensor/Sinc.h"

namespace irsg {

namespace {

/// Neighbouring wavelengths are joined at their mean: their number is that of the frequencies.
constexpr std::size_t mostWavelengths = 96;

double gaussianTransfer(double deviation_rad, double frequency_per_rad) {
    const double product = pi * deviation_rad * frequency_per_rad;
    return std::exp(-2.0 * product * product);
}

} // namespace

SensorTransfer::SensorTransfer(const SensorDescription& sensor, double source_K) : sensor_(sensor) {
    if (!(source_K > 0.0 && std::isfinite(source_K)))
        throw InputError(
            {"", "source temperature", numberText(source_K), "a temperature above 0 K"});
    const SpectralRange& range = sensor.detector.band;
    const Spectrum* const spectra[] = {&sensor.optics.transmission, &sensor.detector.response};
    // Relative to the long end, so that a cold source does not underflow.
    const double peak_um = range.max_um;
    const double scale = planckRadiance_W_m2_sr_um(peak_um, source_K);
    std::vector<double> sums(mostWavelengths), moments(mostWavelengths);
    double total = 0.0;
    const GaussRule& rule = gaussLegendre(4);
    const std::vector<double> axis = mergeAxes(spectra, range);
    const double binWidth_um = range.width_um() / mostWavelengths;
    std::size_t interval = 0;
    for (std::size_t bin = 0; bin < mostWavelengths; ++bin) {
        // In pieces between the nodes of the spectra.
        double from_um = range.min_um + static_cast<double>(bin) * binWidth_um;
        const double end_um = from_um + binWidth_um;
        while (from_um < end_um) {
            while (interval + 2 < axis.size() && axis[interval + 1] <= from_um)
                ++interval;
            const bool isLast = interval + 2 >= axis.size() || axis[interval + 1] >= end_um;
            const double to_um = isLast ? end_um : axis[interval + 1];
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                const double wavelength_um = std::lerp(from_um, to_um, rule.nodes[i]);
                const double radiance =
                    scale > 0.0 ? planckRadiance_W_m2_sr_um(wavelength_um, source_K) / scale : 1.0;
                const double weight = rule.weights[i] * (to_um - from_um) * radiance *
                                      sensor.optics.transmission.at(wavelength_um) *
                                      sensor.signalPerJoule(wavelength_um);
                sums[bin] += weight;
                moments[bin] += weight * wavelength_um;
                total += weight;
            }
            from_um = to_um;
        }
    }
    for (std::size_t bin = 0; bin < mostWavelengths; ++bin) {
        if (sums[bin] <= 0.0)
            continue;
        const double wavelength_um = moments[bin] / sums[bin];
        nodes_.push_back(
            {1e-6 * wavelength_um, sums[bin] / total,
             sensor.optics.defocus_waves * sensor.optics.defocusWavelength_um / wavelength_um});
    }
    cutoff_per_rad_ = sensor.optics.aperture_m / nodes_.front().wavelength_m;
}

double SensorTransfer::averaged(double x_per_rad, double y_per_rad, bool isDefocused) const {
    const SensorOptics& optics = sensor_.optics;
    double sum = 0.0;
    for (const Node& node : nodes_) {
        const double radii = 2.0 * node.wavelength_m / optics.aperture_m;
        sum += node.weight * pupilTransfer(optics.pupil, optics.obscuration,
                                           isDefocused ? node.waves : 0.0, radii * x_per_rad,
                                           radii * y_per_rad);
    }
    return sum;
}

double SensorTransfer::diffraction(double x_per_rad, double y_per_rad) const {
    return averaged(x_per_rad, y_per_rad, false);
}

double SensorTransfer::optics(double x_per_rad, double y_per_rad) const {
    return averaged(x_per_rad, y_per_rad, true);
}

double SensorTransfer::alongColumns(double y_per_rad) const {
    const double active_rad =
        1e-6 * sensor_.detector.activeWidth_um() / sensor_.optics.focalLength_m;
    return gaussianTransfer(1e-6 * sensor_.optics.aberrationBlur_urad, y_per_rad) *
           sinc(active_rad * y_per_rad) *
           gaussianTransfer(1e-6 * sensor_.motion.jitter_urad, y_per_rad);
}

double SensorTransfer::alongRows(double x_per_rad) const {
    const double rate_rad_per_s = 1e-6 * sensor_.motion.lineOfSightRate_urad_per_s;
    const double smear_rad = rate_rad_per_s * sensor_.detector.integrationTime_s;
    const double lag = 2.0 * pi * rate_rad_per_s * sensor_.detector.timeConstant_s * x_per_rad;
    return alongColumns(x_per_rad) * sinc(smear_rad * x_per_rad) / std::hypot(1.0, lag);
}

std::vector<SensorTransfer::Component> SensorTransfer::components(double x_per_rad,
                                                                  double y_per_rad) const {
    const double diffracted = diffraction(x_per_rad, y_per_rad);
    const double defocused =
        sensor_.optics.defocus_waves == 0.0 ? diffracted : optics(x_per_rad, y_per_rad);
    const double active_rad =
        1e-6 * sensor_.detector.activeWidth_um() / sensor_.optics.focalLength_m;
    const double blur_rad = 1e-6 * sensor_.optics.aberrationBlur_urad;
    const double jitter_rad = 1e-6 * sensor_.motion.jitter_urad;
    const double rate_rad_per_s = 1e-6 * sensor_.motion.lineOfSightRate_urad_per_s;
    return {
        {"diffraction", diffracted},
        {"defocus", diffracted == 0.0 ? 1.0 : defocused / diffracted},
        {"aberration", gaussianTransfer(blur_rad, std::hypot(x_per_rad, y_per_rad))},
        {"detector", sinc(active_rad * x_per_rad) * sinc(active_rad * y_per_rad)},
        {"jitter", gaussianTransfer(jitter_rad, std::hypot(x_per_rad, y_per_rad))},
        {"motion", sinc(rate_rad_per_s * sensor_.detector.integrationTime_s * x_per_rad)},
        {"time_constant", 1.0 / std::hypot(1.0, 2.0 * pi * rate_rad_per_s *
                                                    sensor_.detector.timeConstant_s * x_per_rad)}};
}

double SensorTransfer::at(double x_per_rad, double y_per_rad) const {
    return optics(x_per_rad, y_per_rad) * alongRows(x_per_rad) * alongColumns(y_per_rad);
}

double SensorTransfer::spread_rad() const {
    const double longest_m = nodes_.back().wavelength_m;
    const double airy_rad = 1.22 * longest_m / sensor_.optics.aperture_m;
    // The slope of a defocused wavefront at the edge of the pupil.
    const double defocus_rad =
        4.0 * std::abs(nodes_.back().waves) * longest_m / sensor_.optics.aperture_m;
    const double gauss_rad =
        4e-6 * std::hypot(sensor_.optics.aberrationBlur_urad, sensor_.motion.jitter_urad);
    const double smear_rad =
        1e-6 * sensor_.motion.lineOfSightRate_urad_per_s *
        (0.5 * sensor_.detector.integrationTime_s + 8.0 * sensor_.detector.timeConstant_s);
    return 4.0 * airy_rad + defocus_rad + gauss_rad + smear_rad + 0.5 * sensor_.pixelAngle_rad();
}

} // namespace irsg
