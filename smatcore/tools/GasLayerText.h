#pragma once

#include <string>

#include "irsg/gas/GasLayer.h"

namespace smat {

/// "T_K=700,p_atm=1,length_m=0.5,CO2=0.033,H2O=0.033" as a layer. Temperature, pressure and length
/// are needed, fractions that are not named are 0. Throws InputError with every diagnostic under
/// the name `name`: unknown keys with the nearest one, keys that are missing or there twice, what
/// is no number, values out of range.
irsg::GasLayer gasLayerFromText(const std::string& text, const std::string& name);
/// The same layer as text, without what is 0.
std::string gasLayerText(const irsg::GasLayer& layer);

} // namespace smat
