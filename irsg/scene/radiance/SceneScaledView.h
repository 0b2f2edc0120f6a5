#pragma once

#include <optional>
#include <vector>

#include "irsg/scene/radiance/ProjectedFactors.h"
#include "irsg/scene/radiance/ScaledView.h"
#include "irsg/scene/radiance/SceneRadiometry.h"

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

/// ScaledView of projected factors.
///
/// With G the factors of a surface summed over what lies in front of it, a surface adds
///   integral of eps' L_bb(s T) tau G_thermal + rho' tau / pi (psi_up G_up + psi_down G_down +
///   E_sun G_sun),
/// eps' = min(e eps, 1 - t) and rho' = 1 - t - eps' for the scales s and e. Path radiance, the
/// hidden background and all that transmissivities do are the same in every draw. Where e eps never
/// passes 1 - t the sum is e (f(s) - r1) + r0 with f a ScaleSeries: no integral is left. Elsewhere,
/// and in spectra, each wavelength is looked at.
class SceneScaledView : public ScaledView {
  public:
    /// `nominal` holds the values at scales of 1, which is what `radiometry` must have been made
    /// at. `geometry` tells the range of each object.
    SceneScaledView(const ProjectedFactors& factors, const SceneRadiometry& radiometry,
                    const std::vector<ObjectGeometry>& geometry,
                    const std::vector<ScalingInput>& inputs, bool isSpectrum, ScaledValues nominal);

    std::size_t size() const override {
        return order_.empty() ? base_.intensity.size() : order_.size();
    }
    void evaluate(std::span<const double> scales, ScaledValues& values) const override;
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
    static Surface surfaceOf(const SceneRadiometry& radiometry, std::size_t row);
    void gather(const ProjectedFactors& factors, const SceneRadiometry& radiometry,
                const std::vector<ObjectGeometry>& geometry, std::vector<Surface>& surfaces) const;
    std::vector<Group> groupsOf(const Surface& surface, double mostEmissivity) const;
    void close(Surface& surface, const std::vector<ScalingInput>& inputs) const;
    void add(const Surface& surface, double scaleT, double scaleE, ScaledValues& values) const;

    std::vector<double> wavelengths_um_;
    bool isSpectrum_;
    std::vector<Surface> surfaces_;
    ScaledValues base_; ///< without what the surfaces with an input add
    std::vector<std::size_t> order_;
};

} // namespace irsg
