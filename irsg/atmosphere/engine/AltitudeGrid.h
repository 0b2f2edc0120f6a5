#pragma once

#include <vector>

#include "irsg/atmosphere/engine/Particles.h"
#include "irsg/atmosphere/engine/Profile.h"

namespace irsg {

/// The altitudes, in m, between which extinction is taken to be linear: from the ground to the top
/// of the profile in steps of 0.2 km that grow to 5 km, with the ends of every kind of particles
/// (two altitudes 1 m apart where they begin or end abruptly), the levels of the profile where
/// temperature or gases bend, and as many of the particles' other nodes as stay within
/// `mostTransferAltitudes`. Altitudes are at least 0.5 m apart.
///
/// Bends are levels that a straight line between the altitudes beside them misses by more than
/// `transferTemperatureTolerance_K`, or by more than `transferAmountTolerance` in the logarithm of
/// a mole fraction (of those above 1e-8). Above `transferTolerancePressure_hPa`, where there is
/// less air, both grow as 1 / pressure. The level that is missed by most is taken first
/// (Douglas-Peucker); below that pressure, layers whose temperature changes by more than 10 K/km
/// are then divided into steps of `transferTemperatureStep_K`. So an ascent of thousands of levels
/// keeps its inversions and its dry layers, and costs no more than 1.6 times a model atmosphere,
/// which has neither (76 altitudes). Of an ascent with too many bends the smallest are left out.
///
/// A layer of thickness h whose extinction falls with scale height H gets h^2 / 12 H^2 too much
/// optical depth: 0.1 % for water near the ground, 0.04 % for gases up to 12 km, 0.2 % to 30 km.
std::vector<double> transferAltitudes_m(const Profile& profile,
                                        const std::vector<ParticleLayer>& particles);
inline constexpr std::size_t mostTransferAltitudes = 120;
inline constexpr double transferTemperatureTolerance_K = 0.1;
inline constexpr double transferTemperatureStep_K = 3.0;
inline constexpr double transferAmountTolerance = 0.02;
inline constexpr double transferTolerancePressure_hPa = 300.0;

} // namespace irsg
