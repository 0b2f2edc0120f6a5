// Searches of a range: spectra of an object before the atmosphere, and sums over its surfaces at
// each range.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/LightScenes.h"
#include "tests/support/RaysTest.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class AspectSpectra : public RaysTest {};

constexpr IrCodes paint{1, 1}, glass{2, 2}, flame{3, 3}, polished{4, 4};
constexpr double sampledFrom_m = 2000.0;

Triangles moved(Triangles mesh, const Vec3& by_m) {
    for (Triangle& triangle : mesh) {
        for (Vec3& corner : triangle.vertex) {
            corner = corner + by_m;
        }
    }
    return mesh;
}

Triangles box(const Vec3& size_m, const Vec3& middle_m, IrCodes codes) {
    return moved(boxMesh(size_m, std::vector<IrCodes>(6, codes)), middle_m);
}

SignatureDatabase database() {
    SignatureDatabase made = greyDatabase(0.8, 310.0);
    made.temperatures[2] = fixedTemperature(290.0);
    made.temperatures[3] = fixedTemperature(900.0);
    made.temperatures[4] = fixedTemperature(330.0);
    made.materials[2] = greyMaterial(0.3, 0.6);
    made.materials[3].gasPressure_atm = 1.0;
    made.materials[3].gasCO2 = 0.08;
    made.materials[3].gasH2O = 0.09;
    made.materials[4] = greyMaterial(0.3);
    made.materials[4].surfaceModel = "ggx";
    made.materials[4].roughness = 0.3;
    return made;
}

/// Walls that face each other, a pane, hot gas and polished metal.
Entity everything() {
    Triangles mesh =
        joined(box({4, 1, 2}, {0, 1.5, 0}, paint), box({4, 1, 2}, {0, -1.5, 0}, paint));
    mesh = joined(mesh, box({1, 1, 1}, {3.5, 0, 0}, glass));
    mesh = joined(mesh, box({2, 0.8, 0.8}, {-3.5, 0, 0}, flame));
    mesh = joined(mesh, box({1, 1, 0.5}, {0, 0, 2.5}, polished));
    Entity entity = entityOf(modelOf(mesh), database());
    entity.pose.position_m.z = 251.7;
    entity.referencePoint_m = Vec3{};
    return entity;
}

/// Computed once.
const Environment& smartAir() {
    static const Environment air = [] {
        AtmosphereSmartParameters parameters;
        parameters.resolution_per_cm = 15;
        Environment environment;
        environment.add(std::make_shared<const AtmosphereSmart>(parameters));
        environment.sun = {radians(150.0), radians(38.0)};
        return environment;
    }();
    return air;
}

/// In which the near side of an object outshines its far side.
Environment thickAir() {
    BeerLambertParameters parameters;
    parameters.extinction_per_m = Spectrum::constant(0.004);
    parameters.airTemperature_K = parameters.groundTemperature_K = 270.0;
    Environment environment;
    environment.add(std::make_shared<BeerLambert>(parameters));
    return environment;
}

InteractiveRenderer rendererOf(const std::vector<Entity>& entities, const Environment& air) {
    RenderSettings settings;
    settings.engine = EngineChoice::rays;
    settings.tileSide_samples = 32;
    settings.lightError = 0.05;
    return test::rendererOf(entities, settings, air);
}

void lookFrom(InteractiveRenderer& irsg, double range_m, double azimuth_rad = 0.7) {
    look(irsg, {.range_m = range_m,
                .azimuth_rad = azimuth_rad,
                .elevation_rad = radians(4.0),
                .width_px = 60,
                .height_px = 60,
                .fieldOfView_rad = 30.0 / range_m,
                .band = Band::topHat(3.7, 4.8)});
}

Outputs::Reports search() {
    return Outputs::reports().alongRangeFrom(sampledFrom_m).withErrors(false);
}

RenderReport reportOf(InteractiveRenderer& irsg, const Outputs::Reports& outputs) {
    return irsg.render(outputs).reports.front();
}

/// Sums of single surfaces are made of surfaces, from the same drawing.
void expectAsSurfaces(InteractiveRenderer& irsg, const std::string& name) {
    const RenderReport found = reportOf(irsg, search()),
                       sums = reportOf(irsg, search().bySurface());
    ASSERT_GT(sums.all.intensity_W_sr, 0.0) << name;
    // Weights of slices are floats, and what contrast leaves of intensity is small in thick air.
    const double square_m2 = sums.all.range_m * sums.all.range_m, floats = 1e-7;
    const auto expectNear = [&](double ObjectRadiometry::*member, double largest) {
        const double most = 1e-6 * std::abs(sums.all.*member) + floats * largest;
        EXPECT_NEAR(found.all.*member, sums.all.*member, most) << name;
        EXPECT_NEAR(found.objects.at(0).*member, sums.objects.at(0).*member, most) << name;
    };
    const double intensity_W_sr = sums.all.intensity_W_sr;
    expectNear(&ObjectRadiometry::intensity_W_sr, intensity_W_sr);
    expectNear(&ObjectRadiometry::contrastIntensity_W_sr, intensity_W_sr);
    expectNear(&ObjectRadiometry::irradiance_W_m2, intensity_W_sr / square_m2);
    expectNear(&ObjectRadiometry::coveredPixels, 0.0);
    expectNear(&ObjectRadiometry::solidAngle_sr, 0.0);
    EXPECT_NEAR(found.totalIrradiance_W_m2 / sums.totalIrradiance_W_m2, 1.0, 1e-6) << name;
    EXPECT_EQ(found.background_W_m2_sr, sums.background_W_m2_sr) << name;
    EXPECT_EQ(found.warnings, sums.warnings) << name;
    EXPECT_EQ(found.providedBy, sums.providedBy) << name;
    EXPECT_EQ(found.alongRangeReach_m, sums.alongRangeReach_m) << name;
    EXPECT_EQ(found.all.range_m, sums.all.range_m) << name;
    EXPECT_EQ(found.all.atmosphereError, sums.all.atmosphereError) << name;
    EXPECT_EQ(found.layersLeftOver, sums.layersLeftOver) << name;
}

long calls(const InteractiveRenderer& irsg, const std::string& name) {
    for (const StageTimes::Stage& stage : irsg.stageTimes().stages) {
        if (stage.name == name) {
            return stage.calls;
        }
    }
    return 0;
}

} // namespace

TEST_F(AspectSpectra, SumUpToTheirSurfacesAtEveryRange) {
    const struct {
        std::string name;
        Environment air;
        std::vector<double> ranges_m;
    } rows[] = {
        {"vacuum", Environment::vacuum(), {2000.0, 300.0, 50000.0}},
        {"lines of the air, which those of the gas meet", smartAir(), {3000.0, 200.0, 20000.0}},
        {"slices", thickAir(), {1000.0, 150.0, 2000.0}}};
    for (const auto& row : rows) {
        InteractiveRenderer irsg = rendererOf({everything()}, row.air);
        for (const double range_m : row.ranges_m) {
            lookFrom(irsg, range_m);
            expectAsSurfaces(irsg, row.name + " at " + std::to_string(range_m));
        }
    }
}

TEST_F(AspectSpectra, ServeOtherRangesWithoutSurfaces) {
    InteractiveRenderer irsg = rendererOf({everything()}, smartAir());
    lookFrom(irsg, 3000.0);
    (void)reportOf(irsg, search());
    const long before = calls(irsg, "inter-reflection"), sorted = calls(irsg, "layer sorting");
    for (const double range_m : {250.0, 700.0, 5000.0, 40000.0}) {
        lookFrom(irsg, range_m);
        (void)reportOf(irsg, search());
    }
    EXPECT_GT(before, 0);
    EXPECT_EQ(calls(irsg, "inter-reflection"), before);
    EXPECT_EQ(calls(irsg, "layer sorting"), sorted);
}

TEST_F(AspectSpectra, FollowWhatTheyDependOn) {
    const auto changes = std::vector<std::pair<std::string, void (*)(InteractiveRenderer&)>>{
        {"another aspect", [](InteractiveRenderer& irsg) { lookFrom(irsg, 3000.0, 2.0); }},
        {"a scale of temperatures",
         [](InteractiveRenderer& irsg) { irsg.scene.entities[0].temperatureScale[1] = 1.05; }},
        {"another attitude",
         [](InteractiveRenderer& irsg) { irsg.scene.entities[0].pose.attitude.roll_rad = 0.5; }},
        {"another sun",
         [](InteractiveRenderer& irsg) { irsg.scene.environment.sun.elevation_rad = 0.2; }},
        {"other settings", [](InteractiveRenderer& irsg) { irsg.scene.settings.bounces = 0; }},
        {"another band",
         [](InteractiveRenderer& irsg) { irsg.view.sensor.band = Band::topHat(3.4, 4.1); }},
        {"other air", [](InteractiveRenderer& irsg) { irsg.scene.environment = thickAir(); }},
        {"another altitude", [](InteractiveRenderer& irsg) {
             irsg.scene.entities[0].pose.position_m.z += 500.0;
             lookFrom(irsg, 3000.0);
         }}};
    for (const auto& [name, change] : changes) {
        InteractiveRenderer irsg = rendererOf({everything()}, smartAir());
        lookFrom(irsg, 3000.0);
        const double before = reportOf(irsg, search()).all.intensity_W_sr;
        change(irsg);
        expectAsSurfaces(irsg, name);
        EXPECT_GT(std::abs(reportOf(irsg, search()).all.intensity_W_sr / before - 1.0), 1e-5)
            << name;
    }
}

TEST_F(AspectSpectra, LeaveFramesAloneThatAreNotOfOneObject) {
    Entity other = everything();
    other.pose.position_m.x += 9.0;
    InteractiveRenderer irsg = rendererOf({everything(), other}, thickAir());
    for (const double range_m : {2000.0, 600.0}) {
        lookFrom(irsg, range_m);
        expectAsSurfaces(irsg, "two objects");
    }
}
