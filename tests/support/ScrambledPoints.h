#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace irsg::test::tracing {

/// A sequence of random words, one for each path.
class Words {
  public:
    explicit Words(std::uint64_t start) : state_(start) {}
    /// Splitmix64 (Steele, Lea and Flood 2014).
    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// In (0, 1).
    double unit() { return (static_cast<double>(next() >> 12) + 0.5) * 0x1p-52; }

  private:
    std::uint64_t state_;
};

constexpr std::size_t dimensions = 10;

/// Sobol' points whose digits are scrambled by random lower triangular matrices and a shift
/// (Matousek 1998): each batch has its own.
class ScrambledPoints {
  public:
    explicit ScrambledPoints(std::uint64_t seed);

    using Digits = std::array<std::uint32_t, dimensions>;
    /// The point of a number, in the order of Gray's code.
    Digits at(std::uint32_t number) const {
        Digits digits = shift_;
        for (std::uint32_t gray = number ^ (number >> 1); gray != 0; gray &= gray - 1) {
            for (std::size_t d = 0; d < dimensions; ++d) {
                digits[d] ^= numbers_[d][static_cast<std::size_t>(std::countr_zero(gray))];
            }
        }
        return digits;
    }
    /// From the point of `number` to the next.
    void step(Digits& digits, std::uint32_t number) const {
        const auto changed = static_cast<std::size_t>(std::countr_zero(number + 1u));
        for (std::size_t d = 0; d < dimensions; ++d) {
            digits[d] ^= numbers_[d][changed];
        }
    }

  private:
    std::array<std::array<std::uint32_t, 32>, dimensions> numbers_{};
    Digits shift_{};
};

/// The numbers of one path: the first from a point, the others at random.
struct PathNumbers {
    const ScrambledPoints::Digits& point;
    Words words;

    double at(std::size_t dimension) {
        return dimension < dimensions ? (static_cast<double>(point[dimension]) + 0.5) * 0x1p-32
                                      : words.unit();
    }
};

} // namespace irsg::test::tracing
