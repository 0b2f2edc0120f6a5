#include "irsg/radiance/Fronts.h"

#include <algorithm>

namespace irsg {

int Fronts::behind(int front, const FrontMaterial& material) {
    const auto [place, isNew] = longer_.try_emplace({front, material}, 0);
    if (isNew) {
        std::vector<FrontMaterial> longer = materials(front);
        longer.insert(std::ranges::upper_bound(longer, material), material);
        place->second = numberOf(longer);
    }
    return place->second;
}

int Fronts::numberOf(const std::vector<FrontMaterial>& materials) {
    const auto [place, isNew] = numbers_.try_emplace(materials, static_cast<int>(sets_.size()));
    if (isNew)
        sets_.push_back(materials);
    return place->second;
}

int Fronts::find(const std::vector<FrontMaterial>& materials) const {
    const auto place = numbers_.find(materials);
    return place == numbers_.end() ? -1 : place->second;
}

} // namespace irsg
