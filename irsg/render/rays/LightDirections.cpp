#include "irsg/render/rays/LightDirections.h"

#include <bit>
#include <cmath>
#include <vector>

#include "irsg/radiometry/Units.h"
#include "irsg/signature/random/SobolSequence.h"

namespace irsg {

namespace {

using Digits = std::array<std::uint32_t, 5>;

/// Which of Sobol's coordinates are ours: the two whose projection is the most even choose the
/// direction, the next two the place.
constexpr std::array<int, 5> sobolCoordinates{4, 2, 3, 0, 1};

std::uint32_t reversed(std::uint32_t digits) {
    digits = digits << 16 | digits >> 16;
    digits = (digits & 0x00ff00ffu) << 8 | (digits >> 8 & 0x00ff00ffu);
    digits = (digits & 0x0f0f0f0fu) << 4 | (digits >> 4 & 0x0f0f0f0fu);
    digits = (digits & 0x33333333u) << 2 | (digits >> 2 & 0x33333333u);
    return (digits & 0x55555555u) << 1 | (digits >> 1 & 0x55555555u);
}

/// Of the points, the last digit first.
std::vector<Digits> sobolDigits() {
    std::vector<Digits> all(mostLightPoints);
    for (std::size_t d = 0; d < sobolCoordinates.size(); ++d) {
        const std::array<std::uint32_t, 32>& directions = sobolDirections(sobolCoordinates[d]);
        for (std::uint32_t index = 1; index < mostLightPoints; ++index) {
            const auto lowest = static_cast<std::size_t>(std::countr_zero(index));
            all[index][d] = all[index & (index - 1)][d] ^ reversed(directions[lowest]);
        }
    }
    return all;
}

/// Owen's nested scrambling of digits that stand the last one first: each is flipped or not by a
/// hash of those that count for more (Burley 2020, "Practical hash-based Owen scrambling", Journal
/// of Computer Graphics Techniques 9 (4), after Laine and Karras 2011).
std::uint32_t scrambled(std::uint32_t digits, std::uint32_t seed) {
    digits += seed;
    digits ^= digits * 0x6c50b47cu;
    digits ^= digits * 0xb82f1e52u;
    digits ^= digits * 0xc7afe638u;
    digits ^= digits * 0x8d22f6e6u;
    return digits;
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
    for (std::size_t d = 0; d < seeds_.size(); ++d)
        seeds_[d] = mixed(8 * static_cast<std::uint64_t>(stream) + d);
}

LightPoint LightPoints::at(std::uint32_t index) const {
    static const std::vector<Digits> digits = sobolDigits();
    LightPoint point;
    for (std::size_t d = 0; d < point.size(); ++d) {
        const std::uint32_t own = reversed(scrambled(digits[index][d], seeds_[d]));
        point[d] = (static_cast<double>(own) + 0.5) * 0x1p-32;
    }
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
