#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace irsg {

/// Sobol's low-discrepancy sequence with the direction numbers of Joe and Kuo (2008, "Constructing
/// Sobol sequences with better two-dimensional projections", SIAM Journal on Scientific Computing
/// 30, 2635-2654; their file new-joe-kuo-6.21201) and Owen's nested uniform scrambling.
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

/// The 32 direction numbers of a coordinate, 0 to 127, the first with its highest bit set. Bit k of
/// the index of a point (counted in binary, not in Gray code) takes number k into its digits.
const std::array<std::uint32_t, 32>& sobolDirections(int dimension);

} // namespace irsg
