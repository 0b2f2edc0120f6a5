#include "tests/support/PathTracer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <thread>
#include <utility>

#include "tests/support/FacetTree.h"
#include "tests/support/ScrambledPoints.h"

namespace irsg::test {

using namespace tracing;

namespace {

constexpr double circle_rad = 6.283185307179586;
constexpr double half_turn = 3.141592653589793;

/// Sums of one batch, W m-2 sr-1 over the starting points.
struct Sums {
    double emitted = 0.0, onceFromOutside = 0.0, onceFromOthers = 0.0, more = 0.0;
    std::uint64_t paths = 0;
};

/// Rays towards the bodies, evenly over a rectangle on the plane through the centre, across the
/// direction of the view.
class Viewer {
  public:
    Viewer(const std::vector<Facet>& facets, const Vec3& towards, const TraceSettings& settings)
        : towards_(towards),
          right_(across(towards)),
          up_(cross(towards, right_)),
          centre_m_(settings.centre_m),
          distance_m_(settings.distance_m) {
        for (const Facet& facet : facets) {
            for (const Vec3& corner :
                 {facet.corner_m, facet.corner_m + facet.edge1_m, facet.corner_m + facet.edge2_m}) {
                const Vec3 place = corner - centre_m_;
                const double depth_m = dot(place, towards_);
                before_m_ = std::max(before_m_, depth_m);
                if (settings.body && facet.body != *settings.body) {
                    continue;
                }
                const double scale =
                    distance_m_ > 0.0 ? distance_m_ / (distance_m_ - depth_m) : 1.0;
                const double x = dot(place, right_) * scale, y = dot(place, up_) * scale;
                left_m_ = std::min(left_m_, x), most_m_ = std::max(most_m_, x);
                low_m_ = std::min(low_m_, y), high_m_ = std::max(high_m_, y);
            }
        }
        if (distance_m_ > 0.0 && before_m_ >= distance_m_) {
            throw std::invalid_argument("the viewer stands among the bodies");
        }
        before_m_ += 1e-3 * (1.0 + std::abs(before_m_));
    }

    double area_m2() const {
        return std::max(0.0, most_m_ - left_m_) * std::max(0.0, high_m_ - low_m_);
    }
    /// With its solid angle times distance squared, per area of the rectangle.
    std::pair<Ray, double> ray(double x, double y) const {
        const Vec3 place_m = centre_m_ + right_ * (left_m_ + (most_m_ - left_m_) * x) +
                             up_ * (low_m_ + (high_m_ - low_m_) * y);
        if (distance_m_ <= 0.0) {
            return {{place_m + towards_ * before_m_, towards_ * -1.0}, 1.0};
        }
        const Vec3 eye_m = centre_m_ + towards_ * distance_m_, way_m = place_m - eye_m;
        const double cosine = distance_m_ / norm(way_m);
        return {{eye_m, way_m * (1.0 / norm(way_m))}, cosine * cosine * cosine};
    }
    /// In parallel projection, to a place.
    Ray rayTo(const Vec3& place_m) const {
        const double depth_m = dot(place_m - centre_m_, towards_);
        return {place_m + towards_ * (before_m_ - depth_m), towards_ * -1.0};
    }

  private:
    Vec3 towards_, right_, up_, centre_m_;
    double distance_m_, before_m_ = -infinitelyFar;
    double left_m_ = infinitelyFar, most_m_ = -infinitelyFar;
    double low_m_ = infinitelyFar, high_m_ = -infinitelyFar;
};

TracedValue meanOf(const std::vector<double>& batches) {
    const auto count = static_cast<double>(batches.size());
    double sum = 0.0, squares = 0.0;
    for (const double value : batches) {
        sum += value;
    }
    const double mean = sum / count;
    for (const double value : batches) {
        squares += (value - mean) * (value - mean);
    }
    return {mean, std::sqrt(squares / (count * (count - 1.0)))};
}

} // namespace

struct PathTracer::Impl {
    FacetTree tree;
    std::vector<std::uint32_t> aimedAt; ///< facets
    std::vector<double> aimedShare;     ///< running sum over them, up to 1
    TracedSurroundings surroundings;
    double skin_m = 0.0;

    /// Adds what arrives along a ray from the viewer, times a weight.
    void follow(Ray ray, double weight, PathNumbers numbers, const TraceSettings& settings,
                Sums& sums) const {
        Hit hit = tree.nearest(ray, nothing);
        if (hit.facet == nothing ||
            (settings.body && tree.facets()[hit.facet].body != *settings.body)) {
            return;
        }
        const bool isLitFromOutside =
            surroundings.sky_W_m2_sr > 0.0 || surroundings.ground_W_m2_sr > 0.0;
        double chosen_sr = 0.0; // density of the ray that met the facet, per sr
        std::size_t drawn = 2;  // dimensions
        for (int bounce = 0;; ++bounce) {
            const Facet& facet = tree.facets()[hit.facet];
            const Vec3 normal = hit.isFront ? facet.normal : facet.normal * -1.0;
            double& ofEmission = bounce == 0   ? sums.emitted
                                 : bounce == 1 ? sums.onceFromOthers
                                               : sums.more;
            double& ofOutside = bounce == 0 ? sums.onceFromOutside : sums.more;
            double& ofAimed = bounce == 0 ? sums.onceFromOthers : sums.more;
            double met = 1.0; // of both ways that lead to light
            if (bounce > 0 && facet.aimed_per_m2 > 0.0) {
                const double aimed_sr = facet.aimed_per_m2 * hit.distance_m * hit.distance_m /
                                        std::max(1e-300, -dot(normal, ray.direction));
                met = chosen_sr / (chosen_sr + aimed_sr);
            }
            ofEmission += weight * met * facet.emitted_W_m2_sr;
            weight *= facet.reflectivity;
            if (weight <= 0.0) {
                return;
            }

            const Vec3 place_m = ray.start_m + ray.direction * hit.distance_m + normal * skin_m;
            const double sunCosine = dot(normal, surroundings.towardsSun);
            if (surroundings.sun_W_m2 > 0.0 && sunCosine > 0.0 &&
                !tree.isBlocked({place_m, surroundings.towardsSun}, infinitelyFar, hit.facet,
                                nothing, Stops::whereBackIsSeen)) {
                ofOutside += weight / half_turn * surroundings.sun_W_m2 * sunCosine;
            }

            const bool isLast = bounce == settings.bounces;
            const double first = numbers.at(drawn), second = numbers.at(drawn + 1);
            if (!aimedAt.empty() && !isLast) {
                ofAimed += weight * aimed(place_m, normal, hit.facet, numbers, drawn + 2);
            }
            drawn += aimedAt.empty() ? 2 : 5;
            if (isLast && !isLitFromOutside) {
                return;
            }

            if (bounce >= 6) {
                const double goesOn = std::clamp(facet.reflectivity, 0.2, 0.95);
                if (numbers.words.unit() >= goesOn) {
                    return;
                }
                weight /= goesOn;
            }
            const double radius = std::sqrt(first), angle = circle_rad * second;
            const double cosine = std::sqrt(std::max(0.0, 1.0 - first));
            ray.direction = facet.tangent * (radius * std::cos(angle)) +
                            cross(normal, facet.tangent) * (radius * std::sin(angle)) +
                            normal * cosine;
            ray.start_m = place_m;
            chosen_sr = cosine / half_turn;
            hit = tree.nearest(ray, hit.facet);
            if (hit.facet == nothing) {
                ofOutside += weight * (ray.direction.z > 0.0 ? surroundings.sky_W_m2_sr
                                                             : surroundings.ground_W_m2_sr);
                return;
            }
            if (isLast) {
                return;
            }
        }
    }

    /// What arrives from one of the facets that are aimed at, over all directions, divided by pi.
    double aimed(const Vec3& place_m, const Vec3& normal, std::uint32_t from, PathNumbers& numbers,
                 std::size_t dimension) const {
        const double choice = numbers.at(dimension), first = numbers.at(dimension + 1),
                     second = numbers.at(dimension + 2);
        const auto found = std::ranges::lower_bound(aimedShare, choice);
        const std::uint32_t to = aimedAt[std::min(
            aimedAt.size() - 1, static_cast<std::size_t>(found - aimedShare.begin()))];
        const Facet& facet = tree.facets()[to];
        const double root = std::sqrt(first);
        const Vec3 there_m = facet.corner_m + facet.edge1_m * (root * (1.0 - second)) +
                             facet.edge2_m * (root * second);
        const Vec3 way_m = there_m - place_m;
        const double squared_m2 = dot(way_m, way_m), distance_m = std::sqrt(squared_m2);
        if (to == from || !(distance_m > 0.0)) {
            return 0.0;
        }
        const Vec3 direction = way_m * (1.0 / distance_m);
        const double cosine = dot(normal, direction);
        double cosineThere = -dot(facet.normal, direction);
        if (facet.isTwoSided) {
            cosineThere = std::abs(cosineThere);
        }
        if (cosine <= 0.0 || cosineThere <= 0.0 ||
            tree.isBlocked({place_m, direction}, distance_m * (1.0 - 1e-9), from, to,
                           Stops::whereFrontIsSeen)) {
            return 0.0;
        }
        const double aimed_sr = facet.aimed_per_m2 * squared_m2 / cosineThere;
        const double chosen_sr = cosine / half_turn;
        return facet.emitted_W_m2_sr * chosen_sr / (aimed_sr + chosen_sr);
    }

    template <typename Rays>
    TracedLight traced(const Rays& rayOf, double scale, const TraceSettings& settings) const;
    void chooseAimed();
};

/// Small facets that are brighter than the others by far.
void PathTracer::Impl::chooseAimed() {
    std::vector<Facet>& facets = tree.facets();
    double area_m2 = 0.0, power = 0.0;
    for (const Facet& facet : facets) {
        area_m2 += facet.area_m2;
        power += facet.area_m2 * facet.emitted_W_m2_sr;
    }
    const double from = 4.0 * power / area_m2;
    double aimedPower = 0.0;
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
        if (facets[f].emitted_W_m2_sr > from && facets[f].emitted_W_m2_sr > 0.0) {
            aimedAt.push_back(f);
            aimedPower += facets[f].area_m2 * facets[f].emitted_W_m2_sr;
        }
    }
    double sum = 0.0;
    for (const std::uint32_t f : aimedAt) {
        facets[f].aimed_per_m2 = facets[f].emitted_W_m2_sr / aimedPower;
        sum += facets[f].area_m2 * facets[f].aimed_per_m2;
        aimedShare.push_back(sum);
    }
}

PathTracer::PathTracer(const std::vector<TracedTriangle>& triangles,
                       const TracedSurroundings& surroundings, double skin_m) {
    auto impl = std::make_unique<Impl>();
    impl->surroundings = surroundings;
    std::vector<Facet> facets;
    Vec3 low{infinitelyFar, infinitelyFar, infinitelyFar},
        high{-infinitelyFar, -infinitelyFar, -infinitelyFar};
    for (const TracedTriangle& triangle : triangles) {
        Facet facet;
        facet.corner_m = triangle.corners_m[0];
        facet.edge1_m = triangle.corners_m[1] - triangle.corners_m[0];
        facet.edge2_m = triangle.corners_m[2] - triangle.corners_m[0];
        const Vec3 twice = cross(facet.edge1_m, facet.edge2_m);
        facet.area_m2 = 0.5 * norm(twice);
        if (!(facet.area_m2 > 0.0)) {
            continue;
        }
        facet.normal = twice * (0.5 / facet.area_m2);
        facet.tangent = across(facet.normal);
        facet.emitted_W_m2_sr = triangle.emitted_W_m2_sr;
        facet.reflectivity = triangle.reflectivity;
        facet.isTwoSided = triangle.isTwoSided;
        facet.body = triangle.body;
        facets.push_back(facet);
        for (const Vec3& corner : triangle.corners_m) {
            low = least(low, corner), high = greatest(high, corner);
        }
    }
    if (facets.empty()) {
        throw std::invalid_argument("a path tracer needs a triangle that has an area");
    }
    impl->skin_m = skin_m > 0.0 ? skin_m : 1e-9 * norm(high - low);
    impl->tree = FacetTree(facets);
    impl->chooseAimed();
    impl_ = std::move(impl);
}

PathTracer::~PathTracer() = default;

/// The sums of many paths, which start where `rayOf` says for points of the unit square.
template <typename Rays>
TracedLight PathTracer::Impl::traced(const Rays& rayOf, double scale,
                                     const TraceSettings& settings) const {
    const std::clock_t start = std::clock();
    TracedLight found;
    constexpr std::size_t batches = 16;
    std::vector<ScrambledPoints> points;
    for (std::size_t b = 0; b < batches; ++b) {
        points.emplace_back(Words(settings.seed * 0x51ed2701u + b).next());
    }
    std::vector<Sums> sums(batches);
    std::uint32_t done = 0;
    for (std::uint32_t next = 1024;; done = next, next *= 2) {
        std::atomic<std::size_t> batch{0};
        const auto work = [&] {
            for (std::size_t b = batch++; b < batches; b = batch++) {
                Sums own = sums[b];
                ScrambledPoints::Digits digits = points[b].at(done);
                for (std::uint32_t i = done; i < next; ++i) {
                    PathNumbers numbers{digits,
                                        Words((static_cast<std::uint64_t>(settings.seed) << 40 ^
                                               static_cast<std::uint64_t>(b) << 32 ^ i) *
                                              0xd1342543de82ef95u)};
                    const auto [ray, weight] = rayOf(numbers.at(0), numbers.at(1));
                    follow(ray, weight, numbers, settings, own);
                    points[b].step(digits, i);
                }
                own.paths = next;
                sums[b] = own;
            }
        };
        std::vector<std::thread> others;
        for (unsigned t = 1; t < settings.threads; ++t) {
            others.emplace_back(work);
        }
        work();
        for (std::thread& other : others) {
            other.join();
        }

        const auto part = [&](const auto& of) {
            std::vector<double> values;
            for (const Sums& one : sums) {
                values.push_back(scale * of(one) / static_cast<double>(one.paths));
            }
            return meanOf(values);
        };
        found.emitted = part([](const Sums& s) { return s.emitted; });
        found.onceFromOutside = part([](const Sums& s) { return s.onceFromOutside; });
        found.onceFromOthers = part([](const Sums& s) { return s.onceFromOthers; });
        found.more = part([](const Sums& s) { return s.more; });
        found.between = part([](const Sums& s) { return s.onceFromOthers + s.more; });
        found.total = part([](const Sums& s) {
            return s.emitted + s.onceFromOutside + s.onceFromOthers + s.more;
        });
        found.paths = batches * static_cast<std::uint64_t>(next);
        found.processor_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        const bool isFine =
            found.total.error <= settings.relativeError * found.total.value &&
            (settings.relativeErrorOfBetween <= 0.0 ||
             found.between.error <= settings.relativeErrorOfBetween * found.between.value);
        // Another round takes as long as all before it.
        if ((isFine && next > 2048) || 2.0 * found.processor_s > settings.longest_s ||
            next >= 1u << 30) {
            return found;
        }
    }
}

TracedLight PathTracer::intensity(const Vec3& towardsViewer, const TraceSettings& settings) const {
    const Viewer viewer(impl_->tree.facets(), towardsViewer, settings);
    if (!(viewer.area_m2() > 0.0)) {
        return {};
    }
    return impl_->traced([&](double x, double y) { return viewer.ray(x, y); }, viewer.area_m2(),
                         settings);
}

TracedLight PathTracer::radiance(const Vec3& place_m, const Vec3& towardsViewer,
                                 const TraceSettings& settings) const {
    const Viewer viewer(impl_->tree.facets(), towardsViewer, settings);
    const Ray ray = viewer.rayTo(place_m);
    return impl_->traced([&](double, double) { return std::pair(ray, 1.0); }, 1.0, settings);
}

} // namespace irsg::test