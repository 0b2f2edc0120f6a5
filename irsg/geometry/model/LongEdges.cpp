#include "irsg/geometry/model/LongEdges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <osg/TriangleIndexFunctor>

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

struct LongEdgeCollector {
    const osg::Vec3Array* vertices = nullptr;
    osg::Matrixd modelFromLocal;
    IrCodes codes;
    double shortest_m = 0.0;
    std::map<EdgeKey, Sides> found{};

    void operator()(unsigned a, unsigned b, unsigned c) {
        const std::array<Vec3, 3> corners = {place(a), place(b), place(c)};
        const Vec3 across = cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double area = length(across);
        if (area == 0.0)
            return;
        const Vec3 normal = across * (1.0 / area);
        for (std::size_t i = 0; i < 3; ++i)
            add(corners[i], corners[(i + 1) % 3], normal);
    }

  private:
    Vec3 place(unsigned index) const {
        const osg::Vec3d p = osg::Vec3d((*vertices)[index]) * modelFromLocal;
        return {p.x(), p.y(), p.z()};
    }

    void add(const Vec3& from, const Vec3& to, const Vec3& normal) {
        if (length(to - from) < shortest_m)
            return;
        const Place a = {from.x, from.y, from.z}, b = {to.x, to.y, to.z};
        const auto [edge, isNew] =
            found.try_emplace({std::min(a, b), std::max(a, b)}, Sides{codes, normal, true});
        if (isNew)
            return;
        constexpr double flat = 1e-6; // 1 - cos of 0.08 degrees
        const Sides& other = edge->second;
        if (other.codes == codes && 1.0 - std::abs(dot(other.normal, normal)) < flat)
            edge->second.outlines = false;
    }
};

} // namespace

std::vector<ModelEdge> longEdges(const std::vector<RenderItem>& items, double radius_m) {
    osg::TriangleIndexFunctor<LongEdgeCollector> collector;
    collector.shortest_m = longFrom * radius_m;
    for (const RenderItem& item : items) {
        collector.vertices = dynamic_cast<const osg::Vec3Array*>(item.geometry->getVertexArray());
        if (!collector.vertices)
            continue;
        collector.modelFromLocal = item.modelFromLocal;
        collector.codes = item.codes;
        item.geometry->accept(collector);
    }

    std::vector<ModelEdge> edges;
    for (const auto& [ends, sides] : collector.found)
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
