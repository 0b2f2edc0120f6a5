#include "irsg/scene/radiance/SurfaceRows.h"

#include <algorithm>

namespace irsg {

SurfaceRows::SurfaceRows(std::vector<SurfaceKey> keys, std::vector<bool> transparent,
                         std::vector<SliceNodes> slices)
    : keys_(std::move(keys)), transparent_(std::move(transparent)), slices_(std::move(slices)) {
    isSliced_ =
        std::ranges::any_of(slices_, [](const SliceNodes& nodes) { return nodes.size() > 1; });
    first_.push_back(0);
    for (const auto& [entity, codes] : keys_) {
        const auto rows = static_cast<int>(
            std::max<std::size_t>(slices_[static_cast<std::size_t>(entity)].size(), 1));
        drawnOf_.insert(drawnOf_.end(), static_cast<std::size_t>(rows),
                        static_cast<int>(first_.size()) - 1);
        first_.push_back(first_.back() + rows);
    }
}

} // namespace irsg
