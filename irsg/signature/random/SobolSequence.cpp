#include "irsg/signature/random/SobolSequence.h"

#include <algorithm>
#include <bit>

#include "irsg/core/Errors.h"
#include "irsg/signature/random/Philox.h"

namespace irsg {

namespace {

/// The candidate that the search found for each coordinate from the second on.
constexpr std::array<std::uint8_t, SobolSequence::mostDimensions - 1> chosen{
#include "irsg/signature/random/SobolTable.inc"
};

/// True where x generates all 2^s - 1 residues other than 0 of a polynomial of degree s, given as
/// the bits of its coefficients.
bool isPrimitive(std::uint32_t polynomial) {
    const int degree = std::bit_width(polynomial) - 1;
    const std::uint32_t period = (1u << degree) - 1;
    std::uint32_t residue = 1;
    for (std::uint32_t step = 1; step <= period; ++step) {
        residue <<= 1;
        if (residue >> degree)
            residue ^= polynomial;
        if (residue == 1)
            return step == period;
    }
    return false;
}

const std::vector<std::uint32_t>& primitivePolynomials() {
    static const std::vector<std::uint32_t> list = [] {
        std::vector<std::uint32_t> found;
        for (std::uint32_t p = 3; found.size() + 1 < SobolSequence::mostDimensions; p += 2)
            if (isPrimitive(p))
                found.push_back(p);
        return found;
    }();
    return list;
}

} // namespace

std::array<std::uint32_t, 32> sobolDirections(int dimension, int candidate) {
    std::array<std::uint32_t, 32> v{};
    if (dimension == 0) {
        for (int k = 0; k < 32; ++k)
            v[static_cast<std::size_t>(k)] = 1u << (31 - k);
        return v;
    }
    const std::uint32_t p = primitivePolynomials()[static_cast<std::size_t>(dimension - 1)];
    const int s = std::bit_width(p) - 1;
    for (int k = 0; k < 32; ++k) {
        auto at = [&](int i) -> std::uint32_t& { return v[static_cast<std::size_t>(i)]; };
        if (k < s) {
            const auto words =
                philox4x32({static_cast<std::uint32_t>(dimension), static_cast<std::uint32_t>(k),
                            static_cast<std::uint32_t>(candidate), 0},
                           {0x536F626F, 0x6C000000});
            const std::uint32_t odd = (words[0] & ((1u << k) - 1)) << 1 | 1;
            at(k) = odd << (31 - k);
            continue;
        }
        // v_k = c_1 v_(k-1) + ... + c_(s-1) v_(k-s+1) + v_(k-s) + v_(k-s) / 2^s
        at(k) = at(k - s) ^ at(k - s) >> s;
        for (int i = 1; i < s; ++i)
            if (p >> (s - i) & 1)
                at(k) ^= at(k - i);
    }
    return v;
}

const std::array<std::uint32_t, 32>& sobolDirections(int dimension) {
    static const std::vector<std::array<std::uint32_t, 32>> all = [] {
        std::vector<std::array<std::uint32_t, 32>> made;
        for (int d = 0; d < SobolSequence::mostDimensions; ++d)
            made.push_back(
                sobolDirections(d, d == 0 ? 0 : chosen[static_cast<std::size_t>(d - 1)]));
        return made;
    }();
    if (dimension < 0 || dimension >= SobolSequence::mostDimensions)
        throw LogicError("Sobol' sequences have 128 dimensions");
    return all[static_cast<std::size_t>(dimension)];
}

int sobolPairQuality(const std::array<std::uint32_t, 32>& first,
                     const std::array<std::uint32_t, 32>& second, int m) {
    // Row i of a generator matrix holds bit 31 - i of the first m direction numbers.
    const auto row = [m](const std::array<std::uint32_t, 32>& v, int i) {
        std::uint32_t bits = 0;
        for (int k = 0; k < m; ++k)
            bits |= (v[static_cast<std::size_t>(k)] >> (31 - i) & 1) << k;
        return bits;
    };
    std::array<std::uint32_t, 32> rows1{}, rows2{};
    for (int i = 0; i < m; ++i) {
        rows1[static_cast<std::size_t>(i)] = row(first, i);
        rows2[static_cast<std::size_t>(i)] = row(second, i);
    }

    // d1 rows of the one and as many of the other as stay linearly independent.
    int strength = m;
    for (int d1 = 0; d1 <= m; ++d1) {
        std::array<std::uint32_t, 32> basis{}; // by leading bit
        const auto isIndependent = [&](std::uint32_t bits) {
            while (bits != 0) {
                auto& pivot = basis[static_cast<std::size_t>(std::bit_width(bits) - 1)];
                if (pivot == 0) {
                    pivot = bits;
                    return true;
                }
                bits ^= pivot;
            }
            return false;
        };
        int count = 0;
        for (int i = 0; i < d1 && isIndependent(rows1[static_cast<std::size_t>(i)]); ++i)
            ++count;
        for (int i = 0; i < m - d1 && isIndependent(rows2[static_cast<std::size_t>(i)]); ++i)
            ++count;
        strength = std::min(strength, count);
    }
    return m - strength;
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
