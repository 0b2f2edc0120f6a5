#include "smatcore/analysis/BackgroundClutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "irsg/atmosphere/Atmosphere.h"
#include "irsg/core/Errors.h"
#include "irsg/sensor/SensorChain.h"

namespace smat {

namespace {

/// A side of a pixel, as images in counts have by default: fewer would blur a horizon.
constexpr int samples = 4;
constexpr int side_px = 128;
/// A flat detector sees no wider square.
constexpr double widest_rad = 1.5;
constexpr std::size_t blocksPerSide = 8;

irsg::SensorDescription squareOf(irsg::SensorDescription sensor, int side_px) {
    sensor.detector.columns = sensor.detector.rows = side_px;
    return sensor;
}

/// Whether turning the camera about the target shows another background.
bool dependsOnAzimuth(const PlacedCase& placed) {
    const irsg::Scene& scene = placed.scene;
    if (scene.skybox || scene.terrain || scene.settings.sunDisc)
        return true;
    if (scene.settings.background != irsg::BackgroundMode::environment)
        return false;
    const irsg::Atmosphere* air = scene.environment.find(
        placed.view.sensor.band.range(), irsg::AtmosphereProperty::backgroundRadiance);
    return air != nullptr && air->dependsOnAzimuth(irsg::AtmosphereProperty::backgroundRadiance);
}

} // namespace

PixelDeviation pixelDeviation(const std::vector<double>& values, std::size_t width,
                              std::size_t margin) {
    const std::size_t height = values.size() / width;
    if (std::min(width, height) <= 2 * margin)
        return {};
    const std::size_t columns = width - 2 * margin, rows = height - 2 * margin;
    std::array<double, blocksPerSide * blocksPerSide> squares{}, counts{};
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < columns; ++x) {
            const std::size_t at = (y + margin) * width + x + margin;
            double around = -values[at];
            for (const std::size_t middle : {at - width, at, at + width})
                around += values[middle - 1] + values[middle] + values[middle + 1];
            const double residual = values[at] - around / 8.0;
            const std::size_t block =
                y * blocksPerSide / rows * blocksPerSide + x * blocksPerSide / columns;
            squares[block] += residual * residual;
            counts[block] += 1.0;
        }
    const double count = std::accumulate(counts.begin(), counts.end(), 0.0);
    if (count < 2.0)
        return {};
    const double mean = std::accumulate(squares.begin(), squares.end(), 0.0) / count;
    // Of the mean square, by those of the blocks, each with its weight.
    double spread = 0.0;
    for (std::size_t block = 0; block < squares.size(); ++block)
        spread += std::pow(squares[block] - mean * counts[block], 2);
    const double deviation = std::sqrt(8.0 / 9.0 * mean);
    return {deviation, mean > 0.0 ? deviation * std::sqrt(spread) / (count * mean) : 0.0};
}

/// A square of pixels with its blur, which all backgrounds share.
struct BackgroundClutter::Square {
    explicit Square(const irsg::SensorDescription& sensor)
        : chain(sensor), pinhole(sensor.pinhole()) {
        pinhole.width_px *= samples;
        pinhole.height_px *= samples;
    }
    irsg::SensorChain chain;
    irsg::Sensor pinhole;
};

BackgroundClutter::BackgroundClutter(const RenderDoor& door, irsg::SensorDescription sensor)
    : door_(door),
      sensor_(std::move(sensor)),
      margin_px_(static_cast<std::size_t>(std::ceil(irsg::SensorTransfer(sensor_).spread_rad() /
                                                    sensor_.pixelAngle_rad())) +
                 1) {
    // Of sensors with wide pixels what a flat detector can be.
    const int side = std::min(side_px, static_cast<int>(widest_rad / sensor_.pixelAngle_rad()));
    if (static_cast<std::size_t>(side) >= 2 * margin_px_ + blocksPerSide)
        square_ = std::make_unique<Square>(squareOf(sensor_, side));
}

BackgroundClutter::~BackgroundClutter() = default;

std::vector<double> BackgroundClutter::keyOf(const PlacedCase& placed) const {
    const irsg::Viewpoint& eye = placed.view.viewpoint;
    const irsg::Vec3 target_m = placed.referencePoints_m.front();
    std::vector<double> key = {eye.position_m.z, target_m.z,
                               irsg::length(eye.position_m - target_m)};
    if (dependsOnAzimuth(placed))
        for (const irsg::Vec3& one : {eye.position_m, eye.backward, target_m})
            key.insert(key.end(), {one.x, one.y, one.z});
    // What rounding left of a turn of the camera is the same place.
    for (double& value : key)
        value = std::round(value * 1e6) * 1e-6;
    return key;
}

MeasuredClutter BackgroundClutter::of(const PlacedCase& placed) {
    const auto [known, isNew] = known_.try_emplace(keyOf(placed));
    if (isNew)
        known->second = measure(placed);
    return known->second;
}

MeasuredClutter BackgroundClutter::measure(const PlacedCase& placed) {
    if (!square_)
        throw irsg::InputError({"", "clutter of the background",
                                "a point spread of " + std::to_string(2 * margin_px_) + " pixels",
                                "one that is narrower than the square of pixels about the target "
                                "that clutter is taken from, or a number"});
    PlacedCase behind = placed;
    behind.view.sensor = square_->pinhole;
    irsg::RenderSettings& settings = behind.scene.settings;
    // Nothing of the objects is seen.
    settings.truthLayers = settings.hotSpots = settings.errors = settings.scattering = false;
    settings.sun = settings.ambientReflection = irsg::ReflectionMode::off;
    settings.sunShadows = irsg::SunShadowMode::off;
    settings.bounces = 0;
    const irsg::RadianceImage image = behind.render(door_, irsg::Outputs::background()).image;
    const std::vector<double> signal = square_->chain.exposed(image.primary().values, samples);
    const auto width = static_cast<std::size_t>(square_->pinhole.width_px / samples);
    const PixelDeviation found = pixelDeviation(signal, width, margin_px_);
    const double perRadiance = square_->chain.response().signalPerRadiance();
    return {found.deviation / perRadiance, found.error / perRadiance,
            std::accumulate(signal.begin(), signal.end(), 0.0) /
                static_cast<double>(signal.size()) / perRadiance};
}

} // namespace smat
