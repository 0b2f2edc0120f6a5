#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "irsg/signature/Microfacets.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// How a material that is not Lambertian reflects over directions, without a wavelength: a sum over
/// components k of amount s_k(lambda) times f_k(to, from), sr-1, with light that comes from `from`
/// and goes to `to`. albedo(k, cosine) is what f_k reflects of light that comes at that cosine, so
/// reflectance over angle is the sum of s_k times albedo, and emissivity what that and
/// transmissivity leave (Kirchhoff). Which models there are, with their equations and sources:
/// docs/physics.md, directional surfaces.
class SurfaceModel {
  public:
    static constexpr std::size_t mostComponents = 8;
    using Amounts = std::array<double, mostComponents>;

    virtual ~SurfaceModel() = default;
    SurfaceModel(const SurfaceModel&) = delete;
    SurfaceModel& operator=(const SurfaceModel&) = delete;

    std::size_t components() const { return components_; }
    /// Whether component k has a lobe, which sky, ground and sun are reflected in by direction; the
    /// others are diffuse. Those with lobes come first.
    bool hasLobe(std::size_t k) const { return k < lobes_; }
    /// Directional-hemispherical, of a component at an amount of 1; cosine from 0 to 1.
    double albedo(std::size_t k, double cosine) const;
    /// What f integrates to over the hemisphere for light that comes at a cosine: albedos times
    /// amounts where a model sends no more than falls on it, else what its equations say.
    double reflected(const Amounts& amounts, double cosine) const;
    /// What f_k itself integrates to, at an amount of 1: the mean of facetWeight over facets.
    double sent(std::size_t k, double cosine) const;
    /// The mean of the albedo over the hemisphere.
    double meanAlbedo(std::size_t k) const { return meanAlbedos_[k]; }
    /// f_k, sr-1; 0 where either is below the surface. Facets may be spread wider than they are,
    /// as a sample or the sun's disc make lobes.
    virtual double brdf_per_sr(std::size_t k, const SurfaceDirection& to,
                               const SurfaceDirection& from, const SlopeSpread& spread) const = 0;
    double brdf_per_sr(std::size_t k, const SurfaceDirection& to,
                       const SurfaceDirection& from) const {
        return brdf_per_sr(k, to, from, SlopeSpread::of(roughness()));
    }
    double roughness() const { return facets_.roughness(); }

    /// Facets that stand for all of them, in equal shares of their projected area.
    const std::vector<SurfaceDirection>& facets() const { return samples_; }
    /// One of as many, by its number: within its share of the area, and turned about the normal.
    /// `share` and `turn` from 0 to below 1; a smooth surface has one facet.
    SurfaceDirection facet(std::size_t number, double share, double turn) const;
    /// How many of these there are per solid angle, sr-1, as parts of all: the integral over the
    /// hemisphere is 1.
    double facetDensity_per_sr(const SurfaceDirection& facet) const {
        return facets_.density_per_sr(facet, SlopeSpread::of(roughness())) * facet.z;
    }
    /// What one of them sends towards `to` of component k, in parts of the albedo times their
    /// number.
    virtual double facetWeight(std::size_t k, const SurfaceDirection& to,
                               const SurfaceDirection& facet) const;
    /// The same of all components with lobes; of others 0.
    virtual Amounts facetWeights(const SurfaceDirection& to, const SurfaceDirection& facet) const;

    /// The spectra of a material that amounts are made of, in an order of the model's own; they
    /// live as long as the material and its table.
    virtual std::vector<const Spectrum*> inputs(const Material& material) const = 0;
    /// s_k of what those spectra are at a wavelength, where emissivity is `scale` times what it is.
    virtual Amounts amounts(std::span<const double> inputs, double scale) const = 0;
    /// The same of a material at a wavelength.
    Amounts amountsAt(const Material& material, double wavelength_um) const;
    /// What its components follow from.
    const std::vector<double>& key() const { return key_; }

  protected:
    /// `facets`: those of its lobes, or as wide as they are.
    SurfaceModel(Microfacets facets, std::size_t lobes, std::size_t components,
                 std::vector<double> key);

    static constexpr std::size_t albedoIntervals = 128;
    /// Takes albedos at the squares of 0, 1 / albedoIntervals, .. 1 as cosines.
    void setAlbedos(std::size_t k, std::vector<double> albedos);
    /// What lobes send more than the albedos that were taken say, as a factor by the same cosines.
    void setExcess(std::vector<double> factors);
    const Microfacets& microfacets() const { return facets_; }
    /// Amounts whose shape stays where emissivity scales: what all of them reflect over the
    /// hemisphere is then limit - scale (limit - what they do), and 0 at least.
    Amounts scaledReflection(const Amounts& amounts, double limit, double scale) const;

  private:
    static double at(const std::vector<double>& values, double cosine);

    Microfacets facets_;
    std::size_t lobes_, components_;
    std::array<std::vector<double>, mostComponents> albedos_; // by its root, even from 0 to 1
    std::array<double, mostComponents> meanAlbedos_{};
    std::vector<double> excess_; // of lobes, as albedos; empty: 1
    std::vector<SurfaceDirection> samples_;
    std::vector<double> key_;
};

} // namespace irsg
