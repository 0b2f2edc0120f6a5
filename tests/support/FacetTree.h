#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "irsg/geometry/view/Vec3.h"

namespace irsg::test::tracing {

constexpr double infinitelyFar = std::numeric_limits<double>::infinity();

inline double norm(const Vec3& v) {
    return std::sqrt(dot(v, v));
}

inline Vec3 least(const Vec3& a, const Vec3& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
inline Vec3 greatest(const Vec3& a, const Vec3& b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// Some unit vector across another.
inline Vec3 across(const Vec3& n) {
    const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    const Vec3 axis = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 side = cross(axis, n);
    return side * (1.0 / norm(side));
}

struct Facet {
    Vec3 corner_m, edge1_m, edge2_m;
    Vec3 normal, tangent;
    double area_m2 = 0.0;
    double emitted_W_m2_sr = 0.0, reflectivity = 0.0;
    /// Of a point that is aimed at, per m2; 0 where none is.
    double aimed_per_m2 = 0.0;
    bool isTwoSided = true;
    int body = 0;
};

struct Ray {
    Vec3 start_m, direction;
};

constexpr std::uint32_t nothing = ~0u;

struct Hit {
    std::uint32_t facet = nothing;
    double distance_m = infinitelyFar;
    bool isFront = true;
};

/// Which side of a one-sided facet stops a ray.
enum class Stops { whereFrontIsSeen, whereBackIsSeen };

/// Boxes around boxes around facets, in double.
class FacetTree {
  public:
    FacetTree() = default;
    explicit FacetTree(const std::vector<Facet>& facets);

    /// In the order of the tree, by which hits and queries count them.
    const std::vector<Facet>& facets() const { return facets_; }
    std::vector<Facet>& facets() { return facets_; }

    /// The facet that is seen first; `from` is not met.
    Hit nearest(const Ray& ray, std::uint32_t from) const;
    /// Whether some facet but `from` and `to` is nearer than that.
    bool isBlocked(const Ray& ray, double distance_m, std::uint32_t from, std::uint32_t to,
                   Stops stops) const;

  private:
    struct Node {
        Vec3 low_m, high_m;
        std::uint32_t first = 0; ///< the first facet, or the second child: the first follows it
        std::uint32_t count = 0; ///< of facets; 0 for an inner node
        int axis = 0;
    };
    void walk(const Ray& ray, std::uint32_t from, std::uint32_t to, Stops stops, Hit& hit,
              bool isAnyEnough) const;
    static bool isMet(const Node& node, const Vec3& start_m, const Vec3& per, double most_m);

    std::vector<Facet> facets_;
    std::vector<Node> nodes_;
};

} // namespace irsg::test::tracing
