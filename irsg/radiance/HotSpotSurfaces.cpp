#include "irsg/radiance/HotSpotSurfaces.h"

#include "irsg/radiance/SceneSampling.h"
#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

/// Marks the drawn rows whose radiance, W m-2 sr-1 or alike, is so much of its object's.
template <typename RadianceOf>
void addHot(const SceneRadiometry& radiometry, const std::vector<Entity>& entities,
            double leastShare, const RadianceOf& radianceOf, std::vector<bool>& hot) {
    const std::vector<SurfaceKey>& keys = radiometry.rows().keys();
    std::vector<double> radiance, area_m2;
    std::vector<double> emitted(entities.size()), whole_m2(entities.size());
    for (std::size_t drawn = 0; drawn < keys.size(); ++drawn) {
        const auto& [entity, codes] = keys[drawn];
        const auto e = static_cast<std::size_t>(entity);
        const auto& uses = entities[e].model->codes();
        const auto use = uses.find(codes);
        area_m2.push_back(use == uses.end() ? 0.0 : use->second.area_m2);
        radiance.push_back(radianceOf(static_cast<int>(drawn)));
        emitted[e] += radiance.back() * area_m2.back();
        whole_m2[e] += area_m2.back();
    }
    for (std::size_t drawn = 0; drawn < keys.size(); ++drawn) {
        const auto e = static_cast<std::size_t>(keys[drawn].first);
        if (emitted[e] > 0.0 && radiance[drawn] * whole_m2[e] >= hotFrom * emitted[e] &&
            radiance[drawn] * area_m2[drawn] >= leastShare * emitted[e])
            hot[drawn] = true;
    }
}

} // namespace

std::vector<bool> hotSpotSurfaces(const SceneRadiometry& radiometry,
                                  const std::vector<Entity>& entities) {
    std::vector<bool> hot(radiometry.rows().keys().size());
    for (std::size_t output = 0; output < radiometry.outputs().size(); ++output)
        addHot(
            radiometry, entities, shareFrom,
            [&](int drawn) { return radiometry.thermal_W_m2_sr(drawn, output); }, hot);
    return hot;
}

std::vector<bool> hotSurfaces(const SceneRadiometry& radiometry,
                              const std::vector<Entity>& entities) {
    constexpr double wavelength_um = 4.0;
    std::vector<bool> hot(radiometry.rows().keys().size());
    const auto radianceOf = [&](int drawn) {
        const SurfaceSpectra& surface = radiometry.surfaces()[static_cast<std::size_t>(drawn)];
        if (surface.isGas || radiometry.rows().isTransparent(drawn) ||
            !(surface.temperature_K > 0.0))
            return 0.0;
        const auto& [entity, codes] = radiometry.rows().keys()[static_cast<std::size_t>(drawn)];
        const auto& scales = entities[static_cast<std::size_t>(entity)].temperatureScale;
        return planckRadiance_W_m2_sr_um(wavelength_um, surface.temperature_K /
                                                            scaleOf(scales, codes.temperature));
    };
    addHot(radiometry, entities, 0.0, radianceOf, hot);
    return hot;
}

} // namespace irsg
