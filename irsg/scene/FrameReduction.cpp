#include "irsg/scene/FrameReduction.h"

#include <algorithm>

#include "irsg/scene/PixelGrid.h"

namespace irsg {

FrameReduction::FrameReduction(const Sensor& sensor, const PixelWindow& window,
                               double background_W_m2_sr)
    : sensor_(sensor),
      window_(window),
      background_W_m2_sr_(background_W_m2_sr),
      radiance_(static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height)),
      opacity_(radiance_.size()) {}

void FrameReduction::add(const PixelWindow& tile, int samplesPerAxis,
                         const RadianceSamples& samples) {
    const auto n = static_cast<std::size_t>(samplesPerAxis);
    const auto width = static_cast<std::size_t>(tile.width),
               height = static_cast<std::size_t>(tile.height);
    const double scale = 1.0 / static_cast<double>(n * n);
    for (std::size_t y = 0; y < height; ++y) {
        const std::size_t first = (static_cast<std::size_t>(tile.y - window_.y) + y) *
                                      static_cast<std::size_t>(window_.width) +
                                  static_cast<std::size_t>(tile.x - window_.x);
        // GL's rows run from the bottom up.
        for (std::size_t sy = 0; sy < n; ++sy) {
            const float* sample = &samples.planes[((height - 1 - y) * n + sy) * width * n * 2];
            for (std::size_t x = 0; x < width; ++x)
                for (std::size_t sx = 0; sx < n; ++sx, sample += 2) {
                    radiance_[first + x] += static_cast<double>(sample[0]);
                    opacity_[first + x] += static_cast<double>(sample[1]);
                }
        }
        for (std::size_t x = 0; x < width; ++x) {
            radiance_[first + x] *= scale;
            opacity_[first + x] *= scale;
        }
    }
}

ObjectRadiometry FrameReduction::objects(double range_m) const {
    ObjectRadiometry sum;
    sum.name = "all";
    sum.range_m = range_m;
    const PixelGrid grid(sensor_);
    std::size_t i = 0;
    for (int y = 0; y < window_.height; ++y)
        for (int x = 0; x < window_.width; ++x, ++i) {
            if (opacity_[i] == 0.0 && radiance_[i] == 0.0)
                continue;
            const auto [omega_sr, cosOffAxis] = grid.at(window_.x + x, window_.y + y);
            const double contrast = radiance_[i] - opacity_[i] * background_W_m2_sr_;
            sum.intensity_W_sr += radiance_[i] * omega_sr;
            sum.contrastIntensity_W_sr += contrast * omega_sr;
            sum.irradiance_W_m2 += contrast * omega_sr * cosOffAxis;
            sum.coveredPixels += opacity_[i];
            sum.solidAngle_sr += opacity_[i] * omega_sr;
        }
    sum.intensity_W_sr *= range_m * range_m;
    sum.contrastIntensity_W_sr *= range_m * range_m;
    return sum;
}

RadianceImage FrameReduction::compose() const {
    RadianceImage image(sensor_.width_px, sensor_.height_px);
    std::vector<float>& pixels = image.primary().values;
    std::ranges::fill(pixels, static_cast<float>(background_W_m2_sr_));
    std::size_t i = 0;
    for (int y = 0; y < window_.height; ++y)
        for (int x = 0; x < window_.width; ++x, ++i)
            pixels[image.offset(window_.x + x, window_.y + y)] =
                static_cast<float>(radiance_[i] + (1.0 - opacity_[i]) * background_W_m2_sr_);
    return image;
}

} // namespace irsg
