#include "irsg/atmosphere/SmartAdapter.h"

#include "irsg/radiometry/Units.h"

namespace irsg {

AtmosphericModel SmartAdapter::atmosphericModel(const AtmosphereSmartParameters& parameters,
                                                const std::filesystem::path& file) {
    if (std::vector<Diagnostic> diagnostics = diagnosticsOf(parameters); !diagnostics.empty()) {
        for (Diagnostic& diagnostic : diagnostics)
            diagnostic.file = file.empty() ? "AtmosphereSmart" : file.string();
        throw InputError(std::move(diagnostics));
    }
    AtmosphericModel air{.profile = profile(parameters, file), .particles = {}};
    air.particles = particleLayers(particleSettings(parameters), air.profile);
    air.groundTemperature_K = kelvinFromCelsius(parameters.groundTemperature_C);
    air.groundAlbedo = groundAlbedo(parameters);
    air.scattering =
        parameters.scatteringMode == 1 ? ScatteringMode::single : ScatteringMode::twoStream;
    air.resolution_per_cm = parameters.resolution_per_cm;
    return air;
}

Profile SmartAdapter::profile(const AtmosphereSmartParameters& parameters,
                              const std::filesystem::path& file) {
    Profile profile = Profile::model(static_cast<ModelAtmosphere>(parameters.atmosphereModel),
                                     parameters.co2_ppmv)
                          .withGroundAt(parameters.groundAltitude_m);
    if (!parameters.radiosonde.empty())
        profile = Profile::fromRadiosonde(
            resolveKarmaPath(parameters.radiosonde, file, "parameter Radiosonde"), profile,
            parameters.groundAltitude_m);
    const auto scale = [&](Gas gas, double factor) {
        if (factor != 1.0)
            profile = profile.withScaled(gas, factor);
    };
    const auto setGround = [&](Gas gas, double ppmv) {
        const double own = profile.at(0.0).fraction(gas);
        if (ppmv >= 0.0 && own > 0.0)
            scale(gas, 1e-6 * ppmv / own);
    };
    setGround(Gas::CH4, parameters.ch4_ppmv);
    setGround(Gas::N2O, parameters.n2o_ppmv);
    scale(Gas::O3, parameters.ozoneScale);
    scale(Gas::H2O, parameters.waterScale);
    if (parameters.meteoModel != 2)
        return profile;
    return profile.adjustedToSurfaceObservation(
        {.height_m = parameters.measurementHeight_m,
         .temperature_K = kelvinFromCelsius(parameters.temperatureMH_C),
         .pressure_hPa = parameters.pressureMH_mbar,
         .relativeHumidity = parameters.relativeHumidityMH_percent / 100.0,
         .temperatureAtZero_K = kelvinFromCelsius(parameters.temperatureALT0_C)});
}

ParticleSettings SmartAdapter::particleSettings(const AtmosphereSmartParameters& parameters) {
    ParticleSettings settings;
    settings.aerosol = parameters.aerosols == 1
                           ? std::optional(static_cast<AerosolModel>(parameters.aerosolModel))
                           : std::nullopt;
    settings.visibility_m = parameters.visibility_m;
    settings.airMass = parameters.airMass;
    settings.windSpeed_m_s = parameters.windSpeed_m_s;
    settings.windSpeed24h_m_s = parameters.windSpeedAverage24_m_s;
    settings.windHeight_m = parameters.windSpeedMeasurementHeight_m;
    settings.ground_m = parameters.groundAltitude_m;
    settings.atmosphere = static_cast<ModelAtmosphere>(parameters.atmosphereModel);
    settings.winter = settings.atmosphere == ModelAtmosphere::midlatitudeWinter ||
                      settings.atmosphere == ModelAtmosphere::subarcticWinter;
    settings.cloudModel = parameters.cloudModel;
    if (parameters.cloudModel != 0) {
        settings.cloudBase_m = parameters.cloudBaseAltitude_m;
        settings.cloudThickness_m = parameters.cloudThickness_m;
        settings.cloudExtinction_per_m = parameters.cloudExtinction_per_m;
    }
    return settings;
}

Spectrum SmartAdapter::groundAlbedo(const AtmosphereSmartParameters& parameters) {
    if (parameters.albedoValues.size() == 1)
        return Spectrum::constant(parameters.albedoValues.front());
    return Spectrum(parameters.albedoWavelengths_um, parameters.albedoValues,
                    Spectrum::Outside::hold, "albedo of the ground");
}

} // namespace irsg
