#include "irsg/atmosphere/Environment.h"

#include <cmath>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/core/Errors.h"

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

  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery&, const SpectralRange&) const override {
        return Spectrum::constant(7.0);
    }
};

Provided<Spectrum> transmittance(const Environment& environment, const AtmosphericPath& path,
                                 const SpectralRange& range) {
    return environment.spectrum(AtmosphericQuery::transmittance(path), range);
}
Provided<Spectrum> pathRadiance(const Environment& environment, const AtmosphericPath& path,
                                const SpectralRange& range) {
    return environment.spectrum(AtmosphericQuery::pathRadiance(path, environment.sun), range);
}
Provided<Spectrum> backgroundRadiance(const Environment& environment, const LineOfSight& sight,
                                      const SpectralRange& range) {
    return environment.spectrum(AtmosphericQuery::backgroundRadiance(sight, environment.sun),
                                range);
}
Provided<Spectrum> solarIrradiance(const Environment& environment, double altitude_m,
                                   const SpectralRange& range) {
    return environment.spectrum(AtmosphericQuery::solarIrradiance(altitude_m, environment.sun),
                                range);
}
Provided<Spectrum> upwardFlux(const Environment& environment, double altitude_m,
                              const SpectralRange& range) {
    return environment.spectrum(AtmosphericQuery::upwardFlux(altitude_m, environment.sun), range);
}
Provided<Spectrum> downwardFlux(const Environment& environment, double altitude_m,
                                const SpectralRange& range) {
    return environment.spectrum(AtmosphericQuery::downwardFlux(altitude_m, environment.sun), range);
}

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

TEST(Environment, TheFirstOfTwoOverlappingAtmospheresAnswersAndTheOrderDecides) {
    const auto thin = air("thin", {2.0, 6.0}, 1e-5, 280.0);
    const auto thick = air("thick", {3.0, 12.0}, 1e-3, 300.0);
    Environment environment;
    environment.add(thin);
    environment.add(thick);
    Environment swapped;
    swapped.add(thick);
    swapped.add(thin);
    const AtmosphericPath path{0.0, 0.0, 1000.0};

    EXPECT_EQ(transmittance(environment, path, mwir).providedBy, "thin");
    EXPECT_EQ(transmittance(swapped, path, mwir).providedBy, "thick");
    EXPECT_NEAR(transmittance(environment, path, mwir).value.at(4.0), std::exp(-0.01), 1e-15);
    EXPECT_NEAR(transmittance(swapped, path, mwir).value.at(4.0), std::exp(-1.0), 1e-15);
    EXPECT_EQ(pathRadiance(environment, path, mwir).providedBy, "thin");
    EXPECT_EQ(backgroundRadiance(swapped, {}, mwir).providedBy, "thick");
    EXPECT_EQ(solarIrradiance(swapped, 0.0, mwir).providedBy, "thick");
    EXPECT_EQ(upwardFlux(swapped, 0.0, mwir).providedBy, "thick");
    EXPECT_EQ(downwardFlux(swapped, 0.0, mwir).providedBy, "thick");
    EXPECT_EQ(environment.ambientTemperature_K(0.0).value, 280.0);
    EXPECT_EQ(swapped.ambientTemperature_K(0.0).value, 300.0);
    // Where one alone holds the band, it answers in either order.
    EXPECT_EQ(transmittance(environment, path, {8.0, 12.0}).providedBy, "thick");
    EXPECT_EQ(transmittance(swapped, path, {2.0, 2.5}).providedBy, "thin");
}

TEST(Environment, ABandOneNanometreTooWideIsRefusedByNameAndReason) {
    Environment environment;
    environment.add(air("first", {3.0, 5.0}, 1e-5));
    environment.add(air("second", {2.9, 4.9}, 1e-5));
    EXPECT_EQ(transmittance(environment, {}, mwir).providedBy, "first");
    EXPECT_THAT(refusal([&] {
                    (void)transmittance(environment, {}, {2.999, 5.0});
                }),
                AllOf(HasSubstr("environment: transmittance over 2.999-5 um"),
                      HasSubstr("first (holds only 3-5 um)"),
                      HasSubstr("second (holds only 2.9-4.9 um)")));
    EXPECT_THAT(refusal([&] {
                    (void)upwardFlux(environment, 0.0, {3.0, 5.001});
                }),
                HasSubstr("upward flux over 3-5.001 um"));
}

TEST(Environment, SaysWhichQuantityAnAtmosphereLacks) {
    Environment environment = Environment::vacuum();
    environment.defaultAmbient_K.reset();
    EXPECT_THAT(
        refusal([&] { (void)environment.ambientTemperature_K(0.0); }),
        AllOf(HasSubstr("ambient temperature"), HasSubstr("vacuum (has no ambient temperature)")));
}

TEST(Environment, WithoutAtmospheresRefusesAllButItsDefaults) {
    Environment environment;
    EXPECT_THAT(refusal([&] { (void)transmittance(environment, {}, mwir); }),
                HasSubstr("found no atmosphere"));
    EXPECT_THAT(refusal([&] { (void)backgroundRadiance(environment, {}, mwir); }),
                HasSubstr("background radiance"));
    EXPECT_EQ(environment.ambientTemperature_K(0.0).value, 288.15);
    EXPECT_EQ(environment.ambientTemperature_K(0.0).providedBy, "default");
    environment.defaultBackground = Spectrum::constant(1.5);
    EXPECT_EQ(backgroundRadiance(environment, {}, mwir).value, Spectrum::constant(1.5));
    EXPECT_EQ(backgroundRadiance(environment, {}, mwir).providedBy, "default");
    EXPECT_THROW(environment.add(nullptr), LogicError);
}

TEST(Environment, PrefersAnAtmosphereToItsDefaults) {
    Environment environment;
    environment.defaultBackground = Spectrum::constant(1.5);
    environment.add(air("haze", {3.0, 5.0}, 1e-5, 270.0));
    EXPECT_EQ(backgroundRadiance(environment, {}, mwir).providedBy, "haze");
    EXPECT_EQ(environment.ambientTemperature_K(0.0).value, 270.0);
    EXPECT_EQ(backgroundRadiance(environment, {}, {3.0, 5.1}).providedBy, "default");
}

TEST(Environment, SunBelowTheHorizonIsExactlyZeroWhoeverAnswers) {
    Environment environment;
    environment.add(std::make_shared<MidnightSun>());
    environment.sun = {0.0, 0.2};
    EXPECT_EQ(solarIrradiance(environment, 0.0, mwir).value, Spectrum::constant(7.0));
    for (const double elevation_rad : {-0.01, -0.2}) {
        environment.sun = {0.0, elevation_rad};
        EXPECT_EQ(solarIrradiance(environment, 0.0, mwir).value, Spectrum::constant(0.0));
        EXPECT_EQ(solarIrradiance(environment, 0.0, mwir).providedBy, "midnight sun");
    }
}

TEST(Environment, OfVacuumAnswersEverySpectralQuantity) {
    const Environment environment = Environment::vacuum();
    EXPECT_EQ(transmittance(environment, {0.0, 0.0, 1e7}, mwir).value, Spectrum::constant(1.0));
    EXPECT_EQ(pathRadiance(environment, {}, mwir).value, Spectrum::constant(0.0));
    EXPECT_EQ(backgroundRadiance(environment, {}, mwir).providedBy, "vacuum");
    EXPECT_GT(solarIrradiance(environment, 0.0, mwir).value.minimum(), 0.0);
    EXPECT_EQ(upwardFlux(environment, 0.0, mwir).value, Spectrum::constant(0.0));
    EXPECT_EQ(downwardFlux(environment, 0.0, mwir).value, Spectrum::constant(0.0));
}
