#include "smatcore/analysis/SampleStatistics.h"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/ParallelFor.h"
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
    for (std::size_t i = 0; i < count; ++i) {
        values.push_back(
            target(irsg::unitOf(seed, {0, 0, 0}, i), irsg::unitOf(seed, {0, 0, 1}, i)));
    }
    return values;
}

std::vector<SceneScaling> unitScales(int count) {
    std::vector<SceneScaling> scales;
    for (int i = 0; i < count; ++i) {
        scales.push_back({{0, irsg::ScalingKind::emissivity, i, 0.0, 1.0},
                          irsg::Distribution(irsg::DistributionKind::uniform, 0.0, 1.0),
                          "u"});
    }
    return scales;
}

constexpr int samples = 3000;

} // namespace

TEST(SampleStatistics, KnowsSmallSamplesByHeart) {
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

TEST(SampleStatistics, StandsSamplesThatHaveNoSpreadOrNoValues) {
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

TEST(SampleStatistics, PercentilesWithoutValuesBeyondThemHaveNoError) {
    const std::vector<double> values = plainSample(5, 256);
    for (const double percent : {0.0, 0.01, 99.99, 100.0}) {
        const Statistic statistic{Kind::percentile, percent};
        EXPECT_FALSE(hasBoundedError(statistic, values.size()));
        for (const Estimate& one :
             {estimate(values, statistic), estimateByReplicates(values, 8, statistic)}) {
            EXPECT_TRUE(std::isnan(one.standardError)) << percent;
            EXPECT_TRUE(std::isnan(one.low95) && std::isnan(one.high95)) << percent;
            EXPECT_EQ(one.value, estimate(values, statistic).value);
        }
    }
    // 0.95^n is 0.025 at 71.9 values.
    EXPECT_FALSE(hasBoundedError({Kind::percentile, 95.0}, 71));
    EXPECT_TRUE(hasBoundedError({Kind::percentile, 95.0}, 72));
    EXPECT_FALSE(hasBoundedError({Kind::percentile, 5.0}, 71));
    EXPECT_TRUE(hasBoundedError({Kind::percentile, 5.0}, 72));
    EXPECT_FALSE(hasBoundedError({Kind::percentile, 100.0}, 1'000'000'000));
    EXPECT_TRUE(hasBoundedError({}, 2));
}

TEST(SampleStatistics, CountsEveryValueOfAHistogramOnce) {
    const std::vector<double> values = plainSample(3, 5000);
    const SampleHistogram histogram = histogramOf(values);
    std::size_t sum = 0;
    for (const std::size_t count : histogram.counts) {
        sum += count;
    }
    EXPECT_EQ(sum, values.size());
    EXPECT_GT(histogram.counts.size(), 15u);
    EXPECT_EQ(histogramOf(values, 7).counts.size(), 7u);
}

TEST(Coverage, OfPlainDrawsIsNinetyFivePercent) {
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

TEST(Coverage, OfSobolSequencesIsNinetyFivePercent) {
    const struct {
        const char* name;
        Statistic statistic;
        double truth;
    } rows[] = {{"mean", {}, targetMean()},
                {"median", {Kind::percentile, 50.0}, targetPercentile(50.0)}};
    for (const auto& row : rows) {
        const double found = coverage(samples, row.truth, [&](std::uint64_t seed) {
            const ScalingRealisations realisations(unitScales(2), RealisationSequence::sobol, seed);
            std::vector<double> values;
            for (std::size_t i = 0; i < 512; ++i) {
                const std::vector<double> at = realisations.at(i);
                values.push_back(target(at[0], at[1]));
            }
            return estimateByReplicates(values, sobolReplicates, row.statistic);
        });
        EXPECT_GE(found, 93.0) << row.name;
        EXPECT_LE(found, 97.0) << row.name;
        RecordProperty(row.name, std::to_string(found));
    }
}

TEST(Coverage, OfPercentilesOfStratifiedSetsIsNotLessThanStated) {
    // Sets of a function of one number with a value in each stratum have the same share below the
    // border of two strata, so that their spread is none.
    constexpr std::size_t sets = 16, strata = 16;
    const auto sample = [](std::uint64_t seed) {
        std::vector<double> values(sets * strata);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double place = irsg::unitOf(seed, {0, 0, 0}, i);
            values[i] = std::exp(0.6 * (static_cast<double>(i / sets) + place) / strata);
        }
        return values;
    };
    for (const double percent : {25.0, 40.0, 50.0, 75.0, 90.0}) {
        const double truth = std::exp(0.6 * percent / 100.0);
        double square = 0.0, stated = 0.0;
        const double found = coverage(1000, truth, [&](std::uint64_t seed) {
            const Estimate one =
                estimateByReplicates(sample(seed), sets, {Kind::percentile, percent});
            square += std::pow(one.value - truth, 2);
            stated += one.standardError;
            return one;
        });
        EXPECT_GE(found, 93.0) << percent;
        EXPECT_LE(stated / 1000.0, 1.6 * std::sqrt(square / 1000.0)) << percent;
    }
}

namespace {

/// A function of uniform numbers whose Sobol' indices are known.
struct Analytic {
    const char* name;
    double (*at)(const std::vector<double>& u);
    std::vector<double> firstOrder, total;
};

/// 4 u + 2 v + w: the squares 16 : 4 : 1.
double additive(const std::vector<double>& u) {
    return 4.0 * u[0] + 2.0 * u[1] + u[2];
}
/// Ishigami and Homma (1990) with a = 7 and b = 0.1.
double ishigami(const std::vector<double>& u) {
    const auto angle = [&](std::size_t i) { return M_PI * (2.0 * u[i] - 1.0); };
    return std::sin(angle(0)) + 7.0 * std::pow(std::sin(angle(1)), 2) +
           0.1 * std::pow(angle(2), 4) * std::sin(angle(0));
}
/// The g-function of Saltelli and Sobol' (1995) with a = 0, 1, 9.
double gFunction(const std::vector<double>& u) {
    constexpr double a[] = {0.0, 1.0, 9.0};
    double value = 1.0;
    for (std::size_t i = 0; i < 3; ++i) {
        value *= (std::abs(4.0 * u[i] - 2.0) + a[i]) / (1.0 + a[i]);
    }
    return value;
}

const std::vector<Analytic>& analytics() {
    static const std::vector<Analytic> table = [] {
        std::vector<Analytic> made;
        made.push_back({"additive", additive, {16.0 / 21.0, 4.0 / 21.0, 1.0 / 21.0}, {}});
        made.back().total = made.back().firstOrder;
        // From the integrals in the paper, to their four digits.
        made.push_back({"Ishigami", ishigami, {0.3139, 0.4424, 0.0}, {0.5576, 0.4424, 0.2437}});
        made.push_back({"g", gFunction, {}, {}});
        const double parts[] = {1.0 / 3.0, 1.0 / 12.0, 1.0 / 300.0};
        const double all = (1.0 + parts[0]) * (1.0 + parts[1]) * (1.0 + parts[2]);
        for (const double part : parts) {
            made.back().firstOrder.push_back(part / (all - 1.0));
            made.back().total.push_back(part * all / (1.0 + part) / (all - 1.0));
        }
        return made;
    }();
    return table;
}

} // namespace

TEST(Coverage, OfSobolIndicesIsNinetyFivePercent) {
    // 600 repeats: one standard error of 95 % is 0.9 %; `sobol-coverage` in benchmarks makes more.
    constexpr int repeats = 600;
    for (const Analytic& function : analytics()) {
        const ScaledModel model = [&](const std::vector<double>& u) {
            return std::vector<double>{function.at(u)};
        };
        for (const RealisationSequence sequence :
             {RealisationSequence::plain, RealisationSequence::sobol}) {
            int held[3] = {}, heldTotal[3] = {};
            const auto holds = [](const Estimate& found, double truth) {
                return found.low95 <= truth && truth <= found.high95 ? 1 : 0;
            };
            for (int repeat = 0; repeat < repeats; ++repeat) {
                const ScalingRealisations realisations(unitScales(3), sequence,
                                                       static_cast<std::uint64_t>(repeat), true);
                for (const RankedScaling& one : rankScalings(
                         realisations, sequence, 256, [&] { return model; },
                         [](std::size_t) { return true; })) {
                    held[one.scaling] += holds(one.firstOrder, function.firstOrder[one.scaling]);
                    heldTotal[one.scaling] += holds(one.total, function.total[one.scaling]);
                }
            }
            for (int i = 0; i < 3; ++i) {
                EXPECT_NEAR(100.0 * held[i] / repeats, 95.0, 3.0)
                    << function.name << " " << name(sequence) << " " << i;
                EXPECT_NEAR(100.0 * heldTotal[i] / repeats, 95.0, 3.0)
                    << function.name << " " << name(sequence) << " total " << i;
            }
        }
    }
}

TEST(SobolIndices, HaveErrorsOfAJackknifeAndIntervalsOfStudent) {
    // y + noise and y + other noise, in four replicates of 32 pairs.
    const auto values = [](std::uint64_t i, int which) {
        const double shared = irsg::unitOf(7, {0, 0, 0}, i);
        return std::vector<double>{shared + 0.5 * irsg::unitOf(7, {0, 0, which}, i)};
    };
    constexpr std::size_t replicates = 4;
    const auto indexWithout = [&](std::size_t left) {
        PickFreeze some;
        for (std::uint64_t i = 0; i < 128; ++i) {
            if (i % replicates != left) {
                some.add(values(i, 1), values(i, 2), i % replicates);
            }
        }
        return some.index(true);
    };
    const Estimate found = indexWithout(replicates);
    double mean = 0.0, squares = 0.0;
    for (std::size_t left = 0; left < replicates; ++left) {
        mean += indexWithout(left).value / replicates;
    }
    for (std::size_t left = 0; left < replicates; ++left) {
        squares += std::pow(indexWithout(left).value - mean, 2);
    }
    EXPECT_NEAR(found.standardError, std::sqrt(squares * (replicates - 1.0) / replicates), 1e-12);

    // On the axis of Fisher's transform the interval is symmetric, and as wide as Student's t.
    const auto halfWidths = [](const Estimate& one) {
        const double slope = 1.0 - one.value * one.value;
        const double middle = std::atanh(one.value), unit = one.standardError / slope;
        return std::pair{(std::atanh(one.high95) - middle) / unit,
                         (middle - std::atanh(one.low95)) / unit};
    };
    constexpr double student3 = 3.18245, student127 = 1.97882; // two-sided, tables
    EXPECT_NEAR(halfWidths(found).first, student3, 1e-3);
    EXPECT_NEAR(halfWidths(found).second, student3, 1e-3);
    PickFreeze all;
    for (std::uint64_t i = 0; i < 128; ++i) {
        all.add(values(i, 1), values(i, 2), 0);
    }
    EXPECT_NEAR(halfWidths(all.index(false)).first, student127, 1e-3);
}

TEST(SobolIndices, StayBetweenMinusOneAndOneWithTheirIntervals) {
    // All of the variance is the first scale's: an interval about it must not reach beyond 1.
    const ScaledModel model = [](const std::vector<double>& u) {
        return std::vector<double>{u[0]};
    };
    for (const RealisationSequence sequence :
         {RealisationSequence::plain, RealisationSequence::sobol}) {
        const ScalingRealisations realisations(unitScales(2), sequence, 3, true);
        const auto ranking = rankScalings(
            realisations, sequence, 256, [&] { return model; }, [](std::size_t) { return true; });
        EXPECT_NEAR(ranking[0].firstOrder.value, 1.0, 1e-12);
        EXPECT_NEAR(ranking[0].firstOrder.high95, 1.0, 1e-12);
        EXPECT_NEAR(ranking[1].total.value, 0.0, 1e-12);
        EXPECT_LE(std::abs(ranking[1].firstOrder.low95), 1.0);
    }
}

TEST(SobolIndices, AreTheSameForAnyNumberOfThreads) {
    // A model that remembers the draws of its pair: it must see those of no other.
    const auto modelOfPair = []() -> ScaledModel {
        return [seen = std::make_shared<std::vector<double>>()](const std::vector<double>& u) {
            seen->push_back(u[0]);
            return std::vector<double>{u[0] + 0.1 * u[1] * seen->front(), u[2]};
        };
    };
    const auto rankedBy = [&](unsigned threads) {
        irsg::setMostThreads(threads);
        const ScalingRealisations realisations(unitScales(3), RealisationSequence::sobol, 3, true);
        std::vector<double> numbers;
        std::size_t last = 0;
        for (const RankedScaling& one : rankScalings(realisations, RealisationSequence::sobol, 256,
                                                     modelOfPair, [&](std::size_t pairs) {
                                                         EXPECT_EQ(pairs, last + 1);
                                                         last = pairs;
                                                         return pairs < 205;
                                                     })) {
            numbers.insert(numbers.end(), {one.firstOrder.value, one.firstOrder.high95,
                                           one.total.value, one.total.low95});
        }
        irsg::setMostThreads(0);
        EXPECT_EQ(last, 205u);
        return numbers;
    };
    const std::vector<double> one = rankedBy(1);
    EXPECT_EQ(rankedBy(2), one);
    EXPECT_EQ(rankedBy(7), one);
}

} // namespace smat
