#pragma once

#include <string>
#include <vector>

#include "irsg/gas/GasLayer.h"

namespace smat {

/// One number of a layer, as texts name it and forms show it.
struct GasLayerField {
    const char* key;   ///< "T_K", that of irsg::gasLayerDiagnostics
    const char* label; ///< "Temperature"
    const char* unit;  ///< "K", "" without
    const char* help;
    double step; ///< of the arrow keys in a form
    bool isNeeded = false;
    double& (*of)(irsg::GasLayer& layer) = nullptr;

    double valueIn(irsg::GasLayer layer) const { return of(layer); }
};
/// Those of a layer in the order of its text.
const std::vector<GasLayerField>& gasLayerFields();

/// A layer that examples and forms begin with: exhaust gas of 700 K.
inline constexpr const char* gasLayerExample = "T_K=700,p_atm=1,length_m=0.5,CO2=0.033,H2O=0.033";

/// "T_K=700,p_atm=1,length_m=0.5,CO2=0.033,H2O=0.033" as a layer. Temperature, pressure and length
/// are needed, fractions that are not named are 0. Throws InputError with every diagnostic under
/// the name `name`: unknown keys with the nearest one, keys that are missing or there twice, what
/// is no number, values out of range.
irsg::GasLayer gasLayerFromText(const std::string& text, const std::string& name);
/// The same layer as text, without what is 0.
std::string gasLayerText(const irsg::GasLayer& layer);

} // namespace smat
