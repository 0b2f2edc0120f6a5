#include "smatcore/analysis/SobolIndices.h"

#include <algorithm>
#include <cmath>

namespace smat {

void PickFreeze::add(const std::vector<double>& values, const std::vector<double>& shared,
                     std::size_t replicate) {
    if (origin_.empty()) {
        origin_ = values;
    }
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
    if (slope <= 1e-12) {
        return {value, error, value, value};
    }
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
        for (const Sums& sums : replicates_) {
            if (sums.count > 0.0 && sums.count < all_.count) {
                indices.push_back(indexOf(without(all_, sums)));
            }
        }
        if (indices.size() < 2) {
            return {value, 0.0, value, value};
        }
        const double count = static_cast<double>(indices.size());
        return withError(value, standardDeviationOf(indices) * (count - 1.0) / std::sqrt(count),
                         indices.size() - 1);
    }

    // Delta method: the derivative of the ratio with respect to each pair's own share.
    const std::size_t count = first_.size();
    if (count < 2) {
        return {value, 0.0, value, value};
    }
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

std::vector<RankedScaling> rankScalings(const ScalingDraws& draws, DrawSequence sequence,
                                        std::size_t pairs, const ScaledModel& model,
                                        const std::function<bool(std::size_t done)>& goOn) {
    std::vector<std::size_t> varying;
    for (std::size_t i = 0; i < draws.scalings().size(); ++i) {
        if (!draws.scalings()[i].isFixed()) {
            varying.push_back(i);
        }
    }
    std::vector<PickFreeze> ofOne(varying.size()), ofOthers(varying.size());
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        const std::vector<double> a = draws.at(pair), b = draws.companionAt(pair);
        const std::vector<double> atA = model(a), atB = model(b);
        for (std::size_t j = 0; j < varying.size(); ++j) {
            // A with this scale of B shares it with B, and all others with A.
            std::vector<double> mixed = a;
            mixed[varying[j]] = b[varying[j]];
            const std::vector<double> atMixed = model(mixed);
            ofOne[j].add(atB, atMixed, draws.replicateOf(pair));
            ofOthers[j].add(atA, atMixed, draws.replicateOf(pair));
        }
        if (!goOn(pair + 1)) {
            break;
        }
    }
    std::vector<RankedScaling> ranking;
    const bool byReplicates = sequence == DrawSequence::sobol;
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
