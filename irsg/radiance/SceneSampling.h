#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "irsg/atmosphere/AtmosphereIdentity.h"
#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiance/SceneAtmosphere.h"
#include "irsg/radiance/WidebandPoints.h"
#include "irsg/radiometry/Band.h"

namespace irsg {

/// What of an answer for something behind an object is seen through air of another depth, by node:
/// the answer times a factor, and an offset, W m-2 sr-1 um-1. See PathDepth.h.
struct ThroughDepth {
    std::vector<double> factor, offset;

    /// Of the values at nodes from `first` on.
    std::vector<double> of(const std::vector<double>& behind, std::size_t first = 0) const;
};

/// A band, several next to each other, or a set of wavelengths, with the nodes that their
/// quantities are summed at and the air of a scene there.
struct SampledBand {
    std::shared_ptr<const SpectralSampling> sampling;
    /// Nodes that are summed together, first and behind the last: all of a band, or one each.
    std::vector<std::pair<std::size_t, std::size_t>> outputs;
    /// Brings a surface's spectrum to the nodes.
    SpectrumSampler sample;
    std::vector<double> areas_um; ///< by output: of the response, or of all wavelengths' interval
    std::string description;      ///< what is to be told of the nodes, or nothing
    SceneAtmosphere air;
    /// By entity and output: every so many-th node of its slices is one that the air is taken at,
    /// and the last is; see sliceBetween. No outputs: every node.
    std::vector<std::vector<int>> sliceSteps;
    bool isSource = false; ///< see ofSource
    /// By entity, of air of another depth before it; none: what is behind is as it is answered.
    std::vector<ThroughDepth> behind;

    /// 1 where every node is taken.
    int sliceStep(std::size_t entity, std::size_t output) const {
        return entity < sliceSteps.size() && !sliceSteps[entity].empty()
                   ? sliceSteps[entity][output]
                   : 1;
    }
    /// The same band of the source: its surfaces are lit as they are, but there is no air before
    /// them and nothing behind them.
    SampledBand ofSource(const RadianceTerms& terms) const;
};

/// A scene as its air sees it.
struct AtmosphereScene {
    const RadianceTerms& terms;
    const std::vector<Entity>& entities;
    const std::vector<ObjectGeometry>& geometry;
    const RenderSettings& settings;
    LineOfSight centre; ///< through the middle of the field
    /// Of the air before objects, in that of the atmosphere, see PathDepth.h, and the object behind
    /// whose air the centre's background is.
    double pathDepth = 1.0;
    std::size_t lookedAt = 0;
};

/// Of an index, as entities have scales of temperatures and emissivities; 1 where there is none.
double scaleOf(const std::map<int, double>& scales, int index);
/// Of the surfaces with a temperature, in steps, K: it decides how fine a quadrature must be.
double coldestOf_K(const AtmosphericQueryCache& answers, const AtmosphereScene& scene);

/// Spectra brought to the nodes of a sampling, kept for the next scene that has them: each view of
/// a sweep is evaluated anew in its own air, with the surfaces of all others. May be asked by
/// several threads at once.
class SampledSpectra {
  public:
    explicit SampledSpectra(std::shared_ptr<const SpectralSampling> sampling)
        : sampling_(std::move(sampling)) {}
    /// SpectralSampling::sampled.
    std::vector<double> of(const Spectrum& spectrum);

  private:
    static constexpr std::size_t mostCached = 64;
    struct CacheEntry {
        Spectrum spectrum;
        std::vector<double> values;
    };
    std::shared_ptr<const SpectralSampling> sampling_;
    std::mutex mutex_; ///< of what follows
    RecentlyUsed<CacheEntry> cache_{mostCached};
};

/// The samplings of bands, kept while their spectra stay what they are.
class SceneSampling {
  public:
    /// In the spectral mode: the nodes that the air has of itself, where light that meets its lines
    /// twice is right; null where it has none.
    std::shared_ptr<const SpectralSampling> nodes(const Environment& environment, const Band& band);
    /// Without: Gauss points between the kinks of all spectra of the scene.
    std::shared_ptr<const SpectralSampling>
    quadrature(AtmosphericQueryCache& answers, const AtmosphereScene& scene, const Band& band);

    /// In the order of the bands. Air that has nodes of itself is asked once for all bands that
    /// ascend and lie next to each other: many narrow bands then cost little more than one as wide
    /// as all of them.
    std::vector<SampledBand> spectral(AtmosphericQueryCache& answers, const AtmosphereScene& scene,
                                      const std::vector<Band>& bands);
    /// In the wideband mode: a node is a quadrature point, and spectra are means over its bin.
    static SampledBand wideband(AtmosphericQueryCache& answers, const AtmosphereScene& scene,
                                const std::shared_ptr<const WidebandPoints>& points);
    /// For spectra: each of the ascending wavelengths is an output.
    static SampledBand wavelengths(AtmosphericQueryCache& answers, const AtmosphereScene& scene,
                                   const std::vector<double>& wavelengths_um);

    /// The air of the scene at the nodes of a band, anew: with the slices that its geometry has.
    static void takeAtmosphere(AtmosphericQueryCache& answers, const AtmosphereScene& scene,
                               SampledBand& band);

  private:
    /// Quadratures that are kept, and their nodes and edges: every range of a sweep through real
    /// air has its own.
    static constexpr std::size_t mostCached = 4096, mostNumbers = std::size_t{1} << 18;
    /// Nodes of the air itself, which are those of a band whatever the range.
    static constexpr std::size_t mostNodesCached = 256;

    struct CacheEntry {
        Band band;
        double coldest_K;
        std::vector<double> edges_um; ///< of the panels: the kinks of all spectra
        std::shared_ptr<const SpectralSampling> sampling;
    };
    RecentlyUsed<CacheEntry> cache_{mostCached};
    struct CachedNodes {
        std::vector<Band> bands;
        AtmosphereIdentity atmospheres;
        std::shared_ptr<const SpectralSampling> sampling;
        std::shared_ptr<SampledSpectra> spectra;
    };
    /// Null where the air has none of itself, or has none for several bands in one.
    const CachedNodes* nodesCached(const Environment& environment, std::vector<Band> bands);
    RecentlyUsed<CachedNodes> cachedNodes_{mostNodesCached};
};

/// The surfaces of a scene, entity by entity, codes ascending; the rows of a drawing.
std::vector<SurfaceKey> surfaceKeys(const std::vector<Entity>& entities);

/// What is known of a surface of a scene before its air: entry, material, state, temperature and
/// scale.
/// LogicError for one without an entry: the scene check names those.
SurfaceInput surfaceInput(const Entity& entity, const IrCodes& codes,
                          const ObjectGeometry& geometry, double ambient_K);

} // namespace irsg
