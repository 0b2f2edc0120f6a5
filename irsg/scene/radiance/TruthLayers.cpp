#include "irsg/scene/radiance/TruthLayers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace irsg {

namespace {

const char* const radiometricTerms[] = {"thermal", "sun", "up", "down", "path", "background"};
const char* const radianceUnit = "W m-2 sr-1";

} // namespace

TruthLayers::TruthLayers(const SceneRadiometry& radiometry, const FrameBackground& background,
                         RadianceImage& image)
    : background_(background), image_(image) {
    for (std::size_t row = 0; row < radiometry.surfaces().size(); ++row) {
        const SurfaceSpectra& s = radiometry.surfaces()[row];
        rows_.push_back({radiometry.integrate(s.thermal), radiometry.integrate(s.up),
                         radiometry.integrate(s.down), radiometry.integrate(s.sun),
                         radiometry.integrate(s.path),
                         radiometry.scalarTransmissivity(static_cast<int>(row))});
        codes_.push_back(radiometry.keys()[row].second);
    }

    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    for (const char* index : {"temperature_index", "material_index"})
        std::ranges::fill(image_.channel(index).values, none);
    std::ranges::fill(image_.channel("range", "m").values, none);
    for (const char* term : radiometricTerms)
        image_.channel(term, radianceUnit);
    std::vector<float>& behind = image_.channel("background").values;
    for (int y = 0; y < image_.height(); ++y)
        for (int x = 0; x < image_.width(); ++x)
            behind[image_.offset(x, y)] = static_cast<float>(background_.at(x, y));
    offMiddle_px_.assign(behind.size(), std::numeric_limits<float>::infinity());
}

void TruthLayers::add(const SampleWindow& window, const FactorSamples& samples) {
    const double share = window.share();
    const ImageRectangle place = window.rectangle();
    const double across_px = window.tileSide_px() / window.samplesAcross;
    const double down_px = window.tileSide_px() / window.samplesDown;
    std::vector<float>& temperatureIndex = image_.channel("temperature_index").values;
    std::vector<float>& materialIndex = image_.channel("material_index").values;
    std::vector<float>& range = image_.channel("range").values;
    std::vector<float>* planes[6];
    for (int term = 0; term < 6; ++term)
        planes[term] = &image_.channel(radiometricTerms[term]).values;

    const auto width = static_cast<std::size_t>(window.width());
    window.forEachRun([&](std::size_t first, int count, int x, int y, double weight) {
        const std::size_t pixel = image_.offset(x, y);
        const std::size_t last = first + static_cast<std::size_t>(count);
        double sums[6] = {0, 0, 0, 0, 0, 0}; // as radiometricTerms; of the background what is lost
        for (std::size_t i = first; i < last; ++i) {
            if (samples.first[i] == samples.first[i + 1])
                continue;
            double passed = 1.0;
            for (std::uint32_t k = samples.first[i]; k < samples.first[i + 1]; ++k) {
                const FactorLayer& layer = samples.layers[k];
                const Terms& terms = rows_[static_cast<std::size_t>(layer.row)];
                sums[0] += passed * static_cast<double>(layer.thermal) * terms.thermal;
                sums[1] += passed * static_cast<double>(layer.sun) * terms.sun;
                sums[2] += passed * static_cast<double>(layer.up) * terms.up;
                sums[3] += passed * static_cast<double>(layer.down) * terms.down;
                sums[4] += passed * terms.path;
                passed *= terms.transmissivity;
            }
            sums[5] -= (1.0 - passed) * background_.at(x, y);

            // GL's rows run from the bottom up.
            const int row = window.height() - 1 - static_cast<int>(i / width);
            const double column = static_cast<double>(i % width) - window.shift(row);
            const double right_px = place.left + (column + 0.5) * across_px - (x + 0.5);
            const double below_px = place.top + (row + 0.5) * down_px - (y + 0.5);
            const auto off_px = static_cast<float>(std::hypot(right_px, below_px));
            if (off_px < offMiddle_px_[pixel]) {
                offMiddle_px_[pixel] = off_px;
                const FactorLayer& nearest = samples.layers[samples.first[i]];
                const IrCodes& codes = codes_[static_cast<std::size_t>(nearest.row)];
                temperatureIndex[pixel] = static_cast<float>(codes.temperature);
                materialIndex[pixel] = static_cast<float>(codes.material);
                range[pixel] = nearest.distance_m;
            }
        }
        for (int term = 0; term < 6; ++term)
            (*planes[term])[pixel] += static_cast<float>(sums[term] * weight * share);
    });
}

} // namespace irsg
