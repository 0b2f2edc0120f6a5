#include "irsg/radiance/HotSpotSurfaces.h"

namespace irsg {

namespace {

void addHotIn(std::size_t output, const SceneRadiometry& radiometry,
              const std::vector<Entity>& entities, std::vector<bool>& hot) {
    const std::vector<SurfaceKey>& keys = radiometry.rows().keys();
    std::vector<double> radiance_W_m2_sr, area_m2;
    std::vector<double> emitted_W_sr(entities.size()), whole_m2(entities.size());
    for (std::size_t drawn = 0; drawn < keys.size(); ++drawn) {
        const auto& [entity, codes] = keys[drawn];
        const auto e = static_cast<std::size_t>(entity);
        const auto& uses = entities[e].model->codes();
        const auto use = uses.find(codes);
        area_m2.push_back(use == uses.end() ? 0.0 : use->second.area_m2);
        radiance_W_m2_sr.push_back(radiometry.thermal_W_m2_sr(static_cast<int>(drawn), output));
        emitted_W_sr[e] += radiance_W_m2_sr.back() * area_m2.back();
        whole_m2[e] += area_m2.back();
    }
    for (std::size_t drawn = 0; drawn < keys.size(); ++drawn) {
        const auto e = static_cast<std::size_t>(keys[drawn].first);
        if (emitted_W_sr[e] > 0.0 &&
            radiance_W_m2_sr[drawn] * whole_m2[e] >= hotFrom * emitted_W_sr[e] &&
            radiance_W_m2_sr[drawn] * area_m2[drawn] >= shareFrom * emitted_W_sr[e])
            hot[drawn] = true;
    }
}

} // namespace

std::vector<bool> hotSpotSurfaces(const SceneRadiometry& radiometry,
                                  const std::vector<Entity>& entities) {
    std::vector<bool> hot(radiometry.rows().keys().size());
    for (std::size_t output = 0; output < radiometry.outputs().size(); ++output)
        addHotIn(output, radiometry, entities, hot);
    return hot;
}

} // namespace irsg
