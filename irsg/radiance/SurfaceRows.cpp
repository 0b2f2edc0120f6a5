#include "irsg/radiance/SurfaceRows.h"

#include <algorithm>

namespace irsg {

SliceBetween sliceBetween(int node, int step, int last) {
    const int below = node / step * step;
    if (below == node || node == last)
        return {node, node, 0.0};
    const int above = std::min(below + step, last);
    return {below, above, static_cast<double>(node - below) / (above - below)};
}

SurfaceRows::SurfaceRows(std::vector<SurfaceKey> keys, const std::vector<bool>& transparent,
                         std::vector<SliceNodes> slices, std::vector<LobeQuadratureRow> lobes,
                         std::map<int, GasZone> gases)
    : keys_(std::move(keys)),
      lobes_(std::move(lobes)),
      slices_(std::move(slices)),
      gases_(std::move(gases)) {
    isSliced_ =
        std::ranges::any_of(slices_, [](const SliceNodes& nodes) { return nodes.size() > 1; });
    for (std::size_t drawn = 0; drawn < keys_.size() + lobes_.size(); ++drawn) {
        const int number = static_cast<int>(drawn);
        const SliceNodes& nodes_m = slices_[static_cast<std::size_t>(keyOf(number).first)];
        Rendered& own = rendered_.emplace_back();
        own.isTransparent = !isLobe(number) && transparent[drawn];
        own.first = size();
        if (nodes_m.size() > 1) {
            own.lastSlice = static_cast<int>(nodes_m.size()) - 2;
            own.nearest_m = nodes_m.front();
            own.slicesPerMetre =
                static_cast<double>(nodes_m.size() - 1) / (nodes_m.back() - nodes_m.front());
        }
        renderedOf_.insert(renderedOf_.end(), std::max<std::size_t>(nodes_m.size(), 1),
                           static_cast<int>(drawn));
        if (!isLobe(number))
            continue;
        int& first = rendered_[static_cast<std::size_t>(lobe(number).surface)].firstLobe;
        first = first < 0 ? number : first;
    }
}

} // namespace irsg
