#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "irsg/geometry/view/Vec3.h"

namespace irsg {

/// A point of five coordinates in (0, 1): on which part of a surface a ray begins (0), where on it
/// (1 and 2), and where it goes (3 and 4).
using LightPoint = std::array<double, 5>;

/// Points that are to be sampled at most.
inline constexpr std::uint32_t mostLightPoints = 65'536;

/// Points of Sobol's sequence, scrambled as `stream` says: equal numbers for equal arguments on
/// every machine, and any 2^k that follow one another from a multiple of 2^k are spread evenly. A
/// shift of the digits in place of the scrambling keeps what is regular in the first few points of
/// the sequence: view factors of small senders were then off by up to 3 %.
class LightPoints {
  public:
    explicit LightPoints(std::uint32_t stream);
    /// `index`: below mostLightPoints.
    LightPoint at(std::uint32_t index) const;

  private:
    std::array<std::uint32_t, 5> seeds_;
};

/// Two unit vectors across a direction.
std::pair<Vec3, Vec3> acrossTo(const Vec3& direction);

/// A direction about a normal with a density that goes with the cosine.
Vec3 cosineDirection(const Vec3& normal, double radial, double around);

} // namespace irsg
