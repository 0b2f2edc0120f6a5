#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/core/Errors.h"

using namespace irsg;
using testing::HasSubstr;

namespace {

constexpr ModelAtmosphere allModels[] = {
    ModelAtmosphere::tropical,          ModelAtmosphere::midlatitudeSummer,
    ModelAtmosphere::midlatitudeWinter, ModelAtmosphere::subarcticSummer,
    ModelAtmosphere::subarcticWinter,   ModelAtmosphere::usStandard1976};

void expectSaneAtmosphere(const Profile& air) {
    for (double z = 0.0; z < 1500.0; z += 7.0) {
        const AtmosphericState state = air.at(z);
        EXPECT_LE(relativeHumidity(state), 1.0 + 1e-9) << z;
        EXPECT_GE(state.fraction(Gas::H2O), 0.0) << z;
        EXPECT_GT(state.pressure_hPa, air.at(z + 7.0).pressure_hPa) << z;
    }
}

} // namespace

TEST(SurfaceObservationAdjustment, PassesThroughTheMeasurements) {
    const SurfaceObservation measured{12.0, 291.3, 1004.5, 0.63, 295.1};
    for (const ModelAtmosphere model : allModels) {
        const Profile air = Profile::model(model).adjustedToSurfaceObservation(measured);
        EXPECT_NEAR(air.at(0.0).temperature_K, 295.1, 1e-9);
        EXPECT_NEAR(air.at(12.0).temperature_K, 291.3, 1e-9);
        EXPECT_NEAR(air.at(12.0).pressure_hPa, 1004.5, 1e-9);
        EXPECT_NEAR(relativeHumidity(air.at(12.0)), 0.63, 1e-9);
        EXPECT_NEAR(relativeHumidity(air.at(0.0)), 0.63, 1e-9);
        expectSaneAtmosphere(air);
    }
}

TEST(SurfaceObservationAdjustment, ChangesNothingFromOneKilometreUp) {
    const Profile before = Profile::model(ModelAtmosphere::midlatitudeSummer);
    const Profile after = before.adjustedToSurfaceObservation({5.0, 288.0, 1005.0, 0.9, 286.0});
    for (const double z : {1000.0, 1001.0, 1500.0, 8300.0, 50000.0, 100000.0}) {
        EXPECT_NEAR(after.at(z).temperature_K, before.at(z).temperature_K, 1e-9);
        EXPECT_NEAR(after.at(z).pressure_hPa / before.at(z).pressure_hPa, 1.0, 1e-12);
        for (std::size_t gas = 0; gas < gasCount; ++gas) {
            EXPECT_NEAR(after.at(z).moleFraction[gas] / before.at(z).moleFraction[gas], 1.0, 1e-12);
        }
    }
    // Other gases than water do not change at all.
    EXPECT_NEAR(after.at(400.0).fraction(Gas::O3) / before.at(400.0).fraction(Gas::O3), 1.0, 1e-9);
}

// The levels sample a curve with a continuous derivative: the last pieces approach the slope above.
TEST(SurfaceObservationAdjustment, JoinsTheAirAboveSmoothly) {
    for (const ModelAtmosphere model : allModels) {
        const Profile before = Profile::model(model);
        const Profile after =
            before.adjustedToSurfaceObservation({5.0, 293.15, 1010.0, 0.5, 293.15});
        const auto slope = [](const Profile& air, double z) {
            return (air.at(z + 20.0).temperature_K - air.at(z).temperature_K) / 20.0;
        };
        const double change = std::abs(293.15 - before.at(5.0).temperature_K);
        // The shift near the ceiling is at most 3 x^2 of itself at x of the kilometre below it.
        EXPECT_NEAR(slope(after, 970.0), slope(before, 970.0), 3.1 * 0.05 * change / 995.0);
        EXPECT_NEAR(slope(after, 1000.0), slope(before, 1000.0), 1e-12);
    }
}

TEST(SurfaceObservationAdjustment, OfTheModelsOwnValuesIsTheModel) {
    for (const ModelAtmosphere model : allModels) {
        const Profile before = Profile::model(model);
        const AtmosphericState ten = before.at(10.0);
        const Profile after = before.adjustedToSurfaceObservation(
            {10.0, ten.temperature_K, ten.pressure_hPa, relativeHumidity(ten),
             before.at(0.0).temperature_K});
        for (const double z : {0.0, 5.0, 100.0, 300.0, 555.0, 900.0}) {
            EXPECT_NEAR(after.at(z).temperature_K, before.at(z).temperature_K, 1e-9);
            EXPECT_NEAR(after.at(z).pressure_hPa, before.at(z).pressure_hPa, 0.6);
        }
    }
}

// 30 hPa per 254 m or so: the barometric formula of moist air between levels.
TEST(SurfaceObservationAdjustment, IsHydrostaticUpToTheMisfitThatItSpreads) {
    const Profile air = Profile::model(ModelAtmosphere::usStandard1976)
                            .adjustedToSurfaceObservation({10.0, 288.0, 1012.0, 0.5, 288.1});
    const double belowTheMeasurement =
        std::log(air.at(0.0).pressure_hPa / air.at(10.0).pressure_hPa);
    const double water = air.at(5.0).fraction(Gas::H2O);
    EXPECT_NEAR(belowTheMeasurement,
                9.80665 * (28.964e-3 - 10.949e-3 * water) * 10.0 / 8.314462618 / 288.05, 1e-8);
    for (const double z : {100.0, 300.0, 600.0, 900.0}) {
        const AtmosphericState state = air.at(z);
        const double scale_m = 8.314462618 * state.temperature_K /
                               (9.80665 * (28.964e-3 - 10.949e-3 * state.fraction(Gas::H2O)));
        const double fall = std::log(air.at(z - 10.0).pressure_hPa / air.at(z + 10.0).pressure_hPa);
        EXPECT_NEAR(fall * scale_m / 20.0, 1.0, 0.015);
    }
}

TEST(SurfaceObservationAdjustment, OfWeatherFarFromTheModelStaysSane) {
    struct Case {
        const char* name;
        SurfaceObservation measured;
    };
    const Case cases[] = {{"40 C", {5.0, 313.15, 1013.0, 1.0, 313.15}},
                          {"-40 C", {5.0, 233.15, 1013.0, 1.0, 233.15}},
                          {"ten above the ground", {2.0, 313.15, 1000.0, 0.3, 303.15}},
                          {"ten below the ground", {40.0, 283.15, 1000.0, 0.3, 293.15}},
                          {"low pressure", {5.0, 280.0, 800.0, 0.5, 280.0}},
                          {"high pressure", {5.0, 280.0, 1200.0, 0.5, 280.0}},
                          {"hot and low", {5.0, 313.15, 800.0, 1.0, 313.15}},
                          {"cold and high", {5.0, 233.15, 1200.0, 1.0, 233.15}},
                          {"dry", {5.0, 290.0, 1000.0, 0.0, 290.0}}};
    for (const Case& each : cases) {
        for (const ModelAtmosphere model : allModels) {
            SCOPED_TRACE(each.name);
            const Profile before = Profile::model(model);
            const Profile air = before.adjustedToSurfaceObservation(each.measured);
            expectSaneAtmosphere(air);
            // Between the ground and the measurement, and from there to the model: no overshoot.
            const double ground = air.at(0.0).temperature_K;
            const double height = each.measured.temperature_K;
            for (double z = 0.0; z <= each.measured.height_m; z += 0.5) {
                EXPECT_LE(air.at(z).temperature_K, std::max(ground, height) + 0.3);
                EXPECT_GE(air.at(z).temperature_K, std::min(ground, height) - 0.3);
            }
            double previous = 1e9;
            for (double z = each.measured.height_m; z <= 1000.0; z += 5.0) {
                const double shift = std::abs(air.at(z).temperature_K - before.at(z).temperature_K);
                EXPECT_LE(shift, previous + 1e-9) << z;
                previous = shift;
            }
            EXPECT_NEAR(air.at(2000.0).temperature_K, before.at(2000.0).temperature_K, 1e-9);
        }
    }
}

// A pressure that no weather of the air above explains goes up as a factor; ordinary weather does
// not.
TEST(SurfaceObservationAdjustment, LeavesThePressureAboveAloneInOrdinaryWeather) {
    for (const ModelAtmosphere model : allModels) {
        for (const double pressure_hPa : {975.0, 1013.0, 1040.0}) {
            const Profile before = Profile::model(model);
            const double own_K = before.at(5.0).temperature_K;
            const Profile after =
                before.adjustedToSurfaceObservation({5.0, own_K, pressure_hPa, 0.5, own_K});
            EXPECT_NEAR(after.at(5000.0).pressure_hPa, before.at(5000.0).pressure_hPa, 1e-9);
        }
    }
    const Profile before = Profile::model(ModelAtmosphere::usStandard1976);
    const Profile high = before.adjustedToSurfaceObservation({5.0, 288.0, 800.0, 0.5, 288.0});
    EXPECT_NEAR(high.at(5000.0).pressure_hPa / before.at(5000.0).pressure_hPa,
                800.0 / 1012.4 * 1.051, 0.005);
}

TEST(SurfaceObservationAdjustment, RefusesWeatherByName) {
    const double nan = std::nan("");
    struct Case {
        const char* name;
        SurfaceObservation measured;
        const char* words;
    };
    const Case cases[] = {{"too low", {1.9, 290, 1000, 0.5, 290}, "height_m"},
                          {"too high", {41, 290, 1000, 0.5, 290}, "height_m"},
                          {"cold", {5, 200, 1000, 0.5, 290}, "temperature_K"},
                          {"nan", {5, nan, 1000, 0.5, 290}, "temperature_K"},
                          {"low pressure", {5, 290, 799, 0.5, 290}, "pressure_hPa"},
                          {"high pressure", {5, 290, 1201, 0.5, 290}, "pressure_hPa"},
                          {"dry", {5, 290, 1000, -0.1, 290}, "relativeHumidity"},
                          {"percent", {5, 290, 1000, 50.0, 290}, "relativeHumidity"},
                          {"celsius", {5, 290, 1000, 0.5, 20.0}, "temperatureAtZero_K"}};
    const Profile air = Profile::model(ModelAtmosphere::usStandard1976);
    for (const Case& each : cases) {
        SCOPED_TRACE(each.name);
        try {
            air.adjustedToSurfaceObservation(each.measured);
            FAIL() << "nothing was refused";
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(each.words));
        }
    }
    const Profile low(
        {AtmosphericState{0.0, 1000.0, 290.0, {}}, AtmosphericState{500.0, 950.0, 287.0, {}}});
    EXPECT_THROW(low.adjustedToSurfaceObservation({}), InputError);
}
