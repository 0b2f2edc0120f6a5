#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Quadrature.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/background/BackgroundGrid.h"
#include "irsg/render/background/FastAngle.h"
#include "irsg/render/background/FieldExtent.h"
#include "irsg/render/background/SceneBackground.h"
#include "irsg/render/background/TerrainPass.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

Viewpoint looking(double azimuth_deg, double elevation_deg, double altitude_m = 0.0) {
    const Vec3 eye{0, 0, altitude_m};
    return Viewpoint::lookAt(eye, eye + direction(radians(azimuth_deg), radians(elevation_deg)));
}

/// A clear sky of one layer: black at the horizon, thin above, and a ground.
double clearSky(double elevation_rad, double depth, double horizon_rad = 0.0) {
    const double up = elevation_rad - horizon_rad;
    const double airMass = 1.0 / (std::sin(std::abs(up)) + 0.02);
    return up >= 0.0 ? 10.0 * -std::expm1(-depth * airMass)
                     : 14.0 - 4.0 * -std::expm1(-0.1 * depth * airMass);
}

} // namespace

TEST(FastAngle, IsTheArcTangentToOneInTenMillion) {
    const FastAngle angle;
    for (double turn = -3.14; turn < 3.14; turn += 0.0117) {
        EXPECT_NEAR(angle(3.0 * std::sin(turn), 3.0 * std::cos(turn)), turn, 1e-7);
    }
    EXPECT_EQ(angle(0.0, 0.0), 0.0);
    EXPECT_EQ(angle(0.0, 2.0), 0.0);
    EXPECT_NEAR(angle(2.0, 0.0), 0.5 * pi, 1e-15);
}

TEST(FieldExtent, FindsTheHighestElevationOnAnEdgeAndTheZenithInTheFrame) {
    const Sensor sensor = sensorOf(640, 480, 40.0);
    const FieldRays level(sensor, looking(30.0, 10.0));
    const FieldExtent extent = FieldExtent::of(level, radians(30.0));
    const double half = std::atan(level.vLimit());
    EXPECT_NEAR(extent.highest_rad, radians(10.0) + half, 1e-12) << "middle of the upper edge";
    EXPECT_NEAR(extent.lowest_rad, radians(10.0) - half, 1e-12)
        << "the lower edge, looking down, is lowest in its middle";
    EXPECT_NEAR(extent.left_rad, -extent.right_rad, 1e-12);
    EXPECT_FALSE(extent.allAround);

    const FieldExtent up = FieldExtent::of(FieldRays(sensor, looking(0.0, 80.0)), 0.0);
    EXPECT_TRUE(up.allAround);
    EXPECT_EQ(up.highest_rad, 0.5 * pi);
    EXPECT_NEAR(up.left_rad, -pi, 0.0);
}

TEST(Horizon, SharesAPixelByItsArea) {
    const Sensor sensor = sensorOf(9, 9, 1.0);
    for (const double roll_deg : {0.0, 20.0, 45.0, 90.0, 133.0}) {
        Viewpoint view = looking(0.0, 0.0);
        const double c = std::cos(radians(roll_deg)), s = std::sin(radians(roll_deg));
        const Vec3 right = view.right, up = view.up;
        view.right = right * c + up * s;
        view.up = up * c - right * s;
        const FieldRays rays(sensor, view);
        const Horizon horizon(rays, radians(0.03));
        // The mean over a fine lattice of points in each pixel.
        for (int y = 0; y < 9; ++y) {
            for (int x = 0; x < 9; ++x) {
                int above = 0;
                constexpr int n = 100;
                for (int j = 0; j < n; ++j) {
                    for (int i = 0; i < n; ++i) {
                        above +=
                            elevationOf_rad(rays.at(rays.u(x + (i + 0.5) / n),
                                                    rays.v(y + (j + 0.5) / n))) > radians(0.03);
                    }
                }
                EXPECT_NEAR(horizon.skyFraction(rays.u(x + 0.5), rays.v(y + 0.5)),
                            above / double{n * n}, 0.011)
                    << roll_deg << " deg, pixel " << x << ", " << y;
            }
        }
    }
}

TEST(HorizonOfTheAtmosphere, DipsWithAltitudeAsItsGeometrySays) {
    const Environment vacuum = Environment::vacuum();
    const SpectralRange band{3.0, 5.0};
    EXPECT_EQ(vacuum.horizonElevation_rad(0.0, band), 0.0);
    EXPECT_NEAR(vacuum.horizonElevation_rad(1e4, band), -std::acos(6371.23e3 / 6381.23e3), 1e-9);
    EXPECT_NEAR(vacuum.horizonElevation_rad(1.0, band), -std::sqrt(2.0 / 6371.23e3), 1e-10);

    AtmosphereSmartParameters parameters;
    const AtmosphereSmart smart(parameters);
    // Refraction lifts the horizon by about a twelfth of its dip.
    const double dip = -smart.horizonElevation_rad(1e4);
    EXPECT_LT(dip, std::acos(6371.23e3 / 6381.23e3));
    EXPECT_GT(dip, 0.85 * std::acos(6371.23e3 / 6381.23e3));
    const RayTracer& tracer = smart.transfer().tracer();
    EXPECT_EQ(tracer.along({1e4, -dip - 1e-9, 0.0}).end, RayPath::End::ground);
    EXPECT_NE(tracer.along({1e4, -dip + 1e-9, 0.0}).end, RayPath::End::ground);
    EXPECT_THROW(smart.horizonElevation_rad(-1.0), InputError);
}

TEST(BackgroundGrid, PutsARowOnEachSideOfTheHorizon) {
    for (const int rows : {1, 2, 3, 16}) {
        const BackgroundGrid grid(sensorOf(64, 64, 10.0), looking(20.0, 2.0), radians(-1.0), rows,
                                  3, [](const LineOfSight&) { return 1.0; });
        const std::vector<double> elevations = grid.elevations_rad();
        EXPECT_EQ(elevations.size(), static_cast<std::size_t>(std::max(rows, 2)));
        EXPECT_TRUE(std::ranges::is_sorted(elevations));
        const auto sky = std::ranges::upper_bound(elevations, radians(-1.0));
        ASSERT_NE(sky, elevations.begin());
        ASSERT_NE(sky, elevations.end());
        EXPECT_NEAR(*sky, radians(-1.0), 2e-8);
        EXPECT_NEAR(*(sky - 1), radians(-1.0), 2e-8);
        EXPECT_EQ(grid.azimuths_rad().size(), 3u);
        EXPECT_NEAR(grid.azimuths_rad()[1], radians(20.0), 1e-9);
    }
    EXPECT_THROW(BackgroundGrid(sensorOf(4, 4, 10.0), looking(0, 0), 0.0, -1, 1,
                                [](const LineOfSight&) { return 1.0; }),
                 LogicError);
}

TEST(BackgroundGrid, CarriesAConstantUnchanged) {
    const BackgroundGrid grid(sensorOf(65, 33, 60.0), looking(200.0, 3.0), 0.0, 16, 5,
                              [](const LineOfSight&) { return 123.25; });
    for (const double value : grid.pixels()) {
        EXPECT_EQ(value, 123.25);
    }
}

TEST(BackgroundGrid, IsExactForWhatIsBilinearInElevationAndAzimuthBetweenTwoRows) {
    const auto plane = [](const LineOfSight& sight) {
        return 5.0 + 2.0 * sight.elevation_rad -
               3.0 * std::remainder(sight.azimuth_rad - 3.0, 2 * pi) +
               sight.elevation_rad * std::remainder(sight.azimuth_rad - 3.0, 2 * pi);
    };
    const Sensor sensor = sensorOf(40, 30, 50.0);
    const Viewpoint view = looking(degrees(3.0), 30.0);
    const FieldRays rays(sensor, view);
    const BackgroundGrid grid(sensor, view, 0.0, 2, 3, plane);
    const std::vector<double> pixels = grid.pixels();
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            const Vec3 d = rays.at(rays.u(x + 0.5), rays.v(y + 0.5));
            const double expected = plane({0.0, elevationOf_rad(d), azimuthOf_rad(d)});
            EXPECT_NEAR(pixels[static_cast<std::size_t>(y * 40 + x)], expected, 1e-6);
            EXPECT_NEAR(grid.at(d), expected, 1e-12);
        }
    }
}

TEST(BackgroundGrid, GoesAllAroundTheZenithWithoutASeam) {
    const auto around = [](const LineOfSight& sight) { return 3.0 + std::cos(sight.azimuth_rad); };
    const BackgroundGrid grid(sensorOf(32, 32, 30.0), looking(10.0, 88.0), 0.0, 8, 72, around);
    for (double azimuth = 0.0; azimuth < 2 * pi; azimuth += 0.01) {
        EXPECT_NEAR(grid.at(direction(azimuth, radians(80.0))), around({0.0, 1.4, azimuth}), 1e-3);
    }
}

TEST(BackgroundGrid, IsWithinHalfAPercentOfAClearSkyAtSixteenRows) {
    struct Case {
        std::string name;
        double fieldOfView_deg, elevation_deg, depth;
    };
    for (const Case& c : {Case{"narrow", 4.0, 0.5, 0.3},
                          {"wide", 40.0, 5.0, 0.3},
                          {"thin air", 40.0, 0.0, 0.05},
                          {"thick air", 20.0, 3.0, 1.0},
                          {"fish-eye", 120.0, 10.0, 0.2}}) {
        const Sensor sensor = sensorOf(64, 256, c.fieldOfView_deg / 4.0);
        const Viewpoint view = looking(0.0, c.elevation_deg);
        const FieldRays rays(sensor, view);
        double before = 10.0;
        for (const int rows : {8, 16, 32}) {
            const BackgroundGrid grid(sensor, view, 0.0, rows, 1, [&](const LineOfSight& sight) {
                return clearSky(sight.elevation_rad, c.depth);
            });
            double worst = 0.0;
            for (int i = 1; i < 2000; ++i) {
                const Vec3 d = rays.at(0.0, rays.v(sensor.height_px * i / 2000.0));
                const double truth = clearSky(elevationOf_rad(d), c.depth);
                worst = std::max(worst, std::abs(grid.at(d) / truth - 1.0));
            }
            EXPECT_LT(worst, before) << c.name << ", " << rows << " rows";
            if (rows == 16) {
                EXPECT_LT(worst, 0.005) << c.name;
                RecordProperty("error_16_rows_" + c.name, std::to_string(worst));
            }
            before = std::max(worst, 1e-12);
        }
    }
}

TEST(BackgroundGrid, TakesAsManyRowsAsHalfAPercentNeeds) {
    // Air that ends at layers: radiances with kinks of the limb beside smooth ones.
    const auto layered = [](double elevation_rad) {
        double radiance = clearSky(elevation_rad, 0.1);
        for (const double layer_deg : {0.7, 1.1, 2.4, 3.1}) {
            radiance /= 1.0 + 0.7 * std::max(degrees(elevation_rad) - layer_deg, 0.0);
        }
        return radiance;
    };
    const auto smooth = [](double elevation_rad) { return clearSky(elevation_rad, 0.3); };
    const auto constant = [](double) { return 3.0; };
    const Sensor sensor = sensorOf(64, 256, 5.0);
    const Viewpoint view = looking(0.0, 2.0);
    const FieldRays rays(sensor, view);
    std::vector<std::size_t> rowsTaken;
    for (const std::function<double(double)>& profile :
         {std::function<double(double)>(constant), std::function<double(double)>(smooth),
          std::function<double(double)>(layered)}) {
        int asked = 0;
        const BackgroundGrid grid(sensor, view, 0.0, BackgroundGrid::asManyAsNeeded, 1,
                                  [&](const LineOfSight& sight) {
                                      ++asked;
                                      return profile(sight.elevation_rad);
                                  });
        for (int i = 1; i < 2000; ++i) {
            const Vec3 d = rays.at(0.0, rays.v(sensor.height_px * i / 2000.0));
            ASSERT_NEAR(grid.at(d) / profile(elevationOf_rad(d)), 1.0, BackgroundGrid::needed)
                << degrees(elevationOf_rad(d)) << " deg, " << grid.elevations_rad().size()
                << " rows";
        }
        rowsTaken.push_back(grid.elevations_rad().size());
        EXPECT_EQ(static_cast<std::size_t>(asked), rowsTaken.back()) << "no row is asked twice";
    }
    EXPECT_EQ(rowsTaken[0], 10u);
    EXPECT_GT(rowsTaken[1], rowsTaken[0]);
    EXPECT_GT(rowsTaken[2], rowsTaken[1]);

    // A sky that no number of rows describes ends at the most, a black one at the fewest.
    int asked = 0;
    const BackgroundGrid noise(sensor, view, 0.0, BackgroundGrid::asManyAsNeeded, 3,
                               [&](const LineOfSight&) { return ++asked % 2; });
    EXPECT_EQ(noise.elevations_rad().size(), 2u * BackgroundGrid::mostRows);
    const BackgroundGrid black(sensor, view, 0.0, BackgroundGrid::asManyAsNeeded, 1,
                               [](const LineOfSight&) { return 0.0; });
    EXPECT_EQ(black.elevations_rad().size(), 10u);
}

TEST(BackgroundGrid, RowsOfPixelsHaveTheRadianceOfTheirDirections) {
    // Most pixels of a row are between others that are computed.
    for (const double fieldOfView_deg : {0.5, 15.0, 28.0, 60.0}) {
        for (const double elevation_deg : {-40.0, -1.0, 0.3, 12.0, 85.0}) {
            for (const double roll_deg : {0.0, 20.0}) {
                const Sensor sensor = sensorOf(323, 200, fieldOfView_deg);
                const Vec3 forward = direction(radians(30.0), radians(elevation_deg));
                const Vec3 across = normalized(cross(forward, Vec3{0, 0, 1}));
                const Viewpoint viewpoint =
                    Viewpoint::lookAt({}, forward,
                                      Vec3{0, 0, 1} * std::cos(radians(roll_deg)) +
                                          across * std::sin(radians(roll_deg)));
                const BackgroundGrid grid(
                    sensor, viewpoint, 0.0, BackgroundGrid::asManyAsNeeded, 1,
                    [](const LineOfSight& sight) { return clearSky(sight.elevation_rad, 0.3); });
                const std::vector<double> pixels = grid.pixels();
                const FieldRays rays(sensor, viewpoint);
                double most = 0.0;
                for (int y = 0; y < sensor.height_px; ++y) {
                    for (int x = 0; x < sensor.width_px; ++x) {
                        const Vec3 along = normalized(rays.forward + rays.right * rays.u(x + 0.5) +
                                                      rays.up * rays.v(y + 0.5));
                        // A pixel on the horizon is of both sides.
                        if (std::abs(std::asin(along.z)) < 2.0 * (rays.u(1.0) - rays.u(0.0))) {
                            continue;
                        }
                        const double expected = grid.at(along);
                        const double found =
                            pixels[static_cast<std::size_t>(y) * 323 + static_cast<std::size_t>(x)];
                        most = std::max(most, std::abs(found / expected - 1.0));
                    }
                }
                EXPECT_LT(most, 1e-5) << fieldOfView_deg << " " << elevation_deg << " " << roll_deg;
            }
        }
    }
}

TEST(BackgroundGrid, MixesSkyAndGroundOnlyInThePixelThatHoldsTheHorizon) {
    const Sensor sensor = sensorOf(33, 33, 5.0);
    const Viewpoint view = looking(0.0, 0.01);
    const FieldRays rays(sensor, view);
    const BackgroundGrid grid(sensor, view, 0.0, 6, 1, [](const LineOfSight& sight) {
        return sight.elevation_rad >= 0.0 ? 1.0 : 5.0;
    });
    const std::vector<double> pixels = grid.pixels();
    const Horizon horizon(rays, 0.0);
    int mixed = 0;
    for (int y = 0; y < 33; ++y) {
        for (int x = 0; x < 33; ++x) {
            const double sky = horizon.skyFraction(rays.u(x + 0.5), rays.v(y + 0.5));
            EXPECT_NEAR(pixels[static_cast<std::size_t>(y * 33 + x)], 5.0 - 4.0 * sky, 1e-12);
            mixed += sky > 0.0 && sky < 1.0;
        }
    }
    EXPECT_EQ(mixed, 33) << "one pixel of every column";
}

TEST(BackgroundGrid, SeesTheFlatGroundOfBeerLambertBelowTheHorizontal) {
    const BeerLambertParameters parameters;
    const Environment environment = [&] {
        Environment result;
        result.add(std::make_shared<BeerLambert>(parameters));
        return result;
    }();
    EXPECT_EQ(environment.horizonElevation_rad(500.0, {3.0, 5.0}), 0.0);
}

TEST(SceneBackground, AsksARealAtmosphereForItsRowsWithTheWeightsOfTheBand) {
    AtmosphereSmartParameters parameters;
    auto smart = std::make_shared<AtmosphereSmart>(parameters);
    Environment environment;
    environment.add(smart);
    const Band band = Band::topHat(4.4, 4.9);
    const SpectralQuadrature quadrature(band, {}, 200.0);
    const BandSky sky(environment, quadrature);
    const Sensor sensor = sensorOf(16, 64, 2.0);
    const Viewpoint view = looking(40.0, -1.0, 3000.0);

    BackgroundSettings settings;
    settings.rows = 6;
    BackgroundReport report;
    SceneBackground background;
    GlTerrain painter;
    const FrameBackground frame = background.draw(sensor, view, sky, settings, painter, report);
    ASSERT_FALSE(frame.isUniform());
    ASSERT_EQ(report.providedBy.size(), 1u);
    const FieldRays rays(sensor, view);
    const Horizon horizon(rays, smart->horizonElevation_rad(3000.0));
    for (const int y : {0, 63}) {
        const Vec3 d = rays.at(rays.u(8.5), rays.v(y + 0.5));
        const double exact = sky.radiance_W_m2_sr({3000.0, elevationOf_rad(d), azimuthOf_rad(d)});
        EXPECT_NEAR(frame.at(8, y) / exact, 1.0, 0.005);
    }
    EXPECT_NE(frame.at(8, 0), frame.at(8, 63));
}
