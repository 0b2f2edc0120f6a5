#pragma once

#include <string>

#include "irsg/gas/RoundJet.h"

namespace smat {

/// "D_m=0.3,T_K=800,velocity_m_s=200,fuel_air=0.02" as a jet. These four are needed; others are
/// air_K, coflow_m_s, p_atm, carbon, hydrogen (atoms of the fuel), air_H2O, air_CO2 (mole
/// fractions), soot_ppmv and ends_at, with the values of RoundJet where they are not named. Throws
/// InputError with every diagnostic of the text under the name `name`; jets that cannot be are
/// refused by RoundJet::table().
irsg::RoundJet roundJetFromText(const std::string& text, const std::string& name);

} // namespace smat
