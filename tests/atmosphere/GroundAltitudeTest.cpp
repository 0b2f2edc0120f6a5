#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/SmartAdapter.h"
#include "irsg/atmosphere/engine/Particles.h"
#include "irsg/core/Errors.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using smat::test::refusalOf;
using testing::HasSubstr;

namespace {

const std::string header = "altitude [m],pressure [hPa],temperature [K],relative_humidity [%]\n";
/// As the sonde of a plateau reports it, above sea level.
const std::string plateau = header + "1155,885,291.5,42\n1500,850,289.1,40\n2500,756,281.2,45\n"
                                     "4000,628,270.4,30\n8000,364,240.1,20\n";

Profile ascentOver(double ground_m, const std::string& text) {
    const auto file = smat::test::writtenFile(smat::test::ownFolder() / "ascent.csv", text);
    return Profile::fromRadiosonde(
        file, Profile::model(ModelAtmosphere::midlatitudeSummer).withGroundAt(ground_m), ground_m);
}

AtmosphereSmartParameters over(double ground_m) {
    AtmosphereSmartParameters parameters;
    parameters.groundAltitude_m = ground_m;
    return parameters;
}

} // namespace

TEST(GroundAltitude, AModelAtmosphereBeginsAtTheGround) {
    const Profile sea = Profile::model(ModelAtmosphere::usStandard1976);
    for (const double ground_m : {0.0, 0.0005, 250.0, 1000.0, 1155.0, 5000.0}) {
        const Profile air = sea.withGroundAt(ground_m);
        EXPECT_EQ(air.levels().front().altitude_m, 0.0);
        EXPECT_NEAR(air.top_m(), sea.top_m() - ground_m, 1e-9);
        for (const double altitude_m : {0.0, 10.0, 845.0, 3000.0, 20e3, 60e3}) {
            const AtmosphericState mine = air.at(altitude_m), its = sea.at(altitude_m + ground_m);
            EXPECT_NEAR(mine.pressure_hPa / its.pressure_hPa, 1.0, 1e-6) << ground_m;
            EXPECT_NEAR(mine.temperature_K, its.temperature_K, 1e-6) << ground_m;
            for (std::size_t gas = 0; gas < gasCount; ++gas) {
                EXPECT_NEAR(mine.moleFraction[gas], its.moleFraction[gas],
                            1e-5 * its.moleFraction[gas]);
            }
        }
    }
    EXPECT_THROW(sea.withGroundAt(-1.0), LogicError);
    EXPECT_THROW(sea.withGroundAt(sea.top_m()), LogicError);
}

TEST(GroundAltitude, AnAscentOfAPlateauIsReadAsItIs) {
    const Profile air = ascentOver(1155.0, plateau);
    EXPECT_EQ(air.at(0.0).pressure_hPa, 885.0);
    EXPECT_EQ(air.at(0.0).temperature_K, 291.5);
    EXPECT_NEAR(relativeHumidity(air.at(0.0)), 0.42, 1e-12);
    EXPECT_NEAR(air.at(2500.0 - 1155.0).temperature_K, 281.2, 1e-9);
    EXPECT_NEAR(air.at(8000.0 - 1155.0).pressure_hPa, 364.0, 1e-9);
    // Over a ground 155 m lower the air below the first row is isothermal.
    EXPECT_EQ(ascentOver(1000.0, plateau).at(0.0).temperature_K, 291.5);
    EXPECT_NEAR(ascentOver(1000.0, plateau).at(0.0).pressure_hPa, 901.3, 0.2);
    // A mountain in it cuts it off.
    const Profile mountain = ascentOver(2000.0, plateau);
    EXPECT_NEAR(mountain.at(0.0).temperature_K, air.at(845.0).temperature_K, 1e-9);
    EXPECT_NEAR(mountain.at(0.0).pressure_hPa, air.at(845.0).pressure_hPa, 1e-9);
    EXPECT_NEAR(mountain.at(500.0).temperature_K, 281.2, 1e-9);

    EXPECT_THAT(refusalOf([] { ascentOver(0.0, plateau); }),
                HasSubstr("ascent.csv: line 2, column 1: found '1155', expected a first altitude "
                          "of at most 1000 m, 1000 m above GroundAltitude"));
    EXPECT_THAT(refusalOf([] { ascentOver(154.0, plateau); }), HasSubstr("at most 1154 m"));
    EXPECT_THAT(
        refusalOf([] { ascentOver(4500.0, header + "1155,885,291.5,42\n1500,850,289.1,40\n"); }),
        HasSubstr("line 3, column 1: found '1500', expected a last altitude above "
                  "GroundAltitude, 4500 m"));
    EXPECT_THAT(
        refusalOf([] { ascentOver(1155.0, header + "1155,885,291.5,42\n1100,850,289.1,40\n"); }),
        HasSubstr("more than 1155 m: altitudes ascend strictly"));
}

TEST(GroundAltitude, AirWithoutAerosolsIsThatOfHigherPathsOverTheSea) {
    AtmosphereSmartParameters high = over(1155.0), low = over(0.0);
    high.aerosols = low.aerosols = 0;
    high.scatteringMode = low.scatteringMode = 1;
    const AtmosphereSmart plateauAir(high), seaAir(low);
    for (const AtmosphericPath& path :
         {AtmosphericPath{10.0, 10.0, 5000.0}, {0.0, 3000.0, 6000.0}, {9000.0, 500.0, 20e3}}) {
        const AtmosphericPath higher{path.sensorAltitude_m + 1155.0, path.targetAltitude_m + 1155.0,
                                     path.range_m};
        const Spectrum mine = plateauAir.transmittance(path, plateauAir.base());
        const Spectrum its = seaAir.transmittance(higher, seaAir.base());
        const Spectrum glow = plateauAir.pathRadiance(path, {}, plateauAir.base());
        const Spectrum itsGlow = seaAir.pathRadiance(higher, {}, seaAir.base());
        const Spectrum below = seaAir.transmittance(path, seaAir.base());
        double difference = 0.0;
        for (const double wavelength_um : {3.2, 3.5, 3.8, 4.1, 4.6, 4.8}) {
            EXPECT_NEAR(mine.at(wavelength_um), its.at(wavelength_um), 3e-4) << wavelength_um;
            EXPECT_NEAR(glow.at(wavelength_um), itsGlow.at(wavelength_um),
                        1e-3 * itsGlow.at(wavelength_um))
                << wavelength_um;
            difference =
                std::max(difference, std::abs(mine.at(wavelength_um) - below.at(wavelength_um)));
        }
        EXPECT_GT(difference, 0.01); // the ground matters
    }
}

TEST(GroundAltitude, AerosolsArePressedTogetherBelowSixKilometres) {
    const auto extinction = [](double ground_m, double altitude_m) {
        double sum = 0.0;
        const AtmosphereSmartParameters parameters = over(ground_m);
        for (const ParticleLayer& layer : particleLayers(SmartAdapter::particleSettings(parameters),
                                                         SmartAdapter::profile(parameters, {}))) {
            sum += layer.extinction550At(altitude_m);
        }
        return sum;
    };
    const double ground_m = 1500.0; // a quarter of six kilometres
    EXPECT_NEAR(extinction(ground_m, 0.0), extinction(0.0, 0.0), 1e-12);
    for (const double altitude_m : {500.0, 1000.0, 3000.0, 5500.0}) {
        EXPECT_NEAR(extinction(ground_m, 0.75 * altitude_m), extinction(0.0, altitude_m),
                    1e-9 * extinction(0.0, 0.0))
            << altitude_m;
    }
    for (const double altitude_m : {6500.0, 9000.0, 18e3, 40e3}) {
        EXPECT_NEAR(extinction(ground_m, altitude_m - ground_m), extinction(0.0, altitude_m),
                    1e-9 * extinction(0.0, altitude_m))
            << altitude_m;
    }
}

TEST(GroundAltitude, AFileWithAPlateauAscentIsAir) {
    const auto folder = smat::test::ownFolder();
    smat::test::writtenFile(folder / "ascent.csv", plateau);
    AtmosphereSmartParameters parameters = over(1155.0);
    parameters.radiosonde = "ascent.csv";
    toKarma(parameters).write(folder / "air.xml");
    const auto air = AtmosphereSmart::fromXml(folder / "air.xml");
    EXPECT_EQ(air->ambientTemperature_K(0.0), 291.5);
    toKarma([&] {
        AtmosphereSmartParameters flat = parameters;
        flat.groundAltitude_m = 0.0;
        return flat;
    }())
        .write(folder / "flat.xml");
    EXPECT_THAT(refusalOf([&] { AtmosphereSmart::fromXml(folder / "flat.xml"); }),
                HasSubstr("GroundAltitude"));
}
