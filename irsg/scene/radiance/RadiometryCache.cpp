#include "irsg/scene/radiance/RadiometryCache.h"

#include <algorithm>

namespace irsg {

std::shared_ptr<EvaluatedScene> RadiometryCache::of(const RadianceTerms& terms,
                                                    const std::vector<Entity>& entities,
                                                    const std::vector<ObjectGeometry>& geometry,
                                                    const std::vector<SampledBand>& bands,
                                                    const Fronts& fronts) {
    Kept key;
    for (std::size_t e = 0; e < entities.size(); ++e) {
        const Entity& entity = entities[e];
        EntityState state = entity.state;
        state.altitude_m = geometry[e].path.targetAltitude_m;
        state.ambient_K = bands.front().air.objects[e].ambient_K;
        state.aspectAngle_rad = 0.0; // what depends on it is evaluated anew
        key.aspects_rad.push_back(geometry[e].aspectAngle_rad);
        key.entities.push_back({entity.model, entity.database, state, entity.fallbackTemperature,
                                entity.fallbackMaterial, entity.temperatureScale,
                                entity.emissivityScale, geometry[e].slices_m});
    }
    for (const SampledBand& band : bands)
        key.bands.push_back({band.sampling, band.outputs, band.air.objects});

    const auto known = std::ranges::find_if(kept_, [&](const Kept& kept) {
        return kept.entities == key.entities && kept.bands == key.bands;
    });
    if (known != kept_.end()) {
        kept_.splice(kept_.begin(), kept_, known);
        EvaluatedScene& scene = *kept_.front().scene;
        if (kept_.front().aspects_rad != key.aspects_rad) {
            scene.radiances.forget(scene.radiometry.turn(entities, geometry, bands));
            kept_.front().aspects_rad = std::move(key.aspects_rad);
        }
        return kept_.front().scene;
    }
    key.scene = std::make_shared<EvaluatedScene>(terms, entities, geometry, bands, fronts);
    kept_.push_front(std::move(key));
    if (kept_.size() > mostKept)
        kept_.pop_back();
    return kept_.front().scene;
}

} // namespace irsg
