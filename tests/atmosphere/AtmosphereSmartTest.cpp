#include "irsg/atmosphere/AtmosphereSmart.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/atmosphere/Environment.h"
#include "irsg/atmosphere/SmartAdapter.h"
#include "irsg/radiometry/Planck.h"
#include "tests/atmosphere/KarmaSupport.h"
#include "tests/atmosphere/SyntheticAtmosphere.h"

namespace irsg {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

/// Inside the band that the synthetic gas table holds, 9.901 to 10 um.
const SpectralRange band{9.91, 9.99};
const SunPosition day{0.0, 0.6};

AtmosphereSmartParameters parametersOfBand() {
    AtmosphereSmartParameters parameters;
    parameters.baseWavelengthMin_um = 9.905;
    parameters.baseWavelengthMax_um = 9.995;
    return parameters;
}

AtmosphereSmart smart(const AtmosphereSmartParameters& parameters) {
    return AtmosphereSmart(parameters, "smart", {}, syntheticatmosphere::table());
}

TEST(SmartAdapter, ConvertsUnitsAndCodes) {
    AtmosphereSmartParameters parameters;
    parameters.groundTemperature_C = -12.5;
    parameters.resolution_per_cm = 15;
    parameters.aerosolModel = 3;
    parameters.airMass = 6;
    parameters.windSpeed_m_s = 7.0;
    parameters.windSpeedAverage24_m_s = 8.0;
    parameters.windSpeedMeasurementHeight_m = 12.0;
    parameters.visibility_m = 12e3;
    parameters.cloudModel = 3;
    parameters.cloudBaseAltitude_m = 500.0;
    parameters.cloudThickness_m = 300.0;
    parameters.cloudExtinction_per_m = 0.02;
    const AtmosphericModel air = SmartAdapter::atmosphericModel(parameters);
    EXPECT_DOUBLE_EQ(air.groundTemperature_K, 260.65);
    EXPECT_EQ(air.resolution_per_cm, 15);
    EXPECT_EQ(air.scattering, ScatteringMode::twoStream);
    EXPECT_DOUBLE_EQ(air.groundAlbedo.at(2.75), 0.5 * (0.38 + 0.13));
    EXPECT_DOUBLE_EQ(air.groundAlbedo.at(30.0), 0.08);

    const ParticleSettings particles = SmartAdapter::particleSettings(parameters);
    EXPECT_EQ(particles.aerosol, AerosolModel::navyMaritime);
    EXPECT_EQ(particles.airMass, 6);
    EXPECT_EQ(particles.windSpeed_m_s, 7.0);
    EXPECT_EQ(particles.windSpeed24h_m_s, 8.0);
    EXPECT_EQ(particles.windHeight_m, 12.0);
    EXPECT_EQ(particles.visibility_m, 12e3);
    EXPECT_EQ(particles.cloudModel, 3);
    EXPECT_EQ(particles.cloudBase_m, 500.0);
    EXPECT_EQ(particles.cloudThickness_m, 300.0);
    EXPECT_EQ(particles.cloudExtinction_per_m, 0.02);
    EXPECT_EQ(particles.atmosphere, ModelAtmosphere::midlatitudeSummer);
    // The cloud's own mean extinction arrives in the engine's air.
    double cloud_per_m = 0.0;
    for (const ParticleLayer& layer : air.particles) {
        cloud_per_m = std::max(cloud_per_m, layer.extinction550At(650.0));
    }
    EXPECT_NEAR(cloud_per_m, 0.02, 0.02);
    EXPECT_GT(cloud_per_m, 0.01);
}

TEST(SmartAdapter, DropsThePlaceOfACloudThatIsNotThere) {
    AtmosphereSmartParameters parameters;
    parameters.cloudBaseAltitude_m = 500.0;
    parameters.cloudThickness_m = 300.0;
    parameters.cloudExtinction_per_m = 0.02;
    const ParticleSettings particles = SmartAdapter::particleSettings(parameters);
    EXPECT_LT(particles.cloudBase_m, 0.0);
    EXPECT_EQ(particles.cloudThickness_m, 0.0);
    EXPECT_EQ(particles.cloudExtinction_per_m, 0.0);
    EXPECT_NO_THROW(SmartAdapter::atmosphericModel(parameters));
}

TEST(SmartAdapter, TakesTheSeasonOfTheWinterModels) {
    for (int model = 1; model <= 6; ++model) {
        AtmosphereSmartParameters parameters;
        parameters.atmosphereModel = model;
        EXPECT_EQ(SmartAdapter::particleSettings(parameters).winter, model == 3 || model == 5);
    }
}

TEST(SmartAdapter, PassesMeasuredWeatherOnInKelvinAndFractions) {
    AtmosphereSmartParameters parameters;
    parameters.meteoModel = 2;
    parameters.measurementHeight_m = 10.0;
    parameters.temperatureMH_C = 12.0;
    parameters.temperatureALT0_C = 14.0;
    parameters.pressureMH_mbar = 995.0;
    parameters.relativeHumidityMH_percent = 35.0;
    const Profile profile = SmartAdapter::profile(parameters);
    EXPECT_NEAR(profile.at(10.0).temperature_K, 285.15, 1e-9);
    EXPECT_NEAR(profile.at(0.0).temperature_K, 287.15, 1e-9);
    EXPECT_NEAR(profile.at(10.0).pressure_hPa, 995.0, 1e-9);
    EXPECT_NEAR(relativeHumidity(profile.at(10.0)), 0.35, 1e-9);
    parameters.meteoModel = 1;
    EXPECT_NEAR(SmartAdapter::profile(parameters).at(0.0).temperature_K, 294.2, 1e-9);
}

TEST(SmartAdapter, ScalesCarbonDioxideToItsSetting) {
    AtmosphereSmartParameters parameters;
    EXPECT_NEAR(SmartAdapter::profile(parameters).at(0.0).fraction(Gas::CO2), 400e-6, 8e-6);
    parameters.co2_ppmv = 330.0;
    EXPECT_NEAR(SmartAdapter::profile(parameters).at(0.0).fraction(Gas::CO2), 330e-6, 7e-6);
}

TEST(SmartAdapter, SetsAndScalesTheOtherGases) {
    AtmosphereSmartParameters parameters;
    const Profile own = SmartAdapter::profile(parameters);
    parameters.ch4_ppmv = 2.5;
    parameters.n2o_ppmv = 0.0;
    parameters.ozoneScale = 1.4;
    parameters.waterScale = 0.5;
    const Profile profile = SmartAdapter::profile(parameters);
    EXPECT_NEAR(profile.at(0.0).fraction(Gas::CH4), 2.5e-6, 1e-12);
    for (const double altitude_m : {0.0, 3e3, 25e3, 60e3}) {
        const AtmosphericState was = own.at(altitude_m), is = profile.at(altitude_m);
        EXPECT_NEAR(is.fraction(Gas::CH4) / was.fraction(Gas::CH4),
                    2.5e-6 / own.at(0.0).fraction(Gas::CH4), 1e-9);
        EXPECT_EQ(is.fraction(Gas::N2O), 0.0);
        EXPECT_NEAR(is.fraction(Gas::O3) / was.fraction(Gas::O3), 1.4, 1e-9);
        EXPECT_NEAR(is.fraction(Gas::H2O) / was.fraction(Gas::H2O), 0.5, 1e-9);
        EXPECT_EQ(is.temperature_K, was.temperature_K);
    }
    // More water than air can hold is not there.
    parameters.waterScale = 10.0;
    const Profile wet = SmartAdapter::profile(parameters);
    for (const AtmosphericState& air : wet.levels()) {
        EXPECT_LE(relativeHumidity(air),
                  std::max(1.0 + 1e-9, relativeHumidity(own.at(air.altitude_m))));
    }
    EXPECT_NEAR(relativeHumidity(wet.at(0.0)), 1.0, 1e-9);
    EXPECT_THROW((void)own.withScaled(Gas::O3, -1.0), LogicError);
}

TEST(SmartAdapter, LeavesOutAerosolsAndKeepsClouds) {
    AtmosphereSmartParameters parameters;
    EXPECT_FALSE(SmartAdapter::atmosphericModel(parameters).particles.empty());
    parameters.aerosols = 0;
    EXPECT_TRUE(SmartAdapter::atmosphericModel(parameters).particles.empty());
    parameters.cloudModel = 3;
    EXPECT_FALSE(SmartAdapter::atmosphericModel(parameters).particles.empty());
}

// The report allows -40 C at measurement height but no less than -10 C at altitude 0, within 10 C
// of it: nothing below -20 C. Altitude 0 may be as cold here.
TEST(SmartAdapter, TakesMeasurementsOfAColdDay) {
    for (const double measured_C : {-40.0, -31.0, -21.0}) {
        AtmosphereSmartParameters parameters;
        parameters.atmosphereModel = 5;
        parameters.meteoModel = 2;
        parameters.temperatureMH_C = measured_C;
        parameters.temperatureALT0_C = measured_C - 2.0;
        const Profile profile = SmartAdapter::profile(parameters);
        EXPECT_NEAR(profile.at(5.0).temperature_K, measured_C + 273.15, 1e-9);
        EXPECT_NEAR(profile.at(0.0).temperature_K, measured_C + 271.15, 1e-9);
        EXPECT_TRUE(diagnosticsOf(parameters).empty());
    }
}

TEST(SmartAdapter, TakesARadiosondeAscentFromBesideTheFile) {
    const auto folder = ownFolder();
    writtenFile(folder / "ascent.csv", "altitude [m],pressure [hPa],temperature [K],h2o [ppmv]\n"
                                       "0,1013,280,5000\n1000,898,274,4000\n5000,540,250,500\n");
    AtmosphereSmartParameters parameters;
    parameters.radiosonde = "ascent.csv";
    const Profile profile = SmartAdapter::profile(parameters, folder / "air.xml");
    EXPECT_NEAR(profile.at(0.0).temperature_K, 280.0, 1e-9);
    parameters.radiosonde = "other.csv";
    EXPECT_THAT(refusalOf([&] { SmartAdapter::profile(parameters, folder / "air.xml"); }),
                AllOf(HasSubstr("air.xml: parameter Radiosonde"), HasSubstr("other.csv")));
}

TEST(SmartAdapter, RefusesParametersThatCannotBe) {
    AtmosphereSmartParameters parameters;
    parameters.visibility_m = std::nan("");
    parameters.resolution_per_cm = 3;
    EXPECT_THAT(refusalOf([&] { SmartAdapter::atmosphericModel(parameters); }),
                AllOf(HasSubstr("AtmosphereSmart: Visibility: found nan m"),
                      HasSubstr("AtmosphereSmart: Resolution: found 3 cm-1")));
}

TEST(AtmosphereSmart, AnswersWhatItsRadiativeTransferComputes) {
    const AtmosphereSmart air = smart(parametersOfBand());
    const RadiativeTransfer& transfer = air.transfer();
    const NodeSet nodes = transfer.nodesOf(band);
    const AtmosphericPath path{1000.0, 0.0, 3000.0};
    const LineOfSight up{100.0, 0.3, 1.0};
    const auto expect = [&](const Spectrum& found, const std::vector<double>& values) {
        EXPECT_EQ(found, transfer.spectrum(band, values));
        EXPECT_TRUE(found.covers(band));
    };
    expect(air.transmittance(path, band), transfer.transmittance(nodes, path));
    expect(air.pathRadiance(path, day, band), transfer.pathRadiance(nodes, path, day));
    expect(air.backgroundRadiance(up, day, band), transfer.backgroundRadiance(nodes, up, day));
    expect(air.solarIrradiance(5.0, day, band), transfer.solarIrradiance(nodes, 5.0, day));
    expect(air.upwardFlux(5.0, day, band), transfer.upwardFlux(nodes, 5.0, day));
    expect(air.downwardFlux(5.0, day, band), transfer.downwardFlux(nodes, 5.0, day));
    expect(air.scatteringOpticalDepth(path, band), transfer.scatteringOpticalDepth(nodes, path));
    EXPECT_EQ(air.ambientTemperature_K(1234.0), air.air().profile.at(1234.0).temperature_K);
}

TEST(AtmosphereSmart, APathOfNoLengthChangesNothing) {
    const AtmosphereSmart air = smart(parametersOfBand());
    const AtmosphericPath nothing{10.0, 10.0, 0.0};
    EXPECT_EQ(air.transmittance(nothing, band).minimum(), 1.0);
    EXPECT_EQ(air.pathRadiance(nothing, day, band).maximum(), 0.0);
}

TEST(AtmosphereSmart, TheGroundRadiatesAtItsTemperatureFromClose) {
    AtmosphereSmartParameters parameters = parametersOfBand();
    parameters.groundTemperature_C = 50.0;
    parameters.albedoValues = {0.0};
    parameters.albedoWavelengths_um = {10.0};
    const Spectrum seen = smart(parameters).backgroundRadiance({0.1, -1.5, 0.0}, day, band);
    // At the node that is opaque within centimetres one sees air; the wing of the band is clear.
    EXPECT_NEAR(seen.at(band.max_um) / planckRadiance_W_m2_sr_um(band.max_um, 323.15), 1.0, 0.01);
}

TEST(AtmosphereSmart, HoldsItsBaseAndNothingBeyond) {
    const AtmosphereSmart air = smart(parametersOfBand());
    EXPECT_EQ(air.base(), (SpectralRange{9.905, 9.995}));
    EXPECT_TRUE(air.accept(band, AtmosphereProperty::transmittance));
    EXPECT_TRUE(air.accept(air.base(), AtmosphereProperty::transmittance));
    EXPECT_FALSE(air.accept({9.904, 9.99}, AtmosphereProperty::transmittance));
    EXPECT_THROW(air.transmittance({}, {9.904, 9.99}), LogicError);
    EXPECT_THROW(air.upwardFlux(0.0, day, {3.0, 5.0}), LogicError);
    EXPECT_THROW(air.transmittance({-1.0, 0.0, 10.0}, band), InputError);
    EXPECT_THROW(air.solarIrradiance(-1.0, day, band), InputError);
    EXPECT_THROW(air.ambientTemperature_K(std::nan("")), InputError);
    EXPECT_THROW(air.backgroundRadiance({0.0, 3.0, 0.0}, day, band), InputError);
}

TEST(AtmosphereSmart, SingleScatteringHasNoFluxesAndSaysWhy) {
    AtmosphereSmartParameters parameters = parametersOfBand();
    parameters.scatteringMode = 1;
    const auto air =
        std::make_shared<AtmosphereSmart>(parameters, "single", "", syntheticatmosphere::table());
    EXPECT_FALSE(air->supports(AtmosphereProperty::upwardFlux));
    EXPECT_FALSE(air->supports(AtmosphereProperty::downwardFlux));
    EXPECT_TRUE(air->supports(AtmosphereProperty::pathRadiance));
    EXPECT_GT(air->pathRadiance({0.0, 1000.0, 1000.0}, day, band).maximum(), 0.0);
    EXPECT_THROW(air->downwardFlux(0.0, day, band), LogicError);
    Environment environment;
    environment.add(air);
    EXPECT_THAT(
        refusalOf([&] { environment.spectrum(AtmosphericQuery::upwardFlux(0.0, day), band); }),
        AllOf(HasSubstr("single (has no upward flux in ScatteringMode 1"),
              HasSubstr("ScatteringMode 2")));
}

TEST(AtmosphereSmart, ABandThatTheGasTableLacksIsRefused) {
    const AtmosphereSmart air = smart({});
    EXPECT_EQ(air.ambientTemperature_K(0.0), air.air().profile.at(0.0).temperature_K);
    const auto ask = [&] { air.transmittance({}, {3.0, 5.0}); };
    EXPECT_THAT(refusalOf(ask), AllOf(HasSubstr("BaseWavelengthMin"), HasSubstr("3 to 5 um")));
    EXPECT_THAT(refusalOf(ask), HasSubstr("3 to 5 um"));
}

TEST(AtmosphereSmart, IsReadFromItsFileWithRemarks) {
    const auto folder = ownFolder();
    const auto file = writtenFile(folder / "summer.xml", smartXml(numberXml("Visibility", "5000") +
                                                                  numberXml("AirMass", "9")));
    const auto air = loadAtmosphere(file);
    EXPECT_EQ(air->name(), "AtmosphereSmart (summer.xml)");
    EXPECT_EQ(air->base(), (SpectralRange{3.0, 5.0}));
    EXPECT_THAT(air->remarks(), Contains("no AerosolModel: taken as 0"));
    EXPECT_THAT(air->remarks(), Contains(HasSubstr("AirMass 9 has no effect")));
    EXPECT_EQ(AtmosphereSmart::fromXml(file)->parameters().visibility_m, 5000.0);
    EXPECT_THAT(refusalOf([&] {
                    loadAtmosphere(
                        writtenFile(folder / "bad.xml", smartXml(numberXml("AirMass", "0"))));
                }),
                HasSubstr("bad.xml: line 5, parameter AirMass: found 0, expected 1 to 10"));
}

TEST(AtmosphereSmart, TheFilesThatAreShippedAreWhole) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(SMAT_RESOURCES_DIR) / "atmospheres")) {
        if (entry.path().extension() != ".xml") {
            continue;
        }
        const auto air = AtmosphereSmart::fromXml(entry.path());
        EXPECT_THAT(air->remarks(), testing::IsEmpty()) << entry.path();
        KarmaXml document = KarmaXml::read(entry.path());
        toKarma(air->parameters(), document);
        EXPECT_EQ(significant(document.text()), significant(contentOf(entry.path())));
        ++files;
    }
    EXPECT_GE(files, 3);
}

} // namespace
} // namespace irsg
