#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/Environment.h"
#include "irsg/atmosphere/SpectraAtmosphere.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Quadrature.h"
#include "tests/atmosphere/SyntheticAtmosphere.h"
#include "tests/atmosphere/TabulatedSupport.h"
#include "tests/support/Refusal.h"

using namespace irsg;
using smat::test::refusalOf;
using testing::AllOf;
using testing::HasSubstr;

namespace {

const AtmosphericPath path{300.0, 100.0, 1000.0, 0.4};
const SunPosition day{0.3, 0.6};
const LineOfSight up{300.0, 0.2, 1.0};

/// Every spectral query about one geometry.
std::vector<AtmosphericQuery> queries() {
    return {AtmosphericQuery::transmittance(path),
            AtmosphericQuery::pathRadiance(path, day),
            AtmosphericQuery::backgroundRadiance(up, day),
            AtmosphericQuery::solarIrradiance(100.0, day),
            AtmosphericQuery::upwardFlux(100.0, day),
            AtmosphericQuery::downwardFlux(100.0, day),
            AtmosphericQuery::scatteringOpticalDepth(path)};
}

std::shared_ptr<const BeerLambert> haze(const std::string& name = "haze",
                                        const SpectralRange& base = {3.0, 5.0}) {
    BeerLambertParameters air;
    air.name = name;
    const double middle_um = 0.45 * base.min_um + 0.55 * base.max_um;
    air.extinction_per_m = Spectrum({base.min_um, middle_um, base.max_um}, {1e-4, 2e-3, 5e-4});
    air.solarIrradiance_W_m2_um = Spectrum({2.0, 14.0}, {10.0, 1.0});
    air.upwardFlux_W_m2_um = Spectrum::constant(2.0);
    air.downwardFlux_W_m2_um = Spectrum::constant(3.0);
    return std::make_shared<BeerLambert>(air);
}

/// In the band of the synthetic gas table.
std::shared_ptr<const AtmosphereSmart> smart(int scatteringMode = 2) {
    AtmosphereSmartParameters parameters;
    parameters.baseWavelengthMin_um = 9.905;
    parameters.baseWavelengthMax_um = 9.995;
    parameters.scatteringMode = scatteringMode;
    return std::make_shared<AtmosphereSmart>(parameters, "smart", "", syntheticatmosphere::table());
}

std::shared_ptr<const SpectraAtmosphere> measured() {
    SpectraAtmosphereParameters air;
    air.name = "measured";
    air.path = path;
    air.sight = up;
    air.targetAltitude_m = 100.0;
    air.sun = day;
    for (const AtmosphericQuery& query : queries()) {
        air.spectra.emplace(query.quantity, Spectrum({3.0, 4.0, 5.0}, {0.25, 0.5, 0.75}));
    }
    return std::make_shared<SpectraAtmosphere>(air);
}

std::shared_ptr<const TabulatedAtmosphere> table() {
    const SyntheticRun run = tabulatedtest::runOver({300.0, 100.0, 1000.0});
    return std::make_shared<TabulatedAtmosphere>(tabulatedtest::family({run}));
}

struct Kind {
    const char* name;
    std::shared_ptr<const Atmosphere> (*make)();
};
void PrintTo(const Kind& row, std::ostream* out) {
    *out << row.name;
}

class EveryAtmosphere : public testing::TestWithParam<Kind> {};

CkRequest requestOf(const Band& band) {
    CkRequest request;
    request.band = band;
    request.sun = day;
    return request;
}

} // namespace

TEST_P(EveryAtmosphere, AnswersAtAnySamplingWithItsNativeSpectrum) {
    const auto air = GetParam().make();
    const SpectralRange base = air->base();
    const SpectralRange range = base.contains({3.2, 4.8})
                                    ? SpectralRange{3.2, 4.8}
                                    : SpectralRange{base.min_um + 0.1 * base.width_um(),
                                                    base.max_um - 0.1 * base.width_um()};
    int answered = 0;
    for (const AtmosphericQuery& query : queries()) {
        if (!air->supports(query.quantity)) {
            EXPECT_THROW((void)air->spectrum(query, range), LogicError);
            EXPECT_THROW((void)air->provide(query, SpectralPoints({4.0})), LogicError);
            continue;
        }
        ++answered;
        const Spectrum native = air->spectrum(query, range);
        EXPECT_TRUE(native.covers(range));
        const SpectralGrid grid(native, range);
        EXPECT_EQ(air->provide(query, grid), native.sample(grid.wavelengths_um()));
        const Spectrum* const kinked[] = {&native};
        const SpectralQuadrature quadrature(
            Band::fromResponse(Spectrum({range.min_um, range.max_um}, {1.0, 0.5})), kinked);
        EXPECT_EQ(air->provide(query, quadrature), quadrature.sampled(native));
    }
    EXPECT_GT(answered, 0);
}

TEST_P(EveryAtmosphere, AnswersTypedCallsWithTheSameSpectra) {
    const auto air = GetParam().make();
    const SpectralRange base = air->base();
    const auto expect = [&](const AtmosphericQuery& query, auto call) {
        if (air->supports(query.quantity)) {
            EXPECT_EQ(call(), air->spectrum(query, base));
        }
    };
    expect(queries()[0], [&] { return air->transmittance(path, base); });
    expect(queries()[1], [&] { return air->pathRadiance(path, day, base); });
    expect(queries()[2], [&] { return air->backgroundRadiance(up, day, base); });
    expect(queries()[3], [&] { return air->solarIrradiance(100.0, day, base); });
    expect(queries()[4], [&] { return air->upwardFlux(100.0, day, base); });
    expect(queries()[5], [&] { return air->downwardFlux(100.0, day, base); });
    expect(queries()[6], [&] { return air->scatteringOpticalDepth(path, base); });
}

TEST_P(EveryAtmosphere, AnswersAtTheVeryEndsOfItsBaseButNotBeyond) {
    const auto air = GetParam().make();
    const SpectralRange base = air->base();
    for (const AtmosphericQuery& query : queries()) {
        if (!air->supports(query.quantity)) {
            continue;
        }
        const Spectrum native = air->spectrum(query, base);
        for (const double end_um : {base.min_um, base.max_um}) {
            const std::vector<double> values = air->provide(query, SpectralPoints({end_um}));
            // Air with bins has the mean of a bin where it is asked for one wavelength.
            EXPECT_NEAR(values.at(0), native.at(end_um), 1e-3 * std::abs(native.at(end_um)));
        }
        const std::vector<double> ends =
            air->provide(query, SpectralPoints({base.min_um, base.max_um}));
        EXPECT_NEAR(ends[0], native.at(base.min_um), 1e-12 * std::abs(ends[0]));
        EXPECT_NEAR(ends[1], native.at(base.max_um), 1e-12 * std::abs(ends[1]));
        EXPECT_THROW((void)air->provide(query, SpectralPoints({base.min_um * (1.0 - 1e-8)})),
                     LogicError);
        EXPECT_THROW((void)air->provide(query, SpectralPoints({base.max_um * (1.0 + 1e-8)})),
                     LogicError);
    }
    EXPECT_FALSE(air->covers({base.max_um * (1.0 + 1e-8), 2.0 * base.max_um}));
}

TEST_P(EveryAtmosphere, DependsOnTheAzimuthOnlyWhereItSaysSo) {
    const auto air = GetParam().make();
    const SpectralRange base = air->base();
    AtmosphericPath turned = path;
    turned.azimuth_rad += 1.0;
    const AtmosphericQuery there = AtmosphericQuery::pathRadiance(turned, day);
    if (air->supports(there.quantity) && !air->dependsOnAzimuth(there.quantity)) {
        EXPECT_EQ(air->spectrum(there, base),
                  air->spectrum(AtmosphericQuery::pathRadiance(path, day), base));
    }
    if (air->supports(AtmosphereProperty::backgroundRadiance) &&
        !air->dependsOnAzimuth(AtmosphereProperty::backgroundRadiance)) {
        const LineOfSight aside{up.sensorAltitude_m, up.elevation_rad, up.azimuth_rad + 1.0};
        EXPECT_EQ(air->spectrum(AtmosphericQuery::backgroundRadiance(aside, day), base),
                  air->spectrum(AtmosphericQuery::backgroundRadiance(up, day), base));
    }
    Environment environment;
    environment.add(air);
    EXPECT_EQ(environment.keyOf(there, base) ==
                  environment.keyOf(AtmosphericQuery::pathRadiance(path, day), base),
              !air->dependsOnAzimuth(there.quantity));
}

TEST_P(EveryAtmosphere, RefusesWhatIsNoGeometry) {
    const auto air = GetParam().make();
    const SpectralRange base = air->base();
    const double nan = std::nan("");
    for (AtmosphericQuery query : queries()) {
        if (!air->supports(query.quantity)) {
            continue;
        }
        query.path.sensorAltitude_m = query.sight.sensorAltitude_m = query.altitude_m = -1.0;
        EXPECT_THROW((void)air->spectrum(query, base), InputError);
    }
    if (air->supports(AtmosphereProperty::transmittance)) {
        EXPECT_THROW((void)air->transmittance({0.0, 0.0, 1.0, nan}, base), InputError);
    }
    AtmosphericQuery temperature;
    temperature.quantity = AtmosphereProperty::ambientTemperature;
    EXPECT_THROW((void)air->spectrum(temperature, base), LogicError);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, EveryAtmosphere,
    testing::Values(
        Kind{"Vacuum",
             []() -> std::shared_ptr<const Atmosphere> { return std::make_shared<Vacuum>(); }},
        Kind{"BeerLambert", []() -> std::shared_ptr<const Atmosphere> { return haze(); }},
        Kind{"Smart", []() -> std::shared_ptr<const Atmosphere> { return smart(); }},
        Kind{"Spectra", []() -> std::shared_ptr<const Atmosphere> { return measured(); }},
        Kind{"Tabulated", []() -> std::shared_ptr<const Atmosphere> { return table(); }}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(ProvidersOfAnEnvironment, AreThoseOfTheFirstThatAccepts) {
    Environment environment;
    environment.add(haze("near", {3.0, 4.0}));
    environment.add(haze("wide", {3.0, 5.0}));
    const AtmosphericQuery query = AtmosphericQuery::transmittance(path);
    const SpectralPoints low({3.2, 3.9}), all({3.2, 4.9});
    EXPECT_EQ(environment.provide(query, low).providedBy, "near");
    EXPECT_EQ(environment.provide(query, low).value,
              environment.atmospheres()[0]->provide(query, low));
    EXPECT_EQ(environment.provide(query, all).providedBy, "wide");
    EXPECT_EQ(environment.provide(query, all).value,
              environment.atmospheres()[1]->provide(query, all));
    EXPECT_THAT(refusalOf([&] {
                    (void)environment.provide(query, SpectralPoints({4.0, 5.5}));
                }),
                AllOf(HasSubstr("environment: transmittance over 4-5.5 um"),
                      HasSubstr("near (holds only 3-4 um)"),
                      HasSubstr("wide (holds only 3-5 um)")));
}

TEST(ProvidersOfAnEnvironment, TakeTheDefaultBackgroundWhereNobodyHasOne) {
    Environment environment;
    const AtmosphericQuery query = AtmosphericQuery::backgroundRadiance(up, day);
    const SpectralPoints points({3.0, 4.0});
    EXPECT_THAT(refusalOf([&] { (void)environment.provide(query, points); }),
                AllOf(HasSubstr("background radiance"), HasSubstr("no atmosphere")));
    environment.defaultBackground = Spectrum({3.0, 5.0}, {1.0, 3.0});
    EXPECT_EQ(environment.provide(query, points).value, (std::vector<double>{1.0, 2.0}));
    EXPECT_EQ(environment.provide(query, points).providedBy, "default");
    environment.add(haze());
    EXPECT_EQ(environment.provide(query, SpectralPoints({3.5})).providedBy, "haze");
}

TEST(ProvidersOfAnEnvironment, AreZeroForASunBelowTheHorizon) {
    Environment environment;
    environment.add(measured()); // refuses any sun but its own
    const SpectralPoints points({3.5, 4.0});
    const auto sunlight = [&](const SunPosition& sun) {
        return environment.provide(AtmosphericQuery::solarIrradiance(100.0, sun), points);
    };
    EXPECT_GT(sunlight(day).value[0], 0.0);
    EXPECT_EQ(sunlight({0.0, -0.02}).value, (std::vector<double>{0.0, 0.0}));
    EXPECT_EQ(sunlight({0.0, -0.3}).providedBy, "measured");
}

TEST(ProvidesAtPoints, AreThoseOfTheAirThatPreparedThem) {
    const auto air = smart();
    Environment environment = Environment::vacuum();
    environment.add(air);
    environment.defaultBackground = Spectrum::constant(5.0);
    const auto points = environment.prepareCk(requestOf(Band::topHat(9.92, 9.98)));
    EXPECT_EQ(points.providedBy, "smart");
    const SensorCkData& ck = *points.value;
    const RadiativeTransfer& transfer = air->transfer();
    const NodeSet& nodes = ck.nodes();
    const auto expect = [&](const AtmosphericQuery& query, const std::vector<double>& values) {
        const auto answer = environment.provide(query, ck);
        EXPECT_EQ(answer.providedBy, "smart"); // though the vacuum is asked first
        EXPECT_EQ(answer.value, values);
        EXPECT_EQ(air->provide(query, ck), values);
        EXPECT_EQ(environment.provide(query, SpectralPoints({9.95})).providedBy, "vacuum");
    };
    expect(queries()[0], transfer.transmittance(nodes, path));
    expect(queries()[1], transfer.pathRadiance(nodes, path, day));
    expect(queries()[2], transfer.backgroundRadiance(nodes, up, day));
    expect(queries()[3], transfer.solarIrradiance(nodes, 100.0, day));
    expect(queries()[4], transfer.upwardFlux(nodes, 100.0, day));
    expect(queries()[5], transfer.downwardFlux(nodes, 100.0, day));
    expect(queries()[6], transfer.scatteringOpticalDepth(nodes, path));
    const auto night =
        environment.provide(AtmosphericQuery::solarIrradiance(100.0, {0.0, -0.1}), ck);
    EXPECT_EQ(night.value, std::vector<double>(ck.size(), 0.0));
}

TEST(ProvidesAtPoints, AreRefusedByNameWhereNoAirHasThem) {
    Environment real;
    real.add(smart(1));
    const auto points = real.prepareCk(requestOf(Band::topHat(9.92, 9.98)));
    EXPECT_THAT(refusalOf([&] {
                    (void)real.provide(AtmosphericQuery::upwardFlux(0.0, day), *points.value);
                }),
                AllOf(HasSubstr("wideband upward flux over 9.92-9.98 um"),
                      HasSubstr("smart (has no"),
                      HasSubstr("a wideband atmosphere that supports this quantity")));
    Environment plain = Environment::vacuum();
    plain.defaultBackground = Spectrum::constant(5.0);
    EXPECT_THAT(refusalOf([&] {
                    (void)plain.provide(AtmosphericQuery::backgroundRadiance(up, day),
                                        *points.value);
                }),
                AllOf(HasSubstr("wideband-ck over 9.92-9.98 um"),
                      HasSubstr("vacuum (has no wideband mode)")));
    EXPECT_THROW((void)Vacuum().provide(AtmosphericQuery::transmittance(path), *points.value),
                 LogicError);
    EXPECT_THROW((void)Vacuum().prepareCk(requestOf(Band::topHat(9.92, 9.98))), LogicError);
}

TEST(AtmosphereDescription, TellsLinesAndFactsOfEachKind) {
    const auto fact = [](const AtmosphereDescription& told, const std::string& name) {
        const auto found = std::ranges::find(told.facts, name, &AtmosphereFact::name);
        return found == told.facts.end() ? AtmosphereFactValue{false} : found->value;
    };
    EXPECT_TRUE(Vacuum().describe().lines.empty());
    const AtmosphereDescription homogeneous = haze()->describe();
    EXPECT_THAT(homogeneous.lines, testing::ElementsAre("homogeneous air of 288.15 K over ground "
                                                        "of 288.15 K"));
    EXPECT_EQ(std::get<double>(fact(homogeneous, "air_temperature_K").value), 288.15);
    const AtmosphereDescription spectra = measured()->describe();
    EXPECT_THAT(spectra.lines, testing::Contains("  range 1000 m"));
    EXPECT_EQ(std::get<AtmosphereFacts>(fact(spectra, "geometry").value).front().name,
              "sensor_altitude_m");
    const AtmosphereDescription real = smart()->describe();
    EXPECT_THAT(real.lines[2], HasSubstr("35 parameters, 2 not as by default (*)"));
    EXPECT_EQ(std::get<AtmosphereFacts>(fact(real, "smart").value).front().name, "profile");
    const AtmosphereDescription runs = table()->describe();
    EXPECT_THAT(runs.lines, testing::Contains("1 run"));
    EXPECT_EQ(std::get<AtmosphereFacts>(fact(runs, "table").value).front().name, "wavenumbers");
}
