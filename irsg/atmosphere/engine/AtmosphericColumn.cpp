#include "irsg/atmosphere/engine/AtmosphericColumn.h"

#include <algorithm>

#include "irsg/atmosphere/engine/AltitudeGrid.h"

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
    const double z = std::clamp(altitude_m, altitudes_m_.front(), altitudes_m_.back());
    const auto above = std::ranges::upper_bound(altitudes_m_, z);
    const auto upper =
        std::clamp<std::ptrdiff_t>(above - altitudes_m_.begin(), 1, std::ssize(altitudes_m_) - 1);
    const auto layer = static_cast<std::size_t>(upper - 1);
    return {layer, (z - altitudes_m_[layer]) / (altitudes_m_[layer + 1] - altitudes_m_[layer])};
}

} // namespace irsg
