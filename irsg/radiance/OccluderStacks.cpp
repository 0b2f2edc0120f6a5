#include "irsg/radiance/OccluderStacks.h"

#include <algorithm>

namespace irsg {

int OccluderStacks::behind(int stack, const OccluderMaterial& material) {
    const auto [place, isNew] = longer_.try_emplace({stack, material}, 0);
    if (isNew) {
        std::vector<OccluderMaterial> longer = materials(stack);
        longer.insert(std::ranges::upper_bound(longer, material), material);
        place->second = numberOf(longer);
    }
    return place->second;
}

int OccluderStacks::numberOf(const std::vector<OccluderMaterial>& materials) {
    const auto [place, isNew] = numbers_.try_emplace(materials, static_cast<int>(sets_.size()));
    if (isNew)
        sets_.push_back(materials);
    return place->second;
}

int OccluderStacks::find(const std::vector<OccluderMaterial>& materials) const {
    const auto place = numbers_.find(materials);
    return place == numbers_.end() ? -1 : place->second;
}

} // namespace irsg
