#include "irsg/atmosphere/engine/AtmosphericColumn.h"

#include "irsg/atmosphere/engine/AltitudeGrid.h"
#include "irsg/core/Interpolation.h"

namespace irsg {

AtmosphericColumn::AtmosphericColumn(Profile profile, std::vector<ParticleLayer> particles,
                                     std::shared_ptr<const GasTable> gases)
    : profile_(std::move(profile)),
      particles_(std::move(particles)),
      gases_(std::move(gases)),
      altitudes_m_(transferAltitudes_m(profile_, particles_)) {
    for (const double altitude_m : altitudes_m_)
        levels_.push_back(profile_.at(altitude_m));
    for (const ParticleLayer& kind : particles_)
        for (const double altitude_m : altitudes_m_)
            particleExtinction_.push_back(kind.extinction550At(altitude_m));
}

AtmosphericColumn::Place AtmosphericColumn::placeOf(double altitude_m) const {
    const Bracket at = bracket(altitudes_m_, altitude_m);
    return {at.below, at.fraction};
}

} // namespace irsg
