#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "irsg/scene/radiance/KindRadiances.h"
#include "irsg/scene/radiance/ScaledView.h"
#include "irsg/scene/radiance/SceneRadiometry.h"
#include "irsg/scene/radiance/ViewFactors.h"

namespace irsg {

/// A positive smooth function of a scale s on an interval, as a Chebyshev series of its logarithm
/// over 1 / s: Planck's law is nearly a straight line there.
class ScaleSeries {
  public:
    /// A constant.
    explicit ScaleSeries(double constant = 0.0) : constant_(constant) {}
    /// No value where 65 terms do not reach 1e-11 relative, or the function is not positive.
    template <typename Function>
    static std::optional<ScaleSeries> fitted(double least, double most, const Function& function);

    double at(double scale) const;

  private:
    double constant_ = 0.0;
    double middle_ = 0.0, halfWidth_ = 0.0;
    std::vector<double> terms_;
};

/// ScaledView of the factors of a view.
///
/// With G the factors of a surface summed over what lies in front of it, a surface adds
///   integral of eps' L_bb(s T) tau G_emission + rho' tau / pi (sum over reflected light E G_E),
/// eps' = min(e eps, 1 - t) and rho' = 1 - t - eps' for the scales s and e. Path radiance, the
/// hidden background and all that transmissivities do are the same in every draw. Where e eps never
/// passes 1 - t the sum is e (f(s) - r1) + r0 with f a ScaleSeries: no integral is left. Elsewhere,
/// and in spectra, each wavelength is looked at.
class SceneScaledView : public ScaledView {
  public:
    /// Of nodes `first` to before `last` of the radiances' sampling: a band, or a spectrum, of
    /// which every node is an output. `nominal` holds the values at scales of 1, which is what the
    /// radiometry must have been made at; `ranges_m` by entity.
    SceneScaledView(const ViewFactors& view, const SceneRadiometry& radiometry,
                    const KindRadiances& radiances, const std::vector<double>& ranges_m,
                    std::pair<std::size_t, std::size_t> nodes,
                    const std::vector<ScalingInput>& inputs, bool isSpectrum, ScaledValues nominal);

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
    /// What a surface adds to a quantity, in units of intensity and of irradiance.
    struct Pair {
        double intensity = 0.0, irradiance = 0.0;
    };
    /// Per wavelength: multiplies the emission or the reflectivity.
    struct Drive {
        std::vector<double> intensity, irradiance;
    };
    /// Wavelengths at which the scaled emissivity reaches 1 - t at the same scale, `limit`.
    struct Group {
        double limit = 0.0;
        std::vector<std::size_t> wavelengths;
        ScaleSeries emission, emissionOnDetector;
        Pair reflectedLess;
    };
    struct Surface {
        int temperatureInput = -1, emissivityInput = -1;
        double temperature_K = 0.0; ///< 0 for a user-defined spectrum
        // Without integrals: sum over groups of min(e, limit) (f(s) - r) + reflectedWhite, and
        // e times the emission of a user-defined spectrum.
        bool isClosed = false;
        std::vector<Group> groups;
        Pair reflectedWhite, measured;
        // Wavelength by wavelength.
        std::vector<double> emissivity, absorbedAtMost;
        Drive emitted, reflected; ///< `emitted` is the emission itself of a user-defined spectrum
    };
    Surface surfaceOf(const SceneRadiometry& radiometry, int drawn) const;
    void gather(const ViewFactors& view, const SceneRadiometry& radiometry,
                const KindRadiances& radiances, const std::vector<double>& ranges_m,
                std::vector<Surface>& surfaces) const;
    std::vector<Group> groupsOf(const Surface& surface, double mostEmissivity) const;
    void close(Surface& surface, const std::vector<ScalingInput>& inputs) const;
    void add(const Surface& surface, double scaleT, double scaleE, ScaledValues& values) const;
    /// Of a surface without integrals.
    static Pair closedSum(const Surface& surface, double scaleT, double scaleE);
    /// By surface: what it added at its last few scales, oldest replaced first.
    struct SceneMemo : Memo {
        struct Known {
            double scaleT = 0.0, scaleE = 0.0; // 0: nothing yet; scales are positive
            Pair sum;
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
    ScaledValues base_; ///< without what the surfaces with an input add
    std::vector<std::size_t> order_;
};

} // namespace irsg
