#include "irsg/radiometry/BlackbodyTable.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

/// The interval of the grid that holds a temperature, and where in it the temperature stands.
struct GridPlace {
    std::size_t lower = 0;
    double lower_K = 0.0;
    double upper_K = 0.0;
};

std::optional<GridPlace> placeOf(double temperature_K) {
    if (!(temperature_K >= BlackbodyTable::minimum_K && temperature_K <= BlackbodyTable::maximum_K))
        return std::nullopt;
    const double position = (temperature_K - BlackbodyTable::minimum_K) / BlackbodyTable::step_K;
    const auto lower =
        std::min(static_cast<std::size_t>(position), std::size_t{BlackbodyTable::nodes - 2});
    const double lower_K =
        BlackbodyTable::minimum_K + BlackbodyTable::step_K * static_cast<double>(lower);
    return GridPlace{lower, lower_K, lower_K + BlackbodyTable::step_K};
}

} // namespace

BlackbodyTable::BlackbodyTable(Band band) : band_(std::move(band)) {
    for (int i = 0; i < nodes; ++i) {
        radiance_W_m2_sr_.push_back(bandRadiance_W_m2_sr(band_, minimum_K + step_K * i));
        logRadiance_.push_back(std::log(radiance_W_m2_sr_.back()));
    }
}

double BlackbodyTable::radiance_W_m2_sr(double temperature_K) const {
    const auto place = placeOf(temperature_K);
    if (!place || radiance_W_m2_sr_[place->lower] == 0.0)
        return bandRadiance_W_m2_sr(band_, temperature_K);
    const double t = (1.0 / temperature_K - 1.0 / place->lower_K) /
                     (1.0 / place->upper_K - 1.0 / place->lower_K);
    return std::exp(std::lerp(logRadiance_[place->lower], logRadiance_[place->lower + 1], t));
}

double BlackbodyTable::radianceLinearInTemperature_W_m2_sr(double temperature_K) const {
    const auto place = placeOf(temperature_K);
    if (!place)
        return bandRadiance_W_m2_sr(band_, temperature_K);
    const double t = (temperature_K - place->lower_K) / step_K;
    return std::lerp(radiance_W_m2_sr_[place->lower], radiance_W_m2_sr_[place->lower + 1], t);
}

} // namespace irsg
