#pragma once

#include "irsg/signature/Fresnel.h"
#include "irsg/signature/SurfaceModel.h"

namespace irsg {

/// Facets (GGX or Beckmann) that reflect as Fresnel says of them, in FresnelShapes (after Schlick
/// in two shapes, 1 - p and p, where only the reflectivity at normal incidence is known), and what
/// is reflected among them more than once as one more component, (1 - E)(1 - E') / (pi (1 - mean
/// E)) with E the albedo of white facets (Kulla and Conty 2017), so that no light is lost.
/// Reciprocal; at amounts of a white surface, which reflects all there is, albedos add up to 1 at
/// every angle.
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
    /// Of the amounts of shapes, as many as there are lobes: 1 of each is white.
    Amounts amounts(std::span<const double> reflectivities) const;
    bool usesIndex() const { return usesIndex_; }

  private:
    void fillAlbedos();
    static std::size_t lobesOf(bool usesIndex) { return usesIndex ? FresnelShapes::count : 2; }
    std::size_t lobes() const { return lobesOf(usesIndex_); }
    Amounts shapesAt(double cosine) const;

    bool usesIndex_;
};

} // namespace irsg
