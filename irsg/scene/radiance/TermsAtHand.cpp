#include "irsg/scene/radiance/TermsAtHand.h"

#include <algorithm>
#include <array>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/ck/KeptCk.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/scene/radiance/WidebandPoints.h"

namespace irsg {

namespace {

/// The air that answers in the wideband mode, where it is that which does in the spectral mode too.
const Atmosphere* widebandAir(const Environment& environment, const Band& band) {
    using enum AtmosphereProperty;
    constexpr std::array asked = {transmittance,   pathRadiance, backgroundRadiance,
                                  solarIrradiance, upwardFlux,   downwardFlux};
    const Atmosphere* air = environment.findWideband(band.range());
    const bool isAll = std::ranges::all_of(asked, [&](AtmosphereProperty property) {
        return environment.find(band.range(), property) == air;
    });
    return isAll ? air : nullptr;
}

} // namespace

TermsAtHand termsAtHand(const Environment& environment, const Band& band,
                        const std::vector<Entity>& entities) {
    const Atmosphere* air = widebandAir(environment, band);
    if (!air)
        return TermsAtHand::unavailable;
    const auto* smart = dynamic_cast<const AtmosphereSmart*>(air); // the only air that keeps terms
    std::vector<Entity> loaded;
    std::ranges::copy_if(entities, std::back_inserter(loaded),
                         [](const Entity& entity) { return entity.model != nullptr; });
    const WidebandSpectra spectra = widebandSpectraOf(loaded);
    return smart && isCkKept(*smart, requestOf(environment, band, spectra))
               ? TermsAtHand::kept
               : TermsAtHand::untrained;
}

} // namespace irsg
