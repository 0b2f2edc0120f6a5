#include "irsg/gas/BentJet.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

using namespace irsg;

namespace {

/// A funnel that points upwards; its wind goes along x.
BentJet funnel(double diameter_m, double temperature_K, double velocity_m_s, double wind_m_s) {
    BentJet jet;
    jet.nozzle.diameter_m = diameter_m;
    jet.nozzle.temperature_K = temperature_K;
    jet.nozzle.velocity_m_s = velocity_m_s;
    jet.nozzle.endsAt = 0.01;
    jet.along = {0.0, 0.0, 1.0};
    jet.wind_m_s = {wind_m_s, 0.0, 0.0};
    return jet;
}

/// Over pi and the density of the air, as its momentum.
double massOf(const BentJet& jet, const BentJet::Section& section) {
    const RoundJet& nozzle = jet.nozzle;
    return nozzle.air_K / nozzle.temperature_K * nozzle.velocity_m_s * 0.25 * nozzle.diameter_m *
           nozzle.diameter_m / section.part;
}
double densityOf(const BentJet& jet, const BentJet::Section& section) {
    return jet.nozzle.air_K /
           (jet.nozzle.air_K + section.part * (jet.nozzle.temperature_K - jet.nozzle.air_K));
}
double radiusOf_m(const BentJet& jet, const BentJet::Section& section) {
    return std::sqrt(massOf(jet, section) / (densityOf(jet, section) * section.velocity_m_s));
}

/// The power by which the height grows with the distance downwind, between two distances.
double powerBetween(const std::vector<BentJet::Section>& sections, double first_m, double last_m) {
    const auto height_m = [&](double x_m) {
        for (const BentJet::Section& section : sections) {
            if (section.place_m[0] >= x_m) {
                return section.place_m[2];
            }
        }
        ADD_FAILURE() << "the jet does not reach " << x_m << " m";
        return 1.0;
    };
    return std::log(height_m(last_m) / height_m(first_m)) / std::log(last_m / first_m);
}

TEST(BentJet, WithoutWindAndWeightIsAStraightJet) {
    // Its own law for gas as dense as the air: mass over that of the nozzle is 1 + 4 alpha x / D,
    // alpha 0.1, the axis twice the mean. That of the straight jet, 5 D / x, is its limit.
    BentJet jet = funnel(0.5, 288.5, 100.0, 0.0);
    jet.gravity_m_s2 = 0.0;
    jet.along = {0.6, 0.0, 0.8};
    const auto sections = jet.sections();
    for (const BentJet::Section& section : sections) {
        const double over = section.along_m / (0.5 * std::sqrt(288.0 / 288.5));
        ASSERT_NEAR(1.0 / section.part, 1.0 + 0.4 * over, 0.002 / section.part);
        ASSERT_NEAR(section.place_m[0] / 0.6, section.along_m, 1e-9);
        ASSERT_NEAR(section.place_m[2] / 0.8, section.along_m, 1e-9);
        ASSERT_NEAR(section.velocity_m_s, 100.0 * section.part, 1e-6) << "momentum is lost";
    }
    // Both end at a hundredth of the exhaust: the straight one at 500 diameters.
    EXPECT_NEAR(sections.back().along_m / 0.5, 497.5, 1.0);
    const PlumeTable straight = jet.nozzle.table();
    const PlumeTable own = jet.flow().table;
    for (const auto& [diameters, apart] :
         std::vector<std::pair<double, double>>{{10.0, 0.22}, {50.0, 0.06}, {400.0, 0.02}}) {
        const auto rise_K = [&](const PlumeTable& table) {
            return table.at(0.5 * diameters, 0.0).temperature_K - 288.0;
        };
        EXPECT_NEAR(rise_K(own) / rise_K(straight), 1.0, apart) << diameters;
        EXPECT_LT(rise_K(own), 1.01 * rise_K(straight)) << diameters;
    }
}

TEST(BentJet, KeepsMomentumAndExhaust) {
    const BentJet jet = funnel(1.3, 547.0, 18.0, 4.0);
    const auto sections = jet.sections();
    const double mass0 = massOf(jet, sections.front());
    double lifted = 0.0;
    for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
        const BentJet::Section &here = sections[i], &next = sections[i + 1];
        const double radius_m = radiusOf_m(jet, here);
        lifted += 9.80665 * (1.0 - densityOf(jet, here)) * radius_m * radius_m *
                  (next.along_m - here.along_m);
        const double mass = massOf(jet, next), momentum = mass * next.velocity_m_s;
        ASSERT_NEAR(momentum * next.along[0], 4.0 * (mass - mass0), 1e-9 * momentum);
        ASSERT_NEAR(momentum * next.along[1], 0.0, 1e-9 * momentum);
        ASSERT_NEAR(momentum * next.along[2], 18.0 * mass0 + lifted, 1e-9 * momentum);
    }
    // What the bells of the table carry is what leaves the nozzle.
    const BentJet::Flow flow = jet.flow(96, 56);
    const double heat = 547.0 / 288.0 - 1.0;
    const GasLayer hot = jet.nozzle.nozzleGas();
    for (const double along_m : {2.0, 5.0, 10.0, 25.0}) {
        double carried = 0.0;
        constexpr int steps = 4000;
        const double step_m = flow.table.r_m().back() / steps;
        for (int i = 0; i < steps; ++i) {
            const double r_m = (i + 0.5) * step_m;
            const double part = flow.table.at(along_m, r_m).fraction(HotGas::CO2) /
                                (hot.fraction(HotGas::CO2) - jet.nozzle.airCO2);
            carried += part / (1.0 + part * heat) * 2.0 * r_m * step_m;
        }
        carried *= flow.axisAt(along_m).velocity_m_s;
        EXPECT_NEAR(carried / mass0, 1.0, 0.03) << along_m;
    }
}

TEST(BentJet, RisesInStillAirAsAPlume) {
    // Morton, Taylor and Turner 1956 (Proc. R. Soc. Lond. A 234, 1): a plume of one state across
    // widens by 6/5 of what it takes in, 0.1.
    const BentJet jet = funnel(1.0, 600.0, 1.0, 0.0);
    const auto sections = jet.sections();
    const BentJet::Section &far = sections.back(), &near = sections[sections.size() / 2];
    EXPECT_NEAR((radiusOf_m(jet, far) - radiusOf_m(jet, near)) / (far.along_m - near.along_m), 0.12,
                0.004);
    // And its gas thins by the power -5/3 of the distance from where it would begin, or the radius.
    EXPECT_NEAR(std::log(near.part / far.part) /
                    std::log(radiusOf_m(jet, far) / radiusOf_m(jet, near)),
                5.0 / 3.0, 0.05);
}

TEST(BentJet, RisesInWindByTheTwoThirdsOfBriggs) {
    // G. A. Briggs 1984 (in Atmospheric Science and Power Production): height 1.6 F^(1/3) x^(2/3)
    // / U with the flux F = g V r^2 (1 - density) of a source of little momentum. As much wind as
    // the projected area meets makes it (3 / (2 (2 / pi)^2))^(1/3) = 1.55.
    const BentJet jet = funnel(4.0, 500.0, 6.0, 3.0);
    const auto sections = jet.sections();
    const double flux = 9.80665 * 6.0 * 4.0 * (1.0 - 288.0 / 500.0);
    const BentJet::Section& last = sections.back();
    // Cubes of the heights by buoyancy and by momentum add up (3 / beta^2 M x / U^2, beta 2 / pi).
    const double x_m = last.place_m[0];
    const double byMomentum_m3 = 3.0 / 0.4053 * 288.0 / 500.0 * 36.0 * 4.0 * x_m / 9.0;
    const double byHeat_m = std::cbrt(std::pow(last.place_m[2], 3) - byMomentum_m3);
    EXPECT_NEAR(byHeat_m / (std::cbrt(flux * x_m * x_m) / 3.0), 1.6, 0.2);
    EXPECT_NEAR(powerBetween(sections, 0.3 * last.place_m[0], last.place_m[0]), 2.0 / 3.0, 0.05);
}

TEST(BentJet, BendsInWindByTheThirdOfItsMomentum) {
    // Jets across a wind follow y / (R D) = A (x / (R D))^B, R the ratio of velocities, with A of
    // 1.2 to 2.6 and B of 0.28 to 0.34 (R. J. Margason 1993, AGARD-CP-534). The model: 1.23, 1/3.
    for (const double ratio : {4.0, 8.0, 16.0}) {
        BentJet jet = funnel(1.0, 289.0, 20.0 * ratio, 20.0);
        jet.gravity_m_s2 = 0.0;
        const auto sections = jet.sections();
        const BentJet::Section& last = sections.back();
        // At 16 it has not bent over where it ends.
        EXPECT_NEAR(powerBetween(sections, 0.3 * last.place_m[0], last.place_m[0]), 0.31,
                    ratio < 10.0 ? 0.03 : 0.04)
            << ratio;
        const double a = last.place_m[2] / ratio / std::cbrt(last.place_m[0] / ratio);
        EXPECT_GT(a, 1.2) << ratio;
        EXPECT_LT(a, 1.6) << ratio;
    }
}

TEST(BentJet, TurnsWithItsVectors) {
    BentJet jet = funnel(1.3, 547.0, 18.0, 4.0);
    jet.wind_m_s = {3.0, 2.0, 0.0};
    jet.along = {0.0, 0.6, 0.8};
    BentJet turned = jet;
    const auto turn = [](const GasVector& v) { return GasVector{v[2], v[0], v[1]}; };
    turned.wind_m_s = turn(jet.wind_m_s);
    turned.along = turn(jet.along);
    turned.up = turn(jet.up);
    const auto one = jet.sections(), other = turned.sections();
    ASSERT_EQ(one.size(), other.size());
    const GasVector expected = turn(one.back().place_m);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(other.back().place_m[axis], expected[axis], 1e-6);
    }
    EXPECT_GT(one.back().place_m[0], 1.0) << "it does not go to the side";
}

TEST(BentJet, IsRefusedWhereWindStopsOrFoldsIt) {
    const auto refusalOf = [](const BentJet& jet) -> std::string {
        try {
            jet.sections();
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    BentJet against = funnel(1.0, 600.0, 30.0, 0.0);
    against.gravity_m_s2 = 0.0;
    against.wind_m_s = {0.0, 0.0, -20.0};
    EXPECT_NE(refusalOf(against).find("wind_m_s"), std::string::npos) << refusalOf(against);
    const BentJet across = funnel(1.0, 600.0, 10.0, 60.0);
    EXPECT_NE(refusalOf(across).find("within its own width"), std::string::npos)
        << refusalOf(across);
    // As fast as the air: nothing mixes them.
    BentJet along = funnel(1.0, 289.0, 30.0, 0.0);
    along.gravity_m_s2 = 0.0;
    along.wind_m_s = {0.0, 0.0, 30.0};
    EXPECT_NE(refusalOf(along).find("3000 diameters"), std::string::npos) << refusalOf(along);
    EXPECT_EQ(refusalOf(funnel(1.3, 547.0, 18.0, 4.0)), "");
}

TEST(BentJet, FillsSpaceAboutItsAxis) {
    BentJet jet = funnel(1.3, 547.0, 18.0, 4.0);
    jet.nozzle.endsAt = 0.1;
    const BentJet::Flow flow = jet.flow(96, 56);
    const PlumeField field = bentJetField(flow, 200000);
    for (const double along_m : {1.0, 3.0, 6.0}) {
        const BentJet::Section at = flow.axisAt(along_m);
        const double expected_K = flow.table.at(along_m, 0.0).temperature_K;
        EXPECT_NEAR(field.at(at.place_m).temperature_K, expected_K, 0.05 * (expected_K - 288.0))
            << along_m;
        EXPECT_TRUE(field.isGasAt(at.place_m));
    }
    // As much heat is in it as about a straight axis, but for what the bend takes.
    double inSpace = 0.0;
    for (const PlumePart& part : field.parts()) {
        inSpace += part.absorbs;
    }
    double aboutAxis = 0.0;
    const double end_m = flow.table.x_m().back(), wide_m = flow.table.r_m().back();
    constexpr int steps = 300;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double r_m = wide_m * (j + 0.5) / steps;
            aboutAxis += thinAbsorption(flow.table.at(end_m * (i + 0.5) / steps, r_m)) * 2.0 *
                         3.14159265 * r_m * wide_m / steps * end_m / steps;
        }
    }
    EXPECT_NEAR(inSpace / aboutAxis, 1.0, 0.05);
    EXPECT_FALSE(std::ranges::all_of(field.nodes(), &PlumeField::Node::isGas))
        << "there is gas behind its end";
}

} // namespace
