#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/Microfacets.h"

namespace irsg {

/// Of each of three parts of all tilts, and of half a ring.
inline constexpr int ringsOfFacets = 32, placesOfFacets = 16;

/// Calls visit(to, facet, weight) for facets of a rough surface that light from above can be sent
/// from towards `to`, at a cosine to the normal above 0 to 1; weights are their projected areas,
/// and add up to 1 over all facets. To 1e-4 of what is smooth over the lobe.
template <typename Visit>
void overFacets(const Microfacets& facets, double cosine, const Visit& visit) {
    const GaussRule& rings = gaussLegendre(ringsOfFacets);
    const GaussRule& places = gaussLegendre(placesOfFacets); // on half of each ring
    const double roughness = facets.roughness();
    const SurfaceDirection to{std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
    // Facets are taken by the tangent of their tilt, roughness x / (1 - x). Up to a tilt of half
    // the elevation of `to` all around send light from above the surface, beyond its complement
    // none does, and between them those that reach so far around the ring.
    const double whole = std::tan(0.5 * std::asin(cosine));
    const double first = whole / (roughness + whole), last = 1.0 / (1.0 + roughness * whole);
    const std::array<double, 4> ends{0.0, first, 0.5 * (first + last), last};
    for (std::size_t part = 0; part + 1 < ends.size(); ++part) {
        const double length = ends[part + 1] - ends[part];
        if (!(length > 0.0))
            continue;
        for (std::size_t ring = 0; ring < rings.nodes.size(); ++ring) {
            const double x = ends[part] + length * rings.nodes[ring];
            const double tangent = roughness * x / (1.0 - x);
            const double z = 1.0 / std::sqrt(1.0 + tangent * tangent), across = tangent * z;
            const double density =
                facets.density_per_sr({across, 0.0, z}, SlopeSpread::of(roughness));
            const double ofRing = density * across * z * z * z * roughness /
                                  ((1.0 - x) * (1.0 - x)) * length * rings.weights[ring];
            if (!(ofRing > 0.0))
                continue;
            const double reach =
                part == 0 ? pi
                          : std::acos(std::clamp(
                                (cosine / (2.0 * z) - cosine * z) / (to.x * across), -1.0, 1.0));
            for (std::size_t place = 0; place < places.nodes.size(); ++place) {
                const double angle = reach * places.nodes[place];
                visit(to, SurfaceDirection{across * std::cos(angle), across * std::sin(angle), z},
                      ofRing * 2.0 * reach * places.weights[place]);
            }
        }
    }
}

} // namespace irsg
