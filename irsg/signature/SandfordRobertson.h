#pragma once

#include "irsg/signature/SurfaceModel.h"

namespace irsg {

/// Paints after Sandford and Robertson (1985, Infrared reflectance properties of aircraft paints,
/// Proc. IRIS Targets, Backgrounds and Discrimination), in the form of Conant and Iannarilli (2002,
/// Proc. SPIE 4481, 206-215). With i the direction that light comes from, r the one that it goes
/// to, alpha the tilt of the facet half way between them:
///   f = rho_D g(i) g(r) / (pi G^2) + rho_S(i) h(alpha) / (4 pi H(i) cos r)
///   g(theta) = 1 / (1 + b^2 tan^2 theta), G = (1 + b^2 ln b^2 / (1 - b^2)) / (1 - b^2)
///   rho_S(i) = 1 - t - (rho_D + epsilon) g(i) / G
///   h(alpha) = 1 / (e^2 cos^2 alpha + sin^2 alpha)^2, H(i) its integral over reflected directions
///   emissivity(theta) = epsilon g(theta) / G
/// with rho_D(lambda) and epsilon(lambda), which are hemispherical, and b and e, the width of the
/// lobe. It reflects all that is not emitted, and its lobe is not reciprocal.
class SandfordRobertson final : public SurfaceModel {
  public:
    explicit SandfordRobertson(const Material& material);
    static std::vector<double> keyOf(const Material& material);

    using SurfaceModel::brdf_per_sr;
    double brdf_per_sr(std::size_t k, const SurfaceDirection& to, const SurfaceDirection& from,
                       const SlopeSpread& spread) const override;
    /// Emissivity, transmissivity and diffuse reflectivity.
    std::vector<const Spectrum*> inputs(const Material& material) const override;
    Amounts amounts(std::span<const double> inputs, double scale) const override;

    /// g at a cosine.
    double grazing(double cosine) const;
    /// G, the mean of g over the hemisphere.
    double meanGrazing() const { return meanGrazing_; }
    /// H at a cosine.
    static double lobeIntegral(double width, double cosine);

  private:
    /// Lobe of what reflects at grazing angles, lobe of what reflects along the normal, diffuse.
    enum Component : std::size_t { atGrazing, alongNormal, diffuse, count };

    double squaredGrazing_ = 0.0, meanGrazing_ = 1.0;
};

} // namespace irsg
