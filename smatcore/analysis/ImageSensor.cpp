#include "smatcore/analysis/ImageSensor.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/sensor/SensorChain.h"
#include "irsg/sensor/SensorFile.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

std::optional<irsg::SensorDescription> sensorOfImage(const AnalysisData& data) {
    if (data.kind->form != AnalysisForm::image)
        return std::nullopt;
    const auto file = data.settings[key::imageSensor];
    if (file.empty())
        return std::nullopt;
    return irsg::loadSensor(data.project.resolve(file.front()));
}

} // namespace

void followSensor(const irsg::SensorDescription& sensor, Settings& settings) {
    const irsg::Sensor pinhole = sensor.pinhole();
    settings.set(key::sensorWidth, pinhole.width_px);
    settings.set(key::sensorHeight, pinhole.height_px);
    settings.set(key::sensorFov, irsg::degrees(pinhole.horizontalFieldOfView_rad));
    const irsg::SpectralRange range = pinhole.band.range();
    settings.set(key::sensorBand,
                 irsg::numberText(range.min_um) + "-" + irsg::numberText(range.max_um));
    settings.reset(key::sensorResponse);
}

void followSensor(const irsg::SensorDescription& sensor, SceneDescription& scene) {
    scene.sensor = sensor.pinhole();
    scene.moreBands.clear();
}

void followSensor(AnalysisData& data) {
    if (const auto sensor = sensorOfImage(data))
        followSensor(*sensor, data.settings);
}

void followSensor(const AnalysisData& data, SceneDescription& scene) {
    const auto sensor = sensorOfImage(data);
    if (!sensor)
        return;
    followSensor(*sensor, scene);
    checkSensorGrid(*sensor, data.settings);
    irsg::PointSpread::check(*sensor);
}

void refuseIdleOfSensor(const AnalysisData& data, const Settings& given) {
    if (data.kind->form != AnalysisForm::image)
        return;
    const auto sensor = data.settings[key::imageSensor];
    const std::vector<std::string> idle =
        sensor.empty()
            ? std::vector<std::string>{key::imageSensorSamples, key::imageNoiseSeed}
            : std::vector<std::string>{key::sensorWidth, key::sensorHeight, key::sensorFov,
                                       key::sensorBand, key::sensorResponse};
    std::vector<irsg::Diagnostic> diagnostics;
    for (const std::string& key : idle)
        if (given.isSet(key))
            diagnostics.push_back(
                {settingInfo(key).option, "", given.text(key),
                 sensor.empty() ? "nothing without a sensor (image.sensor) that reads the image"
                                : "nothing: the sensor that reads the image gives it, " +
                                      sensor.front().string()});
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
}

void checkSensorGrid(const irsg::SensorDescription& sensor, const Settings& settings) {
    const int samples = settings[key::imageSensorSamples];
    if (samples * std::max(sensor.detector.columns, sensor.detector.rows) >
        irsg::largestResolution_px)
        throw irsg::InputError({"", key::imageSensorSamples.name, std::to_string(samples),
                                fmt::format("at most {} samples of the image along a side",
                                            irsg::largestResolution_px)});
}

irsg::SensorReading drawThroughSensor(irsg::RadianceImage& image, const irsg::SensorChain& chain,
                                      const Settings& settings, const PlacedCase& placed,
                                      const RenderDoor& door, const FrameNoise& noise) {
    const int samples = settings[key::imageSensorSamples];
    PlacedCase finer = placed;
    finer.view.sensor.width_px *= samples;
    finer.view.sensor.height_px *= samples;
    image = finer.render(door, irsg::Outputs::image()).image;
    irsg::SensorReading reading =
        irsg::readBySensor(image, chain, samples, noise.seed, noise.frame);
    if (settings.text(key::imageQuantity) != "counts")
        std::rotate(image.channels.begin(), image.channels.begin() + 1, image.channels.end());
    return reading;
}

std::vector<std::string> drawThroughSensor(irsg::RadianceImage& image, const AnalysisData& data,
                                           const PlacedCase& placed, const RenderDoor& door) {
    const irsg::SensorChain chain(sensorOfImage(data).value());
    const FrameNoise noise{.seed = static_cast<std::uint64_t>(data.settings[key::imageNoiseSeed])};
    const irsg::SensorReading reading =
        drawThroughSensor(image, chain, data.settings, placed, door, noise);
    std::vector<std::string> sentences;
    if (reading.saturated > 0)
        sentences.push_back(
            fmt::format("{} pixels of the sensor are saturated", reading.saturated));
    return sentences;
}

} // namespace smat
