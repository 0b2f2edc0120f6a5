#include "irsg/scene/HazeGains.h"

#include <algorithm>
#include <optional>

namespace irsg {

namespace {

/// Intensity, contrast and irradiance of one number.
void addHaze(const HazeGain& gain, double& intensity, double& contrast, double& irradiance) {
    const double hidden = intensity - contrast;
    irradiance += gain.irradiance_per_m2 * intensity - gain.hiddenIrradiance_per_m2 * hidden;
    intensity *= gain.intensity;
    contrast = intensity - gain.hidden * hidden;
}

void scale(std::optional<RadiometryErrors>& errors, double gain) {
    if (!errors)
        return;
    for (ErrorParts* parts :
         {&errors->intensity_W_sr, &errors->contrastIntensity_W_sr, &errors->irradiance_W_m2})
        *parts = parts->times(gain);
}

void addHaze(const HazeGain& gain, ObjectRadiometry& object) {
    addHaze(gain, object.intensity_W_sr, object.contrastIntensity_W_sr, object.irradiance_W_m2);
    scale(object.errors, gain.intensity);
    for (SurfaceRadiometry& surface : object.surfaces)
        addHaze(gain, surface.intensity_W_sr, surface.contrastIntensity_W_sr,
                surface.irradiance_W_m2);
}

/// One number after the other of spectra of the same length.
void addHaze(const HazeGain& gain, std::vector<double>& intensity, std::vector<double>& contrast,
             std::vector<double>& irradiance) {
    for (std::size_t i = 0; i < intensity.size(); ++i)
        addHaze(gain, intensity[i], contrast[i], irradiance[i]);
}

void scale(std::vector<RadiometryErrors>& errors, double gain) {
    for (RadiometryErrors& one : errors) {
        std::optional<RadiometryErrors> scaled = one;
        scale(scaled, gain);
        one = *scaled;
    }
}

} // namespace

HazeGain gainOfAll(const HazeGains& gains, const std::vector<ObjectRadiometry>& direct) {
    HazeGain sum{0.0, 0.0, 0.0, 0.0};
    double intensity_W_sr = 0.0, hidden_W_sr = 0.0;
    for (std::size_t e = 0; e < gains.size(); ++e) {
        const double sent = direct[e].intensity_W_sr;
        const double hides = sent - direct[e].contrastIntensity_W_sr;
        intensity_W_sr += sent;
        hidden_W_sr += hides;
        sum.intensity += gains[e].intensity * sent;
        sum.hidden += gains[e].hidden * hides;
        sum.irradiance_per_m2 += gains[e].irradiance_per_m2 * sent;
        sum.hiddenIrradiance_per_m2 += gains[e].hiddenIrradiance_per_m2 * hides;
    }
    HazeGain mean;
    if (intensity_W_sr != 0.0) {
        mean.intensity = sum.intensity / intensity_W_sr;
        mean.irradiance_per_m2 = sum.irradiance_per_m2 / intensity_W_sr;
    }
    if (hidden_W_sr != 0.0) {
        mean.hidden = sum.hidden / hidden_W_sr;
        mean.hiddenIrradiance_per_m2 = sum.hiddenIrradiance_per_m2 / hidden_W_sr;
    }
    return mean;
}

void addHaze(const HazeGains& gains, RenderReport& report) {
    if (gains.empty())
        return;
    const HazeGain ofAll = gainOfAll(gains, report.objects);
    const double direct_W_m2 = report.all.irradiance_W_m2;
    addHaze(ofAll, report.all);
    for (std::size_t e = 0; e < gains.size(); ++e)
        addHaze(gains[e], report.objects[e]);
    report.totalIrradiance_W_m2 += report.all.irradiance_W_m2 - direct_W_m2;
}

void addHaze(const HazeGains& gains, IntensitySpectrum& spectrum) {
    if (gains.empty())
        return;
    if (spectrum.objects.empty()) {
        addHaze(gains.front(), spectrum.intensity_W_sr_um, spectrum.contrastIntensity_W_sr_um,
                spectrum.irradiance_W_m2_um);
        scale(spectrum.errors, gains.front().intensity);
        return;
    }
    double mostGain = 0.0;
    std::vector<double>* const totals[] = {&spectrum.intensity_W_sr_um,
                                           &spectrum.contrastIntensity_W_sr_um,
                                           &spectrum.irradiance_W_m2_um};
    for (std::vector<double>* total : totals)
        total->assign(total->size(), 0.0);
    for (std::size_t e = 0; e < spectrum.objects.size(); ++e) {
        ObjectSpectrum& object = spectrum.objects[e];
        addHaze(gains[e], object.intensity_W_sr_um, object.contrastIntensity_W_sr_um,
                object.irradiance_W_m2_um);
        scale(object.errors, gains[e].intensity);
        mostGain = std::max(mostGain, gains[e].intensity);
        for (std::size_t i = 0; i < object.intensity_W_sr_um.size(); ++i) {
            spectrum.intensity_W_sr_um[i] += object.intensity_W_sr_um[i];
            spectrum.contrastIntensity_W_sr_um[i] += object.contrastIntensity_W_sr_um[i];
            spectrum.irradiance_W_m2_um[i] += object.irradiance_W_m2_um[i];
        }
    }
    scale(spectrum.errors, mostGain);
}

void HazedScaledView::evaluate(std::span<const double> scales, ScaledValues& values,
                               Memo* memo) const {
    direct_->evaluate(scales, values, memo);
    addHaze(gain_, values.intensity, values.contrastIntensity, values.irradiance);
}

} // namespace irsg
