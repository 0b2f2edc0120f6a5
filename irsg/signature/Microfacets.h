#pragma once

#include <cstddef>

namespace irsg {

/// A unit vector about a surface: z along the normal, to the side that is seen.
struct SurfaceDirection {
    double x = 0.0, y = 0.0, z = 1.0;
};

inline double dot(const SurfaceDirection& a, const SurfaceDirection& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Half way between two directions that are not opposite.
SurfaceDirection halfway(const SurfaceDirection& a, const SurfaceDirection& b);
/// The mirror image of `direction` about `axis`.
SurfaceDirection mirrored(const SurfaceDirection& direction, const SurfaceDirection& axis);

/// A symmetric matrix of slopes: twice their covariance, for Gaussian ones.
struct SlopeSpread {
    double xx = 0.0, xy = 0.0, yy = 0.0;
    static SlopeSpread of(double roughness) {
        return {roughness * roughness, 0.0, roughness * roughness};
    }
};

/// How the normals of a rough surface's facets are spread about its own.
enum class FacetDistribution {
    ggx,     ///< Trowbridge and Reitz 1975, Walter et al. 2007: long tails
    beckmann ///< Gaussian slopes: Beckmann and Spizzichino 1963
};

/// A rough surface of mirrors of V shape under Smith's masking, correlated by height (Heitz 2014:
/// Understanding the masking-shadowing function in microfacet-based BRDFs, JCGT 3(2)). Knows
/// nothing of what mirrors reflect.
class Microfacets {
  public:
    /// `roughness`: alpha, the root of twice the mean square slope along an axis for Gaussian
    /// slopes; 0.001 to 1.
    Microfacets(FacetDistribution distribution, double roughness)
        : distribution_(distribution), roughness_(roughness) {}

    double roughness() const { return roughness_; }
    /// Facets per solid angle about a direction, sr-1, with slopes of this spread: the integral
    /// over the hemisphere times the cosine to the normal is 1.
    double density_per_sr(const SurfaceDirection& facet, const SlopeSpread& spread) const;
    /// Part of the facets that is seen from both directions, of those that face them.
    double visible(double cosineTo, double cosineFrom) const;
    /// The cosine below which a part `share` (0 to 1) of the projected area of all facets lies.
    double cosineOfShare(double share) const;

  private:
    double masked(double cosine) const; ///< Smith's Lambda

    FacetDistribution distribution_;
    double roughness_;
};

} // namespace irsg
