#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "irsg/geometry/view/Vec3.h"

namespace irsg {

/// A point of five coordinates in (0, 1): where on a surface a ray begins, and where it goes.
using LightPoint = std::array<double, 5>;

/// Points that are to be sampled at most.
inline constexpr std::uint32_t mostLightPoints = 65'536;

/// Points of Sobol's sequence, their digits shifted by what `stream` says: equal numbers for equal
/// arguments on every machine, and any 2^k that follow one another from a multiple of 2^k are
/// spread evenly.
class LightPoints {
  public:
    explicit LightPoints(std::uint32_t stream);
    /// `index`: below mostLightPoints.
    LightPoint at(std::uint32_t index) const;

  private:
    std::array<std::uint32_t, 5> shifts_;
};

/// Two unit vectors across a direction.
std::pair<Vec3, Vec3> acrossTo(const Vec3& direction);

/// A direction about a normal with a density that goes with the cosine.
Vec3 cosineDirection(const Vec3& normal, double radial, double around);

} // namespace irsg
