#pragma once

#include <functional>
#include <vector>

namespace irsg {

/// Where a range is sought, m.
struct RangeLimits {
    double nearest_m = 100.0; ///< > 0
    double farthest_m = 1e6;  ///< above it
    double tolerance = 1e-5;  ///< of the range, relative
    /// Places at which the signal to noise ratio is looked at, as far as it may cross the threshold
    /// about them.
    int looksPerDecade = 16;
    /// The ratio is looked at at nearer ranges only where it is below the threshold at those
    /// beyond, from the farthest to the first at which it is reached.
    double costlyBelow_m = 0.0;
};

/// How far a target is seen.
struct DetectionRange {
    enum class Found {
        atRange, ///< the ratio falls to the threshold there
        nowhere, ///< it is below the threshold at every range; the range is 0
        beyond   ///< it is not below it at the farthest range, which is given
    };

    Found found = Found::nowhere;
    double range_m = 0.0;
    /// d ln(ratio) / d ln(range) at that range, -2 in vacuum; 0 where nothing was found, and at a
    /// step of the ratio to 0.
    double slope = 0.0;
    /// Of a range at which something was found, what is left of it: the tolerance, or more where
    /// the ratio scatters from range to range.
    double relativeError = 0.0;
    /// How often the ratio crosses the threshold between the limits (from `costlyBelow_m` on where
    /// it is reached there, else from the farthest look at which it is reached), as far as it was
    /// looked at: more than once where contrast passes through zero, say.
    int crossings = 0;
    /// Ranges of the grid about that range, and weights, which sum up to 1, with which a smooth
    /// function of ln(range) is interpolated there (Lagrange); one where nothing was found: at the
    /// nearest, or at the farthest range.
    struct Node {
        double range_m, weight;
    };
    std::vector<Node> around;
};

/// The farthest range at which a signal to noise ratio falls to a threshold > 0. The ratio is
/// looked at at equal ratios of range: four times per decade, and up to `looksPerDecade` times
/// where it may cross the threshold, as its curvature in ln(range) or a change of its sign says.
/// The root is sought between the last two places between which it falls below the threshold: their
/// interval is halved until the root of the cubic in ln(range) through four neighbours is that of
/// the parabolas through three of them to within the tolerance, which it then is far better. So all
/// ranges are those of one grid, whatever the ratio, and what they have in common (air) is computed
/// once for many targets. `ratio` gives the SNR at a range in m, of either sign, whose magnitude
/// counts; it is called once for each. Throws InputError for limits that are none.
DetectionRange detectionRange(const std::function<double(double range_m)>& ratio, double threshold,
                              const RangeLimits& limits);

} // namespace irsg
