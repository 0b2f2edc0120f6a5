#include "irsg/radiance/MirrorReflectivity.h"

#include <algorithm>

#include "irsg/radiometry/Units.h"

namespace irsg {

MirrorReflectivity::MirrorReflectivity(const SceneRadiometry& radiometry, int bounces) {
    constexpr int mostMirrors = 3;
    const SurfaceRows& rows = radiometry.rows();
    mostFollowed_ = bounces < 0 ? mostMirrors : std::clamp(bounces - 1, 0, mostMirrors);
    for (int row = 0; row < static_cast<int>(rows.keys().size()); ++row) {
        double& sum = hemispherical_.emplace_back(0.0);
        SurfaceModel::Amounts& amounts = amounts_.emplace_back();
        const SurfaceModel* const model = radiometry.models()[static_cast<std::size_t>(row)].get();
        for (std::size_t k = 0; model && k < model->components(); ++k) {
            const std::vector<double>& own =
                radiometry.surfaces()[static_cast<std::size_t>(rows.firstLobe(row)) + k]
                    .reflectance;
            amounts[k] = pi * *std::ranges::max_element(own);
            sum += amounts[k] * model->meanAlbedo(k);
        }
        most_ = std::max(most_, sum);
    }
}

bool MirrorReflectivity::isAnyFollowed() const {
    if (mostFollowed_ == 0 || hemispherical_.empty())
        return false;
    return most_ * most_ > leastFollowed;
}

bool MirrorReflectivity::isComponentFollowed(int row, std::size_t component) const {
    return isFollowed(most_, row, 0) && matters(amountOf(row, component));
}

std::vector<double> MirrorReflectivity::key() const {
    std::vector<double> numbers{isAnyFollowed() ? 1.0 : 0.0, static_cast<double>(mostFollowed_)};
    if (!isAnyFollowed())
        return numbers;
    numbers.insert(numbers.end(), hemispherical_.begin(), hemispherical_.end());
    for (const SurfaceModel::Amounts& amounts : amounts_)
        for (const double amount : amounts)
            numbers.push_back(amount > 0.0 ? 1.0 : 0.0);
    return numbers;
}

} // namespace irsg
