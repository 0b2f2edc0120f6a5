// What the surfaces of each pair of codes add to the sums of their object.
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

/// Grey entries of two temperatures, cold at index 1, hot at 2.
SignatureDatabase coldAndHot() {
    SignatureDatabase database = greyDatabase(0.8, 290.0);
    database.temperatures[2] = fixedTemperature(450.0);
    return database;
}

const SurfaceRadiometry& surfaceOf(const ObjectRadiometry& object, int temperature) {
    for (const SurfaceRadiometry& surface : object.surfaces) {
        if (surface.temperature == temperature) {
            return surface;
        }
    }
    throw LogicError("no surface of that temperature");
}

void expectToAddUp(const ObjectRadiometry& object) {
    ASSERT_FALSE(object.surfaces.empty());
    SurfaceRadiometry sum;
    for (const SurfaceRadiometry& surface : object.surfaces) {
        sum.intensity_W_sr += surface.intensity_W_sr;
        sum.contrastIntensity_W_sr += surface.contrastIntensity_W_sr;
        sum.irradiance_W_m2 += surface.irradiance_W_m2;
        sum.solidAngle_sr += surface.solidAngle_sr;
    }
    EXPECT_NEAR(sum.intensity_W_sr / object.intensity_W_sr, 1.0, 1e-12);
    EXPECT_NEAR(sum.contrastIntensity_W_sr / object.contrastIntensity_W_sr, 1.0, 1e-10);
    EXPECT_NEAR(sum.irradiance_W_m2 / object.irradiance_W_m2, 1.0, 1e-10);
    EXPECT_NEAR(sum.solidAngle_sr / object.solidAngle_sr, 1.0, 1e-12);
}

RenderReport bySurface(InteractiveRenderer& irsg) {
    return irsg.render(Outputs::reports().bySurface()).reports.front();
}

} // namespace

TEST(SurfaceSums, AreThoseOfTheFacesWithTheirCodes) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    // Seen from the nose one face alone is in sight.
    int seen = 0;
    for (std::size_t hotFace = 0; hotFace < 6; ++hotFace) {
        std::vector<IrCodes> faces(6, IrCodes{1, 1});
        faces[hotFace] = {2, 1};
        irsg.scene.entities = {entityOf(modelOf(boxMesh({4.0, 2.0, 2.0}, faces)), coldAndHot())};
        look(irsg, {.range_m = 2000.0, .fieldOfView_rad = 0.01});
        const RenderReport report = bySurface(irsg);
        expectToAddUp(report.objects.front());
        const double hot = surfaceOf(report.objects.front(), 2).intensity_W_sr;
        const double cold = surfaceOf(report.objects.front(), 1).intensity_W_sr;
        const bool isSeen = hot > 0.0;
        const double temperature_K = isSeen ? 450.0 : 290.0;
        EXPECT_EQ(isSeen ? cold : hot, 0.0);
        seen += isSeen ? 1 : 0;
        EXPECT_NEAR((isSeen ? hot : cold) /
                        (32.0 * 0.8 * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), temperature_K)),
                    1.0, 2e-2);
    }
    EXPECT_EQ(seen, 1);
}

TEST(SurfaceSums, AddUpWithLightBetweenSurfacesSeveralObjectsAndAirBehindThem) {
    InteractiveRenderer irsg;
    AtmosphereSmartParameters parameters;
    parameters.resolution_per_cm = 15;
    parameters.baseWavelengthMin_um = 8.0;
    parameters.baseWavelengthMax_um = 12.0;
    irsg.scene.environment.add(std::make_shared<const AtmosphereSmart>(parameters));
    const auto model =
        modelOf(boxMesh({4.0, 7.0, 2.0}, {{1, 1}, {1, 1}, {2, 1}, {2, 1}, {1, 1}, {1, 1}}));
    Entity one = entityOf(model, coldAndHot());
    Entity other = one;
    one.name = "one";
    other.name = "other";
    irsg.scene.entities = {one, other};
    look(irsg, {.range_m = 900.0,
                .azimuth_rad = 0.4,
                .elevation_rad = radians(12.0),
                .fieldOfView_rad = 0.05,
                .band = Band::topHat(8.0, 12.0)});
    irsg.scene.entities[1].pose.position_m.x += 5.0;
    irsg.scene.entities[1].pose.position_m.z += 3.0;
    const RenderReport report = bySurface(irsg);
    ASSERT_EQ(report.objects.size(), 2u);
    for (const ObjectRadiometry& object : report.objects) {
        SCOPED_TRACE(object.name);
        expectToAddUp(object);
        EXPECT_GT(surfaceOf(object, 1).intensity_W_sr, 0.0);
        EXPECT_GT(surfaceOf(object, 2).intensity_W_sr, surfaceOf(object, 1).intensity_W_sr);
    }
    // Nobody pays who has not asked.
    EXPECT_TRUE(irsg.measure().objects.front().surfaces.empty());
}
