#include "irsg/radiance/RangeGeometry.h"

#include <algorithm>

#include "irsg/core/Interpolation.h"

namespace irsg {

namespace {

/// Adds the weights of the parabola through three nodes from `first` on.
void addParabola(double nearness, std::size_t first, double share,
                 std::array<double, RangeGeometry::nodes.size()>& weights) {
    for (std::size_t i = first; i < first + 3; ++i) {
        double weight = share;
        for (std::size_t j = first; j < first + 3; ++j)
            if (j != i)
                weight *= (nearness - RangeGeometry::nodes[j]) /
                          (RangeGeometry::nodes[i] - RangeGeometry::nodes[j]);
        weights[i] += weight;
    }
}

} // namespace

std::vector<RangeGeometry::Weight> RangeGeometry::errorWeightsAt(double nearness) {
    constexpr std::size_t last = nodes.size() - 1;
    const std::size_t first =
        std::clamp<std::size_t>(bracket(nodes, nearness).below, 1, last - 2) - 1;
    std::vector<Weight> result;
    std::array<double, nodes.size()> mean{};
    for (const Weight& one : weightsAt(nearness))
        mean[one.node] = one.weight;
    for (std::size_t i = first; i < first + 4; ++i) {
        double cubic = 1.0;
        for (std::size_t j = first; j < first + 4; ++j)
            if (j != i)
                cubic *= (nearness - nodes[j]) / (nodes[i] - nodes[j]);
        if (cubic != mean[i])
            result.push_back({i, cubic - mean[i]});
    }
    return result;
}

std::vector<RangeGeometry::Weight> RangeGeometry::weightsAt(double nearness) {
    constexpr std::size_t last = nodes.size() - 1;
    const Bracket place = bracket(nodes, nearness);
    const std::size_t begin = place.below;

    std::array<double, nodes.size()> weights{};
    const std::size_t left = begin > 0 ? begin - 1 : 0;
    const std::size_t right = std::min(begin, last - 2);
    addParabola(nearness, left, 1.0 - place.fraction, weights);
    addParabola(nearness, right, place.fraction, weights);
    std::vector<Weight> result;
    for (std::size_t i = 0; i <= last; ++i)
        if (weights[i] != 0.0)
            result.push_back({i, weights[i]});
    return result;
}

RangeGeometry::CacheEntry& RangeGeometry::entryOf(int entity, const PointAspect& aspect) {
    return cache_.try_emplace(entity, mostCached)
        .first->second.of([&](const CacheEntry& known) { return known.aspect == aspect; },
                          [&] {
                              return CacheEntry{aspect, {}, {}};
                          });
}

const ViewGeometry& RangeGeometry::at(int entity, const PointAspect& aspect, std::size_t node,
                                      const std::function<ViewGeometry()>& draw) {
    std::optional<ViewGeometry>& own = entryOf(entity, aspect).atNode[node];
    if (!own)
        own = draw();
    return *own;
}

const RangeGeometry::FromOne& RangeGeometry::from(int entity, const PointAspect& aspect,
                                                  double distance_m, bool withPlaces,
                                                  const std::function<FromOne()>& draw) {
    std::optional<FromOne>& own = entryOf(entity, aspect).fromOne;
    if (!own || own->distance_m != distance_m || (withPlaces && !own->places))
        own = draw();
    return *own;
}

void addAtRange(const ViewGeometry& atUnitDistance, double weight, const SurfaceRows& drawn,
                double drawn_m, const SurfaceRows& rows, const RangePlace& place,
                const RadianceBehindKind& behind, ViewGeometry& view) {
    const double scale = weight / (place.range_m * place.range_m);
    const ViewLayout& layout = view.layout;
    view.layersLeftOver = std::max(view.layersLeftOver, atUnitDistance.layersLeftOver);
    // The rows of the view that one of the drawing is, and their parts of it.
    const auto forEachRowOf = [&](int drawnRow, const auto& visit) {
        const int surface = drawn.renderedOf(drawnRow);
        const auto entity = static_cast<std::size_t>(drawn.keyOf(surface).first);
        const SliceNodes& slices_m = drawn.slices()[entity];
        const double before_m =
            slices_m.empty() ? 0.0
                             : slices_m[static_cast<std::size_t>(drawn.nodeOf(drawnRow))] - drawn_m;
        rows.forEachRow(surface, static_cast<float>(place.range_m + before_m), visit);
    };
    for (const auto& [kind, sums] : atUnitDistance.light)
        forEachRowOf(kind.second, [&](int row, float part) {
            addLight({{{kind.first, row}, sums}}, scale * static_cast<double>(part), view.light);
        });
    atUnitDistance.field.forEach(0, [&](std::size_t number, std::span<const double> source) {
        const SurfaceStackId& kind = atUnitDistance.field.kinds()[number];
        const std::vector<double> behind_W_m2_sr =
            layout.backgrounds > 0 ? behind(kind) : std::vector<double>{};
        forEachRowOf(kind.row, [&](int row, float part) {
            double* sums = view.field.at(0, view.field.kindOf({kind.stack, row}));
            const double share = scale * static_cast<double>(part);
            for (std::size_t i = 0; i < layout.pixels(); ++i)
                sums[i] += share * source[i];
            sums[layout.pixels()] +=
                share * source[layout.pixels()] / (place.pixel_rad * place.pixel_rad);
            for (std::size_t k = 0; k < behind_W_m2_sr.size(); ++k) {
                const std::size_t coverage = ViewLayout::coverage();
                sums[layout.background(k)] += share * source[coverage] * behind_W_m2_sr[k];
                sums[layout.backgroundCosine(k)] +=
                    share * source[layout.withCosine(coverage)] * behind_W_m2_sr[k];
            }
        });
    });
    for (std::size_t k = 0; k < std::min(view.sublatticeDifferences.size(),
                                         atUnitDistance.sublatticeDifferences.size());
         ++k)
        addAtRange(atUnitDistance.sublatticeDifferences[k], weight, drawn, drawn_m, rows, place,
                   behind, view.sublatticeDifferences[k]);
}

} // namespace irsg
