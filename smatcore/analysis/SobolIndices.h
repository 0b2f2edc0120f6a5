#pragma once

#include <functional>
#include <vector>

#include "smatcore/analysis/SampleStatistics.h"
#include "smatcore/analysis/ScalingRealisations.h"

namespace smat {

/// What one scale contributes to the spread of a result.
struct RankedScaling {
    std::size_t scaling = 0; ///< its place in ScalingRealisations::scalings()
    /// First-order Sobol' index: the part of the variance that goes when this scale is known.
    Estimate firstOrder;
    /// Total index: the part that stays when all others are known; more than the first-order index
    /// by what it does together with others.
    Estimate total;
};

/// Sums over pairs of values of which one scale, or all but one, is shared: the pick-freeze scheme
/// of Sobol' with the estimator of Janon, Klein, Lagnoux, Nodet and Prieur (ESAIM: Probability and
/// Statistics 18, 2014, eq. 6), asymptotically the best there is for plain draws. Values of a sweep
/// add their variances, so that the index of a sweep weighs its abscissae by their spread (Gamboa,
/// Janon, Klein and Lagnoux 2014).
class PickFreeze {
  public:
    /// One value each for every abscissa; `replicate` as in ScalingRealisations.
    void add(const std::vector<double>& values, const std::vector<double>& shared,
             std::size_t replicate);
    /// `byReplicates` takes the error from the spread of the replicates, else from the draws.
    Estimate index(bool byReplicates) const;

  private:
    struct Sums {
        double count = 0.0;
        std::vector<double> sum, square, product; ///< of both values, halved; per abscissa
    };
    static double indexOf(const Sums& sums);
    static Sums without(const Sums& all, const Sums& part);
    static Estimate withError(double value, double error, std::size_t degreesOfFreedom);

    std::vector<std::vector<double>> first_, second_; ///< all pairs, less the very first value
    std::vector<double> origin_;
    std::vector<Sums> replicates_ = std::vector<Sums>(sobolReplicates);
    Sums all_;
};

/// Values at every abscissa of one set of scales.
using ScaledModel = std::function<std::vector<double>(const std::vector<double>& scales)>;

/// Ranks the scales that vary by their first-order index, the largest first, from `pairs` draws
/// with companions: pairs (2 + d) evaluations, on all cores. `modelOfPair` gives a model for the
/// draws of one pair, which differ in few scales; several threads have one each at a time. `goOn`
/// is asked after every pair, in their order; false ends early, with what there is.
std::vector<RankedScaling> rankScalings(const ScalingRealisations& realisations,
                                        RealisationSequence sequence, std::size_t pairs,
                                        const std::function<ScaledModel()>& modelOfPair,
                                        const std::function<bool(std::size_t done)>& goOn);

} // namespace smat
