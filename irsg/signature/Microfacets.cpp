#include "irsg/signature/Microfacets.h"

#include <algorithm>
#include <cmath>

#include "irsg/radiometry/Units.h"

namespace irsg {

SurfaceDirection halfway(const SurfaceDirection& a, const SurfaceDirection& b) {
    const SurfaceDirection sum{a.x + b.x, a.y + b.y, a.z + b.z};
    const double length = std::sqrt(dot(sum, sum));
    return {sum.x / length, sum.y / length, sum.z / length};
}

SurfaceDirection mirrored(const SurfaceDirection& direction, const SurfaceDirection& axis) {
    const double twice = 2.0 * dot(direction, axis);
    return {twice * axis.x - direction.x, twice * axis.y - direction.y,
            twice * axis.z - direction.z};
}

double Microfacets::density_per_sr(const SurfaceDirection& facet, const SlopeSpread& spread) const {
    if (!(facet.z > 0.0))
        return 0.0;
    const double x = facet.x / facet.z, y = facet.y / facet.z, square = facet.z * facet.z;
    const double determinant = spread.xx * spread.yy - spread.xy * spread.xy;
    const double slope =
        (spread.yy * x * x - 2.0 * spread.xy * x * y + spread.xx * y * y) / determinant;
    const double shape = distribution_ == FacetDistribution::ggx
                             ? 1.0 / ((1.0 + slope) * (1.0 + slope))
                             : std::exp(-slope);
    return shape / (pi * std::sqrt(determinant) * square * square);
}

double Microfacets::masked(double cosine) const {
    const double square = cosine * cosine;
    if (!(square < 1.0))
        return 0.0;
    const double slope = roughness_ * roughness_ * (1.0 - square) / square;
    if (distribution_ == FacetDistribution::ggx)
        return 0.5 * (std::sqrt(1.0 + slope) - 1.0);
    const double a = 1.0 / std::sqrt(slope);
    return 0.5 * (std::exp(-a * a) / (a * std::sqrt(pi)) - std::erfc(a));
}

double Microfacets::visible(double cosineTo, double cosineFrom) const {
    return 1.0 / (1.0 + masked(cosineTo) + masked(cosineFrom));
}

double Microfacets::cosineOfShare(double share) const {
    const double alpha = roughness_ * roughness_;
    const double slope = distribution_ == FacetDistribution::ggx ? alpha * share / (1.0 - share)
                                                                 : -alpha * std::log1p(-share);
    return 1.0 / std::sqrt(1.0 + slope);
}

} // namespace irsg
