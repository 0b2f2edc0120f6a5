#include "irsg/signature/random/SobolSequence.h"

#include <cstddef>

#include <boost/random/sobol.hpp>

#include "irsg/core/Errors.h"
#include "irsg/signature/random/Philox.h"

namespace irsg {

namespace {

using Directions = std::vector<std::array<std::uint32_t, 32>>;

/// Boost.Random counts points in Gray code and leaves out the first, which is zero: its point n
/// combines the direction numbers that the digits of the Gray code of n + 1 name. That of
/// 2^(k + 1) - 1 is 2^k, which names number k alone.
Directions directionsOfJoeAndKuo() {
    boost::random::sobol_engine<std::uint32_t, 32> points(SobolSequence::mostDimensions);
    Directions directions(SobolSequence::mostDimensions);
    for (std::size_t k = 0; k < 32; ++k) {
        points.seed((std::uint32_t{2} << k) - 2);
        for (auto& ofCoordinate : directions)
            ofCoordinate[k] = points();
    }
    return directions;
}

} // namespace

const std::array<std::uint32_t, 32>& sobolDirections(int dimension) {
    static const Directions all = directionsOfJoeAndKuo();
    if (dimension < 0 || dimension >= SobolSequence::mostDimensions)
        throw LogicError("Sobol' sequences have 128 dimensions");
    return all[static_cast<std::size_t>(dimension)];
}

SobolSequence::SobolSequence(int dimensions, std::uint64_t seed, std::uint32_t replicate)
    : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
      replicate_(replicate) {
    if (dimensions < 1 || dimensions > mostDimensions)
        throw LogicError("Sobol' sequences have 1 to 128 dimensions");
    for (int d = 0; d < dimensions; ++d)
        directions_.push_back(&sobolDirections(d));
}

double SobolSequence::at(std::uint32_t index, int dimension) const {
    const auto& v = *directions_[static_cast<std::size_t>(dimension)];
    std::uint32_t bits = 0;
    for (std::size_t k = 0; index >> k != 0; ++k)
        if (index >> k & 1)
            bits ^= v[k];

    // The tree of digits has a random bit in every node: node 1 is its root, and the digits so far
    // lead to the others. Four levels share the words of one counter, 15 bits of a subtree each.
    const auto words = [&](std::uint32_t node, std::uint32_t level) {
        return philox4x32(
            {node, level << 16 | static_cast<std::uint32_t>(dimension), replicate_, 0x4F77656E},
            key_);
    };
    std::uint32_t scrambled = 0;
    for (std::uint32_t level = 0; level < 32; level += 4) {
        const std::uint32_t above = level == 0 ? 0 : bits >> (32 - level);
        const std::uint32_t flips = words(above, level)[0];
        std::uint32_t node = 1;
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t digit = bits >> (31 - level - i) & 1;
            scrambled = scrambled << 1 | (digit ^ (flips >> node & 1));
            node = node << 1 | digit;
        }
    }
    // Below 32 digits every point has digits of its own.
    const std::uint64_t rest = words(bits, 32)[0];
    return unitFromBits(std::uint64_t{scrambled} << 32 | rest);
}

} // namespace irsg
