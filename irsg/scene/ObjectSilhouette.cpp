#include "irsg/scene/ObjectSilhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace irsg {

namespace {

constexpr std::size_t slices = 64;

/// How much of what the facets of a slice cover is hidden, where they hide each other: they are
/// drawn on a grid, each with its opacity. The facets of a convex opaque body hide half of what
/// they cover, those of a plate all.
class Overlap {
  public:
    /// Places to -1 to 1.
    using Corner = std::array<double, 2>; ///< across, above

    void add(std::array<Corner, 3> corners, double opacity) {
        for (Corner& corner : corners)
            corner = {gridOf(corner[0], columns), gridOf(corner[1], rows)};
        const auto [low, high] =
            std::ranges::minmax(corners, {}, [](const Corner& corner) { return corner[1]; });
        const auto first = static_cast<std::size_t>(std::ceil(low[1]));
        for (std::size_t row = first; static_cast<double>(row) < high[1]; ++row) {
            double from = columns, to = 0.0;
            for (std::size_t c = 0; c < 3; ++c)
                if (const auto x =
                        crossing(corners[c], corners[(c + 1) % 3], static_cast<double>(row))) {
                    from = std::min(from, *x);
                    to = std::max(to, *x);
                }
            cover(row, static_cast<std::size_t>(std::ceil(from)),
                  static_cast<std::size_t>(std::ceil(to)), opacity);
        }
    }

    /// What is hidden over the sum of all opacities; 1 where no point of the grid is met.
    double hiddenPartOf(std::size_t slice) const {
        double hidden = 0.0, sum = 0.0;
        for (std::size_t row = slice * rowsOfSlice; row < (slice + 1) * rowsOfSlice; ++row) {
            sum += covered_[row];
            for (std::size_t i = row * columns; sum > 0.0 && i < (row + 1) * columns; ++i)
                hidden += 1.0 - static_cast<double>(passes_[i]);
        }
        return sum > 0.0 ? hidden / sum : 1.0;
    }

  private:
    static constexpr std::size_t rowsOfSlice = 4, rows = rowsOfSlice * slices, columns = 256;

    /// In steps of the grid, whose first points lie half a step inside.
    static double gridOf(double place, std::size_t steps) {
        const auto count = static_cast<double>(steps);
        return std::clamp(0.5 * (place + 1.0) * count - 0.5, 0.0, count);
    }
    /// Where an edge goes through a row; the same for both facets that share it.
    static std::optional<double> crossing(const Corner& a, const Corner& b, double y) {
        const Corner& low = a[1] < b[1] ? a : b;
        const Corner& high = a[1] < b[1] ? b : a;
        if (!(low[1] <= y && y < high[1]))
            return std::nullopt;
        return low[0] + (high[0] - low[0]) * ((y - low[1]) / (high[1] - low[1]));
    }
    void cover(std::size_t row, std::size_t from, std::size_t to, double opacity) {
        to = std::min(to, columns);
        if (from >= to)
            return;
        covered_[row] += opacity * static_cast<double>(to - from);
        const auto passes = static_cast<float>(1.0 - opacity);
        for (std::size_t i = row * columns + from; i < row * columns + to; ++i)
            passes_[i] *= passes;
    }

    std::array<double, rows> covered_{}; ///< sums of opacities
    std::vector<float> passes_ = std::vector<float>(rows * columns, 1.0f);
};

/// Solid angles times opacities by slice, with their moments.
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

    /// `overlap`: null where it is not known.
    std::vector<SilhouettePart> parts(const Overlap* overlap) const {
        double all_sr = 0.0;
        std::vector<SilhouettePart> parts;
        for (std::size_t slice = 0; slice < slices; ++slice) {
            const auto& [solidAngle_sr, moment] = slices_[slice];
            if (!(solidAngle_sr > 0.0))
                continue;
            const double hidden_sr = solidAngle_sr * (overlap ? overlap->hiddenPartOf(slice) : 1.0);
            parts.push_back({moment / solidAngle_sr, hidden_sr});
            all_sr += hidden_sr;
        }
        for (SilhouettePart& part : parts)
            part.weight /= all_sr;
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

/// Cosine of the elevation above which facets that hide each other are not told apart.
constexpr double leastLevel = 0.1;

} // namespace

std::vector<SilhouettePart>
silhouetteOf(const Mesh& mesh, const Pose& pose, const Vec3& sensor_m, const Vec3& reference_m,
             double reach_rad, const std::function<double(const Mesh::Part&)>& opacityOf) {
    const Rotation toWorld = pose.attitude.rotation();
    const Vec3 origin = pose.position_m - sensor_m, middle = reference_m - sensor_m;
    const double middleSine = middle.z / length(middle);
    Slices sums(reach_rad);
    // Elevations meet at the zenith, about which nothing is level.
    const double level = std::hypot(middle.x, middle.y);
    const bool isOnGrid = level > leastLevel * length(middle);
    const Vec3 across = isOnGrid ? Vec3{middle.y / level, -middle.x / level, 0.0} : Vec3{};
    Overlap overlap;
    std::vector<Vec3> places;
    std::vector<double> above_rad, across_rad;
    for (const Mesh::Part& part : mesh.parts) {
        const double opacity = opacityOf(part);
        if (!(opacity > 0.0))
            continue;
        places.clear();
        above_rad.clear();
        across_rad.clear();
        for (const Float3& vertex : part.vertices) {
            const Vec3& place = places.emplace_back(origin + toWorld * toVec3(vertex));
            const double sine = place.z / length(place), mean = 0.5 * (sine + middleSine);
            // asin(sine) - asin(middleSine), near enough over an object.
            const double cosine = std::sqrt(std::max(1.0 - mean * mean, 1e-12));
            above_rad.push_back(std::clamp((sine - middleSine) / cosine, -reach_rad, reach_rad));
            across_rad.push_back(dot(place, across) / length(place));
        }
        for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
            const unsigned a = part.triangles[i], b = part.triangles[i + 1],
                           c = part.triangles[i + 2];
            const Vec3 normal = cross(places[b] - places[a], places[c] - places[a]);
            const double distance_m = length(places[a]);
            const double solidAngle_sr =
                0.5 * std::abs(dot(normal, places[a])) / (distance_m * distance_m * distance_m);
            const bool isFromBehind = dot(normal, places[a]) > 0.0;
            if (!(solidAngle_sr > 0.0) || (part.culled && isFromBehind))
                continue;
            sums.add({above_rad[a], above_rad[b], above_rad[c]}, opacity * solidAngle_sr);
            const auto cornerOf = [&](unsigned i) {
                return Overlap::Corner{across_rad[i] / reach_rad, above_rad[i] / reach_rad};
            };
            if (isOnGrid)
                overlap.add({cornerOf(a), cornerOf(b), cornerOf(c)}, opacity);
        }
    }
    return sums.parts(isOnGrid ? &overlap : nullptr);
}

} // namespace irsg
