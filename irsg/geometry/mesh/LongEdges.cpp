#include "irsg/geometry/mesh/LongEdges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace irsg {

namespace {

using Place = std::array<double, 3>;
using EdgeKey = std::pair<Place, Place>; // the lesser place first

/// What lies on either side of an edge.
struct Sides {
    IrCodes codes;
    Vec3 normal;
    bool outlines = true; ///< no flat, equal surface goes on beyond it
};

class LongEdgeCollector {
  public:
    explicit LongEdgeCollector(double shortest_m) : shortest_m_(shortest_m) {}

    void add(const IrCodes& codes, const std::array<Vec3, 3>& corners) {
        const Vec3 across = cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double area = length(across);
        if (area == 0.0)
            return;
        const Vec3 normal = across * (1.0 / area);
        for (std::size_t i = 0; i < 3; ++i)
            add(codes, corners[i], corners[(i + 1) % 3], normal);
    }
    const std::map<EdgeKey, Sides>& found() const { return found_; }

  private:
    void add(const IrCodes& codes, const Vec3& from, const Vec3& to, const Vec3& normal) {
        if (length(to - from) < shortest_m_)
            return;
        const Place a = {from.x, from.y, from.z}, b = {to.x, to.y, to.z};
        const auto [edge, isNew] =
            found_.try_emplace({std::min(a, b), std::max(a, b)}, Sides{codes, normal, true});
        if (isNew)
            return;
        constexpr double flat = 1e-6; // 1 - cos of 0.08 degrees
        const Sides& other = edge->second;
        if (other.codes == codes && 1.0 - std::abs(dot(other.normal, normal)) < flat)
            edge->second.outlines = false;
    }

    double shortest_m_;
    std::map<EdgeKey, Sides> found_;
};

} // namespace

std::vector<ModelEdge> longEdges(const Mesh& mesh) {
    LongEdgeCollector collector(longFrom * mesh.sphere.radius_m);
    for (const Mesh::Part& part : mesh.parts)
        for (std::size_t i = 0; i < part.triangles.size(); i += 3) {
            const auto corner = [&](std::size_t k) {
                return toVec3(part.vertices[part.triangles[i + k]]);
            };
            collector.add(part.codes, {corner(0), corner(1), corner(2)});
        }

    std::vector<ModelEdge> edges;
    for (const auto& [ends, sides] : collector.found())
        if (sides.outlines) {
            const auto& [a, b] = ends;
            edges.push_back({{a[0], a[1], a[2]}, {b[0], b[1], b[2]}});
        }
    std::ranges::stable_sort(edges, std::ranges::greater{},
                             [](const ModelEdge& edge) { return length(edge.to_m - edge.from_m); });
    if (edges.size() > mostLongEdges)
        edges.resize(mostLongEdges);
    return edges;
}

} // namespace irsg
