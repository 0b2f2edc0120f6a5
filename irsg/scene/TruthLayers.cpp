#include "irsg/scene/TruthLayers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace irsg {

namespace {

const char* const radiometricTerms[] = {"thermal", "sun", "up", "down", "path", "background"};
const char* const radianceUnit = "W m-2 sr-1";

} // namespace

TruthLayers::TruthLayers(const SceneRadiometry& radiometry, RadianceImage& image)
    : background_W_m2_sr_(radiometry.backgroundInBand_W_m2_sr()), image_(image) {
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
    std::ranges::fill(image_.channel("background", radianceUnit).values,
                      static_cast<float>(background_W_m2_sr_));
}

void TruthLayers::beginWindow(const PixelWindow& window, int samplesPerAxis) {
    window_ = window;
    samplesPerAxis_ = samplesPerAxis;
    const std::size_t samples = static_cast<std::size_t>(window.width * samplesPerAxis) *
                                static_cast<std::size_t>(window.height * samplesPerAxis);
    remaining_.assign(samples, 1.0);
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x)
            image_.channel("background").values[image_.offset(window.x + x, window.y + y)] = 0.0f;
}

void TruthLayers::addLayer(const std::vector<float>& plane0, const std::vector<float>& plane1) {
    const int n = samplesPerAxis_;
    std::vector<float>& temperatureIndex = image_.channel("temperature_index").values;
    std::vector<float>& materialIndex = image_.channel("material_index").values;
    std::vector<float>& range = image_.channel("range").values;
    std::vector<float>* planes[5];
    for (int term = 0; term < 5; ++term)
        planes[term] = &image_.channel(radiometricTerms[term]).values;

    for (int y = 0; y < window_.height; ++y)
        for (int x = 0; x < window_.width; ++x) {
            const std::size_t pixel = image_.offset(window_.x + x, window_.y + y);
            double sums[5] = {0, 0, 0, 0, 0};
            for (int sy = 0; sy < n; ++sy)
                for (int sx = 0; sx < n; ++sx) {
                    const int glRow = (window_.height - 1 - y) * n + sy;
                    const std::size_t i = static_cast<std::size_t>(glRow) *
                                              static_cast<std::size_t>(window_.width * n) +
                                          static_cast<std::size_t>(x * n + sx);
                    const float* sample = &plane0[4 * i];
                    if (sample[0] == 0.0f)
                        continue;
                    const auto row = static_cast<std::size_t>(sample[0]) - 1;
                    const Terms& terms = rows_[row];
                    const double front = remaining_[i];
                    sums[0] += front * static_cast<double>(sample[1]) * terms.thermal;
                    sums[1] += front * static_cast<double>(sample[3]) * terms.sun;
                    sums[2] += front * static_cast<double>(plane1[4 * i + 1]) * terms.up;
                    sums[3] += front * static_cast<double>(sample[2]) * terms.down;
                    sums[4] += front * terms.path;
                    remaining_[i] *= terms.transmissivity;
                    if (sx == n / 2 && sy == n / 2 && std::isnan(range[pixel])) {
                        temperatureIndex[pixel] = static_cast<float>(codes_[row].temperature);
                        materialIndex[pixel] = static_cast<float>(codes_[row].material);
                        range[pixel] = plane1[4 * i];
                    }
                }
            for (int term = 0; term < 5; ++term)
                (*planes[term])[pixel] += static_cast<float>(sums[term] / (n * n));
        }
}

void TruthLayers::endWindow() {
    const int n = samplesPerAxis_;
    std::vector<float>& background = image_.channel("background").values;
    for (int y = 0; y < window_.height; ++y)
        for (int x = 0; x < window_.width; ++x) {
            double open = 0.0;
            for (int sy = 0; sy < n; ++sy)
                for (int sx = 0; sx < n; ++sx)
                    open += remaining_[static_cast<std::size_t>((window_.height - 1 - y) * n + sy) *
                                           static_cast<std::size_t>(window_.width * n) +
                                       static_cast<std::size_t>(x * n + sx)];
            background[image_.offset(window_.x + x, window_.y + y)] =
                static_cast<float>(open / (n * n) * background_W_m2_sr_);
        }
}

} // namespace irsg
