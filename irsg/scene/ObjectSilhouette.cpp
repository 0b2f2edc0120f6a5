#include "irsg/scene/ObjectSilhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace irsg {

namespace {

constexpr std::size_t slices = 64;

/// Solid angles by slice with their moments.
class Slices {
  public:
    explicit Slices(double reach_rad)
        : first_rad_(-reach_rad), width_rad_(2.0 * reach_rad / slices) {}

    /// A triangle by the elevations of its corners.
    void add(std::array<double, 3> corners_rad, double solidAngle_sr) {
        std::ranges::sort(corners_rad);
        const auto& [low, middle, high] = corners_rad;
        const std::size_t first = sliceOf(low), last = sliceOf(high);
        if (first == last)
            return put(first, solidAngle_sr, (low + middle + high) / 3.0);
        // The part of its area below an elevation is quadratic up to the middle corner, and beyond.
        const auto below = [&](double at) {
            if (at <= middle)
                return (at - low) * (at - low) / ((middle - low) * (high - low));
            return 1.0 - (high - at) * (high - at) / ((high - middle) * (high - low));
        };
        double before = 0.0, from = low;
        for (std::size_t slice = first; slice <= last; ++slice) {
            const double to =
                slice == last ? high : first_rad_ + static_cast<double>(slice + 1) * width_rad_;
            const double until = slice == last ? 1.0 : below(to);
            put(slice, solidAngle_sr * (until - before), 0.5 * (from + to));
            before = until;
            from = to;
        }
    }

    std::vector<SilhouettePart> parts() const {
        double all_sr = 0.0;
        for (const auto& [solidAngle_sr, moment] : slices_)
            all_sr += solidAngle_sr;
        std::vector<SilhouettePart> parts;
        for (const auto& [solidAngle_sr, moment] : slices_)
            if (solidAngle_sr > 0.0)
                parts.push_back({moment / solidAngle_sr, solidAngle_sr / all_sr});
        return parts;
    }

  private:
    std::size_t sliceOf(double above_rad) const {
        return static_cast<std::size_t>(
            std::clamp((above_rad - first_rad_) / width_rad_, 0.0, slices - 1.0));
    }
    void put(std::size_t slice, double solidAngle_sr, double above_rad) {
        slices_[slice].first += solidAngle_sr;
        slices_[slice].second += solidAngle_sr * above_rad;
    }

    double first_rad_, width_rad_;
    std::array<std::pair<double, double>, slices> slices_{};
};

} // namespace

std::vector<SilhouettePart> silhouetteOf(const Mesh& mesh, const Pose& pose, const Vec3& sensor_m,
                                         const Vec3& reference_m, double reach_rad,
                                         const std::function<bool(const Mesh::Part&)>& counts) {
    const Rotation toWorld = pose.attitude.rotation();
    const Vec3 origin = pose.position_m - sensor_m, middle = reference_m - sensor_m;
    const double middleSine = middle.z / length(middle);
    Slices sums(reach_rad);
    std::vector<Vec3> places;
    std::vector<double> above_rad;
    for (const Mesh::Part& part : mesh.parts) {
        if (!counts(part))
            continue;
        places.clear();
        above_rad.clear();
        for (const Float3& vertex : part.vertices) {
            const Vec3& place = places.emplace_back(origin + toWorld * toVec3(vertex));
            const double sine = place.z / length(place), mean = 0.5 * (sine + middleSine);
            // asin(sine) - asin(middleSine), near enough over an object.
            const double cosine = std::sqrt(std::max(1.0 - mean * mean, 1e-12));
            above_rad.push_back(std::clamp((sine - middleSine) / cosine, -reach_rad, reach_rad));
        }
        for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
            const unsigned a = part.triangles[i], b = part.triangles[i + 1],
                           c = part.triangles[i + 2];
            const Vec3 normal = cross(places[b] - places[a], places[c] - places[a]);
            const double distance_m = length(places[a]);
            const double solidAngle_sr =
                0.5 * std::abs(dot(normal, places[a])) / (distance_m * distance_m * distance_m);
            if (solidAngle_sr > 0.0)
                sums.add({above_rad[a], above_rad[b], above_rad[c]}, solidAngle_sr);
        }
    }
    return sums.parts();
}

} // namespace irsg
