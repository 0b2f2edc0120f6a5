#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

double Material::reflectivityAt(double wavelength_um) const {
    return 1.0 - emissivity.at(wavelength_um) - transmissivity.at(wavelength_um);
}

} // namespace irsg
