#include "irsg/scattering/PhotonTracer.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Collisions after which a photon is given up: far more than any that arrives has.
constexpr int mostCollisions = 10000;

double uniform(std::mt19937_64& random) {
    return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
}

struct Direction {
    double x, y, z;
};

/// Turned by a scattering angle, at a uniform azimuth.
Direction turned(const Direction& d, double cosine, double azimuth_rad) {
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    const double across = std::hypot(d.x, d.y);
    const double c = std::cos(azimuth_rad), s = std::sin(azimuth_rad);
    if (across < 1e-12)
        return {sine * c, sine * s, d.z > 0.0 ? cosine : -cosine};
    Direction n{cosine * d.x + sine * (c * d.x * d.z - s * d.y) / across,
                cosine * d.y + sine * (c * d.y * d.z + s * d.x) / across,
                cosine * d.z - sine * c * across};
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    return {n.x / length, n.y / length, n.z / length};
}

} // namespace

void PhotonSums::add(const PhotonSums& other) {
    if (sums.empty())
        sums.assign(other.sums.size(), 0.0), squares.assign(other.sums.size(), 0.0);
    photons += other.photons;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] += other.sums[i];
        squares[i] += other.squares[i];
    }
}

PhotonTracer::PhotonTracer(const PhaseFunction& phase, const std::vector<ScatteringLayer>& layers,
                           double opticalDepth, std::vector<double> frequencies_per_rad)
    : phase_(phase),
      opticalDepth_(opticalDepth),
      frequencies_per_rad_(std::move(frequencies_per_rad)),
      depths_{0.0},
      places_{0.0} {
    if (!(opticalDepth > 0.0))
        throw LogicError("photons are traced through droplets");
    for (const ScatteringLayer& layer : normalised(layers)) {
        depths_.push_back(depths_.back() + opticalDepth * layer.thickness * layer.concentration);
        places_.push_back(places_.back() + layer.thickness);
    }
    depths_.back() = opticalDepth;
    places_.back() = 1.0;
}

double PhotonTracer::placeOf(double depth) const {
    return interpolate(depths_, places_, depth);
}

template <typename Random>
double PhotonTracer::landing_rad(Random& random) const {
    double depth = -std::log1p(uniform(random) * std::expm1(-opticalDepth_));
    double z = placeOf(depth), x = 0.0, y = 0.0;
    Direction d{0.0, 0.0, 1.0};
    for (int collision = 0; collision < mostCollisions; ++collision) {
        d = turned(d, phase_.cosineAt(uniform(random)), 2.0 * pi * uniform(random));
        if (std::abs(d.z) < 1e-9)
            d.z = std::copysign(1e-9, d.z);
        depth -= std::log(uniform(random)) * d.z;
        if (depth <= 0.0)
            return -1.0;
        const double to = depth >= opticalDepth_ ? 1.0 : placeOf(depth);
        const double way = (to - z) / d.z;
        x += way * d.x;
        y += way * d.y;
        z = to;
        if (depth >= opticalDepth_)
            return std::atan(std::hypot(x, y));
    }
    return -1.0;
}

PhotonSums PhotonTracer::trace(std::uint64_t seed, std::uint64_t batch,
                               std::uint64_t photons) const {
    std::seed_seq words{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                        static_cast<std::uint32_t>(batch), static_cast<std::uint32_t>(batch >> 32)};
    std::mt19937_64 random(words);
    PhotonSums result{photons, std::vector<double>(frequencies_per_rad_.size(), 0.0),
                      std::vector<double>(frequencies_per_rad_.size(), 0.0)};
    for (std::uint64_t p = 0; p < photons; ++p) {
        const double angle = landing_rad(random);
        if (angle < 0.0)
            continue;
        for (std::size_t i = 0; i < frequencies_per_rad_.size(); ++i) {
            const double value = ::j0(2.0 * pi * frequencies_per_rad_[i] * angle);
            result.sums[i] += value;
            result.squares[i] += value * value;
        }
    }
    return result;
}

PhotonEstimate PhotonTracer::estimate(const PhotonSums& sums) const {
    // Scattered light over direct light: the forced collision stands for 1 - e^-tau of all photons.
    const double scale = std::expm1(opticalDepth_);
    const auto n = static_cast<double>(sums.photons);
    PhotonEstimate result;
    for (std::size_t i = 0; i < sums.sums.size(); ++i) {
        const double mean = sums.sums[i] / n;
        const double variance = std::max(sums.squares[i] / n - mean * mean, 0.0);
        result.mtf.push_back(1.0 + scale * mean);
        result.standardError.push_back(scale * std::sqrt(variance / std::max(n - 1.0, 1.0)));
    }
    return result;
}

} // namespace irsg
