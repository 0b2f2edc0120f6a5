#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace irsg {

/// Sobol's low-discrepancy sequence with Owen's nested uniform scrambling.
///
/// Coordinate 0 is van der Corput's sequence; coordinate j uses the j-th primitive polynomial over
/// GF(2), by degree, then by value. Its initial direction numbers m_1 ... m_s (s the degree) are
/// odd numbers below 2^i that are drawn with Philox; of 256 such draws the table in the source
/// holds the one whose two-dimensional projections with all earlier coordinates have the least sum
/// of squared t-values for 2^4 to 2^12 points. `sobol-search` in benchmarks makes the table, and a
/// test holds both together.
///
/// Scrambling flips each binary digit with a random bit that depends on all digits before it (Owen
/// 1995), computed from a counter. A scrambled point is uniform in [0, 1), every replicate keeps
/// the net, and the spread of independent replicates gives the error of a mean.
class SobolSequence {
  public:
    static constexpr int mostDimensions = 128;

    /// `replicate` tells independent scramblings of one seed apart. LogicError for a number of
    /// dimensions outside 1 to 128.
    SobolSequence(int dimensions, std::uint64_t seed, std::uint32_t replicate);

    int dimensions() const { return static_cast<int>(directions_.size()); }
    /// Coordinate `dimension` of point `index`, in (0, 1).
    double at(std::uint32_t index, int dimension) const;

  private:
    std::vector<const std::array<std::uint32_t, 32>*> directions_;
    std::array<std::uint32_t, 2> key_;
    std::uint32_t replicate_;
};

/// The 32 direction numbers of a coordinate, the first with its highest bit set.
const std::array<std::uint32_t, 32>& sobolDirections(int dimension);
/// The same from a candidate of the search instead of the one in the table.
std::array<std::uint32_t, 32> sobolDirections(int dimension, int candidate);
/// t-value of the first 2^m points of two coordinates: of every elementary interval of volume
/// 2^(t - m) as many points lie inside as its volume asks for. 0 is best, m is worst.
int sobolPairQuality(const std::array<std::uint32_t, 32>& first,
                     const std::array<std::uint32_t, 32>& second, int m);

} // namespace irsg
