// Lines of measured spectra that are narrower than the bins of the air.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

namespace {

constexpr IrCodes one{1, 1};

Environment airOf(int resolution_per_cm) {
    AtmosphereSmartParameters parameters;
    parameters.resolution_per_cm = resolution_per_cm;
    Environment environment;
    environment.add(std::make_shared<const AtmosphereSmart>(parameters));
    environment.sun.elevation_rad = radians(-90.0);
    return environment;
}

/// A body that sends a triangle of this half width about a wavenumber.
Entity lamp(double centre_per_cm, double halfWidth_per_cm) {
    SignatureDatabase database = greyDatabase(1.0, 300.0);
    TemperatureEntry& entry = database.temperatures[1];
    entry.mode = EmissionMode::userSpectrum;
    entry.userSpectrum = "laser";
    const auto at_um = [](double wavenumber_per_cm) { return 1e4 / wavenumber_per_cm; };
    database.spectra["laser"] = {
        "laser",
        0.0,
        "W m-2 sr-1 um-1",
        "",
        {{"line", Spectrum({at_um(centre_per_cm + halfWidth_per_cm), at_um(centre_per_cm),
                            at_um(centre_per_cm - halfWidth_per_cm)},
                           {0.0, 1e6, 0.0}, Spectrum::Outside::zero)}}};
    return entityOf(modelOf(sphereMesh(1.0, 8, 16, one)), std::move(database));
}

RenderReport seen(double halfWidth_per_cm, int resolution_per_cm) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = airOf(resolution_per_cm);
    // Beside lines of water vapour.
    irsg.scene.entities = {lamp(2100.0, halfWidth_per_cm)};
    look(irsg, {.range_m = 2000.0,
                .width_px = 32,
                .height_px = 32,
                .fieldOfView_rad = 0.01,
                .band = Band::topHat(4.5, 5.0)});
    return irsg.measure();
}

constexpr const char* sentence = "'laser' has lines narrower than the bins of the air";

} // namespace

TEST(MeasuredLines, SayWhatTheBinsOfTheAirMayLeaveWrong) {
    const RenderReport wide = seen(0.1, 15);
    const auto found = std::ranges::find_if(wide.warnings, [](const std::string& warning) {
        return warning.find(sentence) != std::string::npos;
    });
    ASSERT_NE(found, wide.warnings.end());
    // Narrower bins lie within what is said of wide ones.
    const std::size_t number = found->rfind(' ', found->size() - 3);
    const double stated = found->ends_with(" %") ? std::stod(found->substr(number)) / 100.0 : 1.0;
    const double error = wide.all.intensity_W_sr / seen(0.1, 1).all.intensity_W_sr - 1.0;
    EXPECT_GT(std::abs(error), 0.01);
    EXPECT_LT(std::abs(error), stated);
}

TEST(MeasuredLines, OfBroadSpectraAreNoMatter) {
    EXPECT_THAT(seen(60.0, 15).warnings, Not(Contains(HasSubstr(sentence))));
}
