#include "irsg/scene/radiance/RangeFactors.h"

#include <algorithm>

namespace irsg {

namespace {

/// Adds the weights of the parabola through three nodes from `first` on.
void addParabola(double nearness, std::size_t first, double share,
                 std::array<double, RangeFactors::nodes.size()>& weights) {
    for (std::size_t i = first; i < first + 3; ++i) {
        double weight = share;
        for (std::size_t j = first; j < first + 3; ++j)
            if (j != i)
                weight *= (nearness - RangeFactors::nodes[j]) /
                          (RangeFactors::nodes[i] - RangeFactors::nodes[j]);
        weights[i] += weight;
    }
}

} // namespace

std::vector<RangeFactors::Weight> RangeFactors::weightsAt(double nearness) {
    constexpr std::size_t last = nodes.size() - 1;
    const auto above = std::ranges::upper_bound(nodes, nearness);
    const std::size_t begin =
        std::clamp<std::size_t>(static_cast<std::size_t>(above - nodes.begin()), 1, last) - 1;
    const double part =
        std::clamp((nearness - nodes[begin]) / (nodes[begin + 1] - nodes[begin]), 0.0, 1.0);

    std::array<double, nodes.size()> weights{};
    const std::size_t left = begin > 0 ? begin - 1 : 0;
    const std::size_t right = std::min(begin, last - 2);
    addParabola(nearness, left, 1.0 - part, weights);
    addParabola(nearness, right, part, weights);
    std::vector<Weight> result;
    for (std::size_t i = 0; i <= last; ++i)
        if (weights[i] != 0.0)
            result.push_back({i, weights[i]});
    return result;
}

const ViewFactors& RangeFactors::at(int entity, const PointAspect& aspect, std::size_t node,
                                    const std::function<ViewFactors()>& draw) {
    std::list<Kept>& kept = kept_[entity];
    const auto found = std::ranges::find(kept, aspect, &Kept::aspect);
    if (found != kept.end()) {
        kept.splice(kept.begin(), kept, found);
    } else {
        kept.push_front({aspect, {}});
        if (kept.size() > mostKept)
            kept.pop_back();
    }
    std::optional<ViewFactors>& own = kept.front().atNode[node];
    if (!own)
        own = draw();
    return *own;
}

void addAtRange(const ViewFactors& atUnitDistance, double weight, const SurfaceRows& drawn,
                double drawn_m, const SurfaceRows& rows, const RangePlace& place,
                ViewFactors& view) {
    const double scale = weight / (place.range_m * place.range_m);
    const ViewLayout& layout = view.layout;
    view.layersLeftOver = std::max(view.layersLeftOver, atUnitDistance.layersLeftOver);
    atUnitDistance.field.forEach(0, [&](std::size_t number, std::span<const double> source) {
        const FactorKind& kind = atUnitDistance.field.kinds()[number];
        const int surface = drawn.drawnOf(kind.row);
        const auto entity =
            static_cast<std::size_t>(drawn.keys()[static_cast<std::size_t>(surface)].first);
        const SliceNodes& slices_m = drawn.slices()[entity];
        const double before_m =
            slices_m.empty() ? 0.0
                             : slices_m[static_cast<std::size_t>(drawn.nodeOf(kind.row))] - drawn_m;
        const auto distance_m = static_cast<float>(place.range_m + before_m);
        rows.forEachRow(surface, distance_m, [&](int row, float part) {
            double* sums = view.field.at(0, view.field.kindOf({kind.front, row}));
            const double share = scale * static_cast<double>(part);
            for (std::size_t i = 0; i < layout.pixels(); ++i)
                sums[i] += share * source[i];
            sums[layout.pixels()] +=
                share * source[layout.pixels()] / (place.pixel_rad * place.pixel_rad);
        });
    });
}

} // namespace irsg
