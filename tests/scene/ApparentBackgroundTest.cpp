// The background of an object is that of the directions in which it appears. The witness follows
// rays through the air by itself and sums radiances along lines of sight.
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/engine/RadiativeTransfer.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/SightsBehind.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes one{1, 1};
const Band midWave = Band::topHat(3.0, 5.0), longWave = Band::topHat(8.0, 12.0);

std::shared_ptr<const AtmosphereSmart> airOf(const Band& band) {
    static const std::array<std::shared_ptr<const AtmosphereSmart>, 2> airs = [] {
        AtmosphereSmartParameters parameters;
        parameters.resolution_per_cm = 15;
        auto mid = std::make_shared<const AtmosphereSmart>(parameters);
        parameters.baseWavelengthMin_um = 8.0;
        parameters.baseWavelengthMax_um = 12.0;
        return std::array<std::shared_ptr<const AtmosphereSmart>, 2>{
            mid, std::make_shared<const AtmosphereSmart>(parameters)};
    }();
    return airs[band == midWave ? 0 : 1];
}

/// Altitude of a ray after a length, m: steps of Snell's law over a sphere, n r cos(e) = const.
double altitudeAfter_m(const RayTracer& air, double from_m, double elevation_rad, double length_m) {
    constexpr int steps = 20000;
    const double step_m = length_m / steps, radius_m = air.earthRadius_m();
    double altitude_m = from_m, e_rad = elevation_rad;
    // d(e)/ds = cos(e) (1 / r + n' / n), of the middle of each step.
    const auto turn = [&](double z_m, double angle_rad) {
        constexpr double around_m = 5.0;
        const double low_m = std::max(z_m - around_m, 0.0), high_m = low_m + 2.0 * around_m;
        const double slope = (air.refractiveIndex(high_m) - air.refractiveIndex(low_m)) /
                             (high_m - low_m) / air.refractiveIndex(z_m);
        return std::cos(angle_rad) * (1.0 / (radius_m + z_m) + slope);
    };
    for (int i = 0; i < steps; ++i) {
        const double middle_rad = e_rad + 0.5 * step_m * turn(std::max(altitude_m, 0.0), e_rad);
        const double middle_m = altitude_m + 0.5 * step_m * std::sin(e_rad);
        altitude_m += step_m * std::sin(middle_rad);
        e_rad += step_m * turn(std::max(middle_m, 0.0), middle_rad);
    }
    return altitude_m;
}

/// Elevation at the sensor of the ray that ends at an altitude after a range.
double apparentElevation_rad(const RayTracer& air, double from_m, double to_m, double range_m) {
    double low = -0.15, high = 0.15;
    for (int i = 0; i < 45; ++i) {
        const double middle = 0.5 * (low + high);
        (altitudeAfter_m(air, from_m, middle, range_m) < to_m ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double inBand(const Environment& environment, const Band& band, const AtmosphericQuery& query) {
    const auto nodes = environment.nodesOf(band);
    return nodes->integrate(environment.provide(query, *nodes).value);
}

InteractiveRenderer blackBody(const Band& band, const Triangles& mesh, double temperature_K,
                              double altitude_m) {
    InteractiveRenderer irsg;
    irsg.scene.environment = Environment();
    irsg.scene.environment.add(airOf(band));
    irsg.scene.environment.sun.elevation_rad = radians(-90.0);
    irsg.scene.entities = {entityOf(modelOf(mesh), greyDatabase(1.0, temperature_K))};
    irsg.scene.entities.front().pose.position_m.z = altitude_m;
    return irsg;
}

/// A background that changes by direction, over a sphere, in air of one temperature.
class IsothermalAir : public ConstantAtmosphere {
  public:
    TargetView targetView(const AtmosphericPath& path) const override {
        return sphericalTargetView(path);
    }
};

} // namespace

TEST(TargetView, IsThatOfAChordOverASphere) {
    // The chord between two places as high leaves each at half of the angle between them.
    const TargetView level = sphericalTargetView({1000.0, 1000.0, 50e3, 0.0});
    EXPECT_NEAR(level.elevation_rad, -std::asin(25e3 / 6372.23e3), 1e-12);
    EXPECT_EQ(level.hiddenBelow_m, 0.0);
    EXPECT_NEAR(flatTargetView({1000.0, 1300.0, 500.0, 0.0}).elevation_rad, std::asin(0.6), 1e-15);
    // The horizon of 10 m is 11.29 km away; as far behind it 10 m are hidden.
    const double toHorizon_m = std::sqrt(10.0 * (2.0 * 6371.23e3 + 10.0));
    EXPECT_NEAR(sphericalTargetView({10.0, 0.0, 2.0 * toHorizon_m, 0.0}).hiddenBelow_m, 10.0, 1e-6);
    EXPECT_EQ(sphericalTargetView({10.0, 0.0, 0.999 * toHorizon_m, 0.0}).hiddenBelow_m, 0.0);
}

TEST(TargetView, OfRefractingAirIsTheRayBetweenBoth) {
    const RayTracer& air = airOf(midWave)->transfer().tracer();
    struct {
        double from_m, to_m, range_m;
    } const cases[] = {{100.0, 100.0, 20e3}, {1500.0, 1500.0, 50e3}, {10e3, 10e3, 100e3},
                       {10e3, 200.0, 100e3}, {200.0, 10e3, 100e3},   {30.0, 20.0, 25e3}};
    for (const auto& [from_m, to_m, range_m] : cases) {
        EXPECT_NEAR(air.targetView({from_m, to_m, range_m, 0.0}).elevation_rad,
                    apparentElevation_rad(air, from_m, to_m, range_m), 2e-6)
            << from_m << " to " << to_m << " m over " << range_m << " m";
    }
}

TEST(TargetView, HidesWhatTheRayThatGrazesTheGroundPassesAbove) {
    const RayTracer& air = airOf(midWave)->transfer().tracer();
    for (const double from_m : {2.0, 10.0, 300.0}) {
        for (const double range_m : {80e3, 150e3}) {
            const double hidden_m = air.targetView({from_m, 0.0, range_m, 0.0}).hiddenBelow_m;
            const double expected_m =
                altitudeAfter_m(air, from_m, air.horizonElevation_rad(from_m), range_m);
            EXPECT_NEAR(hidden_m, expected_m, 1e-3 * expected_m + 0.1)
                << from_m << " m, " << range_m << " m";
            // What stands there appears on the horizon.
            EXPECT_NEAR(
                air.targetView({from_m, hidden_m * (1.0 + 1e-6), range_m, 0.0}).elevation_rad,
                air.horizonElevation_rad(from_m), 1e-8);
        }
    }
}

TEST(TargetView, IsContinuousWhereTheHorizonIsReached) {
    const RayTracer& air = airOf(midWave)->transfer().tracer();
    double before_m = 0.0;
    for (double range_m = 10e3; range_m < 40e3; range_m += 100.0) {
        const double hidden_m = air.hiddenBelow_m(10.0, range_m);
        EXPECT_GE(hidden_m, before_m);
        EXPECT_LT(hidden_m - before_m, 0.6);
        before_m = hidden_m;
    }
}

TEST(ApparentBackground, OfLevelPathsIsThatOfTheirOwnDirection) {
    for (const Band& band : {midWave, longWave}) {
        for (const double altitude_m : {100.0, 1500.0, 10e3}) {
            InteractiveRenderer irsg =
                blackBody(band, sphereMesh(2.0, 12, 24, one), 320.0, altitude_m);
            const Environment& environment = irsg.scene.environment;
            for (const double range_m : {5e3, 10e3, 20e3, 30e3, 50e3, 100e3}) {
                const RayTracer& tracer = airOf(band)->transfer().tracer();
                if (tracer.targetView({altitude_m, altitude_m, range_m, 0.0}).hiddenBelow_m >
                    90.0) {
                    continue;
                }
                look(irsg, {.range_m = range_m, .fieldOfView_rad = 0.01, .band = band});
                const ObjectRadiometry found = irsg.measure().all;

                const AtmosphericPath path{altitude_m, altitude_m, range_m, pi};
                const auto nodes = environment.nodesOf(band);
                std::vector<double> seen =
                    environment.provide(AtmosphericQuery::transmittance(path), *nodes).value;
                for (std::size_t i = 0; i < seen.size(); ++i) {
                    seen[i] *= planckRadiance_W_m2_sr_um(nodes->wavelengths_um()[i], 320.0);
                }
                const double sent = nodes->integrate(seen) +
                                    inBand(environment, band,
                                           AtmosphericQuery::pathRadiance(path, environment.sun));
                const LineOfSight sight{
                    altitude_m, apparentElevation_rad(tracer, altitude_m, altitude_m, range_m), pi};
                const double contrast =
                    sent - inBand(environment, band,
                                  AtmosphericQuery::backgroundRadiance(sight, environment.sun));
                EXPECT_NEAR(found.contrastIntensity_W_sr / found.intensity_W_sr, contrast / sent,
                            std::max(2e-3 * std::abs(contrast / sent), 1e-5))
                    << band.name() << ", " << altitude_m << " m, over " << range_m << " m";
            }
        }
    }
}

TEST(ApparentBackground, IsTakenOverWhatAnObjectCovers) {
    // A wall of 120 m at 2.5 km, and one across the horizon.
    for (const double altitude_m : {150.0, 62.0}) {
        InteractiveRenderer irsg = blackBody(
            longWave, plateMesh({0, 0, 0}, {30, 0, 0}, {0, 0, 60}, one), 320.0, altitude_m);
        look(irsg, {.range_m = 2500.0,
                    .width_px = 256,
                    .height_px = 256,
                    .fieldOfView_rad = 0.06,
                    .band = longWave});
        irsg.scene.settings.bounces = 0;
        const ObjectRadiometry found = irsg.measure().all;
        const double hidden = (found.intensity_W_sr - found.contrastIntensity_W_sr) /
                              (found.solidAngle_sr * found.range_m * found.range_m);

        const RayTracer& tracer = airOf(longWave)->transfer().tracer();
        constexpr int strips = 240;
        double mean = 0.0, middle = 0.0;
        for (int i = 0; i < strips; ++i) {
            const double z_m = altitude_m - 60.0 + 120.0 * (i + 0.5) / strips;
            const LineOfSight sight{
                altitude_m,
                tracer.targetView({altitude_m, z_m, std::hypot(2500.0, z_m - altitude_m), 0.0})
                    .elevation_rad,
                pi};
            const double seen =
                inBand(irsg.scene.environment, longWave,
                       AtmosphericQuery::backgroundRadiance(sight, irsg.scene.environment.sun));
            mean += seen / strips;
            if (i == strips / 2) {
                middle = seen;
            }
        }
        EXPECT_NEAR(hidden / mean, 1.0, 3e-4) << altitude_m;
        EXPECT_GT(std::abs(middle / mean - 1.0), 5e-4) << "one row would do";
    }
}

TEST(ApparentBackground, OfPanesCountsByTheirOpacity) {
    // An upper half that lets 70 % through, and a lower one that hides another wall.
    const auto half = [](double middle_m, double behind_m, const IrCodes& codes) {
        return plateMesh({0, behind_m, middle_m}, {30, 0, 0}, {0, 0, 30}, codes);
    };
    constexpr double altitude_m = 150.0;
    InteractiveRenderer irsg = blackBody(
        longWave,
        joined(joined(half(-30.0, 0.0, one), half(30.0, 0.0, {1, 2})), half(-30.0, 5.0, one)),
        320.0, altitude_m);
    SignatureDatabase database = greyDatabase(1.0, 320.0);
    database.materials[2] = greyMaterial(0.3, 0.7);
    irsg.scene.entities = {entityOf(irsg.scene.entities.front().model, database)};
    irsg.scene.entities.front().pose.position_m.z = altitude_m;
    irsg.scene.settings.bounces = 0;
    look(irsg, {.range_m = 2500.0,
                .width_px = 256,
                .height_px = 256,
                .fieldOfView_rad = 0.06,
                .band = longWave});
    const ObjectRadiometry found = irsg.measure().all;
    irsg.scene.settings.background = BackgroundMode::constant;
    irsg.scene.settings.background_W_m2_sr = 1.0;
    const ObjectRadiometry before = irsg.measure().all;
    const double hidden = (found.intensity_W_sr - found.contrastIntensity_W_sr) /
                          (before.intensity_W_sr - before.contrastIntensity_W_sr);

    const RayTracer& tracer = airOf(longWave)->transfer().tracer();
    constexpr int strips = 240;
    double sum = 0.0, weights = 0.0, plain = 0.0;
    for (int i = 0; i < strips; ++i) {
        const double z_m = altitude_m - 60.0 + 120.0 * (i + 0.5) / strips;
        const double range_m = std::hypot(2500.0, z_m - altitude_m);
        const LineOfSight sight{
            altitude_m, tracer.targetView({altitude_m, z_m, range_m, 0.0}).elevation_rad, pi};
        const double seen =
            inBand(irsg.scene.environment, longWave,
                   AtmosphericQuery::backgroundRadiance(sight, irsg.scene.environment.sun));
        const double weight = i < strips / 2 ? 1.0 : 0.3;
        sum += weight * seen;
        weights += weight;
        plain += seen / strips;
    }
    EXPECT_NEAR(hidden / (sum / weights), 1.0, 1e-4);
    EXPECT_GT(std::abs(plain / (sum / weights) - 1.0), 5e-4) << "all alike would do";
}

TEST(ApparentBackground, IsOneRowWhereItCannotChange) {
    // Where one direction answers for all, and where the object is small beside its elevation.
    ObjectGeometry steep;
    steep.sight = {2000.0, radians(-50.0), 0.0};
    int asked = 0;
    const RadianceAlong along = [&](const LineOfSight&) {
        ++asked;
        return std::vector<double>{1.0};
    };
    const auto none = [] {
        ADD_FAILURE() << "a silhouette was asked for";
        return std::vector<SilhouettePart>();
    };
    const SightsBehind behind = sightsBehind(steep, radians(-1.4), 4e-4, none, along);
    EXPECT_EQ(behind.sights.size(), 1u);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(behind.error, std::vector<double>{0.0});
}

TEST(ApparentBackground, TakesAsManyRowsAsItsErrorNeeds) {
    ObjectGeometry object;
    object.sight = {100.0, 0.01, 0.0};
    const std::vector<SilhouettePart> slices = {{-0.015, 0.3}, {0.0, 0.5}, {0.005, 0.2}};
    const auto of = [&](const std::function<double(double)>& radiance) {
        return sightsBehind(
            object, 0.0, 0.02, [&] { return slices; },
            [&](const LineOfSight& sight) {
                return std::vector<double>{radiance(sight.elevation_rad)};
            });
    };
    const auto exact = [&](const std::function<double(double)>& radiance) {
        double sum = 0.0;
        for (const SilhouettePart& slice : slices) {
            sum += slice.weight * radiance(0.01 + slice.above_rad);
        }
        return sum;
    };
    const auto sum = [&](const SightsBehind& behind,
                         const std::function<double(double)>& radiance) {
        double all = 0.0;
        for (const SightBehind& one : behind.sights) {
            all += one.weight * radiance(one.sight.elevation_rad);
        }
        return all;
    };
    const auto straight = [](double e) { return e >= 0.0 ? 2.0 + 10.0 * e : 1.0 + 4.0 * e; };
    const auto curved = [](double e) {
        return e >= 0.0 ? 1.0 + std::exp(-e / 0.004) : 1.5 - std::exp(e / 0.002);
    };
    const SightsBehind few = of(straight), many = of(curved);
    EXPECT_LE(few.sights.size(), 6u);
    EXPECT_GT(many.sights.size(), few.sights.size());
    EXPECT_NEAR(sum(few, straight), exact(straight), 1e-7);
    EXPECT_NEAR(sum(many, curved), exact(curved), 1e-3);
    EXPECT_GE(many.error.front(), std::abs(sum(many, curved) - exact(curved)));
}

TEST(ApparentBackground, LeavesNoContrastInAWorldOfOneTemperature) {
    IsothermalAir air;
    const double radiance = 3.0; // everywhere
    air.transmittanceValue = 0.4;
    air.pathRadianceValue = 0.6 * radiance;
    air.backgroundValue = radiance;
    InteractiveRenderer irsg;
    // A reflector of all that comes to it: sky and ground are as bright.
    auto isothermal = std::make_shared<IsothermalAir>(air);
    isothermal->upValue = isothermal->downValue = pi * radiance;
    irsg.scene.environment = Environment();
    irsg.scene.environment.add(isothermal);
    irsg.scene.environment.sun.elevation_rad = radians(-90.0);
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(5.0, 12, 24, one)), greyDatabase(0.0, 250.0))};
    irsg.scene.entities.front().pose.position_m.z = standingAltitude_m;
    for (const double range_m : {100.0, 5e3, 60e3}) {
        for (const double elevation_rad : {0.0, 0.01}) {
            look(irsg,
                 {.range_m = range_m, .elevation_rad = elevation_rad, .fieldOfView_rad = 0.2});
            const ObjectRadiometry found = irsg.measure().all;
            EXPECT_NEAR(found.contrastIntensity_W_sr / found.intensity_W_sr, 0.0, 1e-9)
                << range_m << " m, " << elevation_rad;
        }
    }
}

TEST(ApparentBackground, OfATargetBehindTheHorizonIsNotRefused) {
    for (const double range_m : {150e3, 1e6}) {
        InteractiveRenderer irsg = blackBody(longWave, sphereMesh(2.0, 12, 24, one), 320.0, 2.5);
        look(irsg, {.range_m = range_m, .fieldOfView_rad = 0.01, .band = longWave});
        const ObjectRadiometry found = irsg.measure().all;
        EXPECT_EQ(found.intensity_W_sr, 0.0) << range_m;
        EXPECT_EQ(found.contrastIntensity_W_sr, 0.0) << range_m;
    }
}
