#include "irsg/atmosphere/engine/SolarSpectrum.h"

#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/atmosphere/engine/SolarTable.h"
#include "irsg/core/Errors.h"

namespace irsg {

double solarIrradiance_W_m2_per_cm(double lower_per_cm, double upper_per_cm) {
    if (!(lower_per_cm < upper_per_cm))
        throw LogicError("the sun was asked for over an interval of no width");
    static const SolarTable sun = SolarTable::read(atmosphereResource("solar.csv"));
    return sun.integral(lower_per_cm, upper_per_cm) / (upper_per_cm - lower_per_cm);
}

} // namespace irsg
