#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "irsg/geometry/Entity.h"
#include "irsg/radiance/LayerWalk.h"
#include "irsg/radiance/PointSources.h"
#include "irsg/radiance/SurfaceRadianceTable.h"
#include "irsg/radiance/exchange/SceneLight.h"
#include "irsg/render/values/PixelExplanation.h"

namespace irsg {

/// Sums what the samples of one pixel show, surface by surface and term by term, in the first
/// output. (TruthLayers sums the same over surfaces, for all pixels.)
class PixelTerms {
  public:
    /// All must live as long. `light`: between surfaces, or null; `background_W_m2_sr`: behind the
    /// pixel.
    PixelTerms(const SceneRadiometry& radiometry, SurfaceRadianceTable& radiances,
               OccluderStacks& occluderStacks, SceneLight* light, double background_W_m2_sr);

    /// A sample that is `share` of the pixel's area.
    void add(const GeometrySamples& samples, std::size_t sample, double share);
    /// An object that the pixel has as a point at this range.
    void addPoint(const PointGeometry& atUnitDistance, double scale, double range_m);

    /// Near to far, those of most area first.
    std::vector<ExplainedSurface> surfaces(const std::vector<Entity>& entities) const;

  private:
    /// Layer, light alone, drawn row, front of the renderer's.
    using Key = std::tuple<int, bool, int, int>;
    struct Sums {
        double coverage = 0.0, range_m = 0.0, hidden_W_m2_sr = 0.0, between_W_m2_sr = 0.0;
        /// By term: what is drawn, what it makes, and with a factor of 1.
        std::vector<double> drawn, radiance_W_m2_sr, atOne_W_m2_sr;
        int row = 0; ///< the first that was met
    };
    struct KnownSurfaceStack {
        std::vector<double> terms;
        double opacity = 0.0;
        const std::vector<SceneLight::AtReceiver>* light = nullptr;
    };
    const KnownSurfaceStack& knownOf(const SurfaceStackId& kind);
    Sums& sumsOf(const Key& key, int row);
    /// Adds factors of a kind: what `drawn(f)` of each factor f is.
    /// Of a lobe, `coverage` is what stands for it, and counts for radiances alone.
    template <typename Drawn>
    void addKind(const SurfaceStackId& kind, Sums& sums, double coverage, const Drawn& drawn);
    ExplainedSurface explained(const Key& key, const Sums& sums,
                               const std::vector<Entity>& entities) const;
    /// Mean over the band.
    double mean(const std::vector<double>& values) const;

    const SceneRadiometry& radiometry_;
    SurfaceRadianceTable& radiances_;
    OccluderStacks& occluderStacks_;
    SceneLight* light_;
    double background_W_m2_sr_;
    LayerWalk walk_;
    std::map<std::pair<int, int>, KnownSurfaceStack> known_;
    std::map<Key, Sums> sums_;
};

} // namespace irsg
