#include "irsg/atmosphere/Environment.h"

#include <cmath>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/radiometry/Errors.h"

using namespace irsg;
using testing::AllOf;
using testing::HasSubstr;

namespace {

const SpectralRange mwir{3.0, 5.0};

std::shared_ptr<const Atmosphere> air(const std::string& name, const SpectralRange& base,
                                      double extinction_per_m, double temperature_K = 288.15) {
    BeerLambertParameters parameters;
    parameters.name = name;
    parameters.extinction_per_m =
        Spectrum({base.min_um, base.max_um}, {extinction_per_m, extinction_per_m});
    parameters.airTemperature_K = temperature_K;
    parameters.solarIrradiance_W_m2_um = Spectrum::constant(10.0);
    parameters.upwardFlux_W_m2_um = Spectrum::constant(2.0);
    parameters.downwardFlux_W_m2_um = Spectrum::constant(3.0);
    return std::make_shared<BeerLambert>(parameters);
}

/// A vacuum whose sun never sets.
class MidnightSun : public Vacuum {
  public:
    std::string name() const override { return "midnight sun"; }
    Spectrum solarIrradiance(double, const SunPosition&, const SpectralRange&) const override {
        return Spectrum::constant(7.0);
    }
};

template <typename Act>
std::string refusal(Act&& act) {
    try {
        act();
    } catch (const InputError& error) {
        return error.what();
    }
    return "answered";
}

} // namespace

TEST(Environment, theFirstOfTwoOverlappingAtmospheresAnswersAndTheOrderDecides) {
    const auto thin = air("thin", {2.0, 6.0}, 1e-5, 280.0);
    const auto thick = air("thick", {3.0, 12.0}, 1e-3, 300.0);
    Environment environment;
    environment.add(thin);
    environment.add(thick);
    Environment swapped;
    swapped.add(thick);
    swapped.add(thin);
    const AirPath path{0.0, 0.0, 1000.0};

    EXPECT_EQ(environment.transmittance(path, mwir).answeredBy, "thin");
    EXPECT_EQ(swapped.transmittance(path, mwir).answeredBy, "thick");
    EXPECT_NEAR(environment.transmittance(path, mwir).value.at(4.0), std::exp(-0.01), 1e-15);
    EXPECT_NEAR(swapped.transmittance(path, mwir).value.at(4.0), std::exp(-1.0), 1e-15);
    EXPECT_EQ(environment.pathRadiance(path, mwir).answeredBy, "thin");
    EXPECT_EQ(swapped.backgroundRadiance({}, mwir).answeredBy, "thick");
    EXPECT_EQ(swapped.solarIrradiance(0.0, mwir).answeredBy, "thick");
    EXPECT_EQ(swapped.upwardFlux(0.0, mwir).answeredBy, "thick");
    EXPECT_EQ(swapped.downwardFlux(0.0, mwir).answeredBy, "thick");
    EXPECT_EQ(environment.ambientTemperature_K(0.0).value, 280.0);
    EXPECT_EQ(swapped.ambientTemperature_K(0.0).value, 300.0);
    // Where one alone holds the band, it answers in either order.
    EXPECT_EQ(environment.transmittance(path, {8.0, 12.0}).answeredBy, "thick");
    EXPECT_EQ(swapped.transmittance(path, {2.0, 2.5}).answeredBy, "thin");
}

TEST(Environment, aBandOneNanometreTooWideIsRefusedByNameAndReason) {
    Environment environment;
    environment.add(air("first", {3.0, 5.0}, 1e-5));
    environment.add(air("second", {2.9, 4.9}, 1e-5));
    EXPECT_EQ(environment.transmittance({}, mwir).answeredBy, "first");
    EXPECT_THAT(refusal([&] {
                    (void)environment.transmittance({}, {2.999, 5.0});
                }),
                AllOf(HasSubstr("environment: transmittance over 2.999-5 um"),
                      HasSubstr("first (holds only 3-5 um)"),
                      HasSubstr("second (holds only 2.9-4.9 um)")));
    EXPECT_THAT(refusal([&] {
                    (void)environment.upwardFlux(0.0, {3.0, 5.001});
                }),
                HasSubstr("upward flux over 3-5.001 um"));
}

TEST(Environment, saysWhichQuantityAnAtmosphereLacks) {
    Environment environment = Environment::vacuum();
    environment.defaultAmbient_K.reset();
    EXPECT_THAT(
        refusal([&] { (void)environment.ambientTemperature_K(0.0); }),
        AllOf(HasSubstr("ambient temperature"), HasSubstr("vacuum (has no ambient temperature)")));
}

TEST(Environment, withoutAtmospheresRefusesAllButItsDefaults) {
    Environment environment;
    EXPECT_THAT(refusal([&] { (void)environment.transmittance({}, mwir); }),
                HasSubstr("found no atmosphere"));
    EXPECT_THAT(refusal([&] { (void)environment.backgroundRadiance({}, mwir); }),
                HasSubstr("background radiance"));
    EXPECT_EQ(environment.ambientTemperature_K(0.0).value, 288.15);
    EXPECT_EQ(environment.ambientTemperature_K(0.0).answeredBy, "default");
    environment.defaultBackground = Spectrum::constant(1.5);
    EXPECT_EQ(environment.backgroundRadiance({}, mwir).value, Spectrum::constant(1.5));
    EXPECT_EQ(environment.backgroundRadiance({}, mwir).answeredBy, "default");
    EXPECT_THROW(environment.add(nullptr), LogicError);
}

TEST(Environment, prefersAnAtmosphereToItsDefaults) {
    Environment environment;
    environment.defaultBackground = Spectrum::constant(1.5);
    environment.add(air("haze", {3.0, 5.0}, 1e-5, 270.0));
    EXPECT_EQ(environment.backgroundRadiance({}, mwir).answeredBy, "haze");
    EXPECT_EQ(environment.ambientTemperature_K(0.0).value, 270.0);
    EXPECT_EQ(environment.backgroundRadiance({}, {3.0, 5.1}).answeredBy, "default");
}

TEST(Environment, sunBelowTheHorizonIsExactlyZeroWhoeverAnswers) {
    Environment environment;
    environment.add(std::make_shared<MidnightSun>());
    environment.sun = {0.0, 0.2};
    EXPECT_EQ(environment.solarIrradiance(0.0, mwir).value, Spectrum::constant(7.0));
    for (const double elevation_rad : {0.0, -0.2}) {
        environment.sun = {0.0, elevation_rad};
        EXPECT_EQ(environment.solarIrradiance(0.0, mwir).value, Spectrum::constant(0.0));
        EXPECT_EQ(environment.solarIrradiance(0.0, mwir).answeredBy, "midnight sun");
    }
}

TEST(Environment, ofVacuumAnswersEverySpectralQuantity) {
    const Environment environment = Environment::vacuum();
    EXPECT_EQ(environment.transmittance({0.0, 0.0, 1e7}, mwir).value, Spectrum::constant(1.0));
    EXPECT_EQ(environment.pathRadiance({}, mwir).value, Spectrum::constant(0.0));
    EXPECT_EQ(environment.backgroundRadiance({}, mwir).answeredBy, "vacuum");
    EXPECT_GT(environment.solarIrradiance(0.0, mwir).value.minimum(), 0.0);
    EXPECT_EQ(environment.upwardFlux(0.0, mwir).value, Spectrum::constant(0.0));
    EXPECT_EQ(environment.downwardFlux(0.0, mwir).value, Spectrum::constant(0.0));
}
