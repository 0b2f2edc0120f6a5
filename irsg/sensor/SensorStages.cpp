#include "irsg/sensor/SensorStages.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "irsg/core/Errors.h"
#include "irsg/sensor/FourierTransform.h"
#include "irsg/sensor/SensorChain.h"

namespace irsg {

namespace {

SensorStage stageOf(std::string_view component) {
    if (component == "detector" || component == "time_constant")
        return SensorStage::detector;
    if (component == "jitter" || component == "motion")
        return SensorStage::motion;
    return SensorStage::optics;
}

/// The scene with a margin of its outermost cells, so that what is blurred across one side does
/// not reach the other.
struct Padded {
    std::size_t width, height, margin;
    std::vector<float> values;
};

Padded padded(const StageScene& scene, double cell_rad, double spread_rad) {
    const std::size_t cells = static_cast<std::size_t>(scene.samples);
    const std::size_t width = scene.columns_px * cells, height = scene.rows_px * cells;
    const auto margin = static_cast<std::size_t>(
        std::min(std::ceil(spread_rad / cell_rad), static_cast<double>(std::max(width, height))));
    Padded out{smoothSize(width + 2 * margin), smoothSize(height + 2 * margin), margin, {}};
    out.values.reserve(out.width * out.height);
    // The far half of what is beyond the scene belongs to the first side of the periodic grid.
    const auto inside = [&](std::size_t at, std::size_t size, std::size_t whole) {
        if (at < margin || at >= margin + size + (whole - size) / 2)
            return std::size_t{0};
        return std::min(at - margin, size - 1);
    };
    for (std::size_t y = 0; y < out.height; ++y)
        for (std::size_t x = 0; x < out.width; ++x)
            out.values.push_back(scene.radiance_W_m2_sr[inside(y, height, out.height) * width +
                                                        inside(x, width, out.width)]);
    return out;
}

} // namespace

std::vector<SensorTransfer::Component>
componentsOf(SensorStage stage, const std::vector<SensorTransfer::Component>& components) {
    std::vector<SensorTransfer::Component> out;
    for (const SensorTransfer::Component& one : components)
        if (stageOf(one.name) == stage && stage != SensorStage::electronics)
            out.push_back(one);
    return out;
}

StagePictures stagePictures(const SensorDescription& sensor, const StageScene& scene,
                            double source_K, std::uint64_t seed) {
    const std::size_t cells = static_cast<std::size_t>(std::max(scene.samples, 1));
    if (scene.radiance_W_m2_sr.empty() ||
        scene.radiance_W_m2_sr.size() != scene.columns_px * scene.rows_px * cells * cells)
        throw LogicError("a scene of another number of cells");
    SensorDescription piece = sensor;
    piece.detector.columns = static_cast<int>(scene.columns_px);
    piece.detector.rows = static_cast<int>(scene.rows_px);

    StagePictures out;
    out.radiance_W_m2_sr[0] = scene.radiance_W_m2_sr;
    const SensorTransfer transfer(sensor, source_K);
    const double cell_rad = sensor.pixelAngle_rad() / static_cast<double>(cells);
    const Padded wide = padded(scene, cell_rad, transfer.spread_rad());
    HalfSpectrumOf<float> spectrum = transformOf(wide.values, wide.width, wide.height);
    const std::size_t columns = spectrum.columns();
    // The factor of each stage by frequency; it is even along both axes.
    std::array<std::vector<float>, 3> factors;
    for (std::vector<float>& factor : factors)
        factor.resize(columns * (wide.height / 2 + 1));
    const double perColumn = 1.0 / (static_cast<double>(wide.width) * cell_rad);
    const double perRow = 1.0 / (static_cast<double>(wide.height) * cell_rad);
    for (std::size_t row = 0; row <= wide.height / 2; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const double x = static_cast<double>(column) * perColumn;
            const double y = static_cast<double>(row) * perRow;
            const std::size_t at = row * columns + column;
            for (std::vector<float>& factor : factors)
                factor[at] = 1.0F;
            if (std::hypot(x, y) > 1.5 * transfer.cutoff_per_rad()) {
                factors[0][at] = 0.0F; // of a square pupil the diagonal reaches farthest
                continue;
            }
            for (const SensorTransfer::Component& one : transfer.components(x, y))
                factors[static_cast<std::size_t>(stageOf(one.name))][at] *=
                    static_cast<float>(one.value);
        }
    const std::size_t width = scene.columns_px * cells, height = scene.rows_px * cells;
    for (std::size_t stage = 0; stage < factors.size(); ++stage) {
        for (std::size_t row = 0; row < wide.height; ++row)
            for (std::size_t column = 0; column < columns; ++column)
                spectrum.values[row * columns + column] *=
                    factors[stage][std::min(row, wide.height - row) * columns + column];
        const std::vector<float> blurred = transformBack(spectrum);
        std::vector<float>& picture = out.radiance_W_m2_sr[stage + 1];
        picture.reserve(width * height);
        for (std::size_t y = 0; y < height; ++y)
            picture.insert(
                picture.end(),
                blurred.begin() +
                    static_cast<std::ptrdiff_t>((y + wide.margin) * wide.width + wide.margin),
                blurred.begin() + static_cast<std::ptrdiff_t>((y + wide.margin) * wide.width +
                                                              wide.margin + width));
    }
    const SensorChain chain(piece, source_K);
    SensorReading reading =
        chain.read(chain.exposed(scene.radiance_W_m2_sr, scene.samples), seed, 0);
    out.counts = std::move(reading.counts);
    out.saturated = reading.saturated;
    return out;
}

} // namespace irsg
