#include <cmath>
#include <string>
#include <vector>

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

/// g/cm2 of a gas above the ground, by fine trapezoids.
double column_g_per_cm2(const Profile& profile, Gas gas, double molarMass_g) {
    double sum_per_m2 = 0.0;
    const double step_m = 10.0;
    for (double z = 0.0; z < profile.top_m(); z += step_m) {
        sum_per_m2 += profile.at(z + 0.5 * step_m).density_per_m3(gas) * step_m;
    }
    return sum_per_m2 * 1e-4 * molarMass_g / 6.02214076e23;
}

} // namespace

TEST(Profile, HoldsThePublishedNumbersOfTheModels) {
    const AtmosphericState tropical = Profile::model(ModelAtmosphere::tropical, 330.0).at(0.0);
    EXPECT_EQ(tropical.pressure_hPa, 1013.0);
    EXPECT_EQ(tropical.temperature_K, 299.7);
    EXPECT_NEAR(tropical.fraction(Gas::H2O), 25930e-6, 1e-15);
    EXPECT_NEAR(tropical.fraction(Gas::O2), 0.209, 1e-15);
    const AtmosphericState winter = Profile::model(ModelAtmosphere::subarcticWinter).at(1000.0);
    EXPECT_EQ(winter.temperature_K, 259.1);
    EXPECT_EQ(winter.pressure_hPa, 887.8);
    const Profile standard = Profile::model(ModelAtmosphere::usStandard1976);
    EXPECT_NEAR(standard.at(0.0).temperature_K, 288.15, 0.06);
    EXPECT_NEAR(standard.at(11000.0).temperature_K, 216.65, 0.2);
    EXPECT_EQ(standard.top_m(), 100000.0);
    EXPECT_EQ(standard.name(), "US standard 1976");
}

// MODTRAN prints 4.1147 and 0.000594 g/cm2 for the tropical, 1.416445 and 0.000736 for the US
// standard atmosphere (headers of its tape7). It interpolates between the 36 levels it runs.
TEST(Profile, HasTheColumnsThatModtranPrints) {
    struct Case {
        ModelAtmosphere model;
        double water_g_per_cm2;
        double ozone_g_per_cm2;
    };
    for (const Case& each : {Case{ModelAtmosphere::tropical, 4.1147, 0.000594},
                             Case{ModelAtmosphere::usStandard1976, 1.416445, 0.000736}}) {
        const Profile full = Profile::model(each.model);
        EXPECT_NEAR(column_g_per_cm2(full, Gas::H2O, 18.015) / each.water_g_per_cm2, 1.0, 1e-3);
        EXPECT_NEAR(column_g_per_cm2(full, Gas::O3, 47.998) / each.ozone_g_per_cm2, 1.0, 0.02);

        std::vector<AtmosphericState> levels;
        for (const AtmosphericState& level : full.levels()) {
            const double z = level.altitude_m;
            if (z <= 25000.0 || (z <= 50000.0 && std::fmod(z, 5000.0) == 0.0) ||
                std::fmod(z, 10000.0) == 0.0) {
                levels.push_back(level);
            }
        }
        EXPECT_NEAR(column_g_per_cm2(Profile(levels), Gas::O3, 47.998) / each.ozone_g_per_cm2, 1.0,
                    2e-3);
    }
}

TEST(Profile, ScalesTheWholeProfileOfCarbonDioxide) {
    const Profile air = Profile::model(ModelAtmosphere::midlatitudeSummer, 420.0);
    EXPECT_NEAR(air.at(0.0).fraction(Gas::CO2), 420e-6, 1e-12);
    EXPECT_NEAR(air.at(100000.0).fraction(Gas::CO2), 195e-6 * 420.0 / 330.0, 1e-12);
    EXPECT_EQ(Profile::model(ModelAtmosphere::tropical, 0.0).at(0.0).fraction(Gas::CO2), 0.0);
    EXPECT_THROW(Profile::model(ModelAtmosphere::tropical, -1.0), InputError);
    EXPECT_THROW(Profile::model(ModelAtmosphere::tropical, std::nan("")), InputError);
    EXPECT_THROW(Profile::model(static_cast<ModelAtmosphere>(7)), InputError);
}

TEST(Profile, IsLinearInTemperatureAndInLogarithmsOfPressureAndGases) {
    AtmosphericState low{0.0, 1000.0, 300.0, {}};
    AtmosphericState high{1000.0, 810.0, 290.0, {}};
    low.moleFraction = {0.04, 4e-4, 0.0, 0.0, 0.0, 0.0, 0.2, 0.0};
    high.moleFraction = {0.01, 4e-4, 1e-6, 0.0, 0.0, 0.0, 0.2, 0.0};
    const AtmosphericState middle = Profile({low, high}).at(500.0);
    EXPECT_NEAR(middle.temperature_K, 295.0, 1e-12);
    EXPECT_NEAR(middle.pressure_hPa, 900.0, 1e-10);
    EXPECT_NEAR(middle.fraction(Gas::H2O), 0.02, 1e-15);
    EXPECT_NEAR(middle.fraction(Gas::O3), 5e-7, 1e-20);
    EXPECT_EQ(middle.fraction(Gas::CH4), 0.0);
}

TEST(Profile, HoldsItsEndsOutside) {
    const Profile air = Profile::model(ModelAtmosphere::tropical);
    EXPECT_EQ(air.at(-10.0).pressure_hPa, 1013.0);
    EXPECT_EQ(air.at(1e6).temperature_K, air.levels().back().temperature_K);
    EXPECT_EQ(air.at(1e6).altitude_m, 1e6);
    EXPECT_EQ(air.at(air.top_m()).pressure_hPa, air.levels().back().pressure_hPa);
}

// Murphy and Koop 2005, table C1: values over supercooled and liquid water.
TEST(Profile, KnowsTheSaturationPressureOfWater) {
    EXPECT_NEAR(saturationPressure_hPa(273.16), 6.11657, 2e-4);
    EXPECT_NEAR(saturationPressure_hPa(240.0), 0.37667, 1e-4);
    EXPECT_NEAR(saturationPressure_hPa(300.0), 35.368, 0.005);
    AtmosphericState air{0.0, 1000.0, 300.0, {}};
    air.moleFraction[0] = 0.5 * saturationPressure_hPa(300.0) / 1000.0;
    EXPECT_NEAR(relativeHumidity(air), 0.5, 1e-12);
}

TEST(Profile, OfEveryModelIsNearHydrostaticAndUnsaturatedLow) {
    for (const ModelAtmosphere model : allModels) {
        const Profile air = Profile::model(model);
        for (double z = 0.0; z < 10000.0; z += 1000.0) {
            const AtmosphericState middle = air.at(z + 500.0);
            const double mass = 28.964e-3 - middle.fraction(Gas::H2O) * 10.95e-3;
            const double fall = std::log(air.at(z).pressure_hPa / air.at(z + 1000.0).pressure_hPa);
            EXPECT_NEAR(fall, 9.80665 * mass * 1000.0 / 8.314462618 / middle.temperature_K, 3e-3);
            EXPECT_LT(relativeHumidity(air.at(z)), 1.0);
        }
    }
}

TEST(Profile, RefusesLevelsByName) {
    struct Case {
        const char* name;
        std::vector<AtmosphericState> levels;
        const char* words;
    };
    const auto level = [](double z, double p, double t, double water = 0.01) {
        AtmosphericState air{z, p, t, {}};
        air.moleFraction[0] = water;
        return air;
    };
    const double nan = std::nan("");
    const Case cases[] = {
        {"none", {}, "at least two levels"},
        {"one", {level(0, 1000, 300)}, "at least two levels"},
        {"above ground", {level(5, 1000, 300), level(10, 900, 300)}, "the lowest level at 0 m"},
        {"same altitude", {level(0, 1000, 300), level(0, 900, 300)}, "ascend strictly"},
        {"descending", {level(0, 1000, 300), level(-5, 900, 300)}, "ascend strictly"},
        {"rising pressure", {level(0, 1000, 300), level(9, 1001, 300)}, "pressure falls"},
        {"no pressure", {level(0, 1000, 300), level(9, 0, 300)}, "more than 0"},
        {"cold", {level(0, 1000, 99), level(9, 900, 300)}, "100 to 400 K"},
        {"hot", {level(0, 1000, 300), level(9, 900, 401)}, "100 to 400 K"},
        {"nan temperature", {level(0, 1000, nan), level(9, 900, 300)}, "100 to 400 K"},
        {"nan altitude", {level(0, 1000, 300), level(nan, 900, 300)}, "finite altitude"},
        {"too wet", {level(0, 1000, 300, 1.1), level(9, 900, 300)}, "mole fraction of 0 to 1"},
        {"negative gas", {level(0, 1000, 300, -0.1), level(9, 900, 300)}, "H2O -0.1"}};
    for (const Case& each : cases) {
        SCOPED_TRACE(each.name);
        try {
            const Profile profile(each.levels, "mine");
            FAIL() << "nothing was refused";
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(each.words));
            EXPECT_THAT(error.what(), HasSubstr("mine"));
        }
    }
}

TEST(Profile, NamesEveryBadLevelAtOnce) {
    try {
        const Profile profile(
            {AtmosphericState{0.0, 1000.0, 50.0, {}}, AtmosphericState{10.0, 1001.0, 500.0, {}}});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 3u);
    }
}
