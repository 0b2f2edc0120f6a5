#pragma once

#include "irsg/signature/ReflectanceTable.h"
#include "irsg/signature/SurfaceModel.h"

namespace irsg {

/// A measured table, a component for each of its wavelengths, linear between them and clamped
/// beyond. A BRDF reflects as it was measured, from the incidence of the table to its reflection,
/// and its integral is its reflectance over angle. Of directional-hemispherical reflectance alone,
/// rho(theta), the least that is reciprocal and reflects as much at every angle is taken,
///   f = rho(i) rho(r) / (pi mean rho).
/// Transmissivity is the material's; emissivity is what both leave.
class TabulatedModel final : public SurfaceModel {
  public:
    explicit TabulatedModel(const Material& material);
    /// InputError where there is no table.
    static std::vector<double> keyOf(const Material& material);

    using SurfaceModel::brdf_per_sr;
    double brdf_per_sr(std::size_t k, const SurfaceDirection& to, const SurfaceDirection& from,
                       const SlopeSpread& spread) const override;
    /// Transmissivity, and how much each wavelength of the table counts.
    std::vector<const Spectrum*> inputs(const Material& material) const override;
    Amounts amounts(std::span<const double> inputs, double scale) const override;

  private:
    ReflectanceTable table_;
};

} // namespace irsg
