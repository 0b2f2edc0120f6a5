#include "irsg/atmosphere/SpectraAtmosphere.h"

#include <cmath>
#include <fstream>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using smat::test::refusalOf;
using smat::test::TemporaryFolder;
using testing::HasSubstr;

namespace {

constexpr SpectralRange band{3.0, 5.0};
const Spectrum rising({3.0, 4.0, 5.0}, {0.25, 0.5, 0.75});

SpectraAtmosphereParameters kilometre() {
    SpectraAtmosphereParameters air;
    air.name = "kilometre";
    air.path = AtmosphericPath{500.0, 100.0, 1000.0};
    air.sight = LineOfSight{500.0, std::asin(-0.4), radians(90.0)};
    air.targetAltitude_m = 100.0;
    air.sun = SunPosition{radians(180.0), radians(45.0)};
    air.ambientTemperature_K = 280.0;
    for (const AtmosphereProperty property : allAtmosphereProperties) {
        if (property != AtmosphereProperty::ambientTemperature) {
            air.spectra.emplace(property, rising);
        }
    }
    return air;
}

/// What the file of one row holds, without the row under test.
const std::string comments = "# analysis: radiative\n# atmosphere: haze\n"
                             "# sensor_altitude [m]: 500\n# target_altitude [m]: 100\n"
                             "# range [m]: 1000\n# los_elevation [deg]: -23.5\n"
                             "# sun_azimuth [deg]: 180\n# sun_elevation [deg]: 45\n";

SpectraAtmosphere fromText(const std::string& text) {
    const TemporaryFolder folder;
    std::ofstream(folder / "s.csv") << text;
    return SpectraAtmosphere::fromCsv(folder / "s.csv");
}

} // namespace

TEST(SpectraAtmosphere, AnswersWithItsSpectraForItsGeometry) {
    const SpectraAtmosphere air(kilometre());
    const SunPosition sun = *air.parameters().sun;
    EXPECT_EQ(air.base(), band);
    EXPECT_EQ(air.transmittance(*air.parameters().path, band), rising);
    EXPECT_EQ(air.pathRadiance(*air.parameters().path, sun, band), rising);
    EXPECT_EQ(air.backgroundRadiance(*air.parameters().sight, sun, band), rising);
    EXPECT_EQ(air.solarIrradiance(100.0, sun, band), rising);
    EXPECT_EQ(air.upwardFlux(100.0, sun, band), rising);
    EXPECT_EQ(air.downwardFlux(100.0, sun, band), rising);
    EXPECT_EQ(air.scatteringOpticalDepth(*air.parameters().path, band), rising);
    EXPECT_EQ(air.ambientTemperature_K(100.0), 280.0);
}

TEST(SpectraAtmosphere, SupportsWhatItHasASpectrumOf) {
    SpectraAtmosphereParameters parameters = kilometre();
    parameters.spectra.erase(AtmosphereProperty::upwardFlux);
    parameters.ambientTemperature_K.reset();
    const SpectraAtmosphere air(parameters);
    EXPECT_TRUE(air.accept(band, AtmosphereProperty::transmittance));
    EXPECT_FALSE(air.accept({3.0, 5.001}, AtmosphereProperty::transmittance));
    EXPECT_FALSE(air.supports(AtmosphereProperty::upwardFlux));
    EXPECT_FALSE(air.supports(AtmosphereProperty::ambientTemperature));
    EXPECT_THROW((void)air.upwardFlux(100.0, {}, band), LogicError);
    EXPECT_THROW((void)air.ambientTemperature_K(100.0), LogicError);
    EXPECT_THROW((void)air.transmittance(*parameters.path, {2.0, 5.0}), LogicError);
}

TEST(SpectraAtmosphere, TakesTheFlatAndTheSphericalPathForTheSame) {
    // After 30 km the earth has fallen away by 71 m and the horizon has sunk by 2.4 mrad.
    SpectraAtmosphereParameters parameters = kilometre();
    parameters.path = AtmosphericPath{10.0, 80.6, 30e3};
    parameters.sight = LineOfSight{10.0, 0.0, 0.0};
    const SpectraAtmosphere air(parameters);
    EXPECT_NO_THROW((void)air.transmittance({10.0, 10.0, 30e3}, band));
    EXPECT_NO_THROW((void)air.backgroundRadiance({10.0, -2.35e-3, 0.0}, *parameters.sun, band));
    EXPECT_THROW((void)air.transmittance({10.0, 160.0, 30e3}, band), InputError);
    EXPECT_THROW((void)air.backgroundRadiance({10.0, -3e-3, 0.0}, *parameters.sun, band),
                 InputError);
}

TEST(SpectraAtmosphere, TakesLeftAndRightOfTheSunForTheSame) {
    const SpectraAtmosphere air(kilometre());
    LineOfSight sight = *air.parameters().sight;
    SunPosition sun = *air.parameters().sun;
    sight.azimuth_rad = radians(270.0);
    EXPECT_NO_THROW((void)air.backgroundRadiance(sight, sun, band));
    sight.azimuth_rad = radians(10.0);
    sun.azimuth_rad = radians(280.0);
    EXPECT_NO_THROW((void)air.backgroundRadiance(sight, sun, band));
    sun.azimuth_rad = radians(290.0);
    EXPECT_THROW((void)air.backgroundRadiance(sight, sun, band), InputError);
}

TEST(SpectraAtmosphere, ASunBelowTheHorizonMayStandAnywhereBelow) {
    SpectraAtmosphereParameters parameters = kilometre();
    parameters.sun = SunPosition{0.0, -0.1};
    const SpectraAtmosphere air(parameters);
    EXPECT_NO_THROW((void)air.backgroundRadiance(*parameters.sight, {2.0, -0.5}, band));
    EXPECT_THROW((void)air.backgroundRadiance(*parameters.sight, {0.0, 0.1}, band), InputError);
}

namespace {

struct OtherGeometry {
    const char* name;
    std::function<void(const SpectraAtmosphere&)> ask;
    const char* named;
};

void PrintTo(const OtherGeometry& row, std::ostream* out) {
    *out << row.name;
}

class SpectraAtmosphereOtherGeometry : public testing::TestWithParam<OtherGeometry> {};

} // namespace

TEST_P(SpectraAtmosphereOtherGeometry, IsRefusedByName) {
    const SpectraAtmosphere air(kilometre());
    const std::string refusal = refusalOf([&] { GetParam().ask(air); });
    EXPECT_THAT(refusal, HasSubstr("kilometre: " + std::string(GetParam().named)));
    EXPECT_THAT(refusal, HasSubstr("the one geometry"));
}

INSTANTIATE_TEST_SUITE_P(
    Rows, SpectraAtmosphereOtherGeometry,
    testing::Values(
        OtherGeometry{"sensorAltitude",
                      [](const auto& air) {
                          (void)air.transmittance({502, 100, 1000}, band);
                      },
                      "sensor altitude: found 502 m, expected 500 m to within 1.08 m"},
        OtherGeometry{"targetAltitude",
                      [](const auto& air) {
                          (void)air.transmittance({500, 90, 1000}, band);
                      },
                      "target altitude: found 90 m, expected 100 m"},
        OtherGeometry{"range",
                      [](const auto& air) {
                          (void)air.scatteringOpticalDepth({500, 100, 1001}, band);
                      },
                      "range: found 1001 m, expected 1000 m to within 0.1 m"},
        OtherGeometry{"sunElevation",
                      [](const auto& air) {
                          (void)air.pathRadiance({500, 100, 1000}, {pi, radians(44.0)}, band);
                      },
                      "sun elevation: found 44 deg, expected 45 deg"},
        OtherGeometry{"sunSet",
                      [](const auto& air) {
                          (void)air.solarIrradiance(100, {pi, radians(-1.0)}, band);
                      },
                      "sun elevation: found -1 deg"},
        OtherGeometry{
            "elevation",
            [](const auto& air) {
                (void)air.backgroundRadiance({500, 0.0, radians(90.0)}, {pi, radians(45.0)}, band);
            },
            "elevation of the line of sight: found 0 deg, expected -23.5781784"},
        OtherGeometry{
            "azimuth",
            [](const auto& air) {
                (void)air.backgroundRadiance({500, std::asin(-0.4), pi}, {pi, radians(45.0)}, band);
            },
            "azimuth of the sun from the line of sight: found 0 deg, expected 90 deg"},
        OtherGeometry{"altitudeOfFlux",
                      [](const auto& air) {
                          (void)air.upwardFlux(200, {pi, radians(45.0)}, band);
                      },
                      "target altitude: found 200 m"},
        OtherGeometry{"altitudeOfTemperature",
                      [](const auto& air) { (void)air.ambientTemperature_K(0); },
                      "target altitude: found 0 m"}),
    [](const auto& row) { return row.param.name; });

namespace {

struct BadParameters {
    const char* name;
    std::function<void(SpectraAtmosphereParameters&)> spoil;
    const char* named;
};

void PrintTo(const BadParameters& row, std::ostream* out) {
    *out << row.name;
}

class SpectraAtmosphereBadParameters : public testing::TestWithParam<BadParameters> {};

} // namespace

TEST_P(SpectraAtmosphereBadParameters, AreRefusedByName) {
    SpectraAtmosphereParameters parameters = kilometre();
    GetParam().spoil(parameters);
    EXPECT_THAT(refusalOf([&] { (void)SpectraAtmosphere(parameters); }),
                HasSubstr(GetParam().named));
}

INSTANTIATE_TEST_SUITE_P(
    Rows, SpectraAtmosphereBadParameters,
    testing::Values(
        BadParameters{"noSpectrum", [](auto& air) { air.spectra.clear(); }, "no spectrum"},
        BadParameters{"noPath", [](auto& air) { air.path.reset(); }, "no path"},
        BadParameters{"noSight", [](auto& air) { air.sight.reset(); }, "no line of sight"},
        BadParameters{"noSun", [](auto& air) { air.sun.reset(); }, "no sun"},
        BadParameters{"noTargetAltitude", [](auto& air) { air.targetAltitude_m.reset(); },
                      "no target"},
        BadParameters{"coldAir", [](auto& air) { air.ambientTemperature_K = 0.0; }, "found 0 K"},
        BadParameters{"negativeRadiance",
                      [](auto& air) {
                          air.spectra[AtmosphereProperty::pathRadiance] = Spectrum::constant(-1.0);
                      },
                      "path radiance: found -1"},
        BadParameters{"moreThanAll",
                      [](auto& air) {
                          air.spectra[AtmosphereProperty::transmittance] = Spectrum::constant(1.1);
                      },
                      "transmittance: found 1.1"},
        BadParameters{
            "temperatureAsASpectrum",
            [](auto& air) { air.spectra[AtmosphereProperty::ambientTemperature] = rising; },
            "ambient temperature: found a spectrum"},
        BadParameters{
            "nothingInCommon",
            [](auto& air) {
                air.spectra[AtmosphereProperty::upwardFlux] = Spectrum({8.0, 12.0}, {1.0, 1.0});
            },
            "wavelengths in common"}),
    [](const auto& row) { return row.param.name; });

TEST(SpectraAtmosphereCsv, ReadsWavelengthsThatFallAndThatRise) {
    for (const char* rows :
         {"2000,5,0.5\n2500,4,0.4\n4000,2.5,0.3\n", "4000,2.5,0.3\n2500,4,0.4\n2000,5,0.5\n"}) {
        const SpectraAtmosphere air =
            fromText(comments + "wavenumber [cm-1],wavelength [um],transmittance\n" + rows);
        EXPECT_THAT(air.name(), HasSubstr("haze, spectra of s.csv"));
        EXPECT_EQ(air.base(), (SpectralRange{2.5, 5.0}));
        EXPECT_EQ(air.transmittance({500, 100, 1000}, {2.5, 5.0}),
                  Spectrum({2.5, 4.0, 5.0}, {0.3, 0.4, 0.5}));
    }
}

TEST(SpectraAtmosphereCsv, IsToldFromOtherTablesByItsComment) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.csv") << "# program: smat\n#analysis:radiative\nx\n1\n";
    std::ofstream(folder / "b.csv") << "# name: haze\nwavelength [um]\n# analysis: radiative\n";
    EXPECT_TRUE(SpectraAtmosphere::isSpectraCsv(folder / "a.csv"));
    EXPECT_FALSE(SpectraAtmosphere::isSpectraCsv(folder / "b.csv"));
    EXPECT_FALSE(SpectraAtmosphere::isSpectraCsv(folder / "none.csv"));
}

namespace {

struct BadFile {
    const char* name;
    std::string text;
    const char* named;
};

void PrintTo(const BadFile& row, std::ostream* out) {
    *out << row.name;
}

class SpectraAtmosphereBadFile : public testing::TestWithParam<BadFile> {};

std::string rows(const std::string& text) {
    return comments + "wavelength [um],transmittance\n" + text;
}

} // namespace

TEST_P(SpectraAtmosphereBadFile, IsRefusedWithItsPlace) {
    EXPECT_THAT(refusalOf([&] { (void)fromText(GetParam().text); }), HasSubstr(GetParam().named));
}

INSTANTIATE_TEST_SUITE_P(
    Rows, SpectraAtmosphereBadFile,
    testing::Values(
        BadFile{"empty", "", "no rows"}, BadFile{"oneRow", rows("3,0.5\n"), "1 rows of numbers"},
        BadFile{"word", rows("3,0.5\n4,half\n"), "line 11, column 2: found 'half'"},
        BadFile{"notANumber", rows("3,0.5\n4,nan\n"), "line 11, column 2: found 'nan'"},
        BadFile{"ragged", rows("3,0.5\n4\n"), "line 11: found '1 cells'"},
        BadFile{"turningAxis", rows("3,0.5\n4,0.5\n3.5,0.5\n"), "line 12: found '3.5 um'"},
        BadFile{"doubledWavelength", rows("3,0.5\n3,0.5\n"), "line 11: found '3 um'"},
        BadFile{"wavelengthOfZero", rows("0,0.5\n3,0.5\n"), "line 10, column 1: found '0'"},
        BadFile{"transmittanceAboveOne", rows("3,1.5\n4,0.5\n"), "found '1.5', expected a number "},
        BadFile{"negative", rows("3,-0.5\n4,0.5\n"), "line 10, column 2: found '-0.5'"},
        BadFile{"unknownColumn", comments + "wavelength [um],fog\n3,1\n4,1\n", "found 'fog'"},
        BadFile{"columnTwice",
                comments + "wavelength [um],transmittance,transmittance\n3,1,1\n4,1,1\n",
                "each column once"},
        BadFile{"noWavelength", comments + "transmittance\n1\n1\n", "'wavelength [um]'"},
        BadFile{"noQuantity", comments + "wavelength [um]\n3\n4\n", "no spectrum"},
        BadFile{"wavenumberOfAnotherWavelength",
                comments +
                    "wavenumber [cm-1],wavelength [um],transmittance\n2000,5,1\n2500,4.1,1\n",
                "line 11: found '2500 cm-1'"},
        BadFile{"noGeometry", "# analysis: radiative\nwavelength [um],transmittance\n3,1\n4,1\n",
                "no path"},
        BadFile{"altitudeBelowGround", "# sensor_altitude [m]: -5\n" + rows("3,1\n4,1\n"),
                "line 1: found '-5'"},
        BadFile{"wordForAnAngle", "# sun_elevation [deg]: noon\n" + rows("3,1\n4,1\n"),
                "found 'noon'"},
        BadFile{"elevationBeyondTheZenith", "# los_elevation [deg]: 91\n" + rows("3,1\n4,1\n"),
                "line 1: found '91'"}),
    [](const auto& row) { return row.param.name; });
