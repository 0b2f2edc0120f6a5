#include "gui/tools/SensorScene.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace smat::gui {

namespace {

constexpr int samplesPerPixel = 4;
constexpr std::size_t mostColumns_px = 96, mostRows_px = 72;

std::optional<double> numberOf(const irsg::RadianceImage& image, const char* attribute) {
    const auto found = image.attributes.find(attribute);
    double value = 0.0;
    if (found == image.attributes.end() ||
        std::from_chars(found->second.data(), found->second.data() + found->second.size(), value)
                .ec != std::errc())
        return std::nullopt;
    return value;
}

/// Of a pixel in the middle of the image.
std::optional<double> pixelAngle_rad(const irsg::RadianceImage& image) {
    const auto field_deg = numberOf(image, "sensor.horizontal_field_of_view_deg");
    if (!field_deg || image.width() == 0)
        return std::nullopt;
    return 2.0 * std::tan(0.5 * irsg::radians(*field_deg)) / image.width();
}

} // namespace

irsg::StageScene testPattern(const irsg::SensorDescription& sensor) {
    irsg::StageScene scene{64, 48, samplesPerPixel, {}};
    const std::size_t width = scene.columns_px * samplesPerPixel;
    const auto radiance = [&](double temperature_K) {
        return static_cast<float>(irsg::bandRadiance_W_m2_sr(sensor.band(), temperature_K));
    };
    scene.radiance_W_m2_sr.assign(width * scene.rows_px * samplesPerPixel, radiance(300.0));
    const float warm = radiance(310.0);
    const auto fill = [&](std::size_t x, std::size_t y, std::size_t across, std::size_t down,
                          float value) {
        for (std::size_t row = y; row < y + down; ++row)
            std::fill_n(scene.radiance_W_m2_sr.begin() +
                            static_cast<std::ptrdiff_t>(row * width + x),
                        across, value);
    };
    // In samples: bars of half a period, seven times as high as wide.
    std::size_t left = 6 * samplesPerPixel;
    for (const std::size_t half : {4 * samplesPerPixel, 2 * samplesPerPixel, samplesPerPixel}) {
        for (std::size_t bar = 0; bar < 4; ++bar)
            fill(left + 2 * bar * half, 6 * samplesPerPixel, half,
                 std::min(7 * half, std::size_t{28 * samplesPerPixel}), warm);
        left += 7 * half + 3 * samplesPerPixel;
    }
    fill(50 * samplesPerPixel + 1, 38 * samplesPerPixel + 1, 1, 1, radiance(500.0));
    return scene;
}

bool canBeStageScene(const irsg::RadianceImage& image) {
    return image.find("L") != nullptr && pixelAngle_rad(image).has_value();
}

irsg::StageScene pieceOf(const irsg::RadianceImage& image, const irsg::SensorDescription& sensor) {
    if (!canBeStageScene(image))
        throw irsg::LogicError("an image without radiance or field of view");
    const double ofImage_rad = *pixelAngle_rad(image), ofSensor_rad = sensor.pixelAngle_rad();
    const auto pixels = [&](int size, std::size_t most) {
        const double whole = std::floor(size * ofImage_rad / ofSensor_rad);
        return static_cast<std::size_t>(std::clamp(whole, 1.0, static_cast<double>(most)));
    };
    irsg::StageScene scene{pixels(image.width(), mostColumns_px),
                           pixels(image.height(), mostRows_px),
                           samplesPerPixel,
                           {}};
    const double step = ofSensor_rad / (samplesPerPixel * ofImage_rad);
    const auto pixelAt = [&](std::size_t cell, std::size_t pieces_px, int size) {
        const double fromMiddle = static_cast<double>(cell) + 0.5 -
                                  0.5 * static_cast<double>(pieces_px) * samplesPerPixel;
        return std::clamp(static_cast<int>(std::floor(0.5 * size + fromMiddle * step)), 0,
                          size - 1);
    };
    const std::vector<float>& radiance = image.find("L")->values;
    for (std::size_t row = 0; row < scene.rows_px * samplesPerPixel; ++row)
        for (std::size_t column = 0; column < scene.columns_px * samplesPerPixel; ++column)
            scene.radiance_W_m2_sr.push_back(
                radiance[image.offset(pixelAt(column, scene.columns_px, image.width()),
                                      pixelAt(row, scene.rows_px, image.height()))]);
    return scene;
}

std::string wordsOfPiece(const irsg::RadianceImage& image, const irsg::SensorDescription& sensor) {
    std::string words =
        fmt::format("A pixel of the sensor is {} pixels of the image wide",
                    irsg::roundedText(sensor.pixelAngle_rad() / pixelAngle_rad(image).value(), 3));
    if (sensor.pixelAngle_rad() < *pixelAngle_rad(image))
        words += ", too coarse to show its blur";
    const auto min_um = numberOf(image, "band.min_um"), max_um = numberOf(image, "band.max_um");
    const irsg::SpectralRange& band = sensor.detector.band;
    if (min_um && max_um && (*min_um != band.min_um || *max_um != band.max_um))
        words +=
            fmt::format("; its radiance from {} to {} µm is taken as that of the sensor's band",
                        irsg::roundedText(*min_um, 4), irsg::roundedText(*max_um, 4));
    return words + ".";
}

} // namespace smat::gui
