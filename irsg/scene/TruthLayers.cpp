#include "irsg/scene/TruthLayers.h"

#include <algorithm>
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

void TruthLayers::add(const PixelWindow& window, int samplesPerAxis, const FactorSamples& samples) {
    const int n = samplesPerAxis;
    const double share = 1.0 / (n * n);
    std::vector<float>& temperatureIndex = image_.channel("temperature_index").values;
    std::vector<float>& materialIndex = image_.channel("material_index").values;
    std::vector<float>& range = image_.channel("range").values;
    std::vector<float>* planes[6];
    for (int term = 0; term < 6; ++term)
        planes[term] = &image_.channel(radiometricTerms[term]).values;

    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x) {
            const std::size_t pixel = image_.offset(window.x + x, window.y + y);
            double sums[6] = {0, 0, 0, 0, 0, 0}; // as radiometricTerms
            for (int sy = 0; sy < n; ++sy)
                for (int sx = 0; sx < n; ++sx) {
                    // GL's rows run from the bottom up.
                    const int glRow = (window.height - 1 - y) * n + sy;
                    const auto i = static_cast<std::size_t>(glRow * samples.width + x * n + sx);
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
                    sums[5] += passed * background_W_m2_sr_;

                    if (sx == n / 2 && sy == n / 2 && samples.first[i] < samples.first[i + 1]) {
                        const FactorLayer& nearest = samples.layers[samples.first[i]];
                        const IrCodes& codes = codes_[static_cast<std::size_t>(nearest.row)];
                        temperatureIndex[pixel] = static_cast<float>(codes.temperature);
                        materialIndex[pixel] = static_cast<float>(codes.material);
                        range[pixel] = nearest.distance_m;
                    }
                }
            for (int term = 0; term < 6; ++term)
                (*planes[term])[pixel] = static_cast<float>(sums[term] * share);
        }
}

} // namespace irsg
