#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/AtmosphereIdentity.h"
#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiance/EntityKey.h"
#include "irsg/radiance/SceneSampling.h"

namespace irsg {

/// A scene's bands with their nodes and air, sliced where the air changes over an object.
struct SampledScene {
    /// Several bands may be in one. Then their sources, where these are asked for.
    std::vector<SampledBand> bands;
    // By entity: see ObjectGeometry.
    std::vector<SliceNodes> slices_m;
    std::vector<double> atmosphereError, likelyAtmosphereError;
    SharedValues background; ///< see backgroundOf
    std::vector<std::string> providedBy, warnings;

    /// That has an output, counted through all bands.
    const SampledBand& ofOutput(std::size_t output) const;
};

/// The same nodes, slices and air on the way to the objects, of one sampled scene or of two; the
/// second but for what the air itself sends along the way, as about the sun.
bool areAlike(const SampledScene& a, const SampledScene& b);
bool areAlikeButForPathRadiance(const RadianceTerms& terms, const SampledScene& a,
                                const SampledScene& b);

/// Sampled scenes by what they follow from: few numbers, so that cases of a sweep that share their
/// paths find theirs without a look at a spectrum. Aspect and azimuth count only where the air
/// answers by them.
class SampledScenes {
  public:
    /// Samples the bands of a scene whose objects have one slice each, in their order.
    using Sampler =
        std::function<std::vector<SampledBand>(const AtmosphereScene&, const std::vector<Band>&)>;

    /// `scene.geometry` may hold any slices: they come out. With `slices`, by entity, it has these.
    std::shared_ptr<const SampledScene>
    of(AtmosphericQueryCache& answers, const AtmosphereScene& scene, const std::vector<Band>& bands,
       bool withSources, const Sampler& sample, const std::vector<SliceNodes>& slices = {});

  private:
    struct Key {
        AtmosphereIdentity atmospheres;
        std::optional<Spectrum> defaultBackground;
        std::optional<double> defaultAmbient_K;
        std::vector<AtmosphericQueryKey> queries;
        /// The sun, the extent of each object, settings, and which terms are on.
        std::vector<double> numbers;
        std::vector<Band> bands;
        bool withSources = false;
        std::vector<EntityKey> entities;
        std::vector<SliceNodes> slices;
        bool operator==(const Key&) const = default;
    };
    struct CacheEntry {
        Key key;
        std::shared_ptr<const SampledScene> scene;
        std::size_t size; ///< numbers in it
    };
    /// As many as a Monte Carlo analysis has phases and more; of large scenes as many as hold so
    /// many numbers (8 MiB), and the last one.
    static constexpr std::size_t mostCached = 16, mostNumbers = std::size_t{1} << 20;

    static Key keyOf(const AtmosphericQueryCache& answers, const AtmosphereScene& scene,
                     const std::vector<Band>& bands, bool withSources,
                     const std::vector<SliceNodes>& slices);
    static std::shared_ptr<const SampledScene> make(AtmosphericQueryCache& answers,
                                                    const AtmosphereScene& scene,
                                                    const std::vector<Band>& bands,
                                                    bool withSources, const Sampler& sample,
                                                    const std::vector<SliceNodes>& slices);

    RecentlyUsed<CacheEntry> cache_{mostCached};
};

} // namespace irsg
