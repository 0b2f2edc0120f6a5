#include "irsg/signature/ComponentFactors.h"

#include "irsg/radiometry/Units.h"
#include "irsg/signature/ClampedTables.h"
#include "irsg/signature/SignatureDatabase.h"

#include "Support.h"

namespace irsg {
namespace {

EntityState stateAt(double time_s, double angle_deg) {
    EntityState state;
    state.time_s = time_s;
    state.aspectAngle_rad = radians(angle_deg);
    return state;
}

const LookupTable time({0.0, 1.0, 2.0}, {0.5, 0.7, 0.5}, true);
const LookupTable angle({0.0, 90.0, 180.0}, {1.0, 0.4, 0.2});

TEST(ComponentFactor, IsOneUnlessToldOtherwise) {
    EXPECT_EQ(ComponentFactor{}.at(stateAt(3.0, 45.0)), 1.0);
}

TEST(ComponentFactor, OfAConstantAloneIsTheConstant) {
    const ComponentFactor factor{"CO2", 0.3, {}, {}};
    EXPECT_EQ(factor.at(stateAt(0.0, 0.0)), 0.3);
    EXPECT_EQ(factor.at(stateAt(9.0, 170.0)), 0.3);
}

TEST(ComponentFactor, OfATimeTableReplacesTheConstant) {
    const ComponentFactor factor{"CO2", 0.3, time, {}};
    EXPECT_DOUBLE_EQ(factor.at(stateAt(1.0, 0.0)), 0.7);
    EXPECT_DOUBLE_EQ(factor.at(stateAt(0.5, 90.0)), 0.6);
    EXPECT_DOUBLE_EQ(factor.at(stateAt(2.5, 0.0)), 0.6) << "one period later";
    EXPECT_DOUBLE_EQ(factor.at(stateAt(-0.5, 0.0)), 0.6) << "before the start";
}

TEST(ComponentFactor, MultipliesConstantAndAngle) {
    const ComponentFactor factor{"CO2", 0.5, {}, angle};
    EXPECT_DOUBLE_EQ(factor.at(stateAt(0.0, 0.0)), 0.5);
    EXPECT_DOUBLE_EQ(factor.at(stateAt(0.0, 45.0)), 0.35);
    EXPECT_DOUBLE_EQ(factor.at(stateAt(0.0, 180.0)), 0.1);
}

TEST(ComponentFactor, MultipliesTimeAndAngle) {
    const ComponentFactor factor{"CO2", 123.0, time, angle};
    EXPECT_DOUBLE_EQ(factor.at(stateAt(1.0, 90.0)), 0.7 * 0.4);
    EXPECT_DOUBLE_EQ(factor.at(stateAt(0.5, 135.0)), 0.6 * 0.3);
}

TEST(ComponentFactor, OfASelectedConstantLeavesItsTablesAside) {
    ComponentFactor factor{"CO2", 0.25, time, angle};
    factor.selection = FactorSelection::constant;
    EXPECT_EQ(factor.at(stateAt(1.0, 90.0)), 0.25);
    factor.selection = FactorSelection::table;
    EXPECT_DOUBLE_EQ(factor.at(stateAt(1.0, 90.0)), 0.7 * 0.4) << "they are still there";
}

TEST(ComponentFactor, WhoseTableDoesNotCountHoldsNoEndOfIt) {
    SignatureDatabase database;
    database.temperatures[1].mode = EmissionMode::userSpectrum;
    ComponentFactor factor{"CO2", 0.25, LookupTable({0.0, 1.0}, {0.5, 0.7}), {}};
    database.temperatures[1].factors = {factor};
    EXPECT_EQ(clampedTables(database, stateAt(9.0, 0.0)).size(), 1u);
    database.temperatures[1].factors.front().selection = FactorSelection::constant;
    EXPECT_TRUE(clampedTables(database, stateAt(9.0, 0.0)).empty());
}

} // namespace
} // namespace irsg
