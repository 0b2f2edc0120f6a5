#include "irsg/signature/LintUnits.h"

#include <algorithm>
#include <cmath>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/Findings.h"
#include "irsg/signature/LintAxis.h"
#include "irsg/signature/SpectrumCsv.h"

namespace irsg {

namespace {

constexpr double coldest_K = 200.0;
constexpr double hottest_K = 4000.0;
/// W cm-2 over W m-2.
constexpr double areaFactor = 1e4;
/// Three digits of a printed table are a misfit of 0.0015; shapes that are wrong by the square of
/// the wavelength are 0.02 off over 3-5 um.
constexpr double greyMisfit = 0.003;
constexpr double wrongShape = 5.0;
/// A black body's emissivity with the rounding of a fit; no surface shows less than the least.
constexpr double mostEmissivity = 1.05;
constexpr double leastEmissivity = 1e-3;

/// What the values of a curve would have to be multiplied by, node by node, had the file meant
/// another unit than it was read in.
struct UnitReading {
    double factor = 1.0;
    enum class Jacobian { none, perWavenumber, perMicrometre } jacobian = Jacobian::none;
    std::string suspicion;

    double at(double wavelength_um) const {
        switch (jacobian) {
        case Jacobian::perWavenumber:
            return factor * perMicrometreFromPerWavenumber(
                                1.0, wavenumberFromWavelength_per_cm(wavelength_um));
        case Jacobian::perMicrometre:
            return factor * perWavenumberFromPerMicrometre(1.0, wavelength_um);
        case Jacobian::none:
            break;
        }
        return factor;
    }
};

using Jacobian = UnitReading::Jacobian;

const UnitReading perWavenumberReadAsPerMicrometre{
    1.0, Jacobian::perWavenumber, "suspect: a density per cm-1 read as one per um"};
const UnitReading perMicrometreReadAsPerWavenumber{
    1.0, Jacobian::perMicrometre, "suspect: a density per um read as one per cm-1"};

/// In the order in which they are suspected.
std::vector<UnitReading> otherUnits(bool tooSmall) {
    if (tooSmall) {
        return {
            {areaFactor, Jacobian::none,
             "suspect: W cm-2 read as W m-2, a factor of 1e4 too small"},
            perWavenumberReadAsPerMicrometre,
            {areaFactor, Jacobian::perWavenumber, "suspect: W cm-2 per cm-1 read as W m-2 per um"}};
    }
    return {{1.0 / areaFactor, Jacobian::none,
             "suspect: W m-2 read as W cm-2, a factor of 1e4 too large"},
            perMicrometreReadAsPerWavenumber,
            {1e-3, Jacobian::none, "suspect: mW read as W, a factor of 1e3 too large"},
            {1e-6, Jacobian::none, "suspect: uW read as W, a factor of 1e6 too large"},
            {1.0 / areaFactor, Jacobian::perMicrometre,
             "suspect: W m-2 per um read as W cm-2 per cm-1"}};
}

std::vector<double> readAs(const Spectrum& radiance, const UnitReading& reading) {
    std::vector<double> values;
    for (std::size_t i = 0; i < radiance.size(); ++i)
        values.push_back(radiance.values()[i] * reading.at(radiance.wavelengths_um()[i]));
    return values;
}

/// The highest brightness temperature of a curve, K; 0 where nothing is emitted.
double peakBrightness_K(const std::vector<double>& wavelengths_um,
                        const std::vector<double>& values) {
    double peak_K = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto brightness_K = brightnessTemperature_K(wavelengths_um[i], values[i]);
        peak_K = std::max(peak_K, brightness_K.value_or(0.0));
    }
    return peak_K;
}

bool isPlausible(double brightness_K) {
    return brightness_K >= coldest_K && brightness_K <= hottest_K;
}

/// The repair says in the notes of the spectrum what was done to it.
Finding::Repair multiply(const std::string& key, const std::string& component,
                         const UnitReading& reading) {
    return onSpectrum(key, [component, reading](UserSpectrum& spectrum) {
        for (SpectrumComponent& each : spectrum.components) {
            if (each.name == component) {
                each.radiance = Spectrum(each.radiance.wavelengths_um(),
                                         readAs(each.radiance, reading), Spectrum::Outside::zero);
                spectrum.notes += (spectrum.notes.empty() ? "" : "; ") + component +
                                  " repaired by lint, " + reading.suspicion;
            }
        }
    });
}

bool isLikely(const GreyBody& body) {
    return body.misfit <= greyMisfit && isPlausible(body.temperature_K) &&
           body.emissivity >= leastEmissivity && body.emissivity <= mostEmissivity;
}

/// The reading under which a curve that is no likely grey body's as it stands is one: of the same
/// shape, or of a shape that fits far better.
std::optional<UnitReading> greyReading(const Spectrum& radiance,
                                       const std::optional<GreyBody>& given) {
    if (given && isLikely(*given))
        return std::nullopt;
    for (const bool tooSmall : {true, false}) {
        for (const UnitReading& reading : otherUnits(tooSmall)) {
            const auto fit = fitGreyBody(radiance.wavelengths_um(), readAs(radiance, reading));
            if (!fit)
                continue;
            const bool better = reading.jacobian == Jacobian::none || !given ||
                                given->misfit > wrongShape * fit->misfit;
            if (isLikely(*fit) && better)
                return reading;
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<GreyBody> fitGreyBody(const std::vector<double>& wavelengths_um,
                                    const std::vector<double>& radiance_W_m2_sr_um) {
    const std::size_t n = wavelengths_um.size();
    if (n < 5 || std::ranges::any_of(radiance_W_m2_sr_um, [](double v) { return !(v > 0.0); }))
        return std::nullopt;
    std::vector<double> logs;
    double meanInverse = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        logs.push_back(std::log(firstRadiationConstant_W_um4_m2_sr / radiance_W_m2_sr_um[i]) -
                       5.0 * std::log(wavelengths_um[i]));
        meanInverse += 1.0 / wavelengths_um[i] / static_cast<double>(n);
    }
    GreyBody body;
    double slope_um = 0.0; // c2 / T
    constexpr int rounds = 60;
    for (int round = 0; round < rounds; ++round) {
        // The straight line through what is left when the last term is taken away.
        const auto left = [&](std::size_t i) {
            const double x = slope_um / wavelengths_um[i];
            return logs[i] - (slope_um > 0.0 ? std::log(-std::expm1(-x)) : 0.0);
        };
        double mean = 0.0;
        for (std::size_t i = 0; i < n; ++i)
            mean += left(i) / static_cast<double>(n);
        double covariance = 0.0;
        double variance = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            const double inverse = 1.0 / wavelengths_um[i] - meanInverse;
            covariance += inverse * (left(i) - mean);
            variance += inverse * inverse;
        }
        const double slopeBefore_um = slope_um;
        const double next_um = covariance / variance;
        double squares = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            const double inverse = 1.0 / wavelengths_um[i] - meanInverse;
            const double miss = left(i) - mean - next_um * inverse;
            squares += miss * miss;
        }
        if (!(next_um > 0.0))
            return std::nullopt;
        slope_um = next_um;
        body.temperature_K = secondRadiationConstant_um_K / slope_um;
        body.emissivity = std::exp(slope_um * meanInverse - mean);
        body.misfit = std::sqrt(squares / static_cast<double>(n));
        if (std::abs(slope_um - slopeBefore_um) <= 1e-12 * slope_um)
            break;
    }
    return body;
}

void lintRadianceUnit(const std::string& key, const UserSpectrum& spectrum, std::size_t component,
                      Findings& findings) {
    const SpectrumComponent& curve = spectrum.components[component];
    const Spectrum& radiance = curve.radiance;
    const auto& axis_um = radiance.wavelengths_um();
    const std::string place = "." + curve.name;
    const double peak_K = peakBrightness_K(axis_um, radiance.values());

    const auto given = fitGreyBody(axis_um, radiance.values());
    if (const auto reading = greyReading(radiance, given)) {
        const auto body = fitGreyBody(axis_um, readAs(radiance, *reading));
        const bool sameShape = given && given->misfit <= greyMisfit;
        Finding& found = findings.warning(
            place,
            sameShape ? "the curve of a body of " + rounded(given->temperature_K) +
                            " K with an emissivity of " + rounded(given->emissivity)
                      : "a curve that is no grey body's, and read otherwise is one of " +
                            rounded(body->temperature_K) + " K",
            "the unit that the file holds: " + rounded(body->temperature_K) +
                " K and an emissivity of " + rounded(body->emissivity) + " in another");
        found.remedy = reading->suspicion;
        found.repair = multiply(key, curve.name, *reading);
        return;
    }
    if (peak_K == 0.0 || isPlausible(peak_K))
        return;
    Finding& found = findings.warning(
        place, "peak brightness temperature " + numberText(std::round(peak_K)) + " K",
        "a brightness temperature from 200 to 4000 K");
    for (const UnitReading& reading : otherUnits(peak_K < coldest_K)) {
        if (isPlausible(peakBrightness_K(axis_um, readAs(radiance, reading)))) {
            found.remedy = reading.suspicion;
            found.repair = multiply(key, curve.name, reading);
            break;
        }
    }
}

bool lintSpectrumAxis(const std::string& key, const UserSpectrum& spectrum,
                      const std::vector<SpectralRange>& bands, Findings& findings) {
    const auto& axis_um = spectrum.components.front().radiance.wavelengths_um();
    if (axis_um.empty() || !isAbsurdAxis(axis_um.front(), axis_um.back()))
        return false;
    Finding& found = findings.warning(
        "", numberText(axis_um.front()) + " to " + numberText(axis_um.back()) + " um",
        "wavelengths from 0.1 to 200 um");
    const auto readings = otherReadings(axis_um.front(), axis_um.back(), bands);
    const bool clear = isClear(readings, axis_um.front(), axis_um.back(), bands);
    found.remedy = axisRepair(readings, clear);
    if (!clear)
        return true;
    found.repair = onSpectrum(key, [reading = readings.front()](UserSpectrum& to) {
        bool perWavenumber = false;
        try {
            perWavenumber = SpectralRadianceUnit::parse(to.importedUnit).perWavenumber;
        } catch (const InputError&) {
            // Without a unit that is known, the values are taken for densities per um.
        }
        for (SpectrumComponent& component : to.components) {
            const auto before_um = component.radiance.wavelengths_um();
            std::vector<std::size_t> order;
            auto after_um = readOtherwise(before_um, reading, order);
            std::vector<double> values;
            for (std::size_t i = 0; i < order.size(); ++i) {
                const double shift = before_um[order[i]] / after_um[i];
                values.push_back(component.radiance.values()[order[i]] *
                                 (perWavenumber ? shift * shift : 1.0));
            }
            component.radiance =
                Spectrum(std::move(after_um), std::move(values), Spectrum::Outside::zero);
        }
    });
    return true;
}

} // namespace irsg
