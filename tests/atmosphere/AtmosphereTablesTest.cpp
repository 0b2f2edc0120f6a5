#include <cmath>

#include <gtest/gtest.h>

#include "irsg/atmosphere/tables/AtmosphereTables.h"
#include "irsg/core/Errors.h"
#include "tests/atmosphere/SyntheticAtmosphere.h"

namespace irsg {
namespace {

AdaptiveTable sine(double tolerance, std::size_t* calls = nullptr) {
    return AdaptiveTable(
        0.0, 10.0, tolerance,
        [calls](double x) {
            if (calls) {
                ++*calls;
            }
            return std::vector<double>{std::sin(x), x};
        },
        halfway(largestDifference));
}

TEST(AdaptiveTable, StaysWithinItsTolerance) {
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        const AdaptiveTable table = sine(tolerance);
        for (double x = 0.0; x <= 10.0; x += 0.0137) {
            const auto values = table.at(x);
            EXPECT_NEAR(values[0], std::sin(x), 1.2 * tolerance);
            EXPECT_NEAR(values[1], x, 1e-12);
        }
        EXPECT_LE(table.largestError(), tolerance);
    }
}

TEST(AdaptiveTable, NeedsFewerEvaluationsThanQuestions) {
    std::size_t calls = 0;
    const AdaptiveTable table = sine(1e-3, &calls);
    for (double x = 0.0; x <= 10.0; x += 0.001) {
        (void)table.at(x);
    }
    EXPECT_EQ(calls, table.evaluations());
    EXPECT_LT(calls, 300u);
    const std::size_t before = calls;
    (void)table.at(3.3);
    EXPECT_EQ(calls, before);
}

TEST(AdaptiveTable, RefinesOnlyWhereItIsAsked) {
    std::size_t calls = 0;
    const AdaptiveTable table = sine(1e-6, &calls);
    (void)table.at(0.5);
    EXPECT_LT(calls, 60u);
}

TEST(AdaptiveTable, ComputesWhatItCannotInterpolate) {
    const AdaptiveTable step(
        0.0, 1.0, 1e-3, [](double x) { return std::vector<double>{x < 1.0 / 3.0 ? 0.0 : 1.0}; },
        halfway(largestDifference));
    EXPECT_EQ(step.at(0.2)[0], 0.0);
    EXPECT_EQ(step.at(0.5)[0], 1.0);
    EXPECT_EQ(step.at(std::nextafter(1.0 / 3.0, 0.0))[0], 0.0);
    EXPECT_EQ(step.at(1.0 / 3.0)[0], 1.0);
}

TEST(AdaptiveTable, RefusesWhatItDoesNotHold) {
    EXPECT_THROW((void)sine(1e-3).at(10.1), LogicError);
    EXPECT_THROW((void)sine(1e-3).at(std::nan("")), LogicError);
    EXPECT_THROW(sine(0.0), LogicError);
}

class AtmosphereTablesTest : public testing::Test {
  protected:
    AtmosphereTablesTest()
        : transfer(syntheticatmosphere::model(syntheticatmosphere::profile(288.0, 6.5)),
                   syntheticatmosphere::table()),
          tables(transfer, syntheticatmosphere::nodes(), tolerance) {}

    static constexpr double tolerance = 1e-3;
    RadiativeTransfer transfer;
    AtmosphereTables tables;
    SunPosition sun{0.4, 0.6};

    void near(const std::vector<double>& found, const std::vector<double>& expected,
              const std::string& what) {
        EXPECT_LT(relativeDifference(expected, found), 2.0 * tolerance) << what;
    }
};

TEST_F(AtmosphereTablesTest, GiveWhatTheTransferGivesAlongARange) {
    for (double range_m = 20.0; range_m < 150e3; range_m *= 1.31) {
        for (const auto& [sensor_m, target_m] :
             {std::pair{10.0, 10.0}, std::pair{3000.0, 3010.0}}) {
            if (sensor_m < 100.0 && range_m > 60e3) {
                continue;
            }
            const AtmosphericPath path{sensor_m, target_m,
                                       std::max(range_m, 1.1 * std::abs(sensor_m - target_m))};
            EXPECT_LT(largestDifference(tables.transmittance(path),
                                        transfer.transmittance(tables.nodes(), path)),
                      1.5 * tolerance)
                << range_m;
            near(tables.pathRadiance(path, sun), transfer.pathRadiance(tables.nodes(), path, sun),
                 "path radiance over " + std::to_string(range_m));
        }
    }
    EXPECT_LE(tables.largestError(), tolerance);
}

TEST_F(AtmosphereTablesTest, KeepTransmittanceOneAtRangeZeroAndFalling) {
    EXPECT_EQ(tables.transmittance({100.0, 100.0, 0.0}), std::vector<double>(5, 1.0));
    std::vector<double> last(5, 1.0);
    for (double range_m = 1.0; range_m < 1e5; range_m *= 1.4) {
        const auto values = tables.transmittance({1000.0, 1000.0, range_m});
        for (std::size_t i = 0; i < values.size(); ++i) {
            EXPECT_LE(values[i], last[i] + tolerance) << range_m;
        }
        last = values;
    }
}

TEST_F(AtmosphereTablesTest, GiveSkyAndGroundOnBothSidesOfTheHorizon) {
    for (const double altitude_m : {10.0, 5000.0}) {
        for (double elevation_rad = -1.5; elevation_rad <= 1.5; elevation_rad += 0.0617) {
            const LineOfSight sight{altitude_m, elevation_rad, 1.0};
            near(tables.backgroundRadiance(sight, sun),
                 transfer.backgroundRadiance(tables.nodes(), sight, sun),
                 "background at " + std::to_string(elevation_rad));
        }
    }
}

TEST_F(AtmosphereTablesTest, GiveSunAndFluxesOverAltitude) {
    for (double altitude_m = 0.0; altitude_m <= 40e3; altitude_m += 1234.5) {
        const std::string at = " at " + std::to_string(altitude_m);
        near(tables.solarIrradiance(altitude_m, sun),
             transfer.solarIrradiance(tables.nodes(), altitude_m, sun), "sun" + at);
        near(tables.upwardFlux(altitude_m, sun),
             transfer.upwardFlux(tables.nodes(), altitude_m, sun), "up" + at);
        near(tables.downwardFlux(altitude_m, sun),
             transfer.downwardFlux(tables.nodes(), altitude_m, sun), "down" + at);
    }
}

TEST_F(AtmosphereTablesTest, AskTheTransferLessThanTheyAreAsked) {
    std::size_t questions = 0;
    for (double range_m = 1000.0; range_m < 40e3; range_m += 20.0, ++questions) {
        (void)tables.transmittance({3000.0, 3000.0, range_m});
    }
    EXPECT_LT(tables.evaluations(), questions / 10);
}

TEST_F(AtmosphereTablesTest, HoldTheirToleranceWhereAirIsBlackAfterMillimetres) {
    // A node of a depth of 1 in 13 um beside one of 1 in kilometres.
    for (double range_m = 1e-6; range_m < 3.0; range_m *= 1.17) {
        const AtmosphericPath path{10.0, 10.0, range_m};
        EXPECT_LT(largestDifference(tables.transmittance(path),
                                    transfer.transmittance(tables.nodes(), path)),
                  1.5 * tolerance)
            << range_m;
    }
    EXPECT_LE(tables.largestError(), tolerance);
}

TEST_F(AtmosphereTablesTest, AreBoundedHoweverManyAltitudesAreAsked) {
    for (int i = 0; i < 3000; ++i) {
        const double altitude_m = 1.0 + 0.37 * i;
        const auto found = tables.transmittance({altitude_m, altitude_m, 2000.0});
        EXPECT_EQ(tables.evaluations(), 0u); // what is asked once has no table
        if (i % 500 == 0) {
            EXPECT_EQ(found,
                      transfer.transmittance(tables.nodes(), {altitude_m, altitude_m, 2000.0}));
        }
    }
    EXPECT_EQ(tables.bytes(), 0u);
    for (int i = 0; i < 3000; ++i) {
        const double altitude_m = 1.0 + 0.37 * i;
        (void)tables.transmittance({altitude_m, altitude_m, 2000.0});
        (void)tables.transmittance({altitude_m, altitude_m, 2001.0});
    }
    EXPECT_GT(tables.bytes(), 0u);
    EXPECT_LT(tables.bytes(), 1000 * 5 * sizeof(double));
}

} // namespace
} // namespace irsg
