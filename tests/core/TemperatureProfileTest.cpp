#include "smatcore/tools/TemperatureProfile.h"

#include <cmath>
#include <limits>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/core/Errors.h"

namespace smat {
namespace {

/// The lowest layers of the U.S. Standard Atmosphere, 1976: 288.15 K at 0, falling by 6.5 K/km to
/// 216.65 K at 11 km and constant from there to 20 km.
class Standard : public irsg::Atmosphere {
  public:
    std::string name() const override { return "standard"; }
    irsg::SpectralRange base() const override { return {0.2, 40.0}; }
    bool supports(irsg::AtmosphereProperty property) const override {
        return property == irsg::AtmosphereProperty::ambientTemperature;
    }
    double ambientTemperature_K(double altitude_m) const override {
        return std::max(288.15 - 6.5e-3 * altitude_m, 216.65);
    }
};

irsg::Environment standard() {
    irsg::Environment environment = irsg::Environment::vacuum();
    environment.add(std::make_shared<Standard>());
    return environment;
}

TEST(TemperatureProfile, FollowsTheStandardAtmosphere) {
    const ResultTable table =
        temperatureProfile(standard(), {.min_m = 0.0, .max_m = 20e3, .step_m = 1000.0});
    ASSERT_EQ(table.rowCount(), 21u);
    EXPECT_EQ(table.columns()[0].header(), "altitude [m]");
    EXPECT_EQ(table.columns()[1].header(), "temperature [K]");
    EXPECT_NEAR(table.columns()[1].values[0], 288.15, 1e-12);
    EXPECT_NEAR(table.columns()[1].values[11], 216.65, 1e-12);
    EXPECT_EQ(table.columns()[0].values.back(), 20e3);
    EXPECT_EQ(table.provenance.value("answered by"), "ambient temperature: standard");
}

/// One of the model atmospheres that ship with the program.
class Model : public Standard {
  public:
    double ambientTemperature_K(double altitude_m) const override {
        return profile_.at(altitude_m).temperature_K;
    }

  private:
    irsg::Profile profile_ = irsg::Profile::model(irsg::ModelAtmosphere::usStandard1976);
};

TEST(TemperatureProfile, OfTheModelAtmosphereIsTheStandardWithinItsTable) {
    // The table of Anderson et al. (1986) gives tenths of a kelvin, and 216.8 K at 11 km.
    irsg::Environment model;
    model.add(std::make_shared<Model>());
    const TemperatureProfileRequest request = {.min_m = 0.0, .max_m = 20e3, .step_m = 500.0};
    const ResultTable table = temperatureProfile(model, request);
    const ResultTable expected = temperatureProfile(standard(), request);
    const auto& temperatures = table.find("temperature")->values;
    EXPECT_NEAR(temperatures.at(0), 288.15, 0.051);
    EXPECT_NEAR(temperatures.at(22), 216.65, 0.151);
    for (std::size_t i = 0; i < temperatures.size(); ++i) {
        EXPECT_NEAR(temperatures[i], expected.find("temperature")->values[i], 0.2) << i;
    }
}

TEST(TemperatureProfile, HasEachAltitudeOnceWithoutRoundingAway) {
    // A tenth has no exact double; a step that does not fit ends below max.
    EXPECT_EQ(
        temperatureProfile(standard(), {.min_m = 0.0, .max_m = 1.0, .step_m = 0.1}).rowCount(),
        11u);
    const ResultTable table =
        temperatureProfile(standard(), {.min_m = 5.0, .max_m = 12.0, .step_m = 3.0});
    EXPECT_THAT(table.columns()[0].values, testing::ElementsAre(5.0, 8.0, 11.0));
    EXPECT_EQ(
        temperatureProfile(standard(), {.min_m = 7.0, .max_m = 7.0, .step_m = 1.0}).rowCount(), 1u);
}

TEST(TemperatureProfile, DoesNotTakeTheDefaultForAProfile) {
    EXPECT_THROW(temperatureProfile(irsg::Environment::vacuum(), {}), irsg::InputError);
}

struct BadRow {
    const char* name;
    TemperatureProfileRequest request;
    std::vector<std::string> named;
};

void PrintTo(const BadRow& row, std::ostream* out) {
    *out << row.name;
}

class BadTemperatureProfile : public testing::TestWithParam<BadRow> {};

TEST_P(BadTemperatureProfile, IsRefusedByName) {
    try {
        temperatureProfile(standard(), GetParam().request);
        FAIL() << "nothing was refused";
    } catch (const irsg::InputError& error) {
        for (const std::string& named : GetParam().named) {
            EXPECT_THAT(error.what(), testing::HasSubstr(named));
        }
    }
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Rows, BadTemperatureProfile,
    testing::Values(BadRow{"BelowGround", {-1, 10, 1, ""}, {"min: found -1 m"}},
                    BadRow{"Reversed", {10, 5, 1, ""}, {"max: found 5 m", "10 m"}},
                    BadRow{"NoStep", {0, 5, 0, ""}, {"step: found 0 m"}},
                    BadRow{"NegativeStep", {0, 5, -1, ""}, {"step: found -1 m"}},
                    BadRow{"TooManyRows", {0, 1e5, 1e-3, ""}, {"step: found 0.001 m", "1000000"}},
                    BadRow{"NoNumbers",
                           {nan, nan, nan, ""},
                           {"min: found nan", "max: found nan", "step: found nan"}}),
    [](const auto& row) { return row.param.name; });

} // namespace
} // namespace smat
