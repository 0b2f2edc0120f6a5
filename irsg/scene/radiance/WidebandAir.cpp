#include "irsg/scene/radiance/WidebandAir.h"

#include <algorithm>
#include <array>

namespace irsg {

bool hasWidebandAir(const Environment& environment, const Band& band) {
    using enum AtmosphereProperty;
    constexpr std::array asked = {transmittance,   pathRadiance, backgroundRadiance,
                                  solarIrradiance, upwardFlux,   downwardFlux};
    const Atmosphere* air = environment.findWideband(band.range());
    return air != nullptr && std::ranges::all_of(asked, [&](AtmosphereProperty property) {
               return environment.find(band.range(), property) == air;
           });
}

} // namespace irsg
