#include "gui/atmosphere/AtmospherePreview.h"

#include <memory>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/SmartAdapter.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/tools/RadiativeOutput.h"

namespace smat::gui {
namespace {

constexpr double profileStep_m = 100.0;

} // namespace

AtmosphereSpectra atmosphereSpectra(const AtmospherePreviewQuery& query) {
    const auto air = std::make_shared<const irsg::AtmosphereSmart>(query.parameters,
                                                                   "AtmosphereSmart", query.file);
    irsg::Environment environment;
    environment.add(air);
    environment.sun = query.sun;
    RadiativeRequest request;
    request.quantities = {irsg::AtmosphereProperty::transmittance,
                          irsg::AtmosphereProperty::pathRadiance};
    request.geometry = query.path;
    request.band = air->base();
    const RadiativeOutput output = radiativeOutput(environment, request);
    const auto column = [&](const char* key) {
        const auto& rows = output.table.find(key)->values; // wavelengths fall
        return std::vector<double>(rows.rbegin(), rows.rend());
    };
    return {.wavelength_um = column("wavelength"),
            .transmittance = column("transmittance"),
            .pathRadiance_W_m2_sr_um = column("path_radiance"),
            .meanTransmittance = output.summary.at(0).value,
            .inBandPathRadiance_W_m2_sr = output.summary.at(1).value};
}

AtmosphereProfile atmosphereProfile(const AtmospherePreviewQuery& query) {
    const irsg::Profile profile = irsg::SmartAdapter::profile(query.parameters, query.file);
    AtmosphereProfile column;
    for (double altitude_m = 0.0; altitude_m <= profileTop_m; altitude_m += profileStep_m) {
        const irsg::AtmosphericState air = profile.at(altitude_m);
        column.altitude_km.push_back(1e-3 * altitude_m);
        column.temperature_C.push_back(irsg::celsiusFromKelvin(air.temperature_K));
        column.relativeHumidity_percent.push_back(100.0 * irsg::relativeHumidity(air));
    }
    return column;
}

} // namespace smat::gui
