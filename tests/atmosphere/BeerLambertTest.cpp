#include "irsg/atmosphere/BeerLambert.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/CurveSampling.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

using namespace irsg;
using testing::HasSubstr;

namespace {

const SpectralRange mwir{3.0, 5.0};
const SunPosition noon{0.0, 1.0};

/// Thin at the ends, opaque in the middle, clear from 4.5 um on.
BeerLambertParameters wavy() {
    BeerLambertParameters parameters;
    parameters.name = "wavy";
    parameters.extinction_per_m =
        Spectrum({2.5, 3.2, 4.0, 4.2, 4.5, 4.8, 6.0}, {1e-5, 2e-4, 1.0, 1.0, 0.0, 0.0, 3e-3});
    parameters.airTemperature_K = 285.0;
    parameters.groundTemperature_K = 295.0;
    parameters.solarIrradiance_W_m2_um = Spectrum({2.5, 6.0}, {20.0, 2.0});
    parameters.downwardFlux_W_m2_um = Spectrum::constant(3.0);
    parameters.upwardFlux_W_m2_um = Spectrum::constant(4.0);
    return parameters;
}

double extinctionOf(const BeerLambert& air, double wavelength_um) {
    return air.parameters().extinction_per_m.at(wavelength_um);
}

double planck(double wavelength_um, double temperature_K) {
    return planckRadiance_W_m2_sr_um(wavelength_um, temperature_K);
}

std::vector<double> probes(const SpectralRange& range, int count) {
    std::vector<double> wavelengths;
    for (int i = 0; i <= count; ++i) {
        wavelengths.push_back(
            std::lerp(range.min_um, range.max_um, i / static_cast<double>(count)));
    }
    return wavelengths;
}

/// The largest error against a closed form, relative to the larger of the value and 1e-9 of the
/// largest.
template <typename ClosedForm>
double worstError(const Spectrum& spectrum, const SpectralRange& range, ClosedForm&& closedForm) {
    double worst = 0.0;
    const double floor = atmosphereFloor * spectrum.maximum();
    for (const double x : probes(range, 50021)) {
        const double truth = closedForm(x);
        const double scale = std::max(truth, floor);
        worst = std::max(worst, std::abs(spectrum.at(x) - truth) / scale);
    }
    return worst;
}

} // namespace

TEST(BeerLambert, TransmittanceIsTheExponentialOfTheInterpolatedExtinction) {
    const BeerLambert air(wavy());
    for (const double range_m : {1.0, 100.0, 5000.0, 1e7}) {
        const Spectrum tau = air.transmittance({0.0, 0.0, range_m}, mwir);
        EXPECT_TRUE(tau.covers(mwir));
        const double worst = worstError(
            tau, mwir, [&](double x) { return std::exp(-extinctionOf(air, x) * range_m); });
        EXPECT_LT(worst, 2.0 * atmosphereTolerance) << range_m << " m";
        EXPECT_LE(tau.maximum(), 1.0);
        EXPECT_GE(tau.minimum(), 0.0);
    }
}

TEST(BeerLambert, PathRadianceIsThatOfAirWhichEmitsWhatItAbsorbs) {
    const BeerLambert air(wavy());
    for (const double range_m : {1e-3, 1.0, 5000.0, 1e7}) {
        const Spectrum path = air.pathRadiance({0.0, 0.0, range_m}, noon, mwir);
        const double worst = worstError(path, mwir, [&](double x) {
            return -std::expm1(-extinctionOf(air, x) * range_m) * planck(x, 285.0);
        });
        EXPECT_LT(worst, 2.0 * atmosphereTolerance) << range_m << " m";
    }
}

TEST(BeerLambert, AtRangeZeroThereIsNoAir) {
    const BeerLambert air(wavy());
    EXPECT_EQ(air.transmittance({}, mwir), Spectrum::constant(1.0));
    EXPECT_EQ(air.pathRadiance({}, noon, mwir), Spectrum::constant(0.0));
}

TEST(BeerLambert, OpaqueBandsRadiateAtAirTemperature) {
    const BeerLambert air(wavy());
    const AtmosphericPath path{0.0, 0.0, 100.0};
    const Spectrum tau = air.transmittance(path, mwir);
    const Spectrum radiance = air.pathRadiance(path, noon, mwir);
    for (const double x : {4.0, 4.05, 4.1, 4.2}) {
        EXPECT_LT(tau.at(x), 1e-30);
        EXPECT_NEAR(radiance.at(x) / planck(x, 285.0), 1.0, 2.0 * atmosphereTolerance);
    }
}

TEST(BeerLambert, AnIsothermalEnclosureHidesEverything) {
    // Air, sky and ground at one temperature: what a black body sends through any piece of the
    // path, with the radiance of that piece, is the black body again.
    BeerLambertParameters parameters = wavy();
    parameters.groundTemperature_K = parameters.airTemperature_K;
    parameters.skyRadiance_W_m2_sr_um = sampledPlanck(parameters.airTemperature_K, {2.5, 6.0});
    const BeerLambert air(parameters);
    for (const double range_m : {0.0, 0.5, 20.0, 3000.0, 1e7}) {
        const AtmosphericPath path{0.0, 0.0, range_m};
        const Spectrum tau = air.transmittance(path, mwir);
        const Spectrum radiance = air.pathRadiance(path, noon, mwir);
        for (const double x : probes(mwir, 997)) {
            EXPECT_NEAR((tau.at(x) * planck(x, 285.0) + radiance.at(x)) / planck(x, 285.0), 1.0,
                        2.0 * atmosphereTolerance)
                << range_m << " m, " << x << " um";
        }
    }
    for (const double elevation_rad : {-0.5 * pi, -0.01, 0.0, 0.3, 0.5 * pi}) {
        const Spectrum seen = air.backgroundRadiance({500.0, elevation_rad, 0.0}, noon, mwir);
        for (const double x : probes(mwir, 997)) {
            EXPECT_NEAR(seen.at(x) / planck(x, 285.0), 1.0, 2.0 * atmosphereTolerance)
                << x << " um";
        }
    }
}

TEST(BeerLambert, ALayerCutInTwoChangesNothing) {
    const BeerLambert air(wavy());
    const Spectrum first = air.transmittance({0.0, 0.0, 700.0}, mwir);
    const Spectrum second = air.transmittance({0.0, 0.0, 1300.0}, mwir);
    const Spectrum whole = air.transmittance({0.0, 0.0, 2000.0}, mwir);
    const Spectrum near = air.pathRadiance({0.0, 0.0, 700.0}, noon, mwir);
    const Spectrum far = air.pathRadiance({0.0, 0.0, 1300.0}, noon, mwir);
    const Spectrum all = air.pathRadiance({0.0, 0.0, 2000.0}, noon, mwir);
    for (const double x : probes(mwir, 997)) {
        EXPECT_NEAR(first.at(x) * second.at(x), whole.at(x),
                    4.0 * atmosphereTolerance * whole.at(x) +
                        atmosphereFloor * atmosphereTolerance);
        EXPECT_NEAR(near.at(x) + first.at(x) * far.at(x), all.at(x),
                    4.0 * atmosphereTolerance * all.at(x) +
                        atmosphereFloor * atmosphereTolerance * all.maximum());
    }
}

TEST(BeerLambert, ADownwardLineOfSightEndsOnTheGroundAfterItsWayThroughTheAir) {
    const BeerLambert air(wavy());
    for (const double elevation_deg : {-90.0, -30.0, -1.0}) {
        const double way_m = 800.0 / std::sin(radians(-elevation_deg));
        const Spectrum seen =
            air.backgroundRadiance({800.0, radians(elevation_deg), 0.3}, noon, mwir);
        const double worst = worstError(seen, mwir, [&](double x) {
            const double tau = std::exp(-extinctionOf(air, x) * way_m);
            return tau * planck(x, 295.0) + (1.0 - tau) * planck(x, 285.0);
        });
        EXPECT_LT(worst, 2.0 * atmosphereTolerance) << elevation_deg << " deg";
    }
    // Standing on the ground and looking down, nothing lies between.
    const Spectrum ground = air.backgroundRadiance({0.0, -0.5, 0.0}, noon, mwir);
    EXPECT_NEAR(ground.at(4.1) / planck(4.1, 295.0), 1.0, 2.0 * atmosphereTolerance);
}

TEST(BeerLambert, ALineOfSightThatNeverEndsSeesOpaqueAirOrTheSkyThroughTheClearWindow) {
    BeerLambertParameters parameters = wavy();
    for (const double elevation_rad : {0.0, 0.2, 0.5 * pi}) {
        const Spectrum dark =
            BeerLambert(parameters).backgroundRadiance({0.0, elevation_rad, 0.0}, noon, mwir);
        EXPECT_EQ(dark.at(4.65), 0.0);
        EXPECT_EQ(dark.at(4.5), 0.0);
        EXPECT_NEAR(dark.at(4.4999) / planck(4.4999, 285.0), 1.0, 2.0 * atmosphereTolerance);
        EXPECT_NEAR(dark.at(4.8001) / planck(4.8001, 285.0), 1.0, 2.0 * atmosphereTolerance);
        EXPECT_NEAR(dark.at(3.0) / planck(3.0, 285.0), 1.0, 2.0 * atmosphereTolerance);
    }
    parameters.skyRadiance_W_m2_sr_um = Spectrum::constant(0.125);
    const Spectrum seen = BeerLambert(parameters).backgroundRadiance({0.0, 0.2, 0.0}, noon, mwir);
    EXPECT_EQ(seen.at(4.65), 0.125);
    EXPECT_NEAR(seen.at(4.1) / planck(4.1, 285.0), 1.0, 2.0 * atmosphereTolerance);
}

TEST(BeerLambert, AnExtinctionThatTouchesZeroAtOneNodeIsOpaqueInTheEnd) {
    BeerLambertParameters parameters = wavy();
    parameters.extinction_per_m = Spectrum({2.5, 4.0, 6.0}, {1e-3, 0.0, 1e-3});
    const Spectrum seen = BeerLambert(parameters).backgroundRadiance({}, noon, mwir);
    EXPECT_NEAR(seen.at(4.0) / planck(4.0, 285.0), 1.0, 2.0 * atmosphereTolerance);
}

TEST(BeerLambert, SunFluxesAndTemperatureDoNotChangeWithAltitude) {
    const BeerLambert air(wavy());
    for (const double altitude_m : {0.0, 1000.0, 2e4}) {
        EXPECT_EQ(air.solarIrradiance(altitude_m, noon, mwir),
                  air.parameters().solarIrradiance_W_m2_um);
        EXPECT_EQ(air.upwardFlux(altitude_m, noon, mwir), Spectrum::constant(4.0));
        EXPECT_EQ(air.downwardFlux(altitude_m, noon, mwir), Spectrum::constant(3.0));
        EXPECT_EQ(air.ambientTemperature_K(altitude_m), 285.0);
    }
}

TEST(BeerLambert, SunIsHalfOnTheHorizonAndZeroBelowIt) {
    const BeerLambert air(wavy());
    const Spectrum half = air.solarIrradiance(0.0, {0.0, 0.0}, mwir);
    EXPECT_DOUBLE_EQ(half.at(4.0), 0.5 * air.parameters().solarIrradiance_W_m2_um.at(4.0));
    EXPECT_EQ(air.solarIrradiance(0.0, {0.0, -0.3}, mwir).maximum(), 0.0);
    // What was stated holds for its own day.
    EXPECT_EQ(air.solarIrradiance(0.0, {0.0, 0.5, 1.01}, mwir),
              air.parameters().solarIrradiance_W_m2_um);
}

TEST(BeerLambert, OfConstantExtinctionHoldsTheWholeSpectrum) {
    BeerLambertParameters parameters;
    parameters.extinction_per_m = Spectrum::constant(1e-3);
    const BeerLambert air(parameters);
    EXPECT_EQ(air.base(), (SpectralRange{0.2, 40.0}));
    EXPECT_EQ(air.transmittance({0.0, 0.0, 1000.0}, {0.2, 40.0}),
              Spectrum::constant(std::exp(-1.0)));
    const Spectrum path = air.pathRadiance({0.0, 0.0, 1000.0}, noon, {0.2, 40.0});
    for (const double x : {3.3, 4.7, 9.9, 25.1, 39.9}) {
        EXPECT_NEAR(path.at(x) / ((1.0 - std::exp(-1.0)) * planck(x, 288.15)), 1.0,
                    2.0 * atmosphereTolerance);
    }
}

TEST(BeerLambert, WithoutExtinctionIsAVacuumOverGround) {
    const BeerLambert air(BeerLambertParameters{});
    EXPECT_EQ(air.transmittance({0.0, 0.0, 1e7}, mwir), Spectrum::constant(1.0));
    EXPECT_EQ(air.pathRadiance({0.0, 0.0, 1e7}, noon, mwir).maximum(), 0.0);
    EXPECT_EQ(air.backgroundRadiance({0.0, 0.5, 0.0}, noon, mwir).maximum(), 0.0);
    EXPECT_EQ(air.solarIrradiance(0.0, noon, mwir), Spectrum::constant(0.0));
}

TEST(BeerLambert, BaseIsWhatAllItsSpectraCover) {
    BeerLambertParameters parameters = wavy();
    parameters.downwardFlux_W_m2_um = Spectrum({3.5, 9.0}, {1.0, 1.0});
    EXPECT_EQ(BeerLambert(parameters).base(), (SpectralRange{3.5, 6.0}));
    EXPECT_THROW((void)BeerLambert(parameters).transmittance({}, mwir), LogicError);
}

namespace {

struct BadParameters {
    const char* name;
    void (*spoil)(BeerLambertParameters&);
    const char* message;
};
void PrintTo(const BadParameters& row, std::ostream* out) {
    *out << row.name;
}

class BeerLambertRefuses : public testing::TestWithParam<BadParameters> {};

} // namespace

TEST_P(BeerLambertRefuses, ByName) {
    BeerLambertParameters parameters = wavy();
    GetParam().spoil(parameters);
    try {
        const BeerLambert air(parameters);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("wavy"));
        EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Of, BeerLambertRefuses,
    testing::Values(
        BadParameters{"negativeExtinction",
                      [](auto& p) {
                          p.extinction_per_m = Spectrum({3.0, 5.0}, {1e-3, -1e-3});
                      },
                      "extinction: found -0.001"},
        BadParameters{"negativeSun",
                      [](auto& p) { p.solarIrradiance_W_m2_um = Spectrum::constant(-1.0); },
                      "solar irradiance: found -1"},
        BadParameters{"negativeFluxDown",
                      [](auto& p) { p.downwardFlux_W_m2_um = Spectrum::constant(-1.0); },
                      "downward flux"},
        BadParameters{"negativeFluxUp",
                      [](auto& p) { p.upwardFlux_W_m2_um = Spectrum::constant(-1.0); },
                      "upward flux"},
        BadParameters{"negativeSky",
                      [](auto& p) { p.skyRadiance_W_m2_sr_um = Spectrum::constant(-1.0); },
                      "sky radiance"},
        BadParameters{"negativeAirTemperature", [](auto& p) { p.airTemperature_K = -1.0; },
                      "air temperature: found -1 K"},
        BadParameters{"groundTemperatureNotANumber",
                      [](auto& p) { p.groundTemperature_K = std::nan(""); },
                      "ground temperature: found nan K"},
        BadParameters{"infiniteAirTemperature", [](auto& p) { p.airTemperature_K = HUGE_VAL; },
                      "air temperature: found inf K"},
        BadParameters{"nothingInCommon",
                      [](auto& p) {
                          p.upwardFlux_W_m2_um = Spectrum({8.0, 12.0}, {1.0, 1.0});
                      },
                      "wavelengths in common"}),
    [](const auto& row) { return std::string(row.param.name); });
