#include "irsg/gas/PlumePoints.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tests/gas/PlumeFields.h"

using namespace irsg;
using namespace smat::test;

namespace {

PlumeField fieldOf(const std::string& text) {
    return readPlumePoints(CsvTable::parse(text, "points.csv"));
}
std::string refusalOf(const std::string& text) {
    try {
        fieldOf(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

const std::string head = "x [m],y [m],z [m],T [K],CO2\n";
/// The corners of a cube, all of 800 K.
const std::string cube = "0,0,0,800,0.1\n0,0,1,800,0.1\n0,1,0,800,0.1\n0,1,1,800,0.1\n"
                         "1,0,0,800,0.1\n1,0,1,800,0.1\n1,1,0,800,0.1\n1,1,1,800,0.1\n";

TEST(PlumePoints, OfAGridAreItsNodesInAnyOrder) {
    const PlumeField field =
        fieldOf("z [m],soot [ppmv],T [K],y [m],x [m],p [atm]\n"
                "1,8,900,0,2,1\n0,1,300,0,0,2\n0,2,400,1,0,1\n0,3,500,0,2,1\n"
                "0,4,600,1,2,1\n1,5,700,0,0,1\n1,6,800,1,0,1\n1,7,850,1,2,1\n");
    EXPECT_EQ(field.axes_m()[0], (std::vector<double>{0.0, 2.0}));
    EXPECT_EQ(field.axes_m()[2], (std::vector<double>{0.0, 1.0}));
    EXPECT_DOUBLE_EQ(field.at({0.0, 0.0, 0.0}).temperature_K, 300.0);
    EXPECT_DOUBLE_EQ(field.at({0.0, 0.0, 0.0}).pressure_atm, 2.0);
    EXPECT_DOUBLE_EQ(field.at({2.0, 0.0, 1.0}).soot_ppmv, 8.0);
    EXPECT_DOUBLE_EQ(field.at({1.0, 0.5, 0.0}).temperature_K, 450.0);
    EXPECT_DOUBLE_EQ(field.at({9.0, 9.0, 9.0}).temperature_K, 850.0);
}

TEST(PlumePoints, OfAnyOrderMeetALinearField) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(0.0, 1.0);
    std::vector<PlumePoint> points;
    const auto gasAt = [](const GasVector& place_m) {
        GasLayer gas;
        gas.temperature_K = 500.0 + 200.0 * place_m[0] - 100.0 * place_m[1] + 50.0 * place_m[2];
        gas.fraction(HotGas::CO2) = 0.1 + 0.05 * place_m[2];
        return gas;
    };
    for (int i = 0; i < 8000; ++i) {
        const GasVector place_m{2.0 * anywhere(random), anywhere(random), anywhere(random)};
        points.push_back({place_m, PlumeField::Node::of(gasAt(place_m)), i});
    }
    const PlumeField field = fieldOfPoints(points, "points");
    EXPECT_GT(field.nodes().size(), 2000U);
    for (int look = 0; look < 200; ++look) {
        const GasVector place_m{0.1 + 1.8 * anywhere(random), 0.1 + 0.8 * anywhere(random),
                                0.1 + 0.8 * anywhere(random)};
        ASSERT_NEAR(field.at(place_m).temperature_K, gasAt(place_m).temperature_K, 1.0);
        ASSERT_NEAR(field.at(place_m).fraction(HotGas::CO2), gasAt(place_m).fraction(HotGas::CO2),
                    5e-4);
    }
}

TEST(PlumePoints, AreNoGasFarFromAll) {
    // A ball of points.
    std::mt19937 random(5);
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    std::vector<PlumePoint> points;
    while (points.size() < 30000) {
        const GasVector place_m{anywhere(random), anywhere(random), anywhere(random)};
        if (std::hypot(place_m[0], place_m[1], place_m[2]) < 1.0) {
            GasLayer gas;
            gas.temperature_K = 700.0;
            gas.fraction(HotGas::H2O) = 0.1;
            points.push_back({place_m, PlumeField::Node::of(gas), 0});
        }
    }
    const PlumeField field = fieldOfPoints(points, "points");
    EXPECT_TRUE(field.isGasAt({0.0, 0.0, 0.0}));
    EXPECT_TRUE(field.isGasAt({0.9, 0.0, 0.0}));
    EXPECT_FALSE(field.isGasAt({0.9, 0.9, 0.9}));
    double absorbs = 0.0;
    for (const PlumePart& part : field.parts()) {
        absorbs += part.absorbs;
    }
    EXPECT_NEAR(absorbs / (0.3 * 0.1 / 700.0), 4.18879, 1.2) << "the volume of the ball";
}

TEST(PlumePoints, OfAJetAreItsField) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> even(0.0, 1.0);
    std::normal_distribution<double> bell(0.0, 1.0);
    std::vector<PlumePoint> points;
    for (int i = 0; i < 60000; ++i) {
        const double x_m = 6.0 * even(random) * even(random);
        const double width_m = 0.4 + 0.15 * x_m;
        const GasVector place_m{x_m, width_m * bell(random), width_m * bell(random)};
        GasLayer gas;
        const double part = jetPart(place_m[0], place_m[1], place_m[2]);
        gas.temperature_K = 288.0 + 612.0 * part;
        gas.fraction(HotGas::CO2) = 0.04 * part;
        points.push_back({place_m, PlumeField::Node::of(gas), i});
    }
    const PlumeField field = fieldOfPoints(points, "points");
    for (const double x_m : {0.3, 1.0, 2.0, 4.0}) {
        for (const double r_m : {0.0, 0.1, 0.3}) {
            const double expected_K = 288.0 + 612.0 * jetPart(x_m, r_m, 0.0);
            EXPECT_NEAR(field.at({x_m, r_m, 0.0}).temperature_K, expected_K, 30.0)
                << x_m << " " << r_m;
        }
    }
}

TEST(PlumePoints, MayStandTwiceWithOneGas) {
    EXPECT_EQ(refusalOf(head + cube + "1,1,1,800,0.1\n"), "");
}

TEST(PlumePoints, AreRefusedByLineAndValue) {
    EXPECT_EQ(refusalOf(head + cube), "");
    for (const auto& [text, named] : std::vector<std::pair<std::string, std::string>>{
             {"x [m],y [m],T [K],CO2\n0,0,800,0.1\n", "no column z [m]"},
             {"x [m],y [m],z [m],CO2\n0,0,0,0.1\n", "no column T [K]"},
             {"x [m],y [m],z [m],T [K],r [m]\n0,0,0,800,1\n", "column 5"},
             {head + cube + "2,2,hot,800,0.1\n", "line 10, column 3"},
             {head + cube + "2,2,2,800\n", "line 10"},
             {head + cube + "2,2,2,800,1.1\n", "CO2 = 1.1"},
             {head + cube + "2,2,2,200,0.1\n", "T_K = 200"},
             {head + cube + "2,-2e6,2,800,0.1\n", "line 10: found 'y = -2e+06'"},
             {head + cube + "1,1,1,800,0.2\n",
              "line 10: found x = 1, y = 1, z = 1 again, as in line 9"},
             {head + "0,0,0,800,0.1\n1,1,1,800,0.1\n", "2 points"},
             {head + "0,0,0,8e2,0.1\n0,0,1,8e2,0.1\n0,1,0,8e2,0.1\n0,1,1,8e2,0.1\n"
                     "0,2,0,8e2,0.1\n0,2,1,8e2,0.1\n0,3,0,8e2,0.1\n0,3,1,8e2,0.1\n",
              "all points at x = 0 m"}}) {
        EXPECT_NE(refusalOf(text).find(named), std::string::npos) << refusalOf(text);
    }
}

TEST(PlumePoints, AreKnownByTheirHead) {
    EXPECT_TRUE(arePlumePoints(CsvTable::parse(head + cube, "a")));
    EXPECT_FALSE(arePlumePoints(CsvTable::parse("x [m],r [m],T [K]\n0,0,300\n", "a")));
}

} // namespace
