#pragma once

#include "irsg/signature/SurfaceModel.h"

namespace irsg {

/// Facets (GGX or Beckmann) that reflect as Fresnel says of them: F0 (1 - p) + F90 p + a q, three
/// components (two where only the reflectivity at normal incidence is known), and what is reflected
/// among them more than once as one more, (1 - E)(1 - E') / (pi (1 - mean E)) with E the albedo of
/// white facets (Kulla and Conty 2017), so that no light is lost. Reciprocal; at amounts of a white
/// surface, which reflects all there is, albedos add up to 1 at every angle.
class FacetModel final : public SurfaceModel {
  public:
    explicit FacetModel(const Material& material);
    FacetModel(FacetDistribution distribution, double roughness, bool usesIndex);
    static std::vector<double> keyOf(const Material& material);

    using SurfaceModel::brdf_per_sr;
    double brdf_per_sr(std::size_t k, const SurfaceDirection& to, const SurfaceDirection& from,
                       const SlopeSpread& spread) const override;
    double facetWeight(std::size_t k, const SurfaceDirection& to,
                       const SurfaceDirection& facet) const override;
    Amounts facetWeights(const SurfaceDirection& to, const SurfaceDirection& facet) const override;
    /// Emissivity along the normal and transmissivity, and n and k where they count.
    std::vector<const Spectrum*> inputs(const Material& material) const override;
    Amounts amounts(std::span<const double> inputs, double scale) const override;
    /// Of the reflectivity at normal incidence F0, what is not transmitted, F90 = 1 - t, and the
    /// dip a of Fresnel's curve.
    Amounts amounts(double normal, double limit, double dip) const;
    bool usesIndex() const { return usesIndex_; }

  private:
    void fillAlbedos();
    std::size_t lobes() const { return usesIndex_ ? 3 : 2; }

    bool usesIndex_;
};

} // namespace irsg
