#include "irsg/sensor/TargetingTask.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include <boost/math/tools/toms748_solve.hpp>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/Units.h"
#include "irsg/sensor/RequirePositive.h"
#include "irsg/sensor/Sinc.h"

namespace irsg {

namespace {

/// Steps up to Nyquist's frequency.
constexpr int steps = 1024;
/// Of the observer's eye and mind, root Hz, and of the band that he looks through.
constexpr double calibration_rootHz = 169.6;
constexpr double bandSharpness = 2.2;

/// Of a pattern of frequency f and display pixels p, f p.
double bandwidthAlong(double f) {
    // g = f e^t; at |t| = 3 the square of the band is 1e-17.
    const GaussRule& rule = gaussLegendre(20);
    constexpr int panels = 6;
    double sum = 0.0;
    for (int panel = 0; panel < panels; ++panel)
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double t = -3.0 + 6.0 * (panel + rule.nodes[i]) / panels;
            const double g = f * std::exp(t), shown = sinc(g);
            sum += rule.weights[i] * 6.0 / panels * g * std::exp(-2.0 * bandSharpness * t * t) *
                   shown * shown;
        }
    return 2.0 * sum;
}

} // namespace

double eyeThreshold(double frequency_per_deg, double luminance_cd_m2, double field_deg) {
    const double u = frequency_per_deg, third = 1.0 + u / 3.0;
    const double a = 540.0 * std::pow(1.0 + 0.7 / luminance_cd_m2, -0.2) /
                     (1.0 + 12.0 / (field_deg * third * third));
    const double b = 0.3 * std::pow(1.0 + 100.0 / luminance_cd_m2, 0.15);
    return 1.0 / (a * u * std::exp(-b * u) * std::sqrt(1.0 + 0.06 * std::exp(b * u)));
}

TargetingTask::TargetingTask(const SensorDescription& sensor, double background_K,
                             const Observer& observer, const SensorDisplay& display)
    : transfer_(sensor, background_K),
      observer_(observer),
      display_(display),
      pixel_rad_(sensor.pixelAngle_rad()),
      field_deg_(degrees(1e-3 * display.pixel_mrad *
                         std::sqrt(static_cast<double>(sensor.detector.columns) *
                                   static_cast<double>(sensor.detector.rows)))),
      step_per_rad_(0.5 / pixel_rad_ / steps) {
    requirePositive(observer.integration_s, "integration time of the eye", "a time above 0 s");
    requirePositive(display.pixel_mrad, "pixel of the display", "an angle above 0 mrad");
    requirePositive(display.luminance_cd_m2, "luminance of the display",
                    "a luminance above 0 cd m-2");
    requirePositive(display.sceneContrast_K, "scene contrast",
                    "a temperature difference above 0 K");
    const PixelResponse response(sensor);
    noise_K_ = perceivedNoise_K(sensor, response.noise(response.signal(background_K)),
                                response.contrast_per_K(background_K), observer);
    if (!std::isfinite(noise_K_))
        throw InputError({"", "background temperature", numberText(background_K),
                          "a temperature in K whose radiance in the sensor's band is above 0"});
    for (const Direction direction : {Direction::horizontal, Direction::vertical}) {
        std::vector<Node>& nodes = nodes_[static_cast<std::size_t>(direction)];
        for (int i = 1; i <= steps; ++i) {
            const Node node = nodeAt(step_per_rad_ * i, direction);
            if (!std::isfinite(node.quiet))
                break;
            nodes.push_back(node);
        }
    }
}

TargetingTask::Node TargetingTask::nodeAt(double frequency_per_rad, Direction direction) const {
    constexpr double never = std::numeric_limits<double>::infinity();
    const double shown = frequency_per_rad * pixel_rad_; // cycles per pixel
    const double passed =
        (direction == Direction::horizontal ? transfer_.at(frequency_per_rad, 0.0)
                                            : transfer_.at(0.0, frequency_per_rad)) *
        sinc(shown);
    // What rounding leaves is nothing.
    if (!(passed > 1e-9))
        return {never, 0.0};
    const double seen_per_deg = shown / degrees(1e-3 * display_.pixel_mrad);
    const double quiet = eyeThreshold(seen_per_deg, display_.luminance_cd_m2, field_deg_) / passed;
    // The density is p^2 t of the noise, the bandwidths are in 1 / p; that across is 1 / p.
    const double noise = calibration_rootHz / display_.sceneContrast_K;
    return {quiet * quiet, noise * noise * observer_.integration_s * bandwidthAlong(shown)};
}

double TargetingTask::threshold(double frequency_per_rad, Direction direction) const {
    const Node node = nodeAt(frequency_per_rad, direction);
    return std::sqrt(node.quiet * (1.0 + node.perNoise * noise_K_ * noise_K_));
}

double TargetingTask::along(double contrast, double noise_K, Direction direction) const {
    // sqrt(C / CTF) at the nodes, linear between them; where it passes 1 the integral begins or
    // ends.
    const auto ratioOf = [&](const Node& node) {
        return std::sqrt(contrast /
                         std::sqrt(node.quiet * (1.0 + node.perNoise * noise_K * noise_K)));
    };
    double sum = 0.0, before = 0.0; // at frequency 0 the eye sees nothing
    for (const Node& node : nodes_[static_cast<std::size_t>(direction)]) {
        const double here = ratioOf(node);
        const double low = std::min(before, here), high = std::max(before, here);
        if (low >= 1.0)
            sum += 0.5 * (low + high);
        else if (high > 1.0)
            sum += 0.5 * (1.0 + high) * (high - 1.0) / (high - low);
        before = here;
    }
    return sum * step_per_rad_;
}

double TargetingTask::cycles_per_rad(double difference_K, double noise_K) const {
    const double contrast =
        std::min(1.0, std::abs(difference_K) / (2.0 * display_.sceneContrast_K));
    if (!(contrast > 0.0))
        return 0.0;
    return std::sqrt(along(contrast, noise_K, Direction::horizontal) *
                     along(contrast, noise_K, Direction::vertical));
}

const std::vector<JohnsonTask>& targetingTasks() {
    static const std::vector<JohnsonTask> tasks = {
        {"detection", 2.7}, {"recognition", 14.5}, {"identification", 18.8}};
    return tasks;
}

const std::vector<JohnsonTask>& nominalTasks() {
    static const std::vector<JohnsonTask> tasks = {
        {"detection", 1.0}, {"recognition", 3.0}, {"identification", 6.0}};
    return tasks;
}

double nominalRange_m(const ResolvableTemperature& sensor, const NominalTarget& target,
                      double linePairs) {
    requirePositive(target.side_m, "side of the target", "a length above 0 m");
    requirePositive(target.difference_K, "temperature difference of the target",
                    "a difference above 0 K");
    requirePositive(linePairs, "line pairs across the target", "a number above 0");
    if (!(target.extinction_per_km >= 0.0 && std::isfinite(target.extinction_per_km)))
        throw InputError({"", "extinction", numberText(target.extinction_per_km),
                          "a number of at least 0 per km"});
    const auto excess = [&](double range_m) {
        const double seen_K =
            target.difference_K * std::exp(-1e-3 * target.extinction_per_km * range_m);
        return sensor.frequency_per_rad(seen_K) * target.side_m / range_m - linePairs;
    };
    // No sensor resolves more than Nyquist's frequency, so the root lies nearer than that.
    const double farthest_m = 1.001 * sensor.nyquist_per_rad() * target.side_m / linePairs;
    if (farthest_m <= 1.0 || excess(1.0) <= 0.0)
        return 0.0;
    std::uintmax_t most = 200;
    const auto isNarrow = [](double a, double b) { return b - a <= 1e-12 * b; };
    const auto [low, high] =
        boost::math::tools::toms748_solve(excess, 1.0, farthest_m, isNarrow, most);
    return std::midpoint(low, high);
}

} // namespace irsg
