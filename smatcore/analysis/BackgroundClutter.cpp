#include "smatcore/analysis/BackgroundClutter.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/sensor/SensorChain.h"

namespace smat {

namespace {

constexpr int largestSide_px = 256, samples = 2;

/// Calls `use` for each pixel that has eight neighbours, with its offset, where it and they are
/// background.
template <typename Use>
void forEachInside(const std::vector<bool>& isBackground, std::size_t width, const Use& use) {
    const std::size_t height = isBackground.size() / width;
    for (std::size_t y = 1; y + 1 < height; ++y)
        for (std::size_t x = 1; x + 1 < width; ++x) {
            bool isInside = true;
            for (std::size_t row = y - 1; row <= y + 1; ++row)
                for (std::size_t column = x - 1; column <= x + 1; ++column)
                    isInside = isInside && isBackground[row * width + column];
            if (isInside)
                use(y * width + x);
        }
}

/// Which pixels no sample of an object lies in or within `reach` pixels of, as a square.
std::vector<bool> backgroundPixels(const std::vector<float>& index, std::size_t width,
                                   std::size_t height, std::size_t reach) {
    std::vector<bool> isBackground(width * height, true);
    for (std::size_t y = 0; y < height * samples; ++y)
        for (std::size_t x = 0; x < width * samples; ++x) {
            if (std::isnan(index[y * width * samples + x]))
                continue;
            const std::size_t column = x / samples, row = y / samples;
            for (std::size_t r = row - std::min(row, reach); r <= std::min(row + reach, height - 1);
                 ++r)
                for (std::size_t c = column - std::min(column, reach);
                     c <= std::min(column + reach, width - 1); ++c)
                    isBackground[r * width + c] = false;
        }
    return isBackground;
}

/// With the mean of the background where there are objects, whose light would reach far.
std::vector<float> withoutObjects(std::vector<float> radiance, const std::vector<float>& index) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < radiance.size(); ++i)
        if (std::isnan(index[i])) {
            sum += static_cast<double>(radiance[i]);
            ++count;
        }
    const auto mean = static_cast<float>(count == 0 ? 0.0 : sum / static_cast<double>(count));
    for (std::size_t i = 0; i < radiance.size(); ++i)
        if (!std::isnan(index[i]))
            radiance[i] = mean;
    return radiance;
}

} // namespace

double pixelDeviation(const std::vector<double>& values, const std::vector<bool>& isBackground,
                      std::size_t width) {
    double squares = 0.0;
    std::size_t count = 0;
    forEachInside(isBackground, width, [&](std::size_t at) {
        double around = -values[at];
        for (const std::size_t middle : {at - width, at, at + width})
            around += values[middle - 1] + values[middle] + values[middle + 1];
        const double residual = values[at] - around / 8.0;
        squares += residual * residual;
        ++count;
    });
    return count < 2 ? 0.0 : std::sqrt(8.0 / 9.0 * squares / static_cast<double>(count));
}

MeasuredClutter backgroundClutter(const PlacedCase& placed, const RenderDoor& door,
                                  const irsg::SensorDescription& sensor) {
    irsg::SensorDescription piece = sensor;
    piece.detector.columns = std::min(sensor.detector.columns, largestSide_px);
    piece.detector.rows = std::min(sensor.detector.rows, largestSide_px);
    PlacedCase finer = placed;
    finer.view.sensor = piece.pinhole();
    finer.view.sensor.width_px *= samples;
    finer.view.sensor.height_px *= samples;
    finer.scene.settings.truthLayers = true;
    // What the objects see of each other changes no pixel that counts.
    finer.scene.settings.bounces = 0;
    const irsg::RadianceImage image = finer.render(door, irsg::Outputs::image()).image;
    const std::vector<float>& index = image.find("temperature_index")->values;
    const irsg::SensorChain chain(piece);
    const double reach_px =
        std::ceil(irsg::SensorTransfer(piece).spread_rad() / piece.pixelAngle_rad());
    const auto width = static_cast<std::size_t>(piece.detector.columns);
    const std::vector<bool> isBackground = backgroundPixels(
        image.find("temperature_index")->values, width,
        static_cast<std::size_t>(piece.detector.rows), static_cast<std::size_t>(reach_px));
    const std::vector<double> signal =
        chain.exposed(withoutObjects(image.find("L")->values, index), samples);
    double sum = 0.0;
    std::size_t count = 0;
    forEachInside(isBackground, width, [&](std::size_t at) {
        sum += signal[at];
        ++count;
    });
    if (count < 2)
        throw irsg::InputError({"", "clutter of the background",
                                "no pixel of it beside the target in the sensor's frame",
                                "a range from which the target leaves some free, or a number"});
    const double perRadiance = chain.response().signalPerRadiance();
    return {pixelDeviation(signal, isBackground, width) / perRadiance,
            sum / static_cast<double>(count) / perRadiance};
}

} // namespace smat
