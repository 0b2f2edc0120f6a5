#include "smatcore/analysis/RangeSensitivity.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include "irsg/core/Errors.h"
#include "smatcore/project/SceneScalings.h"

namespace smat {

namespace {

/// Relative changes to both sides: of the sensor and of ranges, and of the target.
constexpr double step = 0.01, targetStep = 0.002;

using Change = std::function<void(double&)>;

void change(irsg::Spectrum& spectrum, const Change& one) {
    spectrum = spectrum.mapped([&](double value) {
        one(value);
        return value;
    });
}

/// A number of a request, or several that are changed alike.
struct Number {
    const char* key;
    const char* title;
    void (*each)(DetectionRequest& request, const Change& one);
};

const std::vector<Number>& numbers() {
    using Request = DetectionRequest;
    static const std::vector<Number> all = {
        {"aperture", "aperture of the optics",
         [](Request& r, const Change& one) { one(r.sensor.optics.aperture_m); }},
        {"focal_length", "focal length",
         [](Request& r, const Change& one) { one(r.sensor.optics.focalLength_m); }},
        {"transmission", "transmission of the optics",
         [](Request& r, const Change& one) { change(r.sensor.optics.transmission, one); }},
        {"defocus", "defocus",
         [](Request& r, const Change& one) { one(r.sensor.optics.defocus_waves); }},
        {"aberration", "aberration blur",
         [](Request& r, const Change& one) { one(r.sensor.optics.aberrationBlur_urad); }},
        {"pitch", "pitch of the pixels",
         [](Request& r, const Change& one) { one(r.sensor.detector.pitch_um); }},
        {"fill_factor", "fill factor",
         [](Request& r, const Change& one) { one(r.sensor.detector.fillFactor); }},
        {"integration_time", "integration time",
         [](Request& r, const Change& one) { one(r.sensor.detector.integrationTime_s); }},
        {"response", "response of the detector",
         [](Request& r, const Change& one) { change(r.sensor.detector.response, one); }},
        {"dark_current", "dark current",
         [](Request& r, const Change& one) { one(r.sensor.detector.darkCurrent_e_per_s); }},
        {"time_constant", "time constant",
         [](Request& r, const Change& one) { one(r.sensor.detector.timeConstant_s); }},
        {"netd", "NETD of the detector",
         [](Request& r, const Change& one) {
             if (r.sensor.detector.thermalNetd_K)
                 one(*r.sensor.detector.thermalNetd_K);
         }},
        {"jitter", "jitter",
         [](Request& r, const Change& one) { one(r.sensor.motion.jitter_urad); }},
        {"line_of_sight_rate", "line of sight rate",
         [](Request& r, const Change& one) { one(r.sensor.motion.lineOfSightRate_urad_per_s); }},
        {"read_noise", "read noise",
         [](Request& r, const Change& one) { one(r.sensor.electronics.readNoise_e); }},
        {"gain", "gain", [](Request& r, const Change& one) { one(r.sensor.electronics.gain); }},
        {"pattern_noise", "pattern noise",
         [](Request& r, const Change& one) {
             irsg::SensorNoise& noise = r.sensor.noise;
             for (double* part : {&noise.tv, &noise.th, &noise.t, &noise.vh, &noise.v, &noise.h})
                 one(*part);
         }},
        {"threshold", "threshold",
         [](Request& r, const Change& one) {
             one(r.criterion == RangeCriterion::point ? r.threshold : r.task.cyclesOfHalf);
         }},
        {"clutter", "clutter", [](Request& r, const Change& one) { one(r.clutter_K); }}};
    return all;
}

/// Those that are not 0, of which there is a relative change.
std::vector<const Number*> numbersOf(const DetectionRequest& request) {
    std::vector<const Number*> found;
    for (const Number& number : numbers()) {
        DetectionRequest copy = request;
        bool isThere = false;
        number.each(copy, [&](double& value) { isThere = isThere || value != 0.0; });
        if (isThere)
            found.push_back(&number);
    }
    return found;
}

DetectionRequest changed(const DetectionRequest& request, const Number& number, double factor) {
    DetectionRequest out = request;
    number.each(out, [&](double& value) { value *= factor; });
    std::optional<double>& netd_K = out.sensor.detector.thermalNetd_K;
    if (netd_K && std::string_view(number.key) != "netd") {
        // The detector keeps its noise: it is stated as a NETD with the optics as they were.
        const double behind_K = out.sensor.detector.thermalNetdTemperature_K;
        *netd_K *= irsg::PixelResponse(request.sensor).contrast_per_K(behind_K) /
                   irsg::PixelResponse(out.sensor).contrast_per_K(behind_K);
    }
    return out;
}

SceneDescription scaled(const SceneDescription& scene, irsg::ScalingKind kind, double factor) {
    SceneDescription out = scene;
    irsg::Entity& target = out.entities.front();
    std::map<int, double>& scales = scalesOf(target, kind);
    const auto scale = [&](int index) { scales.try_emplace(index, 1.0).first->second *= factor; };
    if (kind == irsg::ScalingKind::temperature)
        for (const auto& [index, entry] : target.database->temperatures)
            scale(index);
    else
        for (const auto& [index, entry] : target.database->materials)
            scale(index);
    return out;
}

/// d ln q / d ln p of values at (1 - h) p and (1 + h) p.
double relativeSlope(double less, double more, double h) {
    return std::log(more / less) / std::log((1.0 + h) / (1.0 - h));
}

} // namespace

std::vector<SensitivityName> sensitivityNames(const DetectionRequest& request) {
    std::vector<SensitivityName> names;
    for (const Number* number : numbersOf(request))
        names.push_back({number->key, number->title});
    names.push_back({"extinction", "extinction of the atmosphere"});
    names.push_back({"temperature", "temperatures of the target"});
    names.push_back({"emissivity", "emissivities of the target"});
    return names;
}

RangeSensitivity::RangeSensitivity(const DetectionScene& shared, const DetectionRequest& request)
    : shared_(shared),
      request_(request),
      sight_(std::make_unique<TargetSight>(request)),
      temperature_{scaled(shared.scene, irsg::ScalingKind::temperature, 1.0 - targetStep),
                   scaled(shared.scene, irsg::ScalingKind::temperature, 1.0 + targetStep)},
      emissivity_{scaled(shared.scene, irsg::ScalingKind::emissivity, 1.0 - targetStep),
                  scaled(shared.scene, irsg::ScalingKind::emissivity, 1.0 + targetStep)} {
    for (const Number* number : numbersOf(request))
        variants_.push_back({std::make_unique<Variant>(changed(request, *number, 1.0 - step)),
                             std::make_unique<Variant>(changed(request, *number, 1.0 + step))});
}

std::vector<double> RangeSensitivity::at(const irsg::DetectionRange& found, const TargetLook& look,
                                         TargetAspect& aspect, const AnalysisCase& one,
                                         AnalysisData& data, CaseWarnings& warnings) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> out(variants_.size() + 3, none);
    if (found.found != irsg::DetectionRange::Found::atRange || found.slope == 0.0)
        return out;
    const auto margin = [](TargetSight& sight, TargetLook seen) {
        sight.see(seen);
        return sight.reached(seen) / sight.wanted();
    };
    for (std::size_t i = 0; i < variants_.size(); ++i)
        out[i] = -relativeSlope(margin(variants_[i].less->sight, look),
                                margin(variants_[i].more->sight, look), step) /
                 found.slope;
    // Of a longer path as thick air makes it: the target as large as it is here.
    const auto thicker = [&](double factor) {
        TargetLook seen = aspect.at(factor * found.range_m, false);
        for (double TargetLook::*const part :
             {&TargetLook::contrast_W_m2, &TargetLook::counted_W_m2, &TargetLook::solidAngle_sr})
            seen.*part *= factor * factor;
        return margin(*sight_, seen);
    };
    const auto scaledTarget = [&](const SceneDescription& scene) {
        TargetAspect other(shared_, scene, *sight_, one, data, warnings);
        TargetLook seen = other.at(found.range_m, false);
        seen.clutter_W_m2_sr = look.clutter_W_m2_sr;
        return margin(*sight_, seen);
    };
    try {
        const std::size_t first = variants_.size();
        out[first] = -relativeSlope(thicker(1.0 - step), thicker(1.0 + step), step) / found.slope;
        out[first + 1] = -relativeSlope(scaledTarget(temperature_.less),
                                        scaledTarget(temperature_.more), targetStep) /
                         found.slope;
        out[first + 2] = -relativeSlope(scaledTarget(emissivity_.less),
                                        scaledTarget(emissivity_.more), targetStep) /
                         found.slope;
    } catch (const irsg::InputError& error) {
        warnings.add(std::string("sensitivities that the scene refuses: ") + error.what());
    }
    return out;
}

} // namespace smat
