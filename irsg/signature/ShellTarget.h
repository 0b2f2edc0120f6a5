#pragma once

#include "irsg/signature/Fresnel.h"
#include "irsg/signature/SurfaceModel.h"

namespace irsg {

/// The target model of Shell (2005, Polarimetric remote sensing in the visible to near infrared,
/// dissertation, Rochester Institute of Technology) without polarisation: facets of Gaussian slopes
/// (Priest and Germer 2000) under the shadowing and obscuration of Maxwell and Beard, with a
/// diffuse and a volume part as Westlund and Meyer (2002, Graphics Interface, 189-198) have them.
/// With beta the angle to the facet half way and theta its tilt:
///   f = F(beta; n, k) exp(-tan^2 theta / 2 sigma^2) / (8 pi sigma^2 cos^4 theta cos i cos r) SO
///       + rho_D / pi + 2 rho_V / (pi (cos i + cos r))
///   SO = (1 + theta / Omega exp(-2 beta / tau)) / (1 + theta / Omega)
/// The roughness is sqrt(2) sigma. Reciprocal. At grazing angles the lobe has more than all light,
/// as published: there its reflectance, and emissivity with it, is taken to be 1.
class ShellTarget final : public SurfaceModel {
  public:
    explicit ShellTarget(const Material& material);
    /// InputError where n is not known.
    static std::vector<double> keyOf(const Material& material);

    using SurfaceModel::brdf_per_sr;
    double brdf_per_sr(std::size_t k, const SurfaceDirection& to, const SurfaceDirection& from,
                       const SlopeSpread& spread) const override;
    /// Transmissivity, n, k, diffuse and volume reflectivity.
    std::vector<const Spectrum*> inputs(const Material& material) const override;
    Amounts amounts(std::span<const double> inputs, double scale) const override;

    /// SO of the cosines to the facet and of its tilt.
    double shadowing(double cosineToFacet, double cosineOfTilt) const;

  private:
    /// Shapes of Fresnel's curve, diffuse, volume.
    enum Component : std::size_t { diffuse = FresnelShapes::count, volume, count };

    double shadowTau_rad_ = 1.0, shadowOmega_rad_ = 1.0;
};

} // namespace irsg
