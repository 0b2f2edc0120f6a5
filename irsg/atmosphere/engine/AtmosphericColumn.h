#pragma once

#include <memory>
#include <vector>

#include "irsg/atmosphere/engine/GasTable.h"
#include "irsg/atmosphere/engine/Particles.h"
#include "irsg/atmosphere/engine/Profile.h"

namespace irsg {

/// The air over one place on the levels of its altitude grid, before any wavelength is chosen.
class AtmosphericColumn {
  public:
    AtmosphericColumn(Profile profile, std::vector<ParticleLayer> particles,
                      std::shared_ptr<const GasTable> gases);

    const std::vector<double>& altitudes_m() const { return altitudes_m_; }
    std::size_t levelCount() const { return altitudes_m_.size(); }
    const AtmosphericState& level(std::size_t level) const { return levels_[level]; }
    const Profile& profile() const { return profile_; }
    const GasTable& gases() const { return *gases_; }

    /// Kinds of particles, and the extinction at 0.55 um of one kind at a level, m-1.
    const std::vector<ParticleLayer>& particles() const { return particles_; }
    double particleExtinction550_per_m(std::size_t kind, std::size_t level) const {
        return particleExtinction_[kind * levelCount() + level];
    }

    /// The layer that holds an altitude (the highest one for the top and beyond), and where in it.
    struct Place {
        std::size_t layer = 0;
        double fraction = 0.0; ///< 0 at the lower level, 1 at the upper
    };
    Place placeOf(double altitude_m) const;

  private:
    Profile profile_;
    std::vector<ParticleLayer> particles_;
    std::shared_ptr<const GasTable> gases_;
    std::vector<double> altitudes_m_;
    std::vector<AtmosphericState> levels_;
    std::vector<double> particleExtinction_; ///< [kind][level]
};

} // namespace irsg
