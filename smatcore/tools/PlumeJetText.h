#pragma once

#include <optional>
#include <string>

#include "irsg/gas/BentJet.h"
#include "irsg/gas/RoundJet.h"

namespace smat {

/// The exhaust of a nozzle, and what bends it.
struct PlumeJet {
    irsg::RoundJet nozzle;
    std::optional<double> up_deg;       ///< of its axis over the horizon: its heat lifts it
    std::optional<double> wind_m_s;     ///< horizontal
    std::optional<double> windFrom_deg; ///< clockwise from the nose, from above; 0: from ahead

    /// Neither wind nor its heat: a RoundJet.
    bool isStraight() const { return !up_deg && !wind_m_s; }
    double elevation_deg() const { return up_deg.value_or(0.0); }
    /// Along the axes of a plume whose nozzle points by elevation_deg() over the horizon: along its
    /// axis, starboard, and upwards across both.
    irsg::BentJet bent() const;
};

/// "D_m=0.3,T_K=800,velocity_m_s=200,fuel_air=0.02" as a jet. These four are needed; others are
/// air_K, coflow_m_s, p_atm, carbon, hydrogen (atoms of the fuel), air_H2O, air_CO2 (mole
/// fractions), soot_ppmv and ends_at, with the values of RoundJet where they are not named, and
/// up_deg (-90 to 90), wind_m_s (0 or above) and wind_from_deg (-360 to 360). Throws InputError
/// with every diagnostic of the text under the name `name`; jets that cannot be are refused by
/// RoundJet::table() and BentJet::sections().
PlumeJet plumeJetFromText(const std::string& text, const std::string& name);

} // namespace smat
