#include "smatcore/tools/ViewerGeometry.h"

#include <gtest/gtest.h>

#include "irsg/radiometry/Units.h"

namespace smat {
namespace {

Settings placed(double altitude_m, double range_m, double azimuth_deg, double elevation_deg,
                double yaw_deg = 0.0) {
    Settings settings;
    settings.set("target.altitude", altitude_m);
    settings.set("target.yaw", yaw_deg);
    settings.set("camera.range", range_m);
    settings.set("camera.azimuth", azimuth_deg);
    settings.set("camera.elevation", elevation_deg);
    return settings;
}

TEST(ViewerGeometryTest, ACameraAheadAndAboveLooksSouthAndDown) {
    const auto g = viewerGeometry({}, placed(1000.0, 100.0, 0.0, 30.0), {});
    EXPECT_NEAR(*g.sensorAltitude_m, 1050.0, 1e-9);
    EXPECT_NEAR(*g.losElevation_deg, -30.0, 1e-9);
    EXPECT_NEAR(g.losAzimuth_deg, 180.0, 1e-9);
    EXPECT_NEAR(*g.targetAltitude_m, 1000.0, 1e-9);
    EXPECT_EQ(*g.range_m, 100.0);
    EXPECT_FALSE(g.toSpace);
}

TEST(ViewerGeometryTest, TheStarboardSideIsSeenLookingWest) {
    EXPECT_NEAR(viewerGeometry({}, placed(500.0, 50.0, 90.0, 0.0), {}).losAzimuth_deg, 270.0, 1e-9);
    // A target that turns takes its camera along.
    EXPECT_NEAR(viewerGeometry({}, placed(500.0, 50.0, 90.0, 0.0, 90.0), {}).losAzimuth_deg, 180.0,
                1e-9);
}

TEST(ViewerGeometryTest, AltitudesAreThoseOfTheReferencePoint) {
    const auto g = viewerGeometry({}, placed(100.0, 10.0, 0.0, 0.0), {0.0, 3.0, 7.0});
    EXPECT_NEAR(*g.targetAltitude_m, 107.0, 1e-9);
    EXPECT_NEAR(*g.sensorAltitude_m, 107.0, 1e-9);
}

TEST(ViewerGeometryTest, ItsCommandSaysEveryNumber) {
    const auto g = viewerGeometry({}, placed(1000.0, 100.0, 0.0, 0.0), {});
    const std::string command =
        radiativeCommand({"my air.csv"}, {"sun", "path"}, g, {3.0, 5.0},
                         {irsg::radians(180.0), irsg::radians(45.0)}, 172.0, "out.csv");
    EXPECT_EQ(command.find("smat-batch radiative 'my air.csv' --quantity sun --quantity path "
                           "--band 3-5 --sensor-altitude=1000 --altitude=1000 --range=100 "),
              0U)
        << command;
    EXPECT_NE(command.find("--sun-azimuth=180"), std::string::npos) << command;
    EXPECT_NE(command.find("--day-of-year=172 "), std::string::npos) << command;
    EXPECT_NE(command.find("--out out.csv"), std::string::npos) << command;
}

TEST(ViewerGeometryTest, AProjectWithoutAModelLooksAtItsOrigin) {
    SceneBuilder scenes;
    EXPECT_EQ(targetReferencePoint({}, scenes), irsg::Vec3());
    Project missing;
    missing.models.push_back({.file = "no such model.flt", .database = "none.sigdb"});
    EXPECT_EQ(targetReferencePoint(missing, scenes), irsg::Vec3());
    missing.models.front().referencePoint_m = irsg::Vec3{1.0, 2.0, 3.0};
    EXPECT_EQ(targetReferencePoint(missing, scenes), (irsg::Vec3{1.0, 2.0, 3.0}));
}

} // namespace
} // namespace smat
