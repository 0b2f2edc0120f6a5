#include "irsg/render/rays/LightDirections.h"

#include <bit>
#include <cmath>
#include <vector>

#include "irsg/radiometry/Units.h"
#include "irsg/signature/random/SobolSequence.h"

namespace irsg {

namespace {

using Digits = std::array<std::uint32_t, 5>;

std::vector<Digits> sobolDigits() {
    std::vector<Digits> all(mostLightPoints);
    for (int dimension = 0; dimension < 5; ++dimension) {
        const std::array<std::uint32_t, 32>& directions = sobolDirections(dimension);
        for (std::uint32_t index = 1; index < mostLightPoints; ++index) {
            const auto lowest = static_cast<std::size_t>(std::countr_zero(index));
            const auto d = static_cast<std::size_t>(dimension);
            all[index][d] = all[index & (index - 1)][d] ^ directions[lowest];
        }
    }
    return all;
}

/// Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators".
std::uint32_t mixed(std::uint64_t value) {
    value += 0x9e3779b97f4a7c15u;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
    return static_cast<std::uint32_t>((value ^ (value >> 31)) >> 32);
}

} // namespace

LightPoints::LightPoints(std::uint32_t stream) {
    for (std::size_t d = 0; d < shifts_.size(); ++d)
        shifts_[d] = mixed(8 * static_cast<std::uint64_t>(stream) + d);
}

LightPoint LightPoints::at(std::uint32_t index) const {
    static const std::vector<Digits> digits = sobolDigits();
    LightPoint point;
    for (std::size_t d = 0; d < point.size(); ++d)
        point[d] = (static_cast<double>(digits[index][d] ^ shifts_[d]) + 0.5) * 0x1p-32;
    return point;
}

std::pair<Vec3, Vec3> acrossTo(const Vec3& direction) {
    const Vec3 other = std::abs(direction.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 right = normalized(cross(direction, other));
    return {right, cross(right, direction)};
}

Vec3 cosineDirection(const Vec3& normal, double radial, double around) {
    const auto [right, up] = acrossTo(normal);
    const double radius = std::sqrt(radial), angle = 2.0 * pi * around;
    return normalized(right * (radius * std::cos(angle)) + up * (radius * std::sin(angle)) +
                      normal * std::sqrt(1.0 - radial));
}

} // namespace irsg
