#include "irsg/atmosphere/Vacuum.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

using namespace irsg;

namespace {

const SpectralRange whole{0.2, 40.0};
const SunPosition noon{0.0, 1.0};

} // namespace

TEST(Vacuum, IsClearAndDarkAtEveryRange) {
    const Vacuum vacuum;
    for (const double range_m : {0.0, 1.0, 1e7}) {
        const AtmosphericPath path{100.0, 0.0, range_m};
        EXPECT_EQ(vacuum.transmittance(path, whole), Spectrum::constant(1.0));
        EXPECT_EQ(vacuum.pathRadiance(path, noon, whole), Spectrum::constant(0.0));
    }
    for (const double elevation_rad : {-0.5 * pi, -0.1, 0.0, 0.1, 0.5 * pi}) {
        EXPECT_EQ(vacuum.backgroundRadiance({10.0, elevation_rad, 0.0}, noon, whole),
                  Spectrum::constant(0.0));
    }
    EXPECT_EQ(vacuum.upwardFlux(0.0, noon, whole), Spectrum::constant(0.0));
    EXPECT_EQ(vacuum.downwardFlux(1e4, noon, whole), Spectrum::constant(0.0));
}

TEST(Vacuum, SupportsAllButATemperature) {
    const Vacuum vacuum;
    for (const AtmosphereProperty property : allAtmosphereProperties) {
        EXPECT_EQ(vacuum.accept(whole, property),
                  property != AtmosphereProperty::ambientTemperature);
    }
    EXPECT_THROW((void)vacuum.ambientTemperature_K(0.0), LogicError);
    EXPECT_FALSE(vacuum.accept({0.199, 40.0}, AtmosphereProperty::transmittance));
}

TEST(Vacuum, SunIsABlackBodyOf5772KelvinUnderItsNominalSolidAngle) {
    const Spectrum sun = Vacuum().solarIrradiance(0.0, noon, whole);
    EXPECT_TRUE(sun.covers(whole));
    for (double wavelength_um = 0.2; wavelength_um <= 40.0; wavelength_um *= 1.0123) {
        const double expected = 6.794e-5 * planckRadiance_W_m2_sr_um(wavelength_um, 5772.0);
        EXPECT_NEAR(sun.at(wavelength_um) / expected, 1.0, 1e-4) << wavelength_um << " um";
    }
}

TEST(Vacuum, SunGivesTheSolarConstantInTotal) {
    // Nominal total solar irradiance 1361 W m-2 (IAU 2015 resolution B3); 0.2 to 40 um hold all but
    // a fifth of a percent of the black body.
    const Spectrum sun = extraterrestrialSolarIrradiance(whole);
    const Spectrum* const factors[] = {&sun};
    const double sigma = 5.670374419e-8;
    const double total = sigma * std::pow(5772.0, 4) * std::pow(6.957e8 / 149597870700.0, 2);
    EXPECT_NEAR(total, 1361.0, 0.5);
    const double expected = bandRadiance_W_m2_sr(Band::topHat(0.2, 40.0), 5772.0) * pi *
                            std::pow(6.957e8 / 149597870700.0, 2);
    EXPECT_NEAR(integrateProduct(factors, whole) / expected, 1.0, 1e-6);
    EXPECT_NEAR(expected / total, 1.0, 3e-3);
}

TEST(Vacuum, SunBelowTheHorizonOfTheAltitudeIsExactlyZero) {
    const auto at = [](double altitude_m, double elevation_rad) {
        return Vacuum().solarIrradiance(altitude_m, {1.0, elevation_rad}, whole).at(4.0);
    };
    EXPECT_NEAR(at(0.0, 0.0) / at(0.0, 1.0), 0.5, 1e-12);
    EXPECT_EQ(at(1e4, radians(-2.9)), at(0.0, 1.0));
    EXPECT_EQ(at(1e4, radians(-3.5)), 0.0);
    for (const double elevation_rad : {-0.005, -0.1, -0.5 * pi}) {
        EXPECT_EQ(Vacuum().solarIrradiance(0.0, {1.0, elevation_rad}, whole),
                  Spectrum::constant(0.0));
    }
    EXPECT_GT(Vacuum().solarIrradiance(0.0, {1.0, 0.5 * pi}, whole).maximum(), 0.0);
}

TEST(Vacuum, BeingAskedBeyondItsBaseIsOurFault) {
    EXPECT_THROW((void)Vacuum().transmittance({}, {0.19, 5.0}), LogicError);
    EXPECT_THROW((void)Vacuum().transmittance({}, {3.0, 40.1}), LogicError);
    EXPECT_THROW((void)Vacuum().transmittance({}, {5.0, 3.0}), LogicError);
}

TEST(Vacuum, RefusesPlacesBelowGroundAndRangesThatAreNone) {
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const Vacuum vacuum;
    for (const AtmosphericPath& path :
         {AtmosphericPath{-1.0, 0.0, 1.0}, AtmosphericPath{0.0, -1.0, 1.0},
          AtmosphericPath{0.0, 0.0, -1.0}, AtmosphericPath{0.0, 0.0, infinity},
          AtmosphericPath{0.0, 0.0, notANumber}, AtmosphericPath{notANumber, 0.0, 1.0}}) {
        EXPECT_THROW((void)vacuum.transmittance(path, whole), InputError);
        EXPECT_THROW((void)vacuum.pathRadiance(path, noon, whole), InputError);
    }
    EXPECT_THROW((void)vacuum.backgroundRadiance({-1.0, 0.1, 0.0}, noon, whole), InputError);
    EXPECT_THROW((void)vacuum.backgroundRadiance({0.0, 1.6, 0.0}, noon, whole), InputError);
    EXPECT_THROW((void)vacuum.backgroundRadiance({0.0, notANumber, 0.0}, noon, whole), InputError);
    EXPECT_THROW((void)vacuum.solarIrradiance(-1.0, noon, whole), InputError);
}
