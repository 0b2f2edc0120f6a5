#pragma once

#include <list>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "irsg/scene/radiance/KindRadiances.h"
#include "irsg/scene/radiance/SceneRadiometry.h"

namespace irsg {

/// A scene's spectra with what was evaluated of them.
struct EvaluatedScene {
    EvaluatedScene(const RadianceTerms& terms, const std::vector<Entity>& entities,
                   const std::vector<ObjectGeometry>& geometry,
                   const std::vector<SampledBand>& bands, const Fronts& fronts)
        : radiometry(terms, entities, geometry, bands), radiances(radiometry, fronts) {}

    SceneRadiometry radiometry;
    KindRadiances radiances;
};

/// Evaluated scenes by all that their spectra depend on: samplings, air, databases, states, scales.
/// Cases of a sweep that differ in geometry alone share one; where measured spectra depend on the
/// aspect their rows are evaluated anew, so that a scene is good until the next one is asked for.
class RadiometryCache {
  public:
    std::shared_ptr<EvaluatedScene> of(const RadianceTerms& terms,
                                       const std::vector<Entity>& entities,
                                       const std::vector<ObjectGeometry>& geometry,
                                       const std::vector<SampledBand>& bands, const Fronts& fronts);

  private:
    struct EntityKey {
        std::shared_ptr<const Model> model;
        std::shared_ptr<const SignatureDatabase> database;
        EntityState state;
        std::optional<int> fallbackTemperature, fallbackMaterial;
        std::map<int, double> temperatureScale, emissivityScale;
        SliceNodes slices_m;
        bool operator==(const EntityKey&) const = default;
    };
    struct BandKey {
        std::shared_ptr<const SpectralSampling> sampling;
        std::vector<std::pair<std::size_t, std::size_t>> outputs;
        std::vector<ObjectAir> objects;
        bool operator==(const BandKey&) const = default;
    };
    struct Kept {
        std::vector<EntityKey> entities;
        std::vector<BandKey> bands;
        std::vector<double> aspects_rad; ///< that `scene` is of now, by entity
        std::shared_ptr<EvaluatedScene> scene;
    };
    static constexpr std::size_t mostKept = 4;

    std::list<Kept> kept_; // latest first
};

} // namespace irsg
