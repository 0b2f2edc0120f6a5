#include "irsg/scene/radiance/HotSurfaces.h"

namespace irsg {

std::vector<bool> hotSurfaces(const SceneRadiometry& radiometry,
                              const std::vector<Entity>& entities) {
    const auto& keys = radiometry.keys();
    std::vector<double> radiance_W_m2_sr, area_m2;
    std::vector<double> emitted_W_sr(entities.size()), whole_m2(entities.size());
    for (std::size_t row = 0; row < keys.size(); ++row) {
        const auto& [entity, codes] = keys[row];
        const auto e = static_cast<std::size_t>(entity);
        const auto& uses = entities[e].model->codes();
        const auto use = uses.find(codes);
        area_m2.push_back(use == uses.end() ? 0.0 : use->second.area_m2);
        radiance_W_m2_sr.push_back(radiometry.integrate(radiometry.surfaces()[row].thermal));
        emitted_W_sr[e] += radiance_W_m2_sr.back() * area_m2.back();
        whole_m2[e] += area_m2.back();
    }
    std::vector<bool> hot(keys.size());
    for (std::size_t row = 0; row < keys.size(); ++row) {
        const auto e = static_cast<std::size_t>(keys[row].first);
        hot[row] = emitted_W_sr[e] > 0.0 &&
                   radiance_W_m2_sr[row] * whole_m2[e] >= hotFrom * emitted_W_sr[e] &&
                   radiance_W_m2_sr[row] * area_m2[row] >= shareFrom * emitted_W_sr[e];
    }
    return hot;
}

} // namespace irsg
