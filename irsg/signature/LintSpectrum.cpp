#include "irsg/signature/LintSpectrum.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/signature/EntryJson.h"

namespace irsg {

namespace {

using Severity = Finding::Severity;

constexpr double coldest_K = 200.0;
constexpr double hottest_K = 4000.0;
/// W cm-2 over W m-2.
constexpr double areaFactor = 1e4;

/// The highest brightness temperature of a curve whose values are multiplied by `scale`, K; 0 where
/// nothing is emitted. Between the lines of a gas any temperature is right, so the peak is judged.
double peakBrightness_K(const Spectrum& radiance, double scale) {
    double peak_K = 0.0;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        const auto brightness_K =
            brightnessTemperature_K(radiance.wavelengths_um()[i], scale * radiance.values()[i]);
        peak_K = std::max(peak_K, brightness_K.value_or(0.0));
    }
    return peak_K;
}

bool isPlausible(double brightness_K) {
    return brightness_K >= coldest_K && brightness_K <= hottest_K;
}

void lintBrightness(const std::string& place, const Spectrum& radiance,
                    std::vector<Finding>& findings) {
    const double lowest = radiance.minimum();
    if (lowest < 0.0) {
        findings.push_back({Severity::warning, place, numberText(lowest) + " W m-2 sr-1 um-1",
                            "expected radiance of at least 0", "noise of a measurement? Set to 0"});
    }
    const double peak_K = peakBrightness_K(radiance, 1.0);
    if (isPlausible(peak_K) || peak_K == 0.0) {
        return;
    }
    const double scale = peak_K < coldest_K ? areaFactor : 1.0 / areaFactor;
    std::string repair;
    if (isPlausible(peakBrightness_K(radiance, scale))) {
        repair = peak_K < coldest_K ? "suspect: W cm-2 read as W m-2, a factor of 1e4 too small"
                                    : "suspect: W m-2 read as W cm-2, a factor of 1e4 too large";
    }
    findings.push_back({Severity::warning, place,
                        "peak brightness temperature " + numberText(std::round(peak_K)) + " K",
                        "expected a brightness temperature from 200 to 4000 K", repair});
}

} // namespace

void lintSpectrum(const std::string& key, const UserSpectrum& spectrum,
                  std::vector<Finding>& findings) {
    const std::string path = spectrumPath(key);
    const auto error = [&](std::string place, std::string value, const std::string& expected) {
        findings.push_back(
            {Severity::error, std::move(place), std::move(value), "expected " + expected, ""});
    };
    if (key.empty() || spectrum.name != key) {
        error(path, "the name '" + spectrum.name + "'",
              "the name it is filed under, '" + key + "', and not an empty one");
    }
    if (!(spectrum.referenceDistance_m >= 0.0) || !std::isfinite(spectrum.referenceDistance_m)) {
        error(path + ".referenceDistance_m", numberText(spectrum.referenceDistance_m),
              "a distance of at least 0 m");
    }
    if (spectrum.components.empty()) {
        error(path + ".components", "none", "at least one component");
    }

    std::set<std::string> names;
    for (const SpectrumComponent& component : spectrum.components) {
        const std::string place = path + "." + component.name;
        const Spectrum& radiance = component.radiance;
        const bool control = std::ranges::any_of(
            component.name, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
        if (component.name.empty() || control) {
            error(path + ".components", "the name '" + component.name + "'",
                  "a name of one line, not empty");
        }
        if (!names.insert(component.name).second) {
            error(place, "a second component of this name", "each name once");
        }
        if (radiance.isConstant() || radiance.outside() != Spectrum::Outside::zero) {
            error(place, "a curve without end", "nodes, and nothing emitted outside of them");
        } else if (radiance.wavelengths_um() !=
                   spectrum.components.front().radiance.wavelengths_um()) {
            error(place, "an axis of its own", "the axis that all components share");
        } else {
            lintBrightness(place, radiance, findings);
        }
    }
}

} // namespace irsg
