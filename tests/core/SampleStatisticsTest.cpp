#include "smatcore/analysis/SampleStatistics.h"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/signature/random/Philox.h"
#include "smatcore/analysis/SobolIndices.h"

namespace smat {

namespace {

using Kind = Statistic::Kind;

/// Independent values of the analytic target e^g with g = 0.3 (x + y), x and y standard uniform
/// numbers about 0; its mean and percentiles are known.
double target(double u, double v) {
    return std::exp(0.6 * (u - 0.5) + 0.6 * (v - 0.5));
}
double targetMean() {
    const double one = (std::exp(0.3) - std::exp(-0.3)) / 0.6;
    return one * one;
}
double targetSigma() {
    const double square = (std::exp(0.6) - std::exp(-0.6)) / 1.2;
    return std::sqrt(square * square - std::pow(targetMean(), 2));
}
/// u + v has the triangular distribution.
double targetPercentile(double percent) {
    const double p = percent / 100.0;
    const double sum = p < 0.5 ? std::sqrt(2.0 * p) : 2.0 - std::sqrt(2.0 * (1.0 - p));
    return std::exp(0.6 * (sum - 1.0));
}

/// Percent of samples whose interval holds the truth.
double coverage(int samples, double truth,
                const std::function<Estimate(std::uint64_t seed)>& look) {
    int held = 0;
    for (int sample = 0; sample < samples; ++sample) {
        const Estimate found = look(static_cast<std::uint64_t>(sample) + 1);
        held += found.low95 <= truth && truth <= found.high95 ? 1 : 0;
    }
    return 100.0 * held / samples;
}

std::vector<double> plainSample(std::uint64_t seed, std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(
            target(irsg::unitOf(seed, {0, 0, 0}, i), irsg::unitOf(seed, {0, 0, 1}, i)));
    return values;
}

std::vector<SceneScaling> unitScales(int count) {
    std::vector<SceneScaling> scales;
    for (int i = 0; i < count; ++i)
        scales.push_back({{0, irsg::ScalingKind::emissivity, i, 0.0, 1.0},
                          irsg::Distribution(irsg::DistributionKind::uniform, 0.0, 1.0),
                          "u"});
    return scales;
}

constexpr int samples = 3000;

} // namespace

TEST(SampleStatistics, knowsSmallSamplesByHeart) {
    const std::vector<double> values{4.0, 1.0, 3.0, 2.0};
    EXPECT_EQ(meanOf(values), 2.5);
    EXPECT_NEAR(standardDeviationOf(values), std::sqrt(5.0 / 3.0), 1e-15);
    const std::vector<double> ascending{1.0, 2.0, 3.0, 4.0};
    EXPECT_EQ(percentileOf(ascending, 0.0), 1.0);
    EXPECT_EQ(percentileOf(ascending, 50.0), 2.5);
    EXPECT_EQ(percentileOf(ascending, 100.0), 4.0);
    EXPECT_NEAR(percentileOf(ascending, 25.0), 1.75, 1e-15);
    // Student's t of 3 degrees of freedom: 3.182.
    const Estimate mean = estimate(values, {});
    EXPECT_NEAR(mean.standardError, std::sqrt(5.0 / 12.0), 1e-15);
    EXPECT_NEAR(mean.high95 - mean.value, 3.182 * mean.standardError, 1e-12);
    EXPECT_NEAR(Estimate::withStudent(0.0, 1.0, 15).high95, 2.1314, 1e-3);
    EXPECT_NEAR(Estimate::withStudent(0.0, 1.0, 4).high95, 2.7764, 2e-3);
}

TEST(SampleStatistics, standsSamplesThatHaveNoSpreadOrNoValues) {
    for (const Kind kind : {Kind::mean, Kind::standardDeviation, Kind::percentile}) {
        EXPECT_EQ(estimate({}, {kind, 50.0}).value, 0.0);
        const Estimate same = estimate(std::vector<double>(40, 7.0), {kind, 50.0});
        EXPECT_EQ(same.value, kind == Kind::standardDeviation ? 0.0 : 7.0);
        EXPECT_EQ(same.standardError, 0.0);
    }
    EXPECT_TRUE(histogramOf({}).counts.empty());
    EXPECT_THAT(histogramOf(std::vector<double>(5, 2.0)).counts, testing::ElementsAre(5));
    // A small spread on a large mean.
    EXPECT_NEAR(standardDeviationOf(std::vector<double>{1e9, 1e9 + 1e-3, 1e9 + 2e-3}), 1e-3, 1e-6);
}

TEST(SampleStatistics, countsEveryValueOfAHistogramOnce) {
    const std::vector<double> values = plainSample(3, 5000);
    const SampleHistogram histogram = histogramOf(values);
    std::size_t sum = 0;
    for (const std::size_t count : histogram.counts)
        sum += count;
    EXPECT_EQ(sum, values.size());
    EXPECT_GT(histogram.counts.size(), 15u);
    EXPECT_EQ(histogramOf(values, 7).counts.size(), 7u);
}

TEST(Coverage, ofPlainDrawsIsNinetyFivePercent) {
    const struct {
        const char* name;
        Statistic statistic;
        double truth;
    } rows[] = {{"mean", {}, targetMean()},
                {"standard deviation", {Kind::standardDeviation, 50.0}, targetSigma()},
                {"5th percentile", {Kind::percentile, 5.0}, targetPercentile(5.0)},
                {"median", {Kind::percentile, 50.0}, targetPercentile(50.0)},
                {"95th percentile", {Kind::percentile, 95.0}, targetPercentile(95.0)}};
    for (const auto& row : rows) {
        const double found = coverage(samples, row.truth, [&](std::uint64_t seed) {
            return estimate(plainSample(seed, 256), row.statistic);
        });
        EXPECT_GE(found, 93.0) << row.name;
        EXPECT_LE(found, 97.0) << row.name;
        RecordProperty(row.name, std::to_string(found));
    }
}

TEST(Coverage, ofSobolSequencesIsNinetyFivePercent) {
    const struct {
        const char* name;
        Statistic statistic;
        double truth;
    } rows[] = {{"mean", {}, targetMean()},
                {"median", {Kind::percentile, 50.0}, targetPercentile(50.0)}};
    for (const auto& row : rows) {
        const double found = coverage(samples, row.truth, [&](std::uint64_t seed) {
            const ScalingDraws draws(unitScales(2), DrawSequence::sobol, seed);
            std::vector<double> values;
            for (std::size_t i = 0; i < 512; ++i) {
                const std::vector<double> at = draws.at(i);
                values.push_back(target(at[0], at[1]));
            }
            return estimateByReplicates(values, sobolReplicates, row.statistic);
        });
        EXPECT_GE(found, 93.0) << row.name;
        EXPECT_LE(found, 97.0) << row.name;
        RecordProperty(row.name, std::to_string(found));
    }
}

TEST(Coverage, ofSobolIndicesIsNinetyFivePercent) {
    // 4 u + 2 v + w: the squares 16 : 4 : 1.
    const ScaledModel model = [](const std::vector<double>& x) {
        return std::vector<double>{4.0 * x[0] + 2.0 * x[1] + x[2]};
    };
    for (const DrawSequence sequence : {DrawSequence::plain, DrawSequence::sobol}) {
        const int repeats = 800;
        int held[3] = {}, heldTotal[3] = {};
        for (int repeat = 0; repeat < repeats; ++repeat) {
            const ScalingDraws draws(unitScales(3), sequence, static_cast<std::uint64_t>(repeat),
                                     true);
            for (const RankedScaling& one :
                 rankScalings(draws, sequence, 256, model, [](std::size_t) { return true; })) {
                const double truth = (one.scaling == 0   ? 16.0
                                      : one.scaling == 1 ? 4.0
                                                         : 1.0) /
                                     21.0;
                held[one.scaling] +=
                    one.firstOrder.low95 <= truth && truth <= one.firstOrder.high95 ? 1 : 0;
                heldTotal[one.scaling] +=
                    one.total.low95 <= truth && truth <= one.total.high95 ? 1 : 0;
            }
        }
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(100.0 * held[i] / repeats, 95.0, 3.0) << name(sequence) << " " << i;
            EXPECT_NEAR(100.0 * heldTotal[i] / repeats, 95.0, 3.0) << name(sequence) << " " << i;
        }
    }
}

} // namespace smat
