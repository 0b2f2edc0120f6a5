#include "irsg/sensor/ResolvableTemperature.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include <boost/math/tools/toms748_solve.hpp>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/sensor/RequirePositive.h"

namespace irsg {

namespace {

/// Places from 0 to Nyquist's frequency at which a curve is looked at for its first crossing.
constexpr int looks = 256;

double rootBetween(const auto& curve, double low, double high, double valueLow, double valueHigh) {
    std::uintmax_t most = 100;
    const auto isNarrow = [&](double a, double b) { return b - a <= 1e-12 * high; };
    const auto [a, b] =
        boost::math::tools::toms748_solve(curve, low, high, valueLow, valueHigh, isNarrow, most);
    return std::midpoint(a, b);
}

} // namespace

double perceivedNoise_K(const SensorDescription& sensor, const PixelNoise& noise,
                        double contrast_per_K, const Observer& observer) {
    const double frames = std::max(1.0, sensor.electronics.frameRate_Hz * observer.integration_s);
    return std::hypot(noise.temporal() / std::sqrt(frames), noise.pattern) / contrast_per_K;
}

ResolvableTemperature::ResolvableTemperature(const SensorDescription& sensor, double background_K,
                                             const Observer& observer)
    : transfer_(sensor, background_K), nyquist_per_rad_(0.5 / sensor.pixelAngle_rad()) {
    requirePositive(observer.threshold, "threshold of the observer", "a number above 0");
    requirePositive(observer.integration_s, "integration time of the eye", "a time above 0 s");
    const PixelResponse response(sensor);
    noise_K_ = perceivedNoise_K(sensor, response.noise(response.signal(background_K)),
                                response.contrast_per_K(background_K), observer);
    if (!std::isfinite(noise_K_))
        throw InputError({"", "background temperature", numberText(background_K),
                          "a temperature in K whose radiance in the sensor's band is above 0"});
    perFrequency_rad_ =
        pi * pi / (4.0 * std::sqrt(7.0)) * observer.threshold * sensor.pixelAngle_rad();
    for (const Direction direction : {Direction::horizontal, Direction::vertical}) {
        std::vector<double>& table = looks_[static_cast<std::size_t>(direction)];
        for (int i = 0; i <= looks; ++i)
            table.push_back(transfer(placeOf(i), direction));
        // Without blur at frequency 0; what rounding or a lack of energy leaves there is none.
        const auto reversed = std::ranges::find_if(table, [](double m) { return m <= 0.0; });
        table.erase(reversed == table.end() ? reversed : reversed + 1, table.end());
    }
}

double ResolvableTemperature::transfer(double frequency_per_rad, Direction direction) const {
    return direction == Direction::horizontal ? transfer_.at(frequency_per_rad, 0.0)
                                              : transfer_.at(0.0, frequency_per_rad);
}

double ResolvableTemperature::placeOf(int look) const {
    return nyquist_per_rad_ * look / looks;
}

double ResolvableTemperature::mrtd_K(double frequency_per_rad, Direction direction) const {
    constexpr double never = std::numeric_limits<double>::infinity();
    const std::vector<double>& table = looks_[static_cast<std::size_t>(direction)];
    if (frequency_per_rad > placeOf(static_cast<int>(table.size()) - 1))
        return never;
    const double passed = transfer(frequency_per_rad, direction);
    return passed > 0.0 ? noise_K_ * perFrequency_rad_ * frequency_per_rad / passed : never;
}

double ResolvableTemperature::mrtd_K(double frequency_per_rad) const {
    if (frequency_per_rad == 0.0)
        return 0.0;
    const auto isResolved = [&](double logDifference) {
        return bothResolved_per_rad(std::exp(logDifference)) >= frequency_per_rad;
    };
    // The least difference that resolves it, as ln of it by the noise: at Nyquist's frequency all
    // larger ones resolve no more, so that no root finder knows which one is meant.
    double least = -100.0, most = 100.0;
    if (!isResolved(most))
        return std::numeric_limits<double>::infinity();
    for (int i = 0; i < 60; ++i) {
        const double middle = std::midpoint(least, most);
        (isResolved(middle) ? most : least) = middle;
    }
    return noise_K_ * std::exp(most);
}

double ResolvableTemperature::resolved_per_rad(double differenceByNoise,
                                               Direction direction) const {
    if (!(differenceByNoise > 0.0))
        return 0.0;
    // Without a quotient, which has no value where nothing passes.
    const auto seenLess = [&](double passed, double f) {
        return differenceByNoise * passed - perFrequency_rad_ * f;
    };
    const std::vector<double>& table = looks_[static_cast<std::size_t>(direction)];
    double before = seenLess(table.front(), 0.0);
    for (std::size_t i = 1; i < table.size(); ++i) {
        const double place = placeOf(static_cast<int>(i));
        const double here = seenLess(table[i], place);
        if (here <= 0.0)
            return rootBetween([&](double f) { return seenLess(transfer(f, direction), f); },
                               placeOf(static_cast<int>(i) - 1), place, before, here);
        before = here;
    }
    return placeOf(static_cast<int>(table.size()) - 1);
}

double ResolvableTemperature::bothResolved_per_rad(double differenceByNoise) const {
    return std::sqrt(resolved_per_rad(differenceByNoise, Direction::horizontal) *
                     resolved_per_rad(differenceByNoise, Direction::vertical));
}

const std::vector<JohnsonTask>& johnsonTasks() {
    static const std::vector<JohnsonTask> tasks = {
        {"detection", 0.75}, {"recognition", 3.0}, {"identification", 6.0}};
    return tasks;
}

double taskProbability(double cycles, double cyclesOfHalf, const TaskLaw& law) {
    const double x = std::max(0.0, cycles) / cyclesOfHalf;
    if (x == 0.0)
        return 0.0;
    return 1.0 / (1.0 + std::pow(x, -(law.constant + law.slope * x)));
}

double taskCycles(double probability, double cyclesOfHalf, const TaskLaw& law) {
    if (!(probability > 0.0 && probability < 1.0))
        throw InputError({"", "probability of the task", numberText(probability),
                          "a number between 0 and 1, both exclusive"});
    requirePositive(cyclesOfHalf, "cycles of the task", "a number above 0");
    const auto excess = [&](double x) {
        // ln of the odds: rises without bounds, and is 0 at 1.
        return (law.constant + law.slope * x) * std::log(x) -
               std::log(probability / (1.0 - probability));
    };
    std::uintmax_t most = 200;
    const auto isNarrow = [](double a, double b) { return b - a <= 1e-13 * b; };
    const auto [low, high] = boost::math::tools::toms748_solve(excess, 1e-300, 1e3, isNarrow, most);
    return cyclesOfHalf * std::midpoint(low, high);
}

} // namespace irsg
