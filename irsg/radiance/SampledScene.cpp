#include "irsg/radiance/SampledScene.h"

#include <algorithm>
#include <functional>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/radiance/AtmosphereSlices.h"
#include "irsg/radiance/PathDepth.h"
#include "irsg/radiance/SceneRadiometry.h"

namespace irsg {

namespace {

std::size_t sizeOf(const SampledScene& scene) {
    std::size_t numbers = 0;
    for (const SampledBand& band : scene.bands)
        for (const ObjectAtmosphere& object : band.air.objects)
            for (const AtmosphereSamples& node : object.nodes)
                numbers +=
                    band.sampling->size() *
                    (1 + static_cast<std::size_t>(std::ranges::count_if(
                             node.light, [](const SharedValues& v) { return v != nullptr; })));
    return numbers;
}

} // namespace

const SampledBand& SampledScene::ofOutput(std::size_t output) const {
    for (const SampledBand& band : bands) {
        if (output < band.outputs.size())
            return band;
        output -= band.outputs.size();
    }
    throw LogicError("a scene was asked for an output that it has not");
}

namespace {

template <typename Compare>
bool areAlike(const SampledScene& a, const SampledScene& b, const Compare& compareAir) {
    return &a == &b ||
           (a.slices_m == b.slices_m &&
            std::ranges::equal(
                a.bands, b.bands, [&](const SampledBand& one, const SampledBand& two) {
                    return one.sampling == two.sampling && one.outputs == two.outputs &&
                           one.isSource == two.isSource && one.sliceSteps == two.sliceSteps &&
                           std::ranges::equal(one.air.objects, two.air.objects, compareAir);
                }));
}

} // namespace

bool areAlike(const SampledScene& a, const SampledScene& b) {
    return areAlike(a, b, std::equal_to<ObjectAtmosphere>());
}

bool areAlikeButForPathRadiance(const RadianceTerms& terms, const SampledScene& a,
                                const SampledScene& b) {
    static const auto any = std::make_shared<const std::vector<double>>();
    const auto withAny = [&](ObjectAtmosphere air) {
        for (AtmosphereSamples& node : air.nodes)
            for (std::size_t k = 0; k < node.light.size(); ++k)
                if (terms.terms[k].isAlongPath() && node.light[k])
                    node.light[k] = any;
        return air;
    };
    return areAlike(a, b, [&](const ObjectAtmosphere& one, const ObjectAtmosphere& two) {
        return withAny(one) == withAny(two);
    });
}

SampledScenes::Key SampledScenes::keyOf(const AtmosphericQueryCache& answers,
                                        const AtmosphereScene& scene,
                                        const std::vector<Band>& bands, bool withSources,
                                        const std::vector<SliceNodes>& slices) {
    const Environment& environment = answers.environment();
    const RenderSettings& settings = scene.settings;
    Key key{AtmosphereIdentity(environment),
            environment.defaultBackground,
            environment.defaultAmbient_K,
            atmosphereQueries(environment, scene.terms, scene.geometry, settings, scene.centre),
            {environment.sun.azimuth_rad, environment.sun.elevation_rad,
             environment.sun.distance_au, settings.atmosphereSliceFrom, settings.background_W_m2_sr,
             static_cast<double>(settings.background), static_cast<double>(settings.mode),
             settings.widebandError, static_cast<double>(settings.referenceTransmittance),
             scene.pathDepth, static_cast<double>(scene.lookedAt)},
            bands,
            withSources,
            {},
            slices};
    for (const RadianceTerm& term : scene.terms.terms)
        key.numbers.push_back(term.isOn(settings) ? 1.0 : 0.0);
    for (const ObjectGeometry& object : scene.geometry)
        key.numbers.insert(key.numbers.end(), {object.nearest_m, object.farthest_m});
    // Of the states the nodes depend on the coldest alone, and the air on none.
    key.numbers.push_back(coldestOf_K(answers, scene));
    for (const Entity& entity : scene.entities) {
        key.entities.push_back(EntityKey::of(entity));
        key.entities.back().state = {};
    }
    return key;
}

std::shared_ptr<const SampledScene> SampledScenes::make(AtmosphericQueryCache& answers,
                                                        const AtmosphereScene& scene,
                                                        const std::vector<Band>& bands,
                                                        bool withSources, const Sampler& sample,
                                                        const std::vector<SliceNodes>& slices) {
    std::vector<ObjectGeometry> geometry = scene.geometry;
    for (ObjectGeometry& object : geometry)
        object.slices_m.clear();
    const AtmosphereScene own{scene.terms, scene.entities, geometry, scene.settings, scene.centre};
    auto made = std::make_shared<SampledScene>();
    made->bands = sample(own, bands);
    for (SampledBand& band : made->bands)
        band.sliceSteps.resize(geometry.size());
    bool isSliced = false;
    for (std::size_t e = 0; e < geometry.size(); ++e) {
        if (slices.empty())
            planSlicesOf(answers, made->bands, e, scene.settings, geometry[e]);
        else
            geometry[e].slices_m = slices[e];
        isSliced = isSliced || geometry[e].slices_m.size() > 1;
        made->slices_m.push_back(geometry[e].slices_m);
        made->atmosphereError.push_back(geometry[e].atmosphereError);
        made->likelyAtmosphereError.push_back(geometry[e].likelyAtmosphereError);
    }
    for (SampledBand& band : made->bands) {
        if (isSliced)
            SceneSampling::takeAtmosphere(answers, own, band);
        addProvider(made->providedBy, band.air.providedBy);
        appendUnique(made->warnings, band.air.warnings);
        // Nodes and slices are those of the atmosphere, whatever the depth.
        deepenPaths(answers, scene, band);
    }
    const std::size_t seen = made->bands.size();
    for (std::size_t k = 0; withSources && k < seen; ++k)
        made->bands.push_back(made->bands[k].ofSource(scene.terms));
    made->background = backgroundOf(made->bands, scene.settings);
    return made;
}

std::shared_ptr<const SampledScene> SampledScenes::of(AtmosphericQueryCache& answers,
                                                      const AtmosphereScene& scene,
                                                      const std::vector<Band>& bands,
                                                      bool withSources, const Sampler& sample,
                                                      const std::vector<SliceNodes>& slices) {
    cache_.letGo([](const CacheEntry& kept) { return kept.key.atmospheres.isGone(); });
    Key key = keyOf(answers, scene, bands, withSources, slices);
    if (const CacheEntry* known =
            cache_.find([&](const CacheEntry& kept) { return kept.key == key; }))
        return known->scene;
    auto made = make(answers, scene, bands, withSources, sample, slices);
    const std::size_t size = sizeOf(*made);
    const CacheEntry& latest = cache_.add({std::move(key), std::move(made), size});
    std::size_t numbers = 0;
    cache_.letGo([&](const CacheEntry& kept) {
        numbers += kept.size;
        return &kept != &latest && numbers > mostNumbers;
    });
    return latest.scene;
}

} // namespace irsg
