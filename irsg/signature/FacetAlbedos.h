#pragma once

#include <cmath>

#include "irsg/radiometry/Units.h"
#include "irsg/signature/Microfacets.h"

namespace irsg {

/// Calls visit(to, facet, weight) for facets of a rough surface that light from above can be sent
/// from towards `to`, at a cosine to the normal from 0 to 1; weights are their projected areas, and
/// add up to 1 over all facets. To 1e-4 of what is smooth over the lobe.
template <typename Visit>
void overFacets(const Microfacets& facets, double cosine, const Visit& visit) {
    constexpr int rings = 160, places = 16; // places on half of each ring
    const double roughness = facets.roughness();
    const SurfaceDirection to{std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
    for (int ring = 0; ring < rings; ++ring) {
        // By the tangent of the facet's tilt, roughness x / (1 - x).
        const double x = (ring + 0.5) / rings;
        const double tangent = roughness * x / (1.0 - x);
        const double z = 1.0 / std::sqrt(1.0 + tangent * tangent), across = tangent * z;
        const double density = facets.density_per_sr({across, 0.0, z}, SlopeSpread::of(roughness));
        const double ofRing =
            density * across * z * z * z * roughness / ((1.0 - x) * (1.0 - x) * rings);
        // Facets that send light from above the surface reach so far around the ring.
        const double last = (cosine / (2.0 * z) - cosine * z) / (to.x * across);
        if (!(last < 1.0) || !(ofRing > 0.0))
            continue;
        const double reach = last > -1.0 ? std::acos(last) : pi;
        for (int place = 0; place < places; ++place) {
            const double angle = reach * (place + 0.5) / places;
            visit(to, SurfaceDirection{across * std::cos(angle), across * std::sin(angle), z},
                  ofRing * 2.0 * reach / places);
        }
    }
}

} // namespace irsg
