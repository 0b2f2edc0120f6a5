#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/Environment.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/import/Tape7.h"
#include "tests/atmosphere/SyntheticTape7.h"

using namespace irsg;
using testing::HasSubstr;

namespace {

constexpr double nodes_cm[] = {2000.0, 2010.0, 2020.0, 2030.0, 2040.0};
constexpr double airTemperature_K = 280.0;

TabulatedAtmosphere family(const std::vector<SyntheticRun>& made) {
    std::string text;
    for (const SyntheticRun& run : made) {
        text += tape7(run);
    }
    return {parseTape7(TextLines::parse(text, "family")), "family"};
}

/// Absorption of an exponential atmosphere, m-1, stronger at larger wavenumbers.
double absorption_per_m(double altitude_m, double wavenumber_cm) {
    return 1e-4 * (wavenumber_cm - 1990.0) / 10.0 * std::exp(-altitude_m / 5000.0);
}

/// Optical depth of a straight path over a flat earth.
double depthOf(const AirPath& path, double wavenumber_cm) {
    const double rise = path.targetAltitude_m - path.sensorAltitude_m;
    if (rise == 0.0) {
        return absorption_per_m(path.sensorAltitude_m, wavenumber_cm) * path.range_m;
    }
    return 5000.0 *
           (absorption_per_m(path.sensorAltitude_m, wavenumber_cm) -
            absorption_per_m(path.targetAltitude_m, wavenumber_cm)) *
           path.range_m / rise;
}

SyntheticRun runOver(const AirPath& path) {
    SyntheticRun run;
    run.path = path.sensorAltitude_m == path.targetAltitude_m ? 1 : 2;
    run.h1_km = path.sensorAltitude_m / 1e3;
    run.h2_km = path.targetAltitude_m / 1e3;
    run.range_km = path.range_m / 1e3;
    run.zenith_deg = 60.0;
    run.temperature_K = airTemperature_K;
    run.depth = [path](double nu) { return depthOf(path, nu); };
    return run;
}

const InterpolationError& errorOf(const std::vector<InterpolationError>& errors,
                                  const std::string& quantity, const std::string& axis) {
    for (const InterpolationError& error : errors) {
        if (error.quantity == quantity && error.axis == axis) {
            return error;
        }
    }
    ADD_FAILURE() << "no error of " << quantity << " over " << axis;
    return errors.front();
}

std::string refusal(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

} // namespace

TEST(TabulatedAtmosphere, beersLawIsMetBetweenTheNodesOfRange) {
    std::vector<SyntheticRun> made;
    for (const double range : {500.0, 1000.0, 4000.0, 10000.0}) {
        made.push_back(runOver({0.0, 0.0, range}));
    }
    const TabulatedAtmosphere air = family(made);
    for (const double range : {0.0, 1.0, 250.0, 500.0, 700.0, 2500.0, 8000.0, 10000.0}) {
        const Spectrum tau = air.transmittance({0.0, 0.0, range}, air.base());
        const Spectrum path = air.pathRadiance({0.0, 0.0, range}, {}, air.base());
        for (const double nu : nodes_cm) {
            const double expected = std::exp(-depthOf({0.0, 0.0, range}, nu));
            EXPECT_NEAR(tau.at(1e4 / nu), expected, 2e-7) << range;
            const double planck = planckRadiance_W_m2_sr_um(1e4 / nu, airTemperature_K);
            EXPECT_NEAR(path.at(1e4 / nu), (1.0 - expected) * planck, 1e-4 * planck) << range;
        }
    }
    const auto errors = air.interpolationErrors();
    EXPECT_EQ(errorOf(errors, "transmittance", "range").nodes, 3u);
    EXPECT_LT(errorOf(errors, "transmittance", "range").worst, 1e-6);
    EXPECT_LT(errorOf(errors, "path radiance", "range").worst, 1e-4);
}

TEST(TabulatedAtmosphere, theSquareRootLawIsMetWithinTheStatedError) {
    std::vector<SyntheticRun> made;
    const auto depth = [](double range_m, double nu) {
        return (nu - 1990.0) / 50.0 * std::sqrt(range_m / 1000.0);
    };
    for (const double range : {500.0, 1000.0, 2000.0, 4000.0, 8000.0}) {
        SyntheticRun run = runOver({0.0, 0.0, range});
        run.depth = [&, range](double nu) { return depth(range, nu); };
        made.push_back(run);
    }
    const TabulatedAtmosphere air = family(made);
    const double stated = errorOf(air.interpolationErrors(), "transmittance", "range").worst;
    EXPECT_LT(stated, 0.02);
    double before = 1.0;
    for (double range = 20.0; range <= 8000.0; range *= 1.1) {
        const double tau = air.transmittance({0.0, 0.0, range}, air.base()).at(1e4 / 2030.0);
        EXPECT_LE(tau, before) << range;
        EXPECT_NEAR(tau, std::exp(-depth(range, 2030.0)), stated) << range;
        before = tau;
    }
}

TEST(TabulatedAtmosphere, aBandThatTurnsFromWeakToStrongIsMetWithinTheStatedError) {
    // Goody's random band: W = S u / sqrt(1 + S u / a), linear near and a square root far away.
    const auto depth = [](double range_m, double nu) {
        const double weak = range_m / 1000.0 * (nu - 1990.0) / 10.0;
        return weak / std::sqrt(1.0 + weak);
    };
    std::vector<SyntheticRun> made;
    for (const double range : {200.0, 500.0, 1000.0, 2000.0, 5000.0, 10000.0}) {
        SyntheticRun run = runOver({0.0, 0.0, range});
        run.depth = [&, range](double nu) { return depth(range, nu); };
        made.push_back(run);
    }
    const TabulatedAtmosphere air = family(made);
    const double stated = errorOf(air.interpolationErrors(), "transmittance", "range").worst;
    EXPECT_LT(stated, 0.05);
    for (double range = 1.0; range <= 10000.0; range *= 1.1) {
        const Spectrum tau = air.transmittance({0.0, 0.0, range}, air.base());
        for (const double nu : nodes_cm) {
            EXPECT_NEAR(tau.at(1e4 / nu), std::exp(-depth(range, nu)), stated) << range;
        }
    }
}

TEST(TabulatedAtmosphere, theStatedErrorOverRangeIsTheLargerOne) {
    const struct {
        const char* name;
        std::function<double(double, double)> depth; ///< of range in km and strength
    } laws[] = {
        {"Beer", [](double range, double strength) { return 0.1 * strength * range; }},
        {"square root", [](double range, double s) { return 0.2 * s * std::sqrt(range); }},
        {"Goody's band", [](double u, double s) { return s * u / std::sqrt(1.0 + s * u); }},
    };
    for (const auto& law : laws) {
        for (const std::vector<double>& ranges_km :
             {std::vector<double>{1.0, 2.0, 4.0, 8.0}, {0.1, 0.3, 1.0, 2.0, 4.0, 8.0}}) {
            std::vector<SyntheticRun> made;
            const auto depth = [&](double range_m, double nu) {
                return law.depth(range_m / 1000.0, (nu - 1990.0) / 10.0);
            };
            for (const double range_km : ranges_km) {
                made.push_back(runOver({0.0, 0.0, 1000.0 * range_km}));
                made.back().depth = [&, range_km](double nu) {
                    return depth(1000.0 * range_km, nu);
                };
            }
            const TabulatedAtmosphere air = family(made);
            const double stated =
                errorOf(air.interpolationErrors(), "transmittance", "range").worst;
            double worst = 0.0;
            for (double range = 1.0; range <= 8000.0; range *= 1.02) {
                const Spectrum tau = air.transmittance({0.0, 0.0, range}, air.base());
                for (const double nu : nodes_cm) {
                    worst =
                        std::max(worst, std::abs(tau.at(1e4 / nu) - std::exp(-depth(range, nu))));
                }
            }
            std::printf("%s, %zu runs from %g km: stated %.2g, true %.2g\n", law.name,
                        ranges_km.size(), ranges_km.front(), stated, worst);
            EXPECT_LE(worst, stated + 1e-7) << law.name;
        }
    }
}

TEST(TabulatedAtmosphere, nodesAreMetExactly) {
    std::vector<SyntheticRun> made;
    std::vector<AirPath> paths;
    for (const double sensor : {0.0, 1000.0, 3000.0}) {
        for (const double target : {0.0, 2000.0, 3000.0}) {
            for (const double range : {4000.0, 9000.0}) {
                paths.push_back({sensor, target, range});
                made.push_back(runOver(paths.back()));
            }
        }
    }
    const TabulatedAtmosphere air = family(made);
    ASSERT_EQ(air.runs().size(), paths.size());
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const SpectralRun& run = air.runs()[i];
        const Spectrum tau = air.transmittance(paths[i], air.base());
        const Spectrum path = air.pathRadiance(paths[i], {}, air.base());
        for (std::size_t k = 0; k < 5; ++k) {
            EXPECT_DOUBLE_EQ(tau.values()[4 - k], run.transmittance[k]);
            EXPECT_NEAR(path.values()[4 - k], run.pathRadiance_W_m2_sr_um[k],
                        1e-14 * run.pathRadiance_W_m2_sr_um[k]);
        }
    }
}

TEST(TabulatedAtmosphere, altitudesBetweenTheRunsAreMetWithinTheStatedError) {
    std::vector<SyntheticRun> made;
    for (double sensor = 0.0; sensor <= 2000.0; sensor += 500.0) {
        for (double target = 3000.0; target <= 5000.0; target += 500.0) {
            made.push_back(runOver({sensor, target, 6000.0}));
        }
    }
    const TabulatedAtmosphere air = family(made);
    const auto errors = air.interpolationErrors();
    const InterpolationError& sensors = errorOf(errors, "transmittance", "sensor altitude");
    const InterpolationError& targets = errorOf(errors, "transmittance", "target altitude");
    EXPECT_EQ(sensors.nodes, 15u);
    EXPECT_LT(sensors.worst, 5e-3);
    EXPECT_GT(sensors.worst, sensors.rms);
    for (const AirPath path : {AirPath{250.0, 3250.0, 6000.0},
                               {1700.0, 4900.0, 5000.0},
                               {1250.0, 3500.0, 3000.0},
                               {0.0, 4123.0, 6000.0}}) {
        for (const double nu : nodes_cm) {
            EXPECT_NEAR(air.transmittance(path, air.base()).at(1e4 / nu),
                        std::exp(-depthOf(path, nu)), sensors.worst + targets.worst);
        }
    }
}

TEST(TabulatedAtmosphere, horizontalPathsNeedOnlyHorizontalRuns) {
    std::vector<SyntheticRun> made;
    for (const double altitude : {0.0, 500.0, 1000.0}) {
        made.push_back(runOver({altitude, altitude, 5000.0}));
    }
    const TabulatedAtmosphere air = family(made);
    const double stated =
        errorOf(air.interpolationErrors(), "transmittance", "altitude of horizontal paths").worst;
    for (const double nu : nodes_cm) {
        EXPECT_NEAR(air.transmittance({700.0, 704.0, 3000.0}, air.base()).at(1e4 / nu),
                    std::exp(-depthOf({702.0, 702.0, 3000.0}, nu)), stated);
    }
    EXPECT_THAT(refusal([&] {
                    air.transmittance({0.0, 1000.0, 3000.0}, air.base());
                }),
                HasSubstr("sensor 0 to 1000 m, target 0 to 1000 m, range up to 5000 m (3 paths)"));
}

TEST(TabulatedAtmosphere, aPathBackHasTheSameTransmittance) {
    const TabulatedAtmosphere air = family({runOver({0.0, 2000.0, 4000.0})});
    EXPECT_EQ(air.transmittance({2000.0, 0.0, 4000.0}, air.base()),
              air.transmittance({0.0, 2000.0, 4000.0}, air.base()));
    EXPECT_THAT(refusal([&] {
                    air.pathRadiance({2000.0, 0.0, 4000.0}, {}, air.base());
                }),
                HasSubstr("sensor at 2000 m, target at 0 m, range 4000 m"));
}

TEST(TabulatedAtmosphere, whatIsOutsideTheFamilyIsRefusedByName) {
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
        EXPECT_THAT(refusal(row.action), HasSubstr(row.says)) << row.name;
    }
    EXPECT_NO_THROW(air.transmittance({0, 0, 1000.5}, all));
    EXPECT_NO_THROW(air.transmittance({508, 508, 1000}, all));
    EXPECT_NO_THROW(air.backgroundRadiance({9, radians(45), 0}, {}, all));
}

TEST(TabulatedAtmosphere, supportsWhatItsRunsContain) {
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
    EXPECT_EQ(environment.transmittance({0, 0, 100}, {4.95, 4.96}).answeredBy, "family");
}

TEST(TabulatedAtmosphere, spectraCoverTheAskedRangeAndNoMoreNodesThanItNeeds) {
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

TEST(TabulatedAtmosphere, theSunOfItsRunsIsTheOnlyOne) {
    SyntheticRun run = runOver({0.0, 0.0, 1000.0});
    run.kind = 2;
    run.iparm = 2;
    run.parm2_deg = 40.0;
    const TabulatedAtmosphere air = family({run});
    const SunPosition right{0.0, radians(50.0)};
    EXPECT_NO_THROW(air.pathRadiance({0, 0, 1000}, right, air.base()));
    EXPECT_THAT(refusal([&] {
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

TEST(TabulatedAtmosphere, backgroundIsLinearBetweenDirections) {
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

TEST(TabulatedAtmosphere, opaqueAndTransparentPathsKeepTheirDigits) {
    SyntheticRun dense = runOver({0.0, 0.0, 5000.0});
    dense.depth = [](double nu) { return nu < 2025.0 ? 90.0 : 1e-9; };
    const TabulatedAtmosphere air = family({dense});
    const double planck = planckRadiance_W_m2_sr_um(5.0, airTemperature_K);
    EXPECT_NEAR(air.pathRadiance({0, 0, 5000}, {}, air.base()).at(5.0) / planck, 1.0, 1e-4);
    EXPECT_EQ(air.transmittance({0, 0, 5000}, air.base()).at(1e4 / 2040.0), 1.0);
    EXPECT_NEAR(-std::log(air.transmittance({0, 0, 0.01}, air.base()).at(5.0)),
                90.0 * 0.01 / 5000.0, 1e-7);
    EXPECT_NEAR(air.pathRadiance({0, 0, 0.01}, {}, air.base()).at(5.0) / planck,
                90.0 * 0.01 / 5000.0, 1e-7);
}

TEST(TabulatedAtmosphere, anOpaqueRunContinuesTheOneBefore) {
    // A transmittance of 0 tells no depth; half way to it the air is still that of the near run.
    const auto run = [](double range_m, double tau) {
        SpectralRun made;
        made.source = numberText(range_m);
        made.geometry.range_m = range_m;
        made.wavenumbers_cm = {2000.0, 2010.0};
        made.transmittance = {tau, tau};
        return made;
    };
    const TabulatedAtmosphere dense({run(1000.0, std::exp(-8.0)), run(10000.0, 0.0)}, "dense");
    EXPECT_NEAR(-std::log(dense.transmittance({0, 0, 2000}, dense.base()).at(5.0)), 16.0, 1e-9);
    const TabulatedAtmosphere alone({run(1000.0, 0.0)}, "alone");
    EXPECT_LT(alone.transmittance({0, 0, 1000}, alone.base()).at(5.0), 1e-15);
}

TEST(TabulatedAtmosphere, runsOfFilesOfOneNameAreToldApartByTheirFolders) {
    std::vector<std::filesystem::path> files;
    for (const double range : {1000.0, 2000.0}) {
        const std::filesystem::path folder =
            std::filesystem::path(testing::TempDir()) / ("range" + std::to_string(files.size()));
        std::filesystem::create_directories(folder);
        files.push_back(folder / "tape7");
        std::ofstream(files.back(), std::ios::binary) << tape7(runOver({0.0, 0.0, range}));
    }
    const TabulatedAtmosphere air = TabulatedAtmosphere::import(files);
    EXPECT_EQ(air.name(), "tabulated (tape7 and 1 more)");
    EXPECT_EQ(air.runs()[1].source, "range1/tape7");
}

TEST(TabulatedAtmosphere, aTableFileReadsBackEqual) {
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
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "family.smatatm";
    air.write(file);
    EXPECT_TRUE(TabulatedAtmosphere::canImport(file));
    const TabulatedAtmosphere back = TabulatedAtmosphere::read(file);
    EXPECT_EQ(back.name(), air.name());
    EXPECT_EQ(back.runs(), air.runs());
    EXPECT_EQ(back.toText(), air.toText());
    const TabulatedAtmosphere imported = TabulatedAtmosphere::import(std::span(&file, 1));
    EXPECT_EQ(imported.runs(), air.runs());
}

TEST(TabulatedAtmosphere, badTableFilesAreRefusedByName) {
    const std::string good = family({runOver({0.0, 0.0, 1000.0})}).toText();
    const auto with = [&](const std::string& what, const std::string& by) {
        std::string text = good;
        const std::size_t at = text.find(what);
        EXPECT_NE(at, text.npos) << what;
        return text.replace(at, what.size(), by);
    };
    const struct {
        const char* name;
        std::string text;
        const char* says;
    } rows[] = {
        {"no JSON", "{\"format\":", "found no JSON"},
        {"foreign", "{\"format\": \"x\"}", "format: found \"x\""},
        {"no format", "{}", "format: found no such key"},
        {"an array", "[1]", "found no such key"},
        {"another version", with("\"version\":1", "\"version\":9"), "version: found 9, expected 1"},
        {"no runs", with("\"runs\":[{", "\"xruns\":[{"), "runs: found no array"},
        {"no wavenumbers", with("\"wavenumbers [cm-1]\"", "\"x\""), "found no array"},
        {"wavenumbers fall", with("2010.0,", "1999.0,"), "wavenumbers [cm-1][1]: found 1999"},
        {"a text for a number", with("2010.0,", "\"a\","), "wavenumbers [cm-1][1]: found \"a\""},
        {"too few values", with("\"transmittance\":[", "\"transmittance\":[0.5,"),
         "found 6 values, expected 5"},
        {"transmittance above 1", with("\"transmittance\":[0.", "\"transmittance\":[7."),
         "runs[0].transmittance[0]"},
        {"a kind of its own", with("\"thermal radiance\"", "\"colour\""), "kind: found colour"},
        {"a path of its own", with("\"horizontal\"", "\"crooked\""), "path: found crooked"},
        {"a negative range", with("\"range [m]\":1000.0", "\"range [m]\":-1.0"),
         "range [m]: found -1"},
        {"no radiance", with("\"path_radiance [W m-2 sr-1 um-1]\"", "\"y\""), "no radiances"},
        {"a card without number", with("\"MODEL\":6.0", "\"MODEL\":\"six\""), "cards.MODEL"},
    };
    for (const auto& row : rows) {
        EXPECT_THAT(refusal([&] { TabulatedAtmosphere::fromText(row.text, "t.smatatm"); }),
                    HasSubstr(row.says))
            << row.name;
    }
    EXPECT_THAT(refusal([] { TabulatedAtmosphere({}, "nothing"); }), HasSubstr("no runs"));
    EXPECT_THROW(TabulatedAtmosphere::read("no/such.smatatm"), InputError);
}
