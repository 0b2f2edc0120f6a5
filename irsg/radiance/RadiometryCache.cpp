#include "irsg/radiance/RadiometryCache.h"

#include <algorithm>

namespace irsg {

namespace {

std::vector<double> aspectsOf(const std::vector<ObjectGeometry>& geometry) {
    std::vector<double> aspects_rad;
    for (const ObjectGeometry& object : geometry)
        aspects_rad.push_back(object.aspectAngle_rad);
    return aspects_rad;
}

} // namespace

EvaluatedScene::EvaluatedScene(const RadianceTerms& terms, const std::vector<Entity>& entities,
                               const std::vector<ObjectGeometry>& geometry,
                               const std::vector<SampledBand>& bands,
                               const OccluderStacks& occluderStacks)
    : radiometry(terms, entities, geometry, bands),
      radiances(radiometry, occluderStacks),
      planck(radiometry.wavelengths_um()),
      aspects_rad_(aspectsOf(geometry)) {}

EvaluatedScene::EvaluatedScene(const RadianceTerms& terms, const std::vector<Entity>& entities,
                               const std::vector<ObjectGeometry>& geometry,
                               const std::shared_ptr<const SampledScene>& sampled,
                               const OccluderStacks& occluderStacks)
    : EvaluatedScene(terms, entities, geometry, sampled->bands, occluderStacks) {
    along_ = sampled;
}

void EvaluatedScene::turnTo(const std::vector<Entity>& entities,
                            const std::vector<ObjectGeometry>& geometry) {
    std::vector<double> aspects_rad = aspectsOf(geometry);
    if (aspects_rad == aspects_rad_)
        return;
    const std::vector<int> turned = radiometry.turn(entities, geometry);
    radiances.turn(turned);
    if (light && !turned.empty())
        light->turn();
    aspects_rad_ = std::move(aspects_rad);
}

void EvaluatedScene::seeAlong(const std::shared_ptr<const SampledScene>& sampled) {
    if (sampled == along_)
        return;
    if (!along_ || !areAlike(*sampled, *along_)) {
        radiometry.seeAlong(sampled->bands);
        radiances.seeAlong();
    }
    along_ = sampled;
}

std::shared_ptr<EvaluatedScene>
RadiometryCache::of(const RadianceTerms& terms, const std::vector<Entity>& entities,
                    const std::vector<ObjectGeometry>& geometry,
                    const std::shared_ptr<const SampledScene>& sampled,
                    const OccluderStacks& occluderStacks) {
    CacheEntry key;
    for (std::size_t e = 0; e < entities.size(); ++e) {
        key.entities.push_back(EntityKey::of(entities[e]));
        key.altitudes_m.push_back(geometry[e].path.targetAltitude_m);
    }
    CacheEntry* const known = cache_.find([&](const CacheEntry& kept) {
        return kept.entities == key.entities && kept.altitudes_m == key.altitudes_m &&
               areAlikeButForPathRadiance(terms, *kept.scene->along(), *sampled);
    });
    if (known != nullptr) {
        known->scene->turnTo(entities, geometry);
        known->scene->seeAlong(sampled);
        return known->scene;
    }
    key.scene =
        std::make_shared<EvaluatedScene>(terms, entities, geometry, sampled, occluderStacks);
    const std::shared_ptr<EvaluatedScene> scene = cache_.add(std::move(key)).scene;
    forget();
    return scene;
}

void RadiometryCache::forget() {
    std::vector<EntityKey> latest;
    std::size_t ofState = 0, others = 0;
    cache_.letGo([&](const CacheEntry& kept) {
        if (latest.empty())
            latest = kept.entities;
        if (kept.entities == latest)
            return ++ofState > mostOfState;
        const bool isOfSame = std::ranges::equal(
            kept.entities, latest,
            [](const EntityKey& one, const EntityKey& other) { return one.isLike(other); });
        return !isOfSame && ofState + ++others > mostOfState;
    });
}

} // namespace irsg
