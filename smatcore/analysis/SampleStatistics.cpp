#include "smatcore/analysis/SampleStatistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace smat {

namespace {

/// 97.5 % point of the normal distribution.
constexpr double normal975 = 1.959963984540054;

/// 97.5 % point of Student's t: Cornish and Fisher's expansion (Abramowitz and Stegun 26.7.5), 1e-3
/// from 4 degrees of freedom on; tables below.
double student975(std::size_t degreesOfFreedom) {
    constexpr double few[] = {12.706, 4.303, 3.182};
    if (degreesOfFreedom < 1)
        return few[0];
    if (degreesOfFreedom <= 3)
        return few[degreesOfFreedom - 1];
    const double n = static_cast<double>(degreesOfFreedom);
    const double z = normal975, z2 = z * z;
    const double g1 = z * (z2 + 1.0) / 4.0;
    const double g2 = z * ((5.0 * z2 + 16.0) * z2 + 3.0) / 96.0;
    const double g3 = z * (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / 384.0;
    const double g4 =
        z * ((((79.0 * z2 + 776.0) * z2 + 1482.0) * z2 - 1920.0) * z2 - 945.0) / 92160.0;
    return z + (g1 + (g2 + (g3 + g4 / n) / n) / n) / n;
}

std::vector<double> sorted(std::span<const double> values) {
    std::vector<double> ascending(values.begin(), values.end());
    std::sort(ascending.begin(), ascending.end());
    return ascending;
}

double valueOf(std::span<const double> values, const Statistic& statistic) {
    switch (statistic.kind) {
    case Statistic::Kind::mean:
        return meanOf(values);
    case Statistic::Kind::standardDeviation:
        return standardDeviationOf(values);
    case Statistic::Kind::percentile:
        break;
    }
    return percentileOf(sorted(values), statistic.percent);
}

/// Linear between order statistics; `rank` counts from 1 as order statistics do.
double atRank(std::span<const double> ascending, double rank) {
    const double last = static_cast<double>(ascending.size() - 1);
    const double place = std::clamp(rank - 1.0, 0.0, last);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, ascending.size() - 1);
    const double part = place - static_cast<double>(below);
    return ascending[below] + part * (ascending[above] - ascending[below]);
}

/// A percentile whose error the sample does not bound.
Estimate unbounded(double value) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {value, none, none, none};
}

Estimate percentileEstimate(std::span<const double> values, double percent) {
    const std::vector<double> ascending = sorted(values);
    if (!hasBoundedError({Statistic::Kind::percentile, percent}, values.size()))
        return unbounded(percentileOf(ascending, percent));
    const double n = static_cast<double>(values.size()), p = percent / 100.0;
    const double reach = normal975 * std::sqrt(n * p * (1.0 - p));
    // P(X_(r) <= x_p) follows the binomial distribution; half a rank to its continuity.
    const double low = atRank(ascending, n * p - reach + 0.5);
    const double high = atRank(ascending, n * p + reach + 0.5);
    return {percentileOf(ascending, percent), (high - low) / (2.0 * normal975), low, high};
}

/// The spread of the sets' shares of values below the percentile of all, taken to the axis of the
/// values by their order statistics: percentiles of the small sets would be biased. Sets whose
/// points are stratified may all have the same share below it; where it lies between the two values
/// about it is unknown all the same: the middle of them scatters by 1/sqrt(2) of a rank.
Estimate percentileByReplicates(std::span<const double> values, std::size_t replicates,
                                double percent) {
    const std::vector<double> ascending = sorted(values);
    const double value = percentileOf(ascending, percent);
    if (!hasBoundedError({Statistic::Kind::percentile, percent}, values.size()))
        return unbounded(value);
    std::vector<double> shares;
    for (std::size_t replicate = 0; replicate < std::min(replicates, values.size()); ++replicate) {
        double below = 0.0, count = 0.0;
        for (std::size_t i = replicate; i < values.size(); i += replicates) {
            below += values[i] <= value ? 1.0 : 0.0;
            count += 1.0;
        }
        shares.push_back(below / count);
    }
    const double ofRank = std::sqrt(0.5) / static_cast<double>(values.size());
    const double error = std::hypot(
        standardDeviationOf(shares) / std::sqrt(static_cast<double>(shares.size())), ofRank);
    const double t = student975(shares.size() - 1);
    const auto at = [&](double share) {
        return percentileOf(ascending, std::clamp(100.0 * share, 0.0, 100.0));
    };
    const double low = at(percent / 100.0 - t * error), high = at(percent / 100.0 + t * error);
    return {value, (high - low) / (2.0 * t), low, high};
}

} // namespace

Estimate Estimate::withStudent(double value, double standardError, std::size_t degreesOfFreedom) {
    const double reach = student975(degreesOfFreedom) * standardError;
    return {value, standardError, value - reach, value + reach};
}

double meanOf(std::span<const double> values) {
    // About the first value, so that a small spread on a large mean keeps its digits.
    if (values.empty())
        return 0.0;
    double sum = 0.0;
    for (const double value : values)
        sum += value - values.front();
    return values.front() + sum / static_cast<double>(values.size());
}

double standardDeviationOf(std::span<const double> values) {
    if (values.size() < 2)
        return 0.0;
    const double mean = meanOf(values);
    double sum = 0.0;
    for (const double value : values)
        sum += (value - mean) * (value - mean);
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

double percentileOf(std::span<const double> ascending, double percent) {
    if (ascending.empty())
        return 0.0;
    return atRank(ascending, 1.0 + percent / 100.0 * static_cast<double>(ascending.size() - 1));
}

bool hasBoundedError(const Statistic& statistic, std::size_t count) {
    if (statistic.kind != Statistic::Kind::percentile)
        return true;
    const double p = statistic.percent / 100.0;
    constexpr double oneSide = 0.025;
    return std::pow(std::max(p, 1.0 - p), static_cast<double>(count)) <= oneSide;
}

Estimate estimate(std::span<const double> values, const Statistic& statistic) {
    const std::size_t count = values.size();
    if (count < 2) {
        const double value = count == 0 ? 0.0 : values.front();
        return {value, 0.0, value, value};
    }
    const double n = static_cast<double>(count);
    const double sigma = standardDeviationOf(values);
    switch (statistic.kind) {
    case Statistic::Kind::mean:
        return Estimate::withStudent(meanOf(values), sigma / std::sqrt(n), count - 1);
    case Statistic::Kind::standardDeviation: {
        const double mean = meanOf(values);
        double fourth = 0.0;
        for (const double value : values)
            fourth += std::pow(value - mean, 4);
        const double variance = sigma * sigma;
        const double excess = variance > 0.0 ? fourth / (n * variance * variance) - 1.0 : 0.0;
        return Estimate::withStudent(sigma, sigma * std::sqrt(std::max(excess, 0.0) / (4.0 * n)),
                                     count - 1);
    }
    case Statistic::Kind::percentile:
        break;
    }
    return percentileEstimate(values, statistic.percent);
}

Estimate estimateByReplicates(std::span<const double> values, std::size_t replicates,
                              const Statistic& statistic) {
    std::vector<double> statistics;
    for (std::size_t replicate = 0; replicate < replicates; ++replicate) {
        std::vector<double> own;
        for (std::size_t i = replicate; i < values.size(); i += replicates)
            own.push_back(values[i]);
        if (!own.empty())
            statistics.push_back(valueOf(own, statistic));
    }
    const double value = valueOf(values, statistic);
    if (statistics.size() < 2)
        return {value, 0.0, value, value};
    if (statistic.kind == Statistic::Kind::percentile)
        return percentileByReplicates(values, replicates, statistic.percent);
    const double error =
        standardDeviationOf(statistics) / std::sqrt(static_cast<double>(statistics.size()));
    return Estimate::withStudent(value, error, statistics.size() - 1);
}

SampleHistogram histogramOf(std::span<const double> values, std::size_t bins) {
    SampleHistogram histogram;
    if (values.empty())
        return histogram;
    const std::vector<double> ascending = sorted(values);
    const double range = ascending.back() - ascending.front();
    if (bins == 0) {
        const double middleHalf = percentileOf(ascending, 75.0) - percentileOf(ascending, 25.0);
        const double width = 2.0 * middleHalf / std::cbrt(static_cast<double>(ascending.size()));
        bins = width > 0.0
                   ? static_cast<std::size_t>(std::clamp(std::ceil(range / width), 1.0, 200.0))
                   : 1;
    }
    histogram.least = ascending.front();
    histogram.width = range / static_cast<double>(bins);
    histogram.counts.assign(bins, 0);
    for (const double value : ascending) {
        const double place = range > 0.0 ? (value - histogram.least) / histogram.width : 0.0;
        ++histogram.counts[std::min(static_cast<std::size_t>(place), bins - 1)];
    }
    return histogram;
}

} // namespace smat
