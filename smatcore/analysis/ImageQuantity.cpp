#include "smatcore/analysis/ImageQuantity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Quantity.h"

namespace smat {

namespace {

void rename(irsg::ImageChannel& channel, const char* name, irsg::Quantity quantity) {
    channel.name = name;
    channel.unit = std::string(irsg::info(quantity).unit);
}

/// Apparent temperature over a range of radiances: ln L against 1/T is almost a straight line, so
/// that few nodes serve a whole image.
class TemperatureTable {
  public:
    TemperatureTable(const irsg::Band& band, double coldest_K, double hottest_K) {
        constexpr int intervals = 1024;
        for (int i = 0; i <= intervals; ++i) {
            const double share = static_cast<double>(i) / intervals;
            const double inverse = 1.0 / coldest_K + (1.0 / hottest_K - 1.0 / coldest_K) * share;
            inverse_.push_back(inverse);
            log_.push_back(std::log(irsg::bandRadiance_W_m2_sr(band, 1.0 / inverse)));
        }
    }

    double temperature_K(double radiance) const {
        const double wanted = std::log(radiance);
        const auto above = std::upper_bound(log_.begin() + 1, log_.end() - 1, wanted);
        const auto i = static_cast<std::size_t>(above - log_.begin());
        const double share = (wanted - log_[i - 1]) / (log_[i] - log_[i - 1]);
        return 1.0 / (inverse_[i - 1] + (inverse_[i] - inverse_[i - 1]) * share);
    }

  private:
    std::vector<double> inverse_; ///< 1/T, falling
    std::vector<double> log_;     ///< ln L, rising
};

} // namespace

void toIrradiance(irsg::RadianceImage& image, const irsg::Sensor& sensor) {
    irsg::ImageChannel& channel = image.primary();
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            float& value = channel.values[image.offset(x, y)];
            value = static_cast<float>(value * sensor.pixelSolidAngle_sr(x, y) *
                                       sensor.cosOffAxis(x, y));
        }
    }
    rename(channel, "E", irsg::Quantity::irradiance);
}

std::size_t toApparentTemperature(irsg::RadianceImage& image, const irsg::Sensor& sensor) {
    irsg::ImageChannel& channel = image.primary();
    std::vector<float>& values = channel.values;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const float value : values) {
        if (value > 0.0f && std::isfinite(value)) {
            least = std::min(least, static_cast<double>(value));
            most = std::max(most, static_cast<double>(value));
        }
    }
    rename(channel, "T", irsg::Quantity::apparentTemperature);

    // The table ends a little outside the coldest and hottest pixel, which also makes an image of
    // one radiance an ordinary one.
    const auto coldest = irsg::apparentTemperature_K(sensor.band, least);
    const auto hottest = irsg::apparentTemperature_K(sensor.band, most);
    std::size_t without = 0;
    if (!coldest || !hottest) {
        without = values.size();
        std::fill(values.begin(), values.end(), std::numeric_limits<float>::quiet_NaN());
        return without;
    }
    const TemperatureTable table(sensor.band, *coldest * 0.999, *hottest * 1.001);
    for (float& value : values) {
        if (value > 0.0f && std::isfinite(value)) {
            value = static_cast<float>(table.temperature_K(value));
        } else {
            value = std::numeric_limits<float>::quiet_NaN();
            ++without;
        }
    }
    return without;
}

} // namespace smat
