#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {
namespace {

/// Air of the shipped tables over a band, at 15 cm-1 and computed on the fly.
AtmosphereSmart atmosphereOver(const SpectralRange& base, int scatteringMode = 2) {
    AtmosphereSmartParameters parameters;
    parameters.baseWavelengthMin_um = base.min_um;
    parameters.baseWavelengthMax_um = base.max_um;
    parameters.resolution_per_cm = 15;
    parameters.irradianceMode = 2;
    parameters.scatteringMode = scatteringMode;
    return AtmosphereSmart(parameters);
}

const SunPosition day{0.3, 0.7};
const SunPosition night{0.0, -0.5};

void expectSound(const Spectrum& spectrum, double most, const std::string& what) {
    for (const double value : spectrum.values()) {
        EXPECT_TRUE(std::isfinite(value)) << what;
        EXPECT_GE(value, 0.0) << what;
        EXPECT_LE(value, most) << what;
    }
}

double bandOf(const Spectrum& spectrum, const SpectralRange& band) {
    const Spectrum* const factors[] = {&spectrum};
    return integrateProduct(factors, band);
}

TEST(HardCases, BothEndsOfTheSpectrumAreAnswered) {
    const AtmosphereSmart air = atmosphereOver({0.2, 40.0});
    for (const SpectralRange& end : {SpectralRange{0.2, 0.205}, SpectralRange{38.0, 40.0}}) {
        const std::string what = numberText(end.min_um) + " um";
        const AtmosphericPath path{100.0, 2000.0, 5000.0};
        const LineOfSight sky{100.0, 0.4, 0.0};
        expectSound(air.transmittance(path, end), 1.0, what);
        expectSound(air.pathRadiance(path, day, end), 1e4, what);
        expectSound(air.backgroundRadiance(sky, day, end), 1e4, what);
        expectSound(air.solarIrradiance(2000.0, day, end), 1e4, what);
        expectSound(air.upwardFlux(2000.0, day, end), 1e4, what);
        expectSound(air.downwardFlux(2000.0, day, end), 1e4, what);
        expectSound(air.scatteringOpticalDepth(path, end), 1e4, what);
    }
}

TEST(HardCases, AnOpaqueBandRadiatesAsTheAirAtTheSensor) {
    const SpectralRange band{4.24, 4.28};
    const AtmosphereSmart air = atmosphereOver({4.2, 4.4});
    const AtmosphericPath path{0.0, 0.0, 50e3};
    expectSound(air.transmittance(path, band), 1e-30, "transmittance");
    // Across a bin, whose nodes are not all at its centre, Planck's radiance changes by 4 %.
    const Spectrum radiance = air.pathRadiance(path, night, band);
    const double temperature_K = air.ambientTemperature_K(0.0);
    for (std::size_t i = 0; i < radiance.values().size(); ++i) {
        EXPECT_NEAR(radiance.values()[i] /
                        planckRadiance_W_m2_sr_um(radiance.wavelengths_um()[i], temperature_K),
                    1.0, 5e-3);
    }
}

TEST(HardCases, NoRangeIsNoAirAndACentimetreKeepsItsDigits) {
    const SpectralRange band{10.0, 10.3};
    const AtmosphereSmart air = atmosphereOver({9.9, 10.4});
    const Spectrum transmittance = air.transmittance({500.0, 500.0, 0.0}, band);
    // The weights of a bin are floats that add up to 1.
    EXPECT_THAT(transmittance.values(), testing::Each(testing::DoubleNear(1.0, 1e-6)));
    const Spectrum radiance = air.pathRadiance({500.0, 500.0, 0.0}, day, band);
    EXPECT_THAT(radiance.values(), testing::Each(0.0));
    const double one = bandOf(air.pathRadiance({500.0, 500.0, 0.01}, night, band), band);
    const double three = bandOf(air.pathRadiance({500.0, 500.0, 0.03}, night, band), band);
    EXPECT_GT(one, 0.0);
    EXPECT_NEAR(three / one, 3.0, 1e-5);
}

TEST(HardCases, AirIsTheSameFromTheFringeOfSpaceAndFromTenThousandKilometres) {
    const SpectralRange band{8.0, 9.0};
    const AtmosphereSmart air = atmosphereOver(band);
    const AtmosphericPath near{100e3, 1000.0, 99e3};
    const double transmittance = bandOf(air.transmittance(near, band), band);
    const double radiance = bandOf(air.pathRadiance(near, day, band), band);
    const double ground = bandOf(air.backgroundRadiance({100e3, -0.5 * pi, 0.0}, day, band), band);
    EXPECT_GT(transmittance, 0.1);
    for (const double altitude_m : {6.4e6, 1e7}) {
        const AtmosphericPath far{altitude_m, 1000.0, altitude_m - 1000.0};
        EXPECT_NEAR(bandOf(air.transmittance(far, band), band) / transmittance, 1.0, 1e-6);
        EXPECT_NEAR(bandOf(air.pathRadiance(far, day, band), band) / radiance, 1.0, 1e-6);
        const LineOfSight down{altitude_m, -0.5 * pi, 0.0};
        EXPECT_NEAR(bandOf(air.backgroundRadiance(down, day, band), band) / ground, 1.0, 1e-6);
    }
}

TEST(HardCases, TheSkyIsContinuousAMicroradianFromTheHorizontal) {
    const SpectralRange band{9.0, 9.5};
    const AtmosphereSmart air = atmosphereOver(band);
    for (const double altitude_m : {0.0, 2.0, 3000.0, 12e3}) {
        const auto at = [&](double elevation_rad) {
            return bandOf(air.backgroundRadiance({altitude_m, elevation_rad, 0.0}, day, band),
                          band);
        };
        EXPECT_NEAR(at(1e-6) / at(0.0), 1.0, 1e-4) << altitude_m;
        if (altitude_m > 0.0) {
            EXPECT_NEAR(at(-1e-6) / at(0.0), 1.0, 1e-4) << altitude_m;
        }
    }
}

TEST(HardCases, EverySunGivesLightOrNone) {
    const SpectralRange band{0.5, 0.51};
    for (const int mode : {1, 2}) {
        const AtmosphereSmart air = atmosphereOver(band, mode);
        for (const double elevation_rad : {0.5 * pi, 1.0, 1e-6, 0.0, -1e-6, -0.2, -0.5 * pi}) {
            const SunPosition sun{0.0, elevation_rad};
            const std::string what = "sun at " + numberText(elevation_rad) + " rad";
            expectSound(air.backgroundRadiance({10.0, 0.5, 1.0}, sun, band), 1e4, what);
            expectSound(air.pathRadiance({10.0, 10.0, 20e3}, sun, band), 1e4, what);
            const Spectrum direct = air.solarIrradiance(0.0, sun, band);
            expectSound(direct, 2500.0, what);
            if (elevation_rad < -0.1) {
                EXPECT_EQ(bandOf(direct, band), 0.0) << what;
            }
        }
    }
}

} // namespace
} // namespace irsg
