#include "irsg/signature/SignatureDatabase.h"

#include "Support.h"
#include "irsg/signature/ClampedTables.h"

namespace irsg {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SignatureDatabase, ReflectivityIsWhatTheOthersLeave) {
    const Material glass = completeDatabase().materials.at(3);
    EXPECT_DOUBLE_EQ(glass.reflectivityAt(2.0), 1.0 - 0.1 - 0.85);
    EXPECT_DOUBLE_EQ(glass.reflectivityAt(4.75), 1.0 - 0.55 - 0.35);
    EXPECT_DOUBLE_EQ(glass.reflectivityAt(1.0), glass.reflectivityAt(2.0)) << "clamped outside";
    EXPECT_FALSE(glass.isOpaque());
    EXPECT_TRUE(completeDatabase().materials.at(0).isOpaque());
}

TEST(SignatureDatabase, IsAValueThatEveryFieldTells) {
    const SignatureDatabase original = completeDatabase();
    SignatureDatabase copy = original;
    EXPECT_TRUE(copy == original);
    copy.temperatures[2147483647].factors[0].angle = LookupTable({0.0}, {1.0});
    EXPECT_FALSE(copy == original);
    EXPECT_TRUE(original == completeDatabase());
}

TEST(SignatureDatabase, NamesTheTablesThatHoldAnEndValue) {
    EntityState state;
    state.power = 1.0;
    state.mach = 0.5;
    state.time_s = 1e6;
    EXPECT_THAT(clampedTables(completeDatabase(), state), IsEmpty()) << "loops hold nothing";
    state.power = 1.01;
    state.altitude_m = -1.0;
    state.mach = 0.1;
    EXPECT_THAT(clampedTables(completeDatabase(), state),
                ElementsAre("temperatures.0.terms.power", "temperatures.0.terms.altitude_m",
                            "temperatures.0.terms.mach"));
}

TEST(SignatureDatabase, NamesOnlyTablesThatTheModeUses) {
    SignatureDatabase database = completeDatabase();
    TemperatureEntry& gas = database.temperatures[2147483647];
    gas.terms.power = LookupTable({0.0, 0.1}, {0.0, 1.0});
    gas.factors[0].angle = LookupTable({90.0, 180.0}, {1.0, 1.0});
    EntityState state;
    state.power = 0.5;
    state.mach = 0.5;
    EXPECT_THAT(clampedTables(database, state),
                ElementsAre("temperatures.2147483647.factors[0].angle_deg"));
}

} // namespace
} // namespace irsg
