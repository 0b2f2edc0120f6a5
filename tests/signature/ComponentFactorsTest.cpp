#include "irsg/signature/ComponentFactors.h"

#include "irsg/radiometry/Units.h"

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

} // namespace
} // namespace irsg
