#include "smatcore/analysis/SobolIndices.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/ParallelFor.h"

namespace smat {

namespace {

/// Pairs that are evaluated at a time.
constexpr std::size_t pairsOfBlock = 16;

/// Values of a pair: of the draw, of its companion, and of the draw with each scale of the
/// companion in turn.
struct PairValues {
    std::vector<double> atA, atB;
    std::vector<std::vector<double>> atMixed;
};

PairValues valuesOf(const ScalingRealisations& realisations, std::size_t pair,
                    const std::vector<std::size_t>& varying, const ScaledModel& model) {
    const std::vector<double> a = realisations.at(pair), b = realisations.companionAt(pair);
    PairValues values{model(a), model(b), {}};
    for (const std::size_t scaling : varying) {
        // A with this scale of B shares it with B, and all others with A.
        std::vector<double> mixed = a;
        mixed[scaling] = b[scaling];
        values.atMixed.push_back(model(mixed));
    }
    return values;
}

} // namespace

void PickFreeze::add(const std::vector<double>& values, const std::vector<double>& shared,
                     std::size_t replicate) {
    if (origin_.empty())
        origin_ = values;
    std::vector<double> y(values.size()), z(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
        y[k] = values[k] - origin_[k];
        z[k] = shared[k] - origin_[k];
    }
    for (Sums* sums : {&all_, &replicates_.at(replicate)}) {
        if (sums->sum.empty()) {
            sums->sum.resize(y.size());
            sums->square.resize(y.size());
            sums->product.resize(y.size());
        }
        sums->count += 1.0;
        for (std::size_t k = 0; k < y.size(); ++k) {
            sums->sum[k] += 0.5 * (y[k] + z[k]);
            sums->square[k] += 0.5 * (y[k] * y[k] + z[k] * z[k]);
            sums->product[k] += y[k] * z[k];
        }
    }
    first_.push_back(std::move(y));
    second_.push_back(std::move(z));
}

double PickFreeze::indexOf(const Sums& sums) {
    double covariance = 0.0, variance = 0.0;
    for (std::size_t k = 0; k < sums.sum.size(); ++k) {
        const double mean = sums.sum[k] / sums.count;
        covariance += sums.product[k] / sums.count - mean * mean;
        variance += sums.square[k] / sums.count - mean * mean;
    }
    return variance > 0.0 ? covariance / variance : 0.0;
}

Estimate PickFreeze::withError(double value, double error, std::size_t degreesOfFreedom) {
    // The index is a correlation: Fisher's transform makes its error symmetric, and keeps the
    // interval between -1 and 1.
    const double slope = 1.0 - value * value;
    if (slope <= 1e-12)
        return {value, error, value, value};
    const Estimate z = Estimate::withStudent(std::atanh(value), error / slope, degreesOfFreedom);
    return {value, error, std::tanh(z.low95), std::tanh(z.high95)};
}

PickFreeze::Sums PickFreeze::without(const Sums& all, const Sums& part) {
    Sums rest = all;
    rest.count -= part.count;
    for (std::size_t k = 0; k < rest.sum.size(); ++k) {
        rest.sum[k] -= part.sum[k];
        rest.square[k] -= part.square[k];
        rest.product[k] -= part.product[k];
    }
    return rest;
}

Estimate PickFreeze::index(bool byReplicates) const {
    const double value = indexOf(all_);
    if (byReplicates) {
        // Jackknife: the index of one replicate alone, a ratio of few values, would be biased.
        std::vector<double> indices;
        for (const Sums& sums : replicates_)
            if (sums.count > 0.0 && sums.count < all_.count)
                indices.push_back(indexOf(without(all_, sums)));
        if (indices.size() < 2)
            return {value, 0.0, value, value};
        const double count = static_cast<double>(indices.size());
        return withError(value, standardDeviationOf(indices) * (count - 1.0) / std::sqrt(count),
                         indices.size() - 1);
    }

    // Delta method: the derivative of the ratio with respect to each pair's own share.
    const std::size_t count = first_.size();
    if (count < 2)
        return {value, 0.0, value, value};
    std::vector<double> shares(count, 0.0);
    double variance = 0.0;
    for (std::size_t k = 0; k < all_.sum.size(); ++k) {
        const double mean = all_.sum[k] / all_.count;
        variance += all_.square[k] / all_.count - mean * mean;
        for (std::size_t i = 0; i < count; ++i) {
            const double y = first_[i][k] - mean, z = second_[i][k] - mean;
            shares[i] += y * z - 0.5 * value * (y * y + z * z);
        }
    }
    const double error = variance > 0.0 ? standardDeviationOf(shares) /
                                              (variance * std::sqrt(static_cast<double>(count)))
                                        : 0.0;
    return withError(value, error, count - 1);
}

std::vector<RankedScaling> rankScalings(const ScalingRealisations& realisations,
                                        RealisationSequence sequence, std::size_t pairs,
                                        const std::function<ScaledModel()>& modelOfPair,
                                        const std::function<bool(std::size_t done)>& goOn) {
    std::vector<std::size_t> varying;
    for (std::size_t i = 0; i < realisations.scalings().size(); ++i)
        if (!realisations.scalings()[i].isFixed())
            varying.push_back(i);
    std::vector<PickFreeze> ofOne(varying.size()), ofOthers(varying.size());
    bool isWanted = true;
    for (std::size_t begin = 0; begin < pairs && isWanted; begin += pairsOfBlock) {
        std::vector<PairValues> block(std::min(pairsOfBlock, pairs - begin));
        irsg::parallelFor(block.size(), [&](std::size_t i) {
            block[i] = valuesOf(realisations, begin + i, varying, modelOfPair());
        });
        for (std::size_t i = 0; i < block.size() && isWanted; ++i) {
            const std::size_t pair = begin + i;
            for (std::size_t j = 0; j < varying.size(); ++j) {
                ofOne[j].add(block[i].atB, block[i].atMixed[j], realisations.replicateOf(pair));
                ofOthers[j].add(block[i].atA, block[i].atMixed[j], realisations.replicateOf(pair));
            }
            isWanted = goOn(pair + 1);
        }
    }
    std::vector<RankedScaling> ranking;
    const bool byReplicates = sequence == RealisationSequence::sobol;
    for (std::size_t j = 0; j < varying.size(); ++j) {
        const Estimate others = ofOthers[j].index(byReplicates);
        ranking.push_back(
            {varying[j],
             ofOne[j].index(byReplicates),
             {1.0 - others.value, others.standardError, 1.0 - others.high95, 1.0 - others.low95}});
    }
    std::stable_sort(ranking.begin(), ranking.end(),
                     [](const RankedScaling& a, const RankedScaling& b) {
                         return a.firstOrder.value > b.firstOrder.value;
                     });
    return ranking;
}

} // namespace smat
