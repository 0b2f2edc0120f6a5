#include "irsg/image/ApparentTemperature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/image/NotANumber.h"
#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

// A third of what is promised: the error is probed at some points of a piece, not at all.
constexpr double probedTolerance_K = 3e-5;
constexpr double absoluteUpTo_K = 5000.0;
constexpr double coldestSought_K = 1.0;
constexpr double hottestSought_K = 1e6;
constexpr int deepestHalving = 40;

double toleranceAt(double temperature_K) {
    return probedTolerance_K * std::max(1.0, temperature_K / absoluteUpTo_K);
}

} // namespace

ApparentTemperatureTable::ApparentTemperatureTable(const Band& band, double min_W_m2_sr,
                                                   double max_W_m2_sr)
    : band_(band) {
    if (!(min_W_m2_sr > 0.0 && min_W_m2_sr <= max_W_m2_sr && std::isfinite(max_W_m2_sr)))
        throw LogicError("a table of apparent temperatures was asked for from " +
                         numberText(min_W_m2_sr) + " to " + numberText(max_W_m2_sr));

    // The temperatures of the ends, or of the coldest and hottest black body that is sought, a
    // little wider so that the ends lie inside.
    const double coldest_K = apparentTemperature_K(band, min_W_m2_sr).value_or(coldestSought_K);
    const double hottest_K = apparentTemperature_K(band, max_W_m2_sr).value_or(hottestSought_K);
    const Node cold = nodeAt(1.0 / (coldest_K * 0.9999));
    const Node hot = nodeAt(1.0 / (hottest_K * 1.0001));
    // Radiances below the smallest that is told from zero leave the table empty.
    if (!(std::isfinite(cold.logRadiance) && std::isfinite(cold.slope)))
        return;
    nodes_.push_back(cold);
    refine(cold, hot, 0);
}

ApparentTemperatureTable::Node ApparentTemperatureTable::nodeAt(double inverse_1_K) const {
    // The slope of 1/T over ln L from a central difference of four points, good to 1e-9 of itself:
    // ln L is a smooth, nearly straight function of 1/T.
    const auto logAt = [this](double u_1_K) {
        return std::log(bandRadiance_W_m2_sr(band_, 1.0 / u_1_K));
    };
    const double h = 2e-3;
    const double first = logAt(inverse_1_K * (1.0 + h)) - logAt(inverse_1_K * (1.0 - h));
    const double second =
        logAt(inverse_1_K * (1.0 + 2.0 * h)) - logAt(inverse_1_K * (1.0 - 2.0 * h));
    const double derivative = (8.0 * first - second) / (12.0 * h * inverse_1_K);
    return {logAt(inverse_1_K), inverse_1_K, 1.0 / derivative};
}

double ApparentTemperatureTable::interpolate(const Node& low, const Node& high,
                                             double logRadiance) const {
    const double width = high.logRadiance - low.logRadiance;
    const double t = (logRadiance - low.logRadiance) / width;
    const double s = 1.0 - t;
    return s * s * (1.0 + 2.0 * t) * low.inverse_1_K + t * t * (1.0 + 2.0 * s) * high.inverse_1_K +
           t * s * width * (s * low.slope - t * high.slope);
}

void ApparentTemperatureTable::refine(const Node& low, const Node& high, int depth) {
    // Probe the piece where the error of a cubic is largest and where it is skew.
    bool isRight = true;
    for (const double part : {0.2, 0.5, 0.8}) {
        const double inverse_1_K = low.inverse_1_K + part * (high.inverse_1_K - low.inverse_1_K);
        const double temperature_K = 1.0 / inverse_1_K;
        const double found_K =
            1.0 / interpolate(low, high, std::log(bandRadiance_W_m2_sr(band_, temperature_K)));
        isRight = isRight && std::abs(found_K - temperature_K) <= toleranceAt(temperature_K);
    }
    if (isRight || depth == deepestHalving) {
        nodes_.push_back(high);
        return;
    }
    const Node middle = nodeAt(std::sqrt(low.inverse_1_K * high.inverse_1_K));
    refine(low, middle, depth + 1);
    refine(middle, high, depth + 1);
}

double ApparentTemperatureTable::at(double radiance_W_m2_sr) const {
    if (!(radiance_W_m2_sr > 0.0 && std::isfinite(radiance_W_m2_sr)))
        return notANumber;
    const double logRadiance = std::log(radiance_W_m2_sr);
    if (nodes_.empty() || logRadiance < nodes_.front().logRadiance ||
        logRadiance > nodes_.back().logRadiance)
        return apparentTemperature_K(band_, radiance_W_m2_sr).value_or(notANumber);

    const Bracket at = bracket(nodes_, logRadiance, Beyond::clamp, &Node::logRadiance);
    return 1.0 / interpolate(nodes_[at.below], nodes_[at.above], logRadiance);
}

std::size_t addApparentTemperature(RadianceImage& image, const Band& band) {
    ImageChannel& target = image.channel(apparentTemperatureChannel, "K");
    const std::vector<float>& radiances = image.primary().values;
    if (&target == &image.primary())
        throw LogicError("the shown plane is a temperature already");

    // One table for the range of the picture.
    const auto isBright = [](float value) { return value > 0.0F && std::isfinite(value); };
    double low = std::numeric_limits<double>::infinity(), high = 0.0;
    for (const float value : radiances)
        if (isBright(value)) {
            low = std::min(low, static_cast<double>(value));
            high = std::max(high, static_cast<double>(value));
        }
    std::optional<ApparentTemperatureTable> table;
    if (high > 0.0)
        table.emplace(band, low, high);

    // Pixels of a background are often as bright as their neighbours: those are looked up once.
    std::size_t missing = 0;
    double temperature_K = notANumber;
    for (std::size_t i = 0; i < radiances.size(); ++i) {
        if (i == 0 || radiances[i] != radiances[i - 1])
            temperature_K = isBright(radiances[i]) ? table->at(radiances[i]) : notANumber;
        missing += std::isnan(temperature_K) ? 1 : 0;
        target.values[i] = static_cast<float>(temperature_K);
    }
    image.attributes[apparentTemperatureBand] = band.name();
    image.attributes[apparentTemperatureMissing] = std::to_string(missing);
    return missing;
}

} // namespace irsg
