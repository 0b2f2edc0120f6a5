#pragma once

#include <cstdint>

namespace irsg::lbl {

/// Reproducible random numbers, alike on every machine: splitmix64 (Steele, Lea and Flood 2014,
/// Proc. OOPSLA, 453).
class RandomNumbers {
  public:
    explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}

    /// Evenly spread over [0, 1).
    double next() {
        state_ += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        z ^= z >> 31;
        return static_cast<double>(z >> 11) * 0x1.0p-53;
    }

  private:
    std::uint64_t state_;
};

} // namespace irsg::lbl
