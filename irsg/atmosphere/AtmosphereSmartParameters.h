#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "irsg/karma/KarmaXml.h"

namespace irsg {

/// The report's 27 parameters of AtmosphereSmart (F15, annex A) in the report's units, and some of
/// our own. Defaults are the report's but for IrradianceMode. Codes are described in
/// smartParameters().
struct AtmosphereSmartParameters {
    int aerosolModel = 0;
    int airMass = 3;
    std::vector<double> albedoValues = {0.71, 0.56, 0.38, 0.13, 0.2, 0.2,
                                        0.2,  0.18, 0.15, 0.12, 0.1, 0.08};
    std::vector<double> albedoWavelengths_um = {1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 8, 10, 12, 14};
    int atmosphereModel = 2;
    double baseWavelengthMax_um = 5.0;
    double baseWavelengthMin_um = 3.0;
    double cloudBaseAltitude_m = -1.0;  ///< negative: the cloud model's own
    double cloudExtinction_per_m = 0.0; ///< 0 or less: not scaled
    int cloudModel = 0;
    double cloudThickness_m = 0.0; ///< 0 or less: the cloud model's own
    double groundTemperature_C = 20.0;
    int irradianceMode =
        2; ///< of the report 1, tables, which are no quicker at ever other altitudes
    double measurementHeight_m = 5.0;
    int meteoModel = 1;
    std::string modelType = "SMART_ATMOSPHERIC_MODEL";
    double pressureMH_mbar = 1013.0;
    double relativeHumidityMH_percent = 50.0;
    int resolution_per_cm = 5; ///< cm-1
    int scatteringMode = 2;
    double temperatureALT0_C = 20.0;
    double temperatureMH_C = 20.0;
    double visibility_m = 0.0; ///< 0: the aerosol model's own
    double windDirection_rad = 0.0;
    double windSpeed_m_s = 5.0;
    double windSpeedAverage24_m_s = 5.0;
    double windSpeedMeasurementHeight_m = 10.0;

    /// Ours: mole fraction of carbon dioxide near the ground; the report's models have 330 ppmv.
    double co2_ppmv = 400.0;
    /// Ours: 0 leaves out all aerosols, to the top of the air; clouds and rain stay.
    int aerosols = 1;
    /// Ours: mole fractions near the ground; negative: the model's or the ascent's own.
    double ch4_ppmv = -1.0;
    double n2o_ppmv = -1.0;
    /// Ours: of the ground above sea level, m. Every other altitude is above the ground.
    double groundAltitude_m = 0.0;
    /// Ours: what ozone and water vapour are multiplied by at all altitudes. Water stays below
    /// saturation.
    double ozoneScale = 1.0;
    double waterScale = 1.0;
    /// Ours: a radiosonde ascent (CSV) in place of AtmosphereModel, which then gives what the
    /// ascent lacks; a path as in resolveKarmaPath, empty for none.
    std::string radiosonde;

    bool operator==(const AtmosphereSmartParameters&) const = default;
};

/// What a parameter is about, in the order in which forms show them.
enum class SmartGroup { air, gases, aerosol, cloud, ground, computation };

/// One value of a parameter that is a code.
struct SmartCode {
    int code;
    std::string_view words; ///< "mid-latitude summer"
};

/// What describes one parameter: reading, writing, checking, forms and the manual use it.
struct SmartParameter {
    using Field =
        std::variant<int AtmosphereSmartParameters::*, double AtmosphereSmartParameters::*,
                     std::vector<double> AtmosphereSmartParameters::*,
                     std::string AtmosphereSmartParameters::*>;

    std::string_view name; ///< the report's
    std::string_view unit; ///< "" where there is none
    Field field;
    KarmaKind kind;
    bool (*allows)(double); ///< each number; null for text
    std::string_view range; ///< in words, with the unit
    std::string_view help;
    SmartGroup group;
    std::span<const SmartCode> codes = {}; ///< all that there are; none where it is no code
};

/// The 27, by name; and our own, which are written only where they differ from their default.
std::span<const SmartParameter> smartParameters();
std::span<const SmartParameter> ownSmartParameters();
/// A value of a parameter as text: "5", "0.71 0.56", "SMART_ATMOSPHERIC_MODEL".
std::string valueText(const SmartParameter& parameter, const AtmosphereSmartParameters& values);

/// Parameters with what a user should know about them: defaults taken for what was missing,
/// parameters that are not known (kept in the document), and settings without effect.
struct SmartReading {
    AtmosphereSmartParameters parameters;
    std::vector<std::string> remarks;
};

/// Each number of one parameter that is out of its range, with its name as position.
std::vector<Diagnostic> rangeDiagnosticsOf(const SmartParameter& parameter,
                                           const AtmosphereSmartParameters& values);
/// Each value out of range and each combination that cannot be, with the parameter's name as
/// position and without a file; empty where all is well. Impossible are: BaseWavelengthMin not
/// below BaseWavelengthMax; albedo values and wavelengths of different number, or wavelengths that
/// do not ascend; ScatteringMode 1 with a cloud; in MeteoModel 2 more than 10 C between
/// TemperatureMH and TemperatureALT0; a cloud whose top is above 20 km.
std::vector<Diagnostic> diagnosticsOf(const AtmosphereSmartParameters& parameters);
/// Settings without effect: measurements in MeteoModel 1, a cloud's place without a cloud, air mass
/// and wind without the aerosol that asks for them.
std::vector<std::string> remarksOn(const AtmosphereSmartParameters& parameters);

/// Throws InputError with file and line for every diagnostic: another type than AtmosphereSmart, a
/// value of another kind than the parameter's, codes that are no integers, and diagnosticsOf().
SmartReading fromKarma(const KarmaXml& document);
/// Writes the parameters into a document; what else stands there is kept.
void toKarma(const AtmosphereSmartParameters& parameters, KarmaXml& document);
/// A document of their own, with each parameter's help as documentation.
KarmaXml toKarma(const AtmosphereSmartParameters& parameters,
                 const std::string& documentation = "Atmosphere with the report's 27 parameters.");

} // namespace irsg
