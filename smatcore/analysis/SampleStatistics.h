#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace smat {

/// A number from a sample with what is known of its error.
struct Estimate {
    double value = 0.0;
    double standardError = 0.0;
    double low95 = 0.0, high95 = 0.0; ///< interval that holds the truth in 95 % of samples

    /// With the interval of Student's t of so many degrees of freedom.
    static Estimate withStudent(double value, double standardError, std::size_t degreesOfFreedom);
};

/// What one may ask of a sample.
struct Statistic {
    enum class Kind { mean, standardDeviation, percentile };
    Kind kind = Kind::mean;
    double percent = 50.0; ///< of a percentile, 0 to 100

    bool operator==(const Statistic&) const = default;
};

double meanOf(std::span<const double> values);
/// With n - 1; 0 for fewer than two values.
double standardDeviationOf(std::span<const double> values);
/// Of ascending values, linear between order statistics (Hyndman and Fan 1996, definition 7).
double percentileOf(std::span<const double> ascending, double percent);

/// Whether a sample of so many values bounds the statistic on both sides: of a percentile p the
/// interval of 95 % that order statistics give, which none is wide enough for where p^n or
/// (1 - p)^n is above 0.025.
bool hasBoundedError(const Statistic& statistic, std::size_t count);

/// From independent values. Mean: Student's t. Standard deviation: its asymptotic error with the
/// sample's own kurtosis. Percentile: the order statistics at np -+ 1.96 sqrt(n p (1 - p)), free of
/// any assumption about the distribution; of one whose error the sample does not bound
/// (hasBoundedError) error and interval are NaN.
Estimate estimate(std::span<const double> values, const Statistic& statistic);
/// From values that were dealt in turn to `replicates` independent point sets: value i belongs to
/// set i mod replicates. The value is that of all together, its error follows from the sets' spread
/// (Student's t with replicates - 1 degrees of freedom); that of a percentile from the spread of
/// the shares of values below it.
Estimate estimateByReplicates(std::span<const double> values, std::size_t replicates,
                              const Statistic& statistic);

/// Counts in bins of equal width from the least to the largest value.
struct SampleHistogram {
    double least = 0.0, width = 0.0;
    std::vector<std::size_t> counts;
};
/// As many bins as Freedman and Diaconis (1981) ask for, 1 to 200; `bins` other than 0 says how
/// many.
SampleHistogram histogramOf(std::span<const double> values, std::size_t bins = 0);

} // namespace smat
