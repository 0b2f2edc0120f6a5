// Bodies shade the ground near them from sun and sky, and see it so: a wall over level ground
// beside quadratures of the view factors.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/ReflectingGround.h"
#include "irsg/radiometry/Units.h"
#include "irsg/reference/PlanckReference.h"
#include "tests/support/LightScenes.h"
#include "tests/support/RaysTest.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class GroundShadows : public RaysTest {};

constexpr double bottom_m = 0.4, up_W_m2_um = 20.0, down_W_m2_um = 30.0, sun_W_m2_um = 100.0;

class AirOverGround : public ConstantAtmosphere, public ReflectingGround {
  public:
    explicit AirOverGround(double reflectivity) : reflectivity_(reflectivity) {
        upValue = up_W_m2_um;
        downValue = down_W_m2_um;
        sunValue = sun_W_m2_um;
    }
    Spectrum groundReflectivity() const override { return Spectrum::constant(reflectivity_); }

  private:
    double reflectivity_;
};

/// A wall of side 1 that looks along x, over ground at z = 0. The sun stands behind it, 45 degrees
/// high, so that its shadow lies before it.
Entity wall(double emissivity, double temperature_K, double altitude_m) {
    SignatureDatabase database = greyDatabase(emissivity, temperature_K);
    Entity entity =
        entityOf(modelOf(plateMesh({0, 0, 0.5}, {0, 0.5, 0}, {0, 0, 0.5}, {1, 1})), database);
    entity.pose.position_m.z = altitude_m;
    entity.referencePoint_m = Vec3{};
    return entity;
}

double radiance_W_m2_sr(const Entity& entity, double groundReflectivity) {
    Environment environment;
    environment.add(std::make_shared<const AirOverGround>(groundReflectivity));
    const Vec3 front = entity.pose.attitude.rotation() * Vec3{1, 0, 0};
    environment.sun = {std::atan2(-front.x, -front.y), radians(45.0)};
    RenderSettings settings = lightSettings(convergedBounces);
    settings.ambientReflection = ReflectionMode::smart;
    settings.sun = ReflectionMode::smart;
    settings.sunShadows = SunShadowMode::point;
    InteractiveRenderer irsg = rendererOf({entity}, settings, environment);
    Sensor sensor = sensorOf(16, 16, 0.06);
    sensor.band = Band::topHat(3.0, 5.0);
    irsg.view.sensor = sensor;
    const Vec3 middle = entity.pose.toWorld({0, 0, 0.5});
    irsg.view.viewpoint = Viewpoint::lookAt(middle + front * 5000.0, middle);
    return irsg.measure().all.intensity_W_sr;
}

/// What ground places see of the wall, F: its integral over the shadow, and that of its square over
/// all ground before the wall.
struct GroundFactors {
    double shadow = 0.0, all = 0.0;
};

GroundFactors groundFactors() {
    constexpr int places = 20, across = 120, along = 160;
    constexpr double near_m = 0.02, far_m = 40.0;
    GroundFactors sums;
    const auto factorAt = [&](double x, double y) {
        double sum = 0.0;
        for (int i = 0; i < places; ++i) {
            for (int k = 0; k < places; ++k) {
                const double dy = y - ((i + 0.5) / places - 0.5);
                const double z = bottom_m + (k + 0.5) / places;
                const double square = x * x + dy * dy + z * z;
                sum += x * z / (pi * square * square);
            }
        }
        return sum / (places * places);
    };
    const double ratio = std::log(1.0 + far_m / near_m);
    for (int i = 0; i < along; ++i) {
        const double grown = std::exp(ratio * (i + 0.5) / along);
        const double x = near_m * (grown - 1.0), dx = near_m * grown * ratio / along;
        for (int k = 0; k < across; ++k) {
            const double away = std::exp(ratio * (k + 0.5) / across);
            const double y = near_m * (away - 1.0), dy = near_m * away * ratio / across;
            const double factor = factorAt(x, y);
            sums.all += 2.0 * factor * factor * dx * dy;
        }
    }
    constexpr int steps = 40;
    for (int i = 0; i < steps; ++i) {
        for (int k = 0; k < steps; ++k) {
            sums.shadow +=
                factorAt(bottom_m + (i + 0.5) / steps, (k + 0.5) / steps - 0.5) / (steps * steps);
        }
    }
    return sums;
}

} // namespace

TEST_F(GroundShadows, OfAWallAreThoseOfViewFactors) {
    const GroundFactors factors = groundFactors();
    constexpr double width_um = 2.0;
    struct Row {
        double emissivity, temperature_K, ground;
    };
    for (const Row& row :
         {Row{0.4, 2.0, 0.5}, Row{0.9, 2.0, 0.9}, Row{0.7, 420.0, 0.3}, Row{0.4, 2.0, 0.0}}) {
        const double rho = 1.0 - row.emissivity;
        const double emitted =
            row.temperature_K < 100.0
                ? 0.0
                : pi * row.emissivity *
                      static_cast<double>(reference::bandRadiance({3.0, 5.0}, row.temperature_K));
        const double free = width_um * 0.5 * (up_W_m2_um + down_W_m2_um);
        const double lost = width_um * (factors.all * down_W_m2_um +
                                        factors.shadow * sun_W_m2_um * std::sin(radians(45.0)));
        // J = emitted + rho (free - ground (lost - all J)): J as a mean over the wall.
        const double leaving =
            (emitted + rho * (free - row.ground * lost)) / (1.0 - rho * row.ground * factors.all);
        const double found =
            radiance_W_m2_sr(wall(row.emissivity, row.temperature_K, bottom_m), row.ground);
        std::printf("  e %g, %g K, ground %g: %.5f, without shadows %.4f\n", row.emissivity,
                    row.temperature_K, row.ground, found * pi / leaving,
                    (emitted + rho * free) / leaving);
        EXPECT_NEAR(found * pi / leaving, 1.0, 0.004);
    }
}

TEST_F(GroundShadows, AreNotSeenFromHighUpNorOnBlackGround) {
    const double low = radiance_W_m2_sr(wall(0.4, 2.0, bottom_m), 0.0);
    EXPECT_EQ(radiance_W_m2_sr(wall(0.4, 2.0, 1000.0), 0.7),
              radiance_W_m2_sr(wall(0.4, 2.0, 1000.0), 0.0));
    EXPECT_NE(radiance_W_m2_sr(wall(0.4, 2.0, bottom_m), 0.7), low);
}

TEST_F(GroundShadows, HaveTheAlbedoOfTheAir) {
    AtmosphereSmartParameters parameters;
    const AtmosphereSmart air(parameters);
    EXPECT_EQ(air.groundReflectivity().at(4.0), air.air().groundAlbedo.at(4.0));
}
