#pragma once

#include <vector>

#include "irsg/atmosphere/engine/Particles.h"
#include "irsg/atmosphere/engine/Profile.h"

namespace irsg {

/// The altitudes, in m, between which extinction is taken to be linear: from the ground to the top
/// of the profile in steps of 0.2 km that grow to 5 km, with the ends of every kind of particles
/// (two altitudes 1 m apart where they begin or end abruptly) and as many of their other nodes as
/// stay within `mostTransferAltitudes`. Altitudes are at least 0.5 m apart.
///
/// A layer of thickness h whose extinction falls with scale height H gets h^2 / 12 H^2 too much
/// optical depth: 0.1 % for water near the ground, 0.04 % for gases up to 12 km, 0.2 % to 30 km.
std::vector<double> transferAltitudes_m(const Profile& profile,
                                        const std::vector<ParticleLayer>& particles);
inline constexpr std::size_t mostTransferAltitudes = 100;

} // namespace irsg
