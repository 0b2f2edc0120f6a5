#include "smatcore/analysis/RangeSensitivity.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "irsg/core/Errors.h"
#include "smatcore/analysis/ChangedAir.h"
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

/// A number of computed atmospheres, with the relative change to both sides.
struct AirNumber {
    const char* key;
    const char* title;
    double step;
    /// Multiplies it; false where the atmosphere has none.
    bool (*scale)(irsg::AtmosphereSmartParameters& air, double factor);
};

constexpr double ice_K = 273.15;

const std::vector<AirNumber>& airNumbers() {
    using Air = irsg::AtmosphereSmartParameters;
    constexpr int byMeasurements = 2;
    static const std::vector<AirNumber> all = {
        {"visibility", "visibility of the atmosphere", step,
         [](Air& air, double factor) {
             air.visibility_m *= factor;
             return air.visibility_m > 0.0 && air.aerosols != 0;
         }},
        {"humidity", "humidity of the atmosphere", step,
         [](Air& air, double factor) {
             (air.meteoModel == byMeasurements ? air.relativeHumidityMH_percent : air.waterScale) *=
                 factor;
             return true;
         }},
        {"air_temperature", "temperature of the air", targetStep, [](Air& air, double factor) {
             for (double* measured_C : {&air.temperatureMH_C, &air.temperatureALT0_C})
                 *measured_C = (*measured_C + ice_K) * factor - ice_K;
             return air.meteoModel == byMeasurements;
         }}};
    return all;
}

/// None where no atmosphere has it.
std::optional<irsg::Environment> scaledAir(const irsg::Environment& environment,
                                           const AirNumber& number, double factor) {
    return withAir(environment,
                   [&](irsg::AtmosphereSmartParameters& air) { return number.scale(air, factor); });
}

std::vector<const AirNumber*> airNumbersOf(const irsg::Environment& environment) {
    std::vector<const AirNumber*> found;
    for (const AirNumber& number : airNumbers())
        if (scaledAir(environment, number, 1.0))
            found.push_back(&number);
    return found;
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();

bool hasSlope(const irsg::DetectionRange& found) {
    return found.found == irsg::DetectionRange::Found::atRange && found.slope != 0.0;
}

/// d ln q / d ln p of values at (1 - h) p and (1 + h) p.
double relativeSlope(double less, double more, double h) {
    return std::log(more / less) / std::log((1.0 + h) / (1.0 - h));
}

} // namespace

std::vector<SensitivityName> sensitivityNames(const DetectionRequest& request,
                                              const SceneDescription& scene) {
    std::vector<SensitivityName> names;
    for (const Number* number : numbersOf(request))
        names.push_back({number->key, number->title});
    names.push_back({"extinction", "extinction of the atmosphere"});
    names.push_back({"temperature", "temperatures of the target"});
    names.push_back({"emissivity", "emissivities of the target"});
    for (const AirNumber* number : airNumbersOf(scene.environment))
        names.push_back({number->key, number->title});
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

double RangeSensitivity::margin(TargetLook look) const {
    sight_->see(look);
    return sight_->reached(look) / sight_->wanted();
}

double RangeSensitivity::marginIn(const SceneDescription& scene, const FoundRange& found,
                                  AnalysisData& data, CaseWarnings& warnings) const {
    TargetAspect other(shared_, scene, *sight_, found.place, data, warnings);
    other.sampleFrom(found.sampledFrom_m);
    TargetLook seen = other.at(found.found.range_m, false);
    seen.clutter_W_m2_sr = found.look.clutter_W_m2_sr;
    return margin(seen);
}

std::vector<double> RangeSensitivity::at(const FoundRange& one, TargetAspect& aspect,
                                         AnalysisData& data, CaseWarnings& warnings) const {
    const irsg::DetectionRange& found = one.found;
    std::vector<double> out(variants_.size() + 3, none);
    if (!hasSlope(found))
        return out;
    const auto marginOf = [&](Variant& variant) {
        TargetLook seen = one.look;
        variant.sight.see(seen);
        return variant.sight.reached(seen) / variant.sight.wanted();
    };
    for (std::size_t i = 0; i < variants_.size(); ++i)
        out[i] = -relativeSlope(marginOf(*variants_[i].less), marginOf(*variants_[i].more), step) /
                 found.slope;
    const auto inAir = [&](double depth) {
        return margin(aspect.throughDepth(found.range_m, depth));
    };
    const auto ofTarget = [&](const BothSides<SceneDescription>& scenes) {
        return -relativeSlope(marginIn(scenes.less, one, data, warnings),
                              marginIn(scenes.more, one, data, warnings), targetStep) /
               found.slope;
    };
    try {
        const std::size_t first = variants_.size();
        out[first] = -relativeSlope(inAir(1.0 - step), inAir(1.0 + step), step) / found.slope;
        out[first + 1] = ofTarget(temperature_);
        out[first + 2] = ofTarget(emissivity_);
    } catch (const irsg::InputError& error) {
        warnings.add(std::string("sensitivities that the scene refuses: ") + error.what());
    }
    return out;
}

std::vector<std::vector<double>> RangeSensitivity::ofAir(const std::vector<FoundRange>& all,
                                                         AnalysisData& data,
                                                         CaseWarnings& warnings) const {
    const auto tell = [&](const irsg::InputError& error) {
        warnings.add(std::string("sensitivities that the atmosphere refuses: ") + error.what());
    };
    const std::vector<const AirNumber*> numbers = airNumbersOf(shared_.scene.environment);
    std::vector<BothSides<std::optional<SceneDescription>>> scenes(numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k)
        for (const double factor : {-1.0, 1.0})
            try {
                auto& side = factor < 0.0 ? scenes[k].less : scenes[k].more;
                SceneDescription scene = shared_.scene;
                scene.environment = *scaledAir(shared_.scene.environment, *numbers[k],
                                               1.0 + factor * numbers[k]->step);
                side = std::move(scene);
            } catch (const irsg::InputError& error) {
                tell(error);
            }
    // Case by case: one sampling of the target serves all atmospheres.
    std::vector<std::vector<double>> out(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto marginOf = [&](const std::optional<SceneDescription>& scene) {
            try {
                return scene && hasSlope(all[i].found) ? marginIn(*scene, all[i], data, warnings)
                                                       : none;
            } catch (const irsg::InputError& error) {
                tell(error);
                return none;
            }
        };
        for (std::size_t k = 0; k < numbers.size(); ++k)
            out[i].push_back(-relativeSlope(marginOf(scenes[k].less), marginOf(scenes[k].more),
                                            numbers[k]->step) /
                             all[i].found.slope);
    }
    return out;
}

} // namespace smat
