#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/tables/AtmosphereTables.h"
#include "irsg/radiometry/Units.h"

using namespace irsg;

namespace {

AtmosphereSmart hazyAtmosphere(int irradianceMode = 2, int scatteringMode = 2) {
    AtmosphereSmartParameters parameters;
    parameters.irradianceMode = irradianceMode;
    parameters.scatteringMode = scatteringMode;
    parameters.baseWavelengthMin_um = 0.7;
    return AtmosphereSmart(parameters);
}

double sumOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The azimuth at which a line of sight stands at an angle from the sun.
double azimuthAt(double angle_rad, double sightElevation_rad, double sunElevation_rad) {
    return std::acos(
        (std::cos(angle_rad) - std::sin(sightElevation_rad) * std::sin(sunElevation_rad)) /
        (std::cos(sightElevation_rad) * std::cos(sunElevation_rad)));
}

} // namespace

// What is seen to space is what is seen to any place on the way and from there on.
TEST(LightOfThePath, WithTheSkyBeyondTheTargetIsTheSky) {
    for (const int scattering : {1, 2}) {
        const AtmosphereSmart air = hazyAtmosphere(2, scattering);
        const RadiativeTransfer& transfer = air.transfer();
        for (const SpectralRange& range :
             {SpectralRange{0.85, 0.9}, SpectralRange{2.1, 2.2}, SpectralRange{3.5, 4.0}}) {
            const NodeSet nodes = transfer.nodesOf(range);
            for (const double angle_deg : {5.0, 30.0, 90.0}) {
                const double elevation_rad = radians(30.0);
                const SunPosition sun{1.0, radians(32.0)};
                const double azimuth_rad =
                    sun.azimuth_rad +
                    azimuthAt(radians(angle_deg), elevation_rad, sun.elevation_rad);
                const LineOfSight sight{200.0, elevation_rad, azimuth_rad};

                // A target on the refracted line of sight: at 3 km altitude.
                const RayPath ray = transfer.tracer().along(sight);
                const double altitude_m = transfer.tracer().gridAltitudes_m()[15];
                double range_m = 0.0, sine = 0.0;
                for (const RaySegment& segment : ray.segments) {
                    range_m += segment.length_m;
                    sine = segment.sinElevation;
                    if (segment.endAltitude_m >= altitude_m - 1e-6) {
                        break;
                    }
                }
                const AtmosphericPath path{200.0, altitude_m, range_m, azimuth_rad};
                const std::vector<double> through = transfer.transmittance(nodes, path);
                const std::vector<double> beyond = transfer.backgroundRadiance(
                    nodes, {altitude_m, std::asin(sine), azimuth_rad}, sun);
                std::vector<double> seen = transfer.pathRadiance(nodes, path, sun);
                for (std::size_t i = 0; i < seen.size(); ++i) {
                    seen[i] += through[i] * beyond[i];
                }
                EXPECT_NEAR(sumOf(seen) / sumOf(transfer.backgroundRadiance(nodes, sight, sun)),
                            1.0, 5e-3)
                    << scattering << " " << range.min_um << " um, " << angle_deg << " deg";
            }
        }
    }
}

TEST(LightOfThePath, IsBrightestTowardsTheSunAndAlikeOnBothSides) {
    const AtmosphereSmart air = hazyAtmosphere();
    const SpectralRange range{0.85, 0.9};
    const SunPosition sun{1.0, 0.3};
    const auto at = [&](double fromSun_rad) {
        return air.pathRadiance({100.0, 100.0, 5000.0, sun.azimuth_rad + fromSun_rad}, sun, range)
            .at(0.87);
    };
    EXPECT_GT(at(0.0), 2.0 * at(1.5));
    EXPECT_DOUBLE_EQ(at(0.7), at(-0.7));
    EXPECT_DOUBLE_EQ(at(0.7), at(0.7 + 2.0 * pi));
    EXPECT_TRUE(air.dependsOnAzimuth(AtmosphereProperty::pathRadiance));
    // In the dark there is no direction.
    const SunPosition night{1.0, -0.5};
    EXPECT_EQ(air.pathRadiance({100.0, 100.0, 5000.0, 0.0}, night, range),
              air.pathRadiance({100.0, 100.0, 5000.0, 2.0}, night, range));
}

TEST(LightOfThePath, IsTheSameFromTablesAtEveryAzimuth) {
    const AtmosphereSmart fly = hazyAtmosphere(2), table = hazyAtmosphere(1);
    const NodeSet nodes = fly.transfer().nodesOf({2.1, 2.2});
    const AtmosphereTables tables(table.transfer(), nodes);
    const SunPosition sun{1.0, 0.4};
    for (double range_m = 2000.0; range_m < 6000.0; range_m += 370.0) {
        for (const double azimuth_rad : {1.05, 2.5}) {
            const AtmosphericPath path{100.0, 900.0, range_m, azimuth_rad};
            EXPECT_NEAR(sumOf(tables.pathRadiance(path, sun)) /
                            sumOf(fly.transfer().pathRadiance(nodes, path, sun)),
                        1.0, 2e-3);
            const LineOfSight sight{100.0, 1e-4 * range_m, azimuth_rad};
            EXPECT_NEAR(sumOf(tables.backgroundRadiance(sight, sun)) /
                            sumOf(fly.transfer().backgroundRadiance(nodes, sight, sun)),
                        1.0, 2e-3);
        }
    }
    const std::size_t evaluations = tables.evaluations();
    for (double azimuth_rad = 0.0; azimuth_rad < 6.0; azimuth_rad += 0.1) {
        (void)tables.pathRadiance({100.0, 900.0, 3110.0, azimuth_rad}, sun);
    }
    EXPECT_EQ(tables.evaluations(), evaluations) << "another azimuth costs no radiative transfer";
}
