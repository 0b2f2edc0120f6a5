#include "smatcore/simulate/Trajectory.h"

#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace smat {
namespace {

using irsg::radians;
using testing::HasSubstr;

const std::string header = "t [s],x [m],y [m],z [m],yaw [deg],pitch [deg],roll [deg],power,mach\n";

Trajectory parsed(const std::string& rows) {
    return Trajectory::parse(header + rows, "t.csv");
}

TEST(Trajectory, GoesLinearlyBetweenItsPoints) {
    const Trajectory path = parsed("0,0,10,1000,0,-10,0,0.2,0.4\n4,8,-10,1400,40,10,20,0.6,0.8\n");
    const TrajectoryPoint point = path.at(1.0).value();
    EXPECT_EQ(point.time_s, 1.0);
    EXPECT_EQ(point.pose.position_m, (irsg::Vec3{2, 5, 1100}));
    EXPECT_NEAR(point.pose.attitude.yaw_rad, radians(10), 1e-15);
    EXPECT_NEAR(point.pose.attitude.pitch_rad, radians(-5), 1e-15);
    EXPECT_NEAR(point.pose.attitude.roll_rad, radians(5), 1e-15);
    EXPECT_NEAR(point.power, 0.3, 1e-15);
    EXPECT_NEAR(point.mach, 0.5, 1e-15);
}

TEST(Trajectory, GivesItsPointsBackExactly) {
    const Trajectory path =
        parsed("0,0.1,0.2,0.3,1,2,3,0,0\n0.3,1,2,3,4,5,6,0,0\n7,7,7,7,7,7,7,0,0\n");
    for (const TrajectoryPoint& point : path.points()) {
        EXPECT_EQ(path.at(point.time_s), point);
    }
}

TEST(TrajectoryTable, IsWrittenWithItsRemarksAndReadsBackEqual) {
    const std::string text = "# One flight.\n# source: radar\n"
                             "t [s],x [m],y [m],z [m],yaw [deg],pitch [deg],roll [deg],mach\n"
                             "0,0.1,-2e-07,1000,350,-10,0.3,0.4\n4,8,-10,1400,10,10,20,0.8\n";
    const TrajectoryTable table = TrajectoryTable::parse(text, "t.csv");
    EXPECT_EQ(table.text(), text);
    EXPECT_FALSE(table.hasPower);
    EXPECT_EQ(TrajectoryTable::parse(table.text(), "t.csv"), table);
    // What is flown is the same to the last bit.
    EXPECT_EQ(Trajectory(table).points(), Trajectory::parse(text, "t.csv").points());
}

struct TurnRow {
    const char* name;
    double from_deg, to_deg, quarter_deg;
};
void PrintTo(const TurnRow& row, std::ostream* out) {
    *out << row.name;
}
class ATurn : public testing::TestWithParam<TurnRow> {};

TEST_P(ATurn, TakesTheShorterWayRound) {
    const auto [name, from_deg, to_deg, quarter_deg] = GetParam();
    const auto text = [](double value) { return std::to_string(value); };
    for (const bool rolls : {false, true}) {
        const std::string from = rolls ? "0,0," + text(from_deg) : text(from_deg) + ",0,0";
        const std::string to = rolls ? "0,0," + text(to_deg) : text(to_deg) + ",0,0";
        const Trajectory path = parsed("0,0,0,0," + from + ",0,0\n4,0,0,0," + to + ",0,0\n");
        const irsg::Attitude at = path.at(1.0)->pose.attitude;
        const double turned_rad = rolls ? at.roll_rad : at.yaw_rad;
        EXPECT_NEAR(std::remainder(turned_rad - radians(quarter_deg), 2 * irsg::pi), 0.0, 1e-12);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Turns, ATurn,
    testing::Values(TurnRow{"Level", 10, 50, 20}, TurnRow{"OverNorth", 350, 10, 355},
                    TurnRow{"BackOverNorth", 10, 350, 5}, TurnRow{"OverSouth", 170, -170, 175},
                    TurnRow{"WholeTurn", -180, 180, 180}, TurnRow{"TwoWholeTurns", -360, 360, 0},
                    TurnRow{"Backwards", 50, 10, 40}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Trajectory, IsNotThereBeforeItBeginsAndAfterItEnds) {
    const Trajectory path = parsed("2,1,0,0,0,0,0,0,0\n4,3,0,0,0,0,0,0,0\n");
    EXPECT_FALSE(path.at(1.999));
    EXPECT_FALSE(path.at(4.001));
    EXPECT_EQ(path.at(1.9, true)->pose.position_m.x, 1.0);
    EXPECT_EQ(path.at(99.0, true)->pose.position_m.x, 3.0);
    EXPECT_EQ(path.at(99.0, true)->time_s, 99.0);
    // The rounding of step times does not cost the last frame.
    EXPECT_EQ(path.at(4.0 + 1e-9)->pose.position_m.x, 3.0);
}

TEST(Trajectory, OfOnePointIsThereAtOneTimeUnlessHeld) {
    const Trajectory path = parsed("2,1,0,0,0,0,0,0,0\n");
    EXPECT_TRUE(path.at(2.0));
    EXPECT_FALSE(path.at(2.5));
    EXPECT_TRUE(path.at(-1.0, true));
}

TEST(Trajectory, ThatStandsStillIsAlwaysThere) {
    const irsg::Pose pose{{1, 2, 3}, {0.1, 0.2, 0.3}};
    const Trajectory still(pose, 0.5, 0.8);
    for (const double time_s : {-1e9, 0.0, 1e9}) {
        EXPECT_EQ(still.at(time_s)->pose, pose);
        EXPECT_EQ(still.at(time_s)->power, 0.5);
        EXPECT_EQ(still.at(time_s)->mach, 0.8);
    }
}

TEST(Trajectory, TakesColumnsInAnyOrderWithoutUnitsAndRemarks) {
    const Trajectory path = Trajectory::parse(
        "# made by hand\n\nz,roll,pitch,yaw,y,x,t\r\n300,3,2,1,200,100,5\r\n", "t.csv");
    const TrajectoryPoint point = path.points().at(0);
    EXPECT_EQ(point.pose.position_m, (irsg::Vec3{100, 200, 300}));
    EXPECT_NEAR(point.pose.attitude.yaw_rad, radians(1), 1e-15);
    EXPECT_EQ(point.time_s, 5.0);
    EXPECT_FALSE(path.hasPower());
    EXPECT_FALSE(path.hasMach());
    EXPECT_TRUE(parsed("0,0,0,0,0,0,0,0,0\n").hasPower());
}

struct BadRow {
    const char* name;
    std::string text;
    std::vector<std::string> named;
};
void PrintTo(const BadRow& row, std::ostream* out) {
    *out << row.name;
}
class ABadTrajectory : public testing::TestWithParam<BadRow> {};

TEST_P(ABadTrajectory, IsRefusedWithPlaceAndValue) {
    try {
        Trajectory::parse(GetParam().text, "t.csv");
        FAIL() << "accepted";
    } catch (const irsg::InputError& error) {
        for (const std::string& word : GetParam().named) {
            EXPECT_THAT(error.what(), HasSubstr(word));
        }
    }
}

const std::string short_ = "t,x,y,z,yaw,pitch,roll\n";
INSTANTIATE_TEST_SUITE_P(
    Inputs, ABadTrajectory,
    testing::Values(
        BadRow{"Empty", "", {"t.csv", "no rows", "yaw [deg]"}},
        BadRow{"HeaderAlone", header, {"no points"}},
        BadRow{"NoHeader", "0,0,0,0,0,0,0\n", {"line 1, column 1", "found '0'"}},
        BadRow{"MissingColumn", "t,x,y,yaw,pitch,roll\n0,0,0,0,0,0\n", {"no column z"}},
        BadRow{"UnknownColumn", "t,x,y,z,yaw,pitch,roll,thrust\n0,0,0,0,0,0,0,0\n", {"thrust"}},
        BadRow{"ColumnTwice", "t,x,x,y,z,yaw,pitch,roll\n0,0,0,0,0,0,0,0\n", {"column 3", "once"}},
        BadRow{"OtherUnit", "t,x [km],y,z,yaw,pitch,roll\n0,0,0,0,0,0,0\n", {"x [km]", "x [m]"}},
        BadRow{"RaggedRow", short_ + "0,0,0,0,0,0\n", {"line 2", "6 cells", "7 cells"}},
        BadRow{"WordForANumber", short_ + "0,0,0,high,0,0,0\n", {"line 2, column 4", "high"}},
        BadRow{"NotANumber", short_ + "nan,0,0,0,0,0,0\n", {"line 2, column 1", "nan"}},
        BadRow{"Infinite", short_ + "0,inf,0,0,0,0,0\n", {"column 2", "inf"}},
        BadRow{"TimeTwice", short_ + "1,0,0,0,0,0,0\n1,0,0,0,0,0,0\n", {"line 3", "after 1 s"}},
        BadRow{"TimeBackwards", short_ + "1,0,0,0,0,0,0\n0.5,0,0,0,0,0,0\n", {"0.5", "ascend"}},
        BadRow{"TooFar", short_ + "0,1e10,0,0,0,0,0\n", {"1e10", "1000000000 m"}},
        BadRow{"PitchOverTheTop", short_ + "0,0,0,0,0,91,0\n", {"91", "-90 to 90 deg"}},
        BadRow{"YawBeyondATurn", short_ + "0,0,0,0,361,0,0\n", {"361", "360 deg"}},
        BadRow{"NegativePower", header + "0,0,0,0,0,0,0,-1,0\n", {"column 8", "-1"}},
        BadRow{"TooFast", header + "0,0,0,0,0,0,0,0,31\n", {"column 9", "31", "0 to 30"}},
        BadRow{"SeveralAtOnce",
               short_ + "0,a,0,0,0,b,0\n1,0,0,0,400,0,0\n",
               {"line 2, column 2", "line 2, column 6", "line 3, column 5"}}),
    [](const auto& row) { return std::string(row.param.name); });

} // namespace
} // namespace smat
