#include <array>

#include "irsg/atmosphere/AtmosphereSmartParameters.h"

namespace irsg {

namespace {

using S = AtmosphereSmartParameters;

bool within(double value, double least, double most) {
    return value >= least && value <= most;
}
bool zeroOrWithin(double value, double least, double most) {
    return value == 0.0 || within(value, least, most);
}
/// Anything below 0 (the model's own), or up to `most`.
bool atMost(double value, double most) {
    return value >= -1e9 && value <= most;
}
bool isCloud(double code) {
    return within(code, 0.0, 10.0) || code == 18.0 || code == 19.0;
}
bool isResolution(double code) {
    return code == 1.0 || code == 5.0 || code == 15.0;
}
bool isThickness(double value) {
    return within(value, -1e9, 0.0) || within(value, 1.0, 20e3);
}

constexpr KarmaKind number = KarmaKind::number;

constexpr std::array<SmartCode, 8> aerosolModels = {{{0, "rural"},
                                                     {1, "urban"},
                                                     {2, "maritime"},
                                                     {3, "Navy maritime"},
                                                     {4, "tropospheric"},
                                                     {5, "advective fog"},
                                                     {6, "radiative fog"},
                                                     {7, "desert"}}};
constexpr std::array<SmartCode, 6> atmosphereModels = {{{1, "tropical"},
                                                        {2, "mid-latitude summer"},
                                                        {3, "mid-latitude winter"},
                                                        {4, "sub-arctic summer"},
                                                        {5, "sub-arctic winter"},
                                                        {6, "US standard 1976"}}};
constexpr std::array<SmartCode, 13> cloudModels = {{{0, "none"},
                                                    {1, "cumulus"},
                                                    {2, "altostratus"},
                                                    {3, "stratus"},
                                                    {4, "stratocumulus"},
                                                    {5, "nimbostratus"},
                                                    {6, "rain of 2 mm/h"},
                                                    {7, "rain of 5 mm/h"},
                                                    {8, "rain of 12.5 mm/h"},
                                                    {9, "rain of 25 mm/h"},
                                                    {10, "rain of 75 mm/h"},
                                                    {18, "cirrus"},
                                                    {19, "sub-visual cirrus"}}};
constexpr std::array<SmartCode, 2> irradianceModes = {{{1, "tables"}, {2, "on the fly"}}};
constexpr std::array<SmartCode, 2> meteoModels = {
    {{1, "the model atmosphere"}, {2, "reshaped by measurements"}}};
constexpr std::array<SmartCode, 3> resolutions = {{{1, "fine"}, {5, "usual"}, {15, "coarse"}}};
constexpr std::array<SmartCode, 2> scatteringModes = {{{1, "single"}, {2, "two-stream multiple"}}};
constexpr std::array<SmartCode, 2> aerosolSwitch = {{{0, "none"}, {1, "as the model says"}}};

constexpr std::array report = {
    SmartParameter{"AerosolModel", "", &S::aerosolModel, number,
                   [](double v) { return within(v, 0.0, 7.0); }, "0 to 7",
                   "Aerosol: 0 rural, 1 urban, 2 maritime, 3 Navy maritime, 4 tropospheric, 5 "
                   "advective fog, 6 radiative fog, 7 desert.",
                   SmartGroup::aerosol, aerosolModels},
    SmartParameter{"AirMass", "", &S::airMass, number,
                   [](double v) { return within(v, 1.0, 10.0); }, "1 to 10",
                   "Air mass character of the Navy maritime aerosol (MODTRAN ICSTL): 1 open ocean "
                   "to 10 continental.",
                   SmartGroup::aerosol},
    SmartParameter{"AlbedoValues", "", &S::albedoValues, KarmaKind::vector,
                   [](double v) { return within(v, 0.0, 1.0); },
                   "numbers from 0 to 1, as many as AlbedoWavelengths",
                   "Albedo of the ground; its emissivity is 1 less the albedo.",
                   SmartGroup::ground},
    SmartParameter{"AlbedoWavelengths", "um", &S::albedoWavelengths_um, KarmaKind::vector,
                   [](double v) { return within(v, 0.1, 1000.0); },
                   "ascending numbers from 0.1 to 1000 um",
                   "Wavelengths of the albedo values; the ends hold outside.", SmartGroup::ground},
    SmartParameter{"AtmosphereModel", "", &S::atmosphereModel, number,
                   [](double v) { return within(v, 1.0, 6.0); }, "1 to 6",
                   "1 tropical, 2 mid-latitude summer, 3 mid-latitude winter, 4 sub-arctic summer, "
                   "5 sub-arctic winter, 6 US standard 1976.",
                   SmartGroup::air, atmosphereModels},
    SmartParameter{"BaseWavelengthMax", "um", &S::baseWavelengthMax_um, number,
                   [](double v) { return within(v, 0.2, 40.0); },
                   "0.2 to 40 um, above BaseWavelengthMin", "Upper end of the band.",
                   SmartGroup::computation},
    SmartParameter{"BaseWavelengthMin", "um", &S::baseWavelengthMin_um, number,
                   [](double v) { return within(v, 0.2, 40.0); },
                   "0.2 to 40 um, below BaseWavelengthMax", "Lower end of the band.",
                   SmartGroup::computation},
    SmartParameter{"CloudBaseAltitude", "m", &S::cloudBaseAltitude_m, number,
                   [](double v) { return atMost(v, 20e3); },
                   "negative for the cloud model's own, or 0 to 20000 m",
                   "Cloud base above ground; negative: the cloud model's own.", SmartGroup::cloud},
    SmartParameter{"CloudExtinction", "m-1", &S::cloudExtinction_per_m, number,
                   [](double v) { return atMost(v, 1.0); },
                   "0 or less for the cloud model's own, or up to 1 m-1 (not km-1)",
                   "Extinction of the cloud at 0.55 um, mean over its thickness; 0 or less: not "
                   "scaled.",
                   SmartGroup::cloud},
    SmartParameter{"CloudModel", "", &S::cloudModel, number, isCloud, "0 to 10, 18 or 19",
                   "0 none, 1 cumulus, 2 altostratus, 3 stratus, 4 stratocumulus, 5 nimbostratus; "
                   "rain of 2, 5, 12.5, 25 and 75 mm/h: 6 to 10; 18 cirrus (64 um mode radius), 19 "
                   "sub-visual cirrus (4 um).",
                   SmartGroup::cloud, cloudModels},
    SmartParameter{"CloudThickness", "m", &S::cloudThickness_m, number, isThickness,
                   "0 or less for the cloud model's own, or 1 to 20000 m",
                   "Vertical thickness of the cloud; 0 or less: the cloud model's own.",
                   SmartGroup::cloud},
    SmartParameter{"GroundTemperature", "C", &S::groundTemperature_C, number,
                   [](double v) { return within(v, -100.0, 100.0); }, "-100 to 100 C",
                   "Ground or sea surface temperature.", SmartGroup::ground},
    SmartParameter{"IrradianceMode", "", &S::irradianceMode, number,
                   [](double v) { return within(v, 1.0, 2.0); }, "1 or 2",
                   "1 tables computed beforehand, 2 computed on the fly.", SmartGroup::computation,
                   irradianceModes},
    SmartParameter{"MeasurementHeight", "m", &S::measurementHeight_m, number,
                   [](double v) { return within(v, 2.0, 40.0); }, "2 to 40 m",
                   "Height of the temperature, pressure and humidity measurement; MeteoModel 2 "
                   "only.",
                   SmartGroup::air},
    SmartParameter{"MeteoModel", "", &S::meteoModel, number,
                   [](double v) { return within(v, 1.0, 2.0); }, "1 or 2",
                   "1 the model atmosphere, 2 its lowest kilometre reshaped by the measurements.",
                   SmartGroup::air, meteoModels},
    SmartParameter{"ModelType", "", &S::modelType, KarmaKind::entityType, nullptr,
                   "SMART_ATMOSPHERIC_MODEL", "Kind of the model.", SmartGroup::computation},
    SmartParameter{"PressureMH", "mbar", &S::pressureMH_mbar, number,
                   [](double v) { return within(v, 800.0, 1200.0); }, "800 to 1200 mbar",
                   "Pressure at measurement height; MeteoModel 2 only.", SmartGroup::air},
    SmartParameter{"RelativeHumidityMH", "%", &S::relativeHumidityMH_percent, number,
                   [](double v) { return within(v, 0.0, 100.0); }, "0 to 100 %",
                   "Relative humidity at measurement height; MeteoModel 2 only.", SmartGroup::air},
    SmartParameter{"Resolution", "cm-1", &S::resolution_per_cm, number, isResolution,
                   "1, 5 or 15 cm-1", "Spectral resolution.", SmartGroup::computation, resolutions},
    SmartParameter{"ScatteringMode", "", &S::scatteringMode, number,
                   [](double v) { return within(v, 1.0, 2.0); }, "1 or 2",
                   "1 single scattering, 2 two-stream multiple scattering (needed for clouds and "
                   "fluxes).",
                   SmartGroup::computation, scatteringModes},
    SmartParameter{"TemperatureALT0", "C", &S::temperatureALT0_C, number,
                   [](double v) { return within(v, -50.0, 50.0); }, "-50 to 50 C",
                   "Air temperature at altitude 0, within 10 C of TemperatureMH; MeteoModel 2 "
                   "only.",
                   SmartGroup::air},
    SmartParameter{"TemperatureMH", "C", &S::temperatureMH_C, number,
                   [](double v) { return within(v, -40.0, 40.0); }, "-40 to 40 C",
                   "Air temperature at measurement height; MeteoModel 2 only.", SmartGroup::air},
    SmartParameter{"Visibility", "m", &S::visibility_m, number,
                   [](double v) { return zeroOrWithin(v, 10.0, 300e3); },
                   "0 for the aerosol model's own, or 10 to 300000 m",
                   "Koschmieder visibility; 0: the aerosol model's own.", SmartGroup::aerosol},
    SmartParameter{"WindDirection", "rad", &S::windDirection_rad, number,
                   [](double v) { return within(v, -mostFullTurn_rad, mostFullTurn_rad); },
                   "-2 pi to 2 pi rad",
                   "Wind direction, East of North; the air is the same in all directions, so that "
                   "it has no effect.",
                   SmartGroup::aerosol},
    SmartParameter{"WindSpeed", "m/s", &S::windSpeed_m_s, number,
                   [](double v) { return within(v, 0.1, 30.0); }, "0.1 to 30 m/s",
                   "Wind speed now, for the Navy maritime and desert aerosols.",
                   SmartGroup::aerosol},
    SmartParameter{"WindSpeedAverage24", "m/s", &S::windSpeedAverage24_m_s, number,
                   [](double v) { return within(v, 0.1, 30.0); }, "0.1 to 30 m/s",
                   "Mean wind speed of the last 24 h, for the Navy maritime aerosol.",
                   SmartGroup::aerosol},
    SmartParameter{"WindSpeedMeasurementHeight", "m", &S::windSpeedMeasurementHeight_m, number,
                   [](double v) { return within(v, 2.0, 40.0); }, "2 to 40 m",
                   "Height of the wind measurements.", SmartGroup::aerosol}};
static_assert(report.size() == 27);

bool isPpmvOrOwn(double value) {
    return value < 0.0 ? value >= -1e9 : value <= 1e4;
}
bool isScale(double value) {
    return within(value, 0.0, 100.0);
}

constexpr std::array own = {
    SmartParameter{"Aerosols", "", &S::aerosols, number,
                   [](double v) { return within(v, 0.0, 1.0); }, "0 or 1",
                   "0 leaves out all aerosols, those aloft, too; clouds and rain stay. Not one of "
                   "the report's parameters.",
                   SmartGroup::aerosol, aerosolSwitch},
    SmartParameter{"Ch4_ppmv", "ppmv", &S::ch4_ppmv, number, isPpmvOrOwn,
                   "negative for the model's own, or 0 to 10000 ppmv",
                   "Methane near the ground; its profile is scaled. Not one of the report's "
                   "parameters.",
                   SmartGroup::gases},
    SmartParameter{"Co2_ppmv", "ppmv", &S::co2_ppmv, number,
                   [](double v) { return within(v, 0.0, 1e5); }, "0 to 100000 ppmv",
                   "Carbon dioxide near the ground; 400 where it is not given. Not one of the "
                   "report's parameters.",
                   SmartGroup::gases},
    SmartParameter{"GroundAltitude", "m", &S::groundAltitude_m, number,
                   [](double v) { return within(v, 0.0, 5000.0); }, "0 to 5000 m",
                   "Altitude of the ground above sea level, where model atmospheres and ascents "
                   "begin. All other altitudes are above the ground. Not one of the report's "
                   "parameters.",
                   SmartGroup::ground},
    SmartParameter{"N2o_ppmv", "ppmv", &S::n2o_ppmv, number, isPpmvOrOwn,
                   "negative for the model's own, or 0 to 10000 ppmv",
                   "Nitrous oxide near the ground; its profile is scaled. Not one of the report's "
                   "parameters.",
                   SmartGroup::gases},
    SmartParameter{"OzoneScale", "", &S::ozoneScale, number, isScale, "0 to 100",
                   "Multiplies ozone at all altitudes. Not one of the report's parameters.",
                   SmartGroup::gases},
    SmartParameter{"Radiosonde", "", &S::radiosonde, KarmaKind::string, nullptr,
                   "the path of a CSV file",
                   "A radiosonde ascent in place of AtmosphereModel, which gives what the ascent "
                   "lacks. Not one of the report's parameters.",
                   SmartGroup::air},
    SmartParameter{"WaterScale", "", &S::waterScale, number, isScale, "0 to 100",
                   "Multiplies water vapour at all altitudes, up to saturation; measurements of "
                   "MeteoModel 2 come after it. Not one of the report's parameters.",
                   SmartGroup::gases}};

} // namespace

std::span<const SmartParameter> smartParameters() {
    return report;
}

std::span<const SmartParameter> ownSmartParameters() {
    return own;
}

} // namespace irsg
