#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/Environment.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/import/Tape7.h"
#include "tests/atmosphere/TabulatedSupport.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using namespace irsg::tabulatedtest;
using smat::test::refusalOf;
using testing::HasSubstr;

TEST(TabulatedAtmosphere, APathBackHasTheSameTransmittance) {
    const TabulatedAtmosphere air = family({runOver({0.0, 2000.0, 4000.0})});
    EXPECT_EQ(air.transmittance({2000.0, 0.0, 4000.0}, air.base()),
              air.transmittance({0.0, 2000.0, 4000.0}, air.base()));
    EXPECT_THAT(refusalOf([&] {
                    air.pathRadiance({2000.0, 0.0, 4000.0}, {}, air.base());
                }),
                HasSubstr("sensor at 2000 m, target at 0 m, range 4000 m"));
}

TEST(TabulatedAtmosphere, WhatIsOutsideTheFamilyIsRefusedByName) {
    SyntheticRun sky = runOver({0.0, 0.0, 1000.0});
    sky.path = 3;
    sky.h2_km = 100.0;
    sky.zenith_deg = 30.0;
    SyntheticRun low = sky;
    low.zenith_deg = 60.0;
    low.range_km = 200.0;
    SyntheticRun sun = sky;
    sun.kind = 3;
    const TabulatedAtmosphere air =
        family({runOver({0.0, 0.0, 1000.0}), runOver({500.0, 500.0, 2000.0}), sky, low, sun});
    const SpectralRange all = air.base();
    const struct {
        const char* name;
        std::function<void()> action;
        const char* says;
    } rows[] = {
        {"too far",
         [&] {
             air.transmittance({0, 0, 1010}, all);
         },
         "range 1010 m"},
        {"farther than the shorter of two",
         [&] {
             air.transmittance({250, 250, 1500}, all);
         },
         "range up to 1000 to 2000 m"},
        {"too high",
         [&] {
             air.transmittance({600, 600, 100}, all);
         },
         "sensor at 600 m"},
        {"too high to radiate",
         [&] {
             air.pathRadiance({511, 511, 100}, {}, all);
         },
         "sensor at 511 m"},
        {"too low a sight",
         [&] {
             air.backgroundRadiance({0, radians(29.9), 0}, {}, all);
         },
         "elevation 30 to 60 deg (2 directions)"},
        {"a sight from above",
         [&] {
             air.backgroundRadiance({300, radians(45), 0}, {}, all);
         },
         "altitude 300 m, elevation 45 deg"},
        {"too low a sun",
         [&] {
             air.solarIrradiance(0, {0, radians(20)}, all);
         },
         "altitude 0 m, elevation 60 deg (1 direction)"},
        {"below the ground",
         [&] {
             air.transmittance({-1, 0, 10}, all);
         },
         "sensor altitude"},
    };
    for (const auto& row : rows) {
        EXPECT_THAT(refusalOf(row.action), HasSubstr(row.says)) << row.name;
    }
    EXPECT_NO_THROW(air.transmittance({0, 0, 1000.5}, all));
    EXPECT_NO_THROW(air.transmittance({508, 508, 1000}, all));
    EXPECT_NO_THROW(air.backgroundRadiance({9, radians(45), 0}, {}, all));
}

TEST(TabulatedAtmosphere, SupportsWhatItsRunsContain) {
    SyntheticRun transmittance = runOver({0.0, 0.0, 1000.0});
    transmittance.kind = 0;
    SyntheticRun sun;
    sun.kind = 3;
    sun.path = 3;
    const TabulatedAtmosphere clear = family({transmittance});
    EXPECT_TRUE(clear.supports(AtmosphereProperty::transmittance));
    EXPECT_TRUE(clear.supports(AtmosphereProperty::scatteringOpticalDepth));
    EXPECT_FALSE(clear.supports(AtmosphereProperty::pathRadiance));
    EXPECT_FALSE(clear.supports(AtmosphereProperty::upwardFlux));
    EXPECT_FALSE(clear.supports(AtmosphereProperty::ambientTemperature));
    EXPECT_THROW(clear.pathRadiance({0, 0, 1}, {}, clear.base()), LogicError);
    EXPECT_FALSE(clear.accept({4.0, 5.2}, AtmosphereProperty::transmittance));
    EXPECT_TRUE(clear.accept({4.95, 4.96}, AtmosphereProperty::transmittance));
    const TabulatedAtmosphere sunny = family({sun});
    EXPECT_TRUE(sunny.supports(AtmosphereProperty::solarIrradiance));
    EXPECT_FALSE(sunny.supports(AtmosphereProperty::transmittance));

    Environment environment;
    environment.add(std::make_shared<TabulatedAtmosphere>(clear));
    EXPECT_EQ(
        environment.spectrum(AtmosphericQuery::transmittance({0, 0, 100}), {4.95, 4.96}).providedBy,
        "family (nearest run at most 0 m in altitude, 900 m in range away)");
}

TEST(TabulatedAtmosphere, SpectraCoverTheAskedRangeAndNoMoreNodesThanItNeeds) {
    const TabulatedAtmosphere air = family({runOver({0.0, 0.0, 1000.0})});
    const SpectralRange all = air.base();
    const Spectrum whole = air.transmittance({0, 0, 1000}, all);
    EXPECT_EQ(whole.size(), 5u);
    const SpectralRange inside{1e4 / 2019.0, 1e4 / 2011.0};
    const Spectrum part = air.transmittance({0, 0, 1000}, inside);
    EXPECT_EQ(part.size(), 2u);
    EXPECT_TRUE(part.covers(inside));
    for (const double nu : {2011.0, 2015.0, 2019.0}) {
        EXPECT_DOUBLE_EQ(part.at(1e4 / nu), whole.at(1e4 / nu));
    }
    EXPECT_TRUE(air.transmittance({0, 0, 1000}, {1e4 / 2020.0, 1e4 / 2010.0})
                    .covers({1e4 / 2020.0, 1e4 / 2010.0}));
    EXPECT_THROW(air.transmittance({0, 0, 1000}, {4.0, 5.2}), LogicError);
}

TEST(TabulatedAtmosphere, TheSunOfItsRunsIsTheOnlyOne) {
    SyntheticRun run = runOver({0.0, 0.0, 1000.0});
    run.kind = 2;
    run.iparm = 2;
    run.parm2_deg = 40.0;
    const TabulatedAtmosphere air = family({run});
    const SunPosition right{0.0, radians(50.0)};
    EXPECT_NO_THROW(air.pathRadiance({0, 0, 1000}, right, air.base()));
    EXPECT_THAT(refusalOf([&] {
                    air.pathRadiance({0, 0, 1000}, {0.0, radians(45.0)}, air.base());
                }),
                HasSubstr("found an elevation of 45 deg, expected 50 deg"));
    EXPECT_NEAR(air.solarIrradiance(0.0, right, air.base()).at(5.0), 5e-7 * 2000.0 * 2000.0, 1e-9);
    EXPECT_EQ(air.solarIrradiance(0.0, {0.0, -0.1}, air.base()).maximum(), 0.0);
    run.iparm = 1;
    const TabulatedAtmosphere unknown = family({run});
    EXPECT_THAT(unknown.warnings().front(), HasSubstr("IPARM 1"));
    EXPECT_NO_THROW(unknown.pathRadiance({0, 0, 1000}, {0.0, 0.1}, unknown.base()));
}

TEST(TabulatedAtmosphere, BackgroundIsLinearBetweenDirections) {
    std::vector<SyntheticRun> made;
    for (const double zenith : {20.0, 40.0, 60.0}) {
        SyntheticRun run;
        run.path = 3;
        run.h2_km = 100.0;
        run.zenith_deg = zenith;
        run.range_km = 100.0 + zenith;
        run.depth = [zenith](double) { return 0.2 / std::cos(radians(zenith)); };
        made.push_back(run);
    }
    const TabulatedAtmosphere air = family(made);
    const auto at = [&](double elevation_deg) {
        return air.backgroundRadiance({0.0, radians(elevation_deg), 0.0}, {}, air.base()).at(4.95);
    };
    EXPECT_NEAR(at(60.0), 0.5 * (at(70.0) + at(50.0)), 1e-12);
    EXPECT_GT(errorOf(air.interpolationErrors(), "background radiance", "elevation").worst, 1e-3);
    EXPECT_GT(at(30.0), at(50.0));
}

TEST(TabulatedAtmosphere, RunsOfFilesOfOneNameAreToldApartByTheirFolders) {
    std::vector<std::filesystem::path> files;
    for (const double range : {1000.0, 2000.0}) {
        const std::filesystem::path folder =
            smat::test::ownFolder() / ("range" + std::to_string(files.size()));
        files.push_back(
            smat::test::writtenFile(folder / "tape7", tape7(runOver({0.0, 0.0, range}))));
    }
    const TabulatedAtmosphere air = TabulatedAtmosphere::import(files);
    EXPECT_EQ(air.name(), "tabulated (tape7 and 1 more)");
    EXPECT_EQ(air.runs()[1].source, "range1/tape7");
}

TEST(TabulatedAtmosphere, ATableFileReadsBackEqual) {
    SyntheticRun sun;
    sun.kind = 3;
    sun.path = 3;
    sun.zenith_deg = 33.3;
    SyntheticRun withSun = runOver({0.0, 1000.0, 1500.0});
    withSun.kind = 2;
    withSun.iparm = 2;
    withSun.parm2_deg = 33.3;
    SyntheticRun transmittance = runOver({0.0, 0.0, 1500.0});
    transmittance.kind = 0;
    const TabulatedAtmosphere air = family({sun, withSun, transmittance});
    const std::filesystem::path file = smat::test::ownFolder() / "family.smatatm";
    air.write(file);
    EXPECT_TRUE(TabulatedAtmosphere::canImport(file));
    const TabulatedAtmosphere back = TabulatedAtmosphere::read(file);
    EXPECT_EQ(back.name(), air.name());
    EXPECT_EQ(back.runs(), air.runs());
    EXPECT_EQ(back.toText(), air.toText());
    const TabulatedAtmosphere imported = TabulatedAtmosphere::import(std::span(&file, 1));
    EXPECT_EQ(imported.runs(), air.runs());
}

TEST(TabulatedAtmosphere, BadTableFilesAreRefusedByName) {
    const std::string good = family({runOver({0.0, 0.0, 1000.0})}).toText();
    const auto with = [&](const std::string& what, const std::string& by) {
        return replaced(good, what, by);
    };
    const struct {
        const char* name;
        std::string text;
        const char* says;
    } rows[] = {
        {"no JSON", "{\"format\":", "line 1, column 11: found the end of the text"},
        {"a key twice", with("\"version\":1", "\"version\":1,\"version\":1"),
         "version, line 1: found a key that occurs twice"},
        {"a zero byte", good + std::string("\0}", 2), "found a zero byte"},
        {"foreign", "{\"format\": \"x\"}", "format: found \"x\""},
        {"no format", "{}", "format: found nothing"},
        {"an array", "[1]", "found [1], expected a tabulated atmosphere (a JSON object)"},
        {"another version", with("\"version\":1", "\"version\":9"), "version: found 9, expected 1"},
        {"no runs", with("\"runs\":[{", "\"xruns\":[{"),
         "runs: found nothing, expected at least one run"},
        {"no wavenumbers", with("\"wavenumbers [cm-1]\"", "\"x\""),
         "found nothing, expected numbers"},
        {"wavenumbers fall", with("2010.0,", "1999.0,"), "wavenumbers [cm-1][1]: found 1999"},
        {"a text for a number", with("2010.0,", "\"a\","), "wavenumbers [cm-1][1]: found \"a\""},
        {"too few values", with("\"transmittance\":[", "\"transmittance\":[0.5,"),
         "found 6 values, expected 5"},
        {"transmittance above 1", with("\"transmittance\":[0.", "\"transmittance\":[7."),
         "runs[0].transmittance[0]"},
        {"a kind of its own", with("\"thermal radiance\"", "\"colour\""), "kind: found \"colour\""},
        {"a path of its own", with("\"horizontal\"", "\"crooked\""), "path: found \"crooked\""},
        {"a negative range", with("\"range [m]\":1000.0", "\"range [m]\":-1.0"),
         "range [m]: found -1"},
        {"no radiance", with("\"path_radiance [W m-2 sr-1 um-1]\"", "\"y\""), "no radiances"},
        {"a card without number", with("\"MODEL\":6.0", "\"MODEL\":\"six\""), "cards.MODEL"},
    };
    for (const auto& row : rows) {
        EXPECT_THAT(refusalOf([&] { TabulatedAtmosphere::fromText(row.text, "t.smatatm"); }),
                    HasSubstr(row.says))
            << row.name;
    }
    EXPECT_THAT(refusalOf([] { TabulatedAtmosphere({}, "nothing"); }), HasSubstr("no runs"));
    EXPECT_THROW(TabulatedAtmosphere::read("no/such.smatatm"), InputError);
}
