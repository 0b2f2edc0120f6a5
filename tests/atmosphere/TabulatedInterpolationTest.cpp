#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/import/Tape7.h"
#include "tests/atmosphere/TabulatedSupport.h"
#include "tests/support/Refusal.h"

using namespace irsg;
using namespace irsg::tabulatedtest;
using smat::test::refusalOf;
using testing::HasSubstr;

TEST(TabulatedInterpolation, BeersLawIsMetBetweenTheNodesOfRange) {
    std::vector<SyntheticRun> made;
    for (const double range : {500.0, 1000.0, 4000.0, 10000.0}) {
        made.push_back(runOver({0.0, 0.0, range}));
    }
    const TabulatedAtmosphere air = family(made);
    for (const double range : {0.0, 1.0, 250.0, 500.0, 700.0, 2500.0, 8000.0, 10000.0}) {
        const Spectrum tau = air.transmittance({0.0, 0.0, range}, air.base());
        const Spectrum path = air.pathRadiance({0.0, 0.0, range}, {}, air.base());
        for (const double nu : nodes_per_cm) {
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

TEST(TabulatedInterpolation, TheSquareRootLawIsMetWithinTheStatedError) {
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

TEST(TabulatedInterpolation, ABandThatTurnsFromWeakToStrongIsMetWithinTheStatedError) {
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
        for (const double nu : nodes_per_cm) {
            EXPECT_NEAR(tau.at(1e4 / nu), std::exp(-depth(range, nu)), stated) << range;
        }
    }
}

TEST(TabulatedInterpolation, TheStatedErrorOverRangeIsTheLargerOne) {
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
                for (const double nu : nodes_per_cm) {
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

TEST(TabulatedInterpolation, NodesAreMetExactly) {
    std::vector<SyntheticRun> made;
    std::vector<AtmosphericPath> paths;
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

TEST(TabulatedInterpolation, AltitudesBetweenTheRunsAreMetWithinTheStatedError) {
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
    for (const AtmosphericPath path : {AtmosphericPath{250.0, 3250.0, 6000.0},
                                       {1700.0, 4900.0, 5000.0},
                                       {1250.0, 3500.0, 3000.0},
                                       {0.0, 4123.0, 6000.0}}) {
        for (const double nu : nodes_per_cm) {
            EXPECT_NEAR(air.transmittance(path, air.base()).at(1e4 / nu),
                        std::exp(-depthOf(path, nu)), sensors.worst + targets.worst);
        }
    }
}

TEST(TabulatedInterpolation, HorizontalPathsNeedOnlyHorizontalRuns) {
    std::vector<SyntheticRun> made;
    for (const double altitude : {0.0, 500.0, 1000.0}) {
        made.push_back(runOver({altitude, altitude, 5000.0}));
    }
    const TabulatedAtmosphere air = family(made);
    const double stated =
        errorOf(air.interpolationErrors(), "transmittance", "altitude of horizontal paths").worst;
    for (const double nu : nodes_per_cm) {
        EXPECT_NEAR(air.transmittance({700.0, 704.0, 3000.0}, air.base()).at(1e4 / nu),
                    std::exp(-depthOf({702.0, 702.0, 3000.0}, nu)), stated);
    }
    EXPECT_THAT(refusalOf([&] {
                    air.transmittance({0.0, 1000.0, 3000.0}, air.base());
                }),
                HasSubstr("sensor 0 to 1000 m, target 0 to 1000 m, range up to 5000 m (3 paths)"));
}

TEST(TabulatedInterpolation, OpaqueAndTransparentPathsKeepTheirDigits) {
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

TEST(TabulatedInterpolation, AnOpaqueRunContinuesTheOneBefore) {
    // A transmittance of 0 tells no depth; half way to it the air is still that of the near run.
    const auto run = [](double range_m, double tau) {
        SpectralRun made;
        made.source = numberText(range_m);
        made.geometry.range_m = range_m;
        made.wavenumbers_per_cm = {2000.0, 2010.0};
        made.transmittance = {tau, tau};
        return made;
    };
    const TabulatedAtmosphere dense({run(1000.0, std::exp(-8.0)), run(10000.0, 0.0)}, "dense");
    EXPECT_NEAR(-std::log(dense.transmittance({0, 0, 2000}, dense.base()).at(5.0)), 16.0, 1e-9);
    const TabulatedAtmosphere alone({run(1000.0, 0.0)}, "alone");
    EXPECT_LT(alone.transmittance({0, 0, 1000}, alone.base()).at(5.0), 1e-15);
}

TEST(TabulatedInterpolation, BetweenAltitudesDepthsFallAsDensitiesDo) {
    // Air of one scale height: level runs at 1 and 10 km hold what is between them.
    const double scale_m = 7400.0, range_m = 10e3;
    const auto depth = [&](double altitude_m) { return 1.2 * std::exp(-altitude_m / scale_m); };
    const auto run = [&](double altitude_m, double tau) {
        SpectralRun made;
        made.source = numberText(altitude_m);
        made.geometry.sensorAltitude_m = made.geometry.targetAltitude_m = altitude_m;
        made.geometry.range_m = range_m;
        made.wavenumbers_per_cm = {2000.0, 2010.0};
        made.transmittance = {tau, tau};
        return made;
    };
    const TabulatedAtmosphere air(
        {run(1e3, std::exp(-depth(1e3))), run(10e3, std::exp(-depth(10e3)))}, "falling");
    for (const double altitude_m : {1e3, 2e3, 5e3, 9e3, 10e3}) {
        EXPECT_NEAR(air.transmittance({altitude_m, altitude_m, range_m}, air.base()).at(5.0),
                    std::exp(-depth(altitude_m)), 1e-9)
            << altitude_m;
    }
    // A file that prints 1 for the upper run leaves a depth between both, not none.
    const TabulatedAtmosphere clear({run(1e3, 0.5), run(10e3, 1.0)}, "clear");
    double before = 0.0;
    for (double altitude_m = 1e3; altitude_m <= 10e3; altitude_m += 500.0) {
        const double here =
            air.transmittance({altitude_m, altitude_m, range_m}, air.base()).at(5.0);
        EXPECT_GT(here, before);
        before = here;
        const double thin =
            clear.transmittance({altitude_m, altitude_m, range_m}, clear.base()).at(5.0);
        EXPECT_GE(thin, 0.5 - 1e-12);
        EXPECT_LE(thin, 1.0);
    }
}

TEST(TabulatedInterpolation, TellsHowFarTheNearestRunIs) {
    std::vector<SyntheticRun> made;
    for (const double altitude : {0.0, 1000.0}) {
        for (const double range : {1000.0, 2000.0, 5000.0}) {
            made.push_back(runOver({altitude, altitude, range}));
        }
    }
    const TabulatedAtmosphere air = family(made);
    const auto said = [&](const AtmosphericPath& path) {
        return air.nearestRun(AtmosphericQuery::transmittance(path));
    };
    EXPECT_EQ(said({0.0, 0.0, 2000.0}),
              " (nearest run at most 0 m in altitude, 0 m in range away)");
    EXPECT_EQ(said({0.0, 0.0, 2750.5}),
              " (nearest run at most 0 m in altitude, 750.5 m in range away)");
    EXPECT_EQ(said({400.0, 400.0, 4000.0}),
              " (nearest run at most 400 m in altitude, 1000 m in range away)");
    EXPECT_EQ(said({0.0, 0.0, 0.0}), ""); // known without a run
    // The air of a path is the same the other way round.
    SyntheticRun slant = runOver({0.0, 2000.0, 5000.0});
    const TabulatedAtmosphere down = family({slant});
    EXPECT_EQ(down.nearestRun(AtmosphericQuery::transmittance({2000.0, 0.0, 5000.0})),
              down.nearestRun(AtmosphericQuery::transmittance({0.0, 2000.0, 5000.0})));
}

TEST(NearestRun, OneLineKeepsTheFarthest) {
    const auto line = [](double altitude_m, double range_m) {
        return "transmittance: family" +
               nearestRunText({.altitude_m = altitude_m, .range_m = range_m});
    };
    std::vector<std::string> lines;
    addProvider(lines, line(0.0, 250.0));
    addProvider(lines, "path radiance: vacuum");
    addProvider(lines, line(100.0, 20.0));
    addProvider(lines, line(0.0, 1.0));
    addProvider(lines, "path radiance: vacuum");
    EXPECT_EQ(lines, (std::vector<std::string>{line(100.0, 250.0), "path radiance: vacuum"}));
    // Another quantity and another family are lines of their own.
    addProvider(lines, "path radiance: family" + nearestRunText({.range_m = 3.0}));
    addProvider(lines,
                std::vector<std::string>{"sun: family" + nearestRunText({.elevation_deg = 0.5}),
                                         "sun: family" + nearestRunText({.altitude_m = 7.0})});
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_EQ(lines.back(),
              "sun: family (nearest run at most 7 m in altitude, 0.5 deg in elevation away)");
    EXPECT_EQ(withoutNearestRun(lines.back()), "sun: family");
    EXPECT_EQ(withoutNearestRun("vacuum"), "vacuum");
}
