#include "irsg/radiance/WidebandAtmosphere.h"

#include <algorithm>
#include <vector>

namespace irsg {

bool hasWidebandAtmosphere(const Environment& environment, const Band& band,
                           const RenderSettings& settings) {
    using enum AtmosphereProperty;
    std::vector<AtmosphereProperty> asked = {transmittance, pathRadiance};
    if (settings.background == BackgroundMode::environment)
        asked.push_back(backgroundRadiance);
    if (settings.sun != ReflectionMode::off || settings.sunDisc)
        asked.push_back(solarIrradiance);
    if (settings.ambientReflection != ReflectionMode::off)
        asked.insert(asked.end(), {upwardFlux, downwardFlux});
    const Atmosphere* air = environment.findWideband(band.range());
    return air != nullptr && std::ranges::all_of(asked, [&](AtmosphereProperty property) {
               return environment.find(band.range(), property) == air;
           });
}

} // namespace irsg
