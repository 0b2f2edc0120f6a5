#pragma once

#include <string>

#include "irsg/radiance/AtmosphericQueryCache.h"
#include "irsg/radiometry/Band.h"

namespace irsg {

/// How much a path scatters in a band, and who said so.
struct PathScattering {
    double opticalDepth = 0.0; ///< mean over the response, >= 0
    std::string providedBy;
    bool fromTransmittance = false; ///< by the report's eq. 10: absorption counts as scattering
};

/// The scattering optical depth along a path: of an AtmosphereScatteringLUT that knows it, else of
/// the first atmosphere that does, else -ln(Int T R / Int R) of the transmittance (report eq. 10).
/// InputError where nobody knows either.
PathScattering scatteringAlong(AtmosphericQueryCache& answers, const AtmosphericPath& path,
                               const Band& band);

} // namespace irsg
