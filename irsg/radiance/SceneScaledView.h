#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "irsg/radiance/ScaledSum.h"
#include "irsg/radiance/ScaledView.h"
#include "irsg/radiance/SceneRadiometry.h"
#include "irsg/radiance/SurfaceRadianceTable.h"
#include "irsg/radiance/ViewGeometry.h"
#include "irsg/radiance/exchange/ScaledLight.h"

namespace irsg {

/// ScaledView of the factors of a view.
///
/// With G the factors of a surface summed over what lies in front of it, a surface adds
///   integral of eps' L_bb(s T) tau G_emission + rho' tau / pi (sum over reflected light E G_E),
/// eps' = min(e eps, 1 - t) and rho' = 1 - t - eps' for the scales s and e. Path radiance, the
/// hidden background and all that transmissivities do are the same in every draw. In a band that is
/// a ScaledSum of each surface; where it has none, and in spectra, each wavelength is looked at.
class SceneScaledView : public ScaledView {
  public:
    /// Of nodes `first` to before `last` of the radiances' sampling: a band, or a spectrum, of
    /// which every node is an output. `nominal` holds the values at scales of 1, which is what the
    /// radiometry must have been made at; `ranges_m` by entity. With `only` of what that entity
    /// sends alone, and `nominal` is its own.
    SceneScaledView(const ViewGeometry& view, const SceneRadiometry& radiometry,
                    const SurfaceRadianceTable& radiances, SceneLight* light, PlanckTable& planck,
                    const std::vector<double>& ranges_m, std::pair<std::size_t, std::size_t> nodes,
                    const std::vector<ScalingInput>& inputs, bool isSpectrum, ScaledValues nominal,
                    std::optional<int> only = {});

    std::size_t size() const override {
        return order_.empty() ? base_.intensity.size() : order_.size();
    }
    void evaluate(std::span<const double> scales, ScaledValues& values) const override {
        evaluate(scales, values, nullptr);
    }
    std::unique_ptr<Memo> memo() const override;
    void evaluate(std::span<const double> scales, ScaledValues& values, Memo* memo) const override;
    /// Puts the values of a spectrum in another order: value i becomes value order[i] of before.
    void reorder(std::vector<std::size_t> order) { order_ = std::move(order); }

  private:
    struct Surface : ScaledSurface {
        ScaledRow inputs;
        std::optional<ScaledSum> sum;
    };
    Surface surfaceOf(const SceneRadiometry& radiometry, int drawn) const;
    void gather(const ViewGeometry& view, const SceneRadiometry& radiometry,
                const SurfaceRadianceTable& radiances, const std::vector<double>& ranges_m,
                std::vector<Surface>& surfaces) const;
    /// By node, from what passes the materials in front: what multiplies the emissivity times
    /// Planck's law, the measured emission's scale or the reflectivity in a term.
    std::vector<double> unitOf(const SurfaceSpectra& surface, const RadianceTerm& term,
                               const AtmosphereSamples& air, std::size_t number,
                               std::vector<double> passed) const;
    /// Sums over the band what can be summed.
    void close(Surface& surface, PlanckTable& planck,
               const std::vector<ScalingInput>& inputs) const;
    void add(const Surface& surface, double scaleT, double scaleE, ScaledValues& values) const;
    /// By surface: what it added at its last few scales, oldest replaced first.
    struct SceneMemo : Memo {
        struct Known {
            double scaleT = 0.0, scaleE = 0.0; // 0: nothing yet; scales are positive
            ScaledPair sum;
        };
        struct OfSurface {
            std::array<Known, 4> known;
            std::size_t oldest = 0;
        };
        std::vector<OfSurface> surfaces;
    };

    std::pair<std::size_t, std::size_t> nodes_;
    std::vector<double> wavelengths_um_;
    bool isSpectrum_;
    std::vector<Surface> surfaces_;
    std::optional<ScaledLight> light_; ///< where surfaces light each other
    ScaledValues base_;                ///< without what the surfaces with an input add
    std::vector<std::size_t> order_;
};

} // namespace irsg
