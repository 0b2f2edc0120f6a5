#include "irsg/atmosphere/engine/SolarSpectrum.h"

#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/atmosphere/engine/SolarTable.h"
#include "irsg/radiometry/Errors.h"

namespace irsg {

double solarIrradiance_W_m2_per_cm(double lower_cm, double upper_cm) {
    if (!(lower_cm < upper_cm))
        throw LogicError("the sun was asked for over an interval of no width");
    static const SolarTable sun = SolarTable::read(atmosphereResource("solar.csv"));
    return sun.integral(lower_cm, upper_cm) / (upper_cm - lower_cm);
}

} // namespace irsg
