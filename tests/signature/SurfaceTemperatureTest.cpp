#include "irsg/signature/SurfaceTemperature.h"

#include "Support.h"

namespace irsg {
namespace {

/// A state in which every term of eq. 7 would show.
const EntityState flying{.time_s = 5.0,
                         .power = 0.5,
                         .mach = 0.8,
                         .altitude_m = 2000.0,
                         .ambient_K = 250.0,
                         .aspectAngle_rad = 1.0};

TemperatureTerms nothing() {
    TemperatureTerms terms;
    terms.ambientFactor = 0.0;
    return terms;
}

TEST(SurfaceTemperature, WithoutATermIsZero) {
    EXPECT_EQ(surfaceTemperature_K(nothing(), flying), 0.0);
}

TEST(SurfaceTemperature, OfTheBaseAloneDependsOnNothing) {
    TemperatureTerms terms = nothing();
    terms.base_K = 320.0;
    EXPECT_EQ(surfaceTemperature_K(terms, flying), 320.0);
    EXPECT_EQ(surfaceTemperature_K(terms, EntityState{}), 320.0);
}

TEST(SurfaceTemperature, OfTheAmbientTermAloneFollowsTheAir) {
    TemperatureTerms terms = nothing();
    terms.ambientFactor = 1.0;
    EXPECT_EQ(surfaceTemperature_K(terms, flying), 250.0);
    terms.ambientFactor = 0.5;
    EXPECT_EQ(surfaceTemperature_K(terms, flying), 125.0);
    EXPECT_EQ(ambientTerm_K(terms, flying), 125.0);
}

TEST(SurfaceTemperature, OfTheAerodynamicTermIsTheRecoveryTemperature) {
    // Adiabatic wall: T_amb (1 + r (gamma - 1) / 2 M^2) = 250 (1 + 0.2 * 0.89 * 0.64).
    TemperatureTerms terms = nothing();
    terms.ambientFactor = 1.0;
    terms.recoveryFactor = 0.89;
    EXPECT_NEAR(aerodynamicTerm_K(terms, flying), 28.48, 1e-12);
    EXPECT_NEAR(surfaceTemperature_K(terms, flying), 278.48, 1e-12);
}

TEST(SurfaceTemperature, AtRestHasNoAerodynamicTerm) {
    TemperatureTerms terms = nothing();
    terms.ambientFactor = 1.0;
    terms.recoveryFactor = 0.89;
    EntityState parked = flying;
    parked.mach = 0.0;
    EXPECT_EQ(aerodynamicTerm_K(terms, parked), 0.0);
    EXPECT_EQ(surfaceTemperature_K(terms, parked), 250.0);
}

TEST(SurfaceTemperature, OfTheOffsetTermIsAFactorTimesTheOffset) {
    // a T_amb (dT / T_amb) = a dT, whatever the air.
    TemperatureTerms terms = nothing();
    terms.ambientFactor = 0.5;
    terms.ambientOffset_K = 8.0;
    EXPECT_EQ(offsetTerm_K(terms, flying), 4.0);
    EXPECT_EQ(surfaceTemperature_K(terms, flying), 129.0);
    terms.ambientFactor = 0.0;
    EXPECT_EQ(surfaceTemperature_K(terms, flying), 0.0);
}

TEST(SurfaceTemperature, OfEachTableAloneIsItsValue) {
    const LookupTable table({0.0, 1.0, 10.0, 4000.0}, {0.0, 100.0, 190.0, 589.0});
    struct Row {
        const char* name;
        LookupTable TemperatureTerms::*table;
        double expected_K;
    };
    const Row rows[] = {{"time", &TemperatureTerms::time, 140.0},
                        {"power", &TemperatureTerms::power, 50.0},
                        {"altitude", &TemperatureTerms::altitude, 389.0},
                        {"mach", &TemperatureTerms::mach, 80.0},
                        {"ambient", &TemperatureTerms::ambient, 214.0}};
    for (const Row& row : rows) {
        TemperatureTerms terms = nothing();
        terms.*row.table = table;
        EXPECT_NEAR(surfaceTemperature_K(terms, flying), row.expected_K, 1e-10) << row.name;
    }
}

TEST(SurfaceTemperature, OfAllTermsTogetherIsTheirSum) {
    TemperatureTerms terms;
    terms.base_K = 10.0;
    terms.ambientFactor = 0.9;
    terms.recoveryFactor = 0.85;
    terms.ambientOffset_K = 4.0;
    terms.time = LookupTable({0.0, 4.0}, {0.0, 4.0}, true);
    terms.power = LookupTable({0.0, 1.0}, {0.0, 300.0});
    terms.altitude = LookupTable({0.0, 1e4}, {0.0, -10.0});
    terms.mach = LookupTable({0.0, 1.0}, {5.0, 6.0});
    // 10 + 0.9 * 250 * (1 + 0.2 * 0.85 * 0.64 + 4 / 250) + 1 + 150 - 2 + 5.8
    EXPECT_NEAR(surfaceTemperature_K(terms, flying), 417.88, 1e-10);
}

TEST(SurfaceTemperature, OfAnIdleEngineWarmsWithPower) {
    TemperatureTerms terms = TemperatureTerms::ofAmbient();
    terms.recoveryFactor = 0.89;
    terms.power = LookupTable({0.0, 0.3, 1.0}, {0.0, 250.0, 450.0});
    EntityState state;
    double last_K = 0.0;
    for (const double power : {0.0, 0.1, 0.3, 0.6, 1.0}) {
        state.power = power;
        EXPECT_GT(surfaceTemperature_K(terms, state), last_K) << power;
        last_K = surfaceTemperature_K(terms, state);
    }
    EXPECT_DOUBLE_EQ(last_K, 288.15 + 450.0);
}

} // namespace
} // namespace irsg

TEST(SurfaceTemperatureOfCode, IsItsBaseAloneUnlessMoreIsSet) {
    irsg::TemperatureTerms terms;
    terms.base_K = 320.0;
    irsg::EntityState state;
    state.ambient_K = 280.0;
    EXPECT_DOUBLE_EQ(irsg::surfaceTemperature_K(terms, state), 320.0);
    EXPECT_DOUBLE_EQ(irsg::surfaceTemperature_K(irsg::TemperatureTerms::ofAmbient(), state), 280.0);
}
