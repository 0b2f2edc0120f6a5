// What a pixel is made of, beside closed forms and beside what was drawn of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/reference/PlanckReference.h"
#include "irsg/render/rays/RaysBuilt.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class PixelExplanationTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!areRaysBuilt()) {
            GTEST_SKIP() << whyNoRays();
        }
    }
};

constexpr double width_um = 2.0; // of the band 3 to 5 um

double black_W_m2_sr(double temperature_K) {
    return static_cast<double>(reference::bandRadiance({3.0, 5.0}, temperature_K));
}

Triangles plate(double y_m, IrCodes codes, double half_m = 1.0) {
    return plateMesh({0, y_m, 0}, {-half_m, 0, 0}, {0, 0, half_m}, codes);
}

/// A scene with one object, 100 m before a sensor that looks at its middle.
InteractiveRenderer sceneOf(const Triangles& mesh, const SignatureDatabase& database,
                            const Environment& environment,
                            RenderSettings settings = RenderSettings::direct()) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.settings = settings;
    irsg.scene.environment = environment;
    irsg.scene.entities = {entityOf(modelOf(mesh), database)};
    look(irsg, {.width_px = 16, .height_px = 16, .fieldOfView_rad = 0.04});
    return irsg;
}

struct Compared {
    PixelExplanation computed;
    double drawn = 0.0;
};
Compared explained(InteractiveRenderer& irsg, int x, int y) {
    const double drawn = static_cast<double>(irsg.picture().at(x, y));
    return {irsg.explainer()(x, y), drawn};
}

const ExplainedTerm& term(const ExplainedSurface& surface, const std::string& name) {
    const auto found = std::ranges::find(surface.terms, name, &ExplainedTerm::name);
    if (found == surface.terms.end()) {
        throw LogicError("no term " + name);
    }
    return *found;
}

#define EXPECT_CLOSE(value, expected, relative)                                                    \
    EXPECT_NEAR(value, expected, (relative)*std::abs(expected))

ConstantAtmosphere clearAtmosphere() {
    ConstantAtmosphere air;
    air.transmittanceValue = 0.6;
    air.pathRadianceValue = 0.25;
    air.backgroundValue = 0.4;
    air.sunValue = 30.0;
    air.upValue = 4.0;
    air.downValue = 2.0;
    return air;
}

TEST_F(PixelExplanationTest, OfAPlateIsItsClosedForm) {
    InteractiveRenderer irsg = sceneOf(plate(0.0, {1, 1}, 2.0), greyDatabase(0.8, 320.0),
                                       environmentOf(clearAtmosphere(), {0.0, radians(30.0)}));
    const auto [pixel, drawn] = explained(irsg, 12, 8);
    ASSERT_EQ(pixel.surfaces.size(), 1u);
    const ExplainedSurface& surface = pixel.surfaces.front();
    EXPECT_TRUE(pixel.isInterior);
    EXPECT_EQ(surface.layer, 1);
    EXPECT_EQ(surface.temperatureIndex, 1);
    EXPECT_EQ(surface.materialIndex, 1);
    EXPECT_DOUBLE_EQ(surface.temperature_K, 320.0);
    EXPECT_CLOSE(surface.emissivity, 0.8, 1e-12);
    EXPECT_CLOSE(surface.reflectivity, 0.2, 1e-12);
    EXPECT_CLOSE(surface.atmosphereTransmittance, 0.6, 1e-12);
    EXPECT_CLOSE(surface.share, 1.0, 1e-12);
    EXPECT_CLOSE(surface.range_m, 100.0, 1e-3);

    // An upright plate, whose normal is 30 degrees off the sun and sees half a sky.
    const double reflected = 0.6 * 0.2 / pi * width_um;
    EXPECT_CLOSE(term(surface, "thermal").radiance_W_m2_sr, 0.6 * 0.8 * black_W_m2_sr(320.0), 1e-6);
    EXPECT_CLOSE(term(surface, "sun").factor, std::cos(radians(30.0)), 1e-6);
    EXPECT_CLOSE(term(surface, "sun").radiance_W_m2_sr, reflected * 30.0 * std::cos(radians(30.0)),
                 1e-6);
    EXPECT_CLOSE(term(surface, "sun").light.value(), 30.0 * width_um, 1e-9);
    EXPECT_CLOSE(term(surface, "up").radiance_W_m2_sr, reflected * 4.0 * 0.5, 1e-6);
    EXPECT_CLOSE(term(surface, "down").radiance_W_m2_sr, reflected * 2.0 * 0.5, 1e-6);
    EXPECT_CLOSE(term(surface, "path").radiance_W_m2_sr, 0.25 * width_um, 1e-9);
    EXPECT_CLOSE(pixel.background_W_m2_sr, 0.4 * width_um, 1e-9);
    EXPECT_NEAR(pixel.backgroundLeft_W_m2_sr, 0.0, 1e-12);
    EXPECT_CLOSE(pixel.radiance_W_m2_sr, drawn, 1e-6);
}

TEST_F(PixelExplanationTest, TellsAPlumeFromWhatIsBehindIt) {
    SignatureDatabase database = greyDatabase(0.8, 320.0);
    database.temperatures[2] = fixedTemperature(700.0);
    database.materials[2] = greyMaterial(0.3, 0.7);
    database.materials[2].name = "gas";
    // The sensor stands where the nose points to, at +y.
    InteractiveRenderer irsg = sceneOf(joined(plate(-0.5, {1, 1}), plate(0.5, {2, 2})), database,
                                       environmentOf(clearAtmosphere()));
    const auto [pixel, drawn] = explained(irsg, 8, 8);
    ASSERT_EQ(pixel.surfaces.size(), 2u);
    const ExplainedSurface &gas = pixel.surfaces[0], &body = pixel.surfaces[1];
    EXPECT_EQ(gas.layer, 1);
    EXPECT_EQ(gas.materialName, "gas");
    EXPECT_CLOSE(gas.transmissivity, 0.7, 1e-12);
    EXPECT_CLOSE(term(gas, "thermal").radiance_W_m2_sr, 0.6 * 0.3 * black_W_m2_sr(700.0), 1e-6);
    EXPECT_EQ(body.layer, 2);
    EXPECT_CLOSE(body.throughTransmittance, 0.7, 1e-12);
    ASSERT_EQ(body.throughMaterials.size(), 1u);
    EXPECT_NE(body.throughMaterials.front().find("2 gas"), std::string::npos);
    EXPECT_CLOSE(term(body, "thermal").radiance_W_m2_sr, 0.7 * 0.6 * 0.8 * black_W_m2_sr(320.0),
                 1e-6);
    EXPECT_CLOSE(gas.hidden_W_m2_sr, 0.3 * 0.8, 1e-6);
    EXPECT_CLOSE(pixel.radiance_W_m2_sr, drawn, 1e-6);
}

TEST_F(PixelExplanationTest, OfBackgroundAloneIsTheBackground) {
    InteractiveRenderer irsg = sceneOf(plate(0.0, {1, 1}, 0.3), greyDatabase(0.8, 320.0),
                                       environmentOf(clearAtmosphere()));
    const auto [pixel, drawn] = explained(irsg, 0, 0);
    EXPECT_TRUE(pixel.surfaces.empty());
    EXPECT_TRUE(pixel.isInterior);
    EXPECT_CLOSE(pixel.radiance_W_m2_sr, 0.4 * width_um, 1e-9);
    EXPECT_CLOSE(pixel.backgroundLeft_W_m2_sr, drawn, 1e-6);
}

TEST_F(PixelExplanationTest, SharesAPixelThatAnEdgeCrosses) {
    RenderSettings settings = RenderSettings::direct();
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = 4;
    // The pixels are 0.25 m wide: the edge halves those of column 8 + 2.
    InteractiveRenderer irsg = sceneOf(plate(0.0, {1, 1}, 0.625), greyDatabase(1.0, 320.0),
                                       environmentOf(clearAtmosphere()), settings);
    const auto [pixel, drawn] = explained(irsg, 10, 8);
    ASSERT_EQ(pixel.surfaces.size(), 1u);
    EXPECT_EQ(pixel.samples, 16);
    EXPECT_FALSE(pixel.isInterior);
    // Of its area; the half nearer to the axis has more of the solid angle.
    const double pitch = irsg.view.sensor.pixelPitch(), u = 2.5 * pitch, v = 0.5 * pitch;
    const double share = 0.5 * (1.0 + 3.0 * 0.25 * pitch * u / (1.0 + u * u + v * v));
    EXPECT_CLOSE(pixel.surfaces.front().share, share, 1e-12);
    EXPECT_CLOSE(pixel.backgroundLeft_W_m2_sr, (1.0 - share) * 0.4 * width_um, 1e-9);
    EXPECT_CLOSE(pixel.radiance_W_m2_sr, drawn, 1e-6);
}

TEST_F(PixelExplanationTest, KnowsAnObjectThatIsAPoint) {
    InteractiveRenderer irsg =
        sceneOf(plate(0.0, {1, 1}), greyDatabase(0.8, 320.0), environmentOf(clearAtmosphere()));
    look(irsg, {.range_m = 1e6, .width_px = 15, .height_px = 15, .fieldOfView_rad = 0.04});
    const auto [pixel, drawn] = explained(irsg, 7, 7);
    ASSERT_EQ(pixel.surfaces.size(), 1u);
    EXPECT_EQ(pixel.remarks.size(), 1u);
    EXPECT_LT(pixel.surfaces.front().share, 1e-5);
    EXPECT_GT(pixel.surfaces.front().share, 0.0);
    EXPECT_CLOSE(pixel.radiance_W_m2_sr, drawn, 1e-6);
}

TEST_F(PixelExplanationTest, AddsUpToWhatIsDrawnOfABodyInAllItsLight) {
    RenderSettings settings = RenderSettings::direct();
    settings.sunShadows = SunShadowMode::point;
    settings.bounces = 1;
    SignatureDatabase database;
    for (int i = 1; i <= 3; ++i) {
        database.temperatures[i] = fixedTemperature(290.0 + 20.0 * i);
        database.materials[i] = greyMaterial(0.5, i == 3 ? 0.4 : 0.0, i == 2 ? 1.0 : 0.0);
    }
    InteractiveRenderer irsg = sceneOf(
        glazedMesh(), database, environmentOf(clearAtmosphere(), {0.5, radians(40.0)}), settings);
    const RadianceImage image = irsg.picture();
    const auto ready = irsg.explainer();
    int interior = 0;
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            const PixelExplanation pixel = ready(x, y);
            double sum = pixel.backgroundLeft_W_m2_sr;
            for (const ExplainedSurface& surface : pixel.surfaces) {
                sum += surface.betweenSurfaces_W_m2_sr;
                for (const ExplainedTerm& one : surface.terms) {
                    sum += one.radiance_W_m2_sr;
                }
            }
            EXPECT_CLOSE(sum, pixel.radiance_W_m2_sr, 1e-12);
            const auto drawn = static_cast<double>(image.at(x, y));
            EXPECT_CLOSE(pixel.radiance_W_m2_sr, drawn, pixel.isInterior ? 1e-5 : 0.02)
                << x << ", " << y;
            interior += pixel.isInterior && !pixel.surfaces.empty() ? 1 : 0;
        }
    }
    EXPECT_GT(interior, 10);
}

TEST_F(PixelExplanationTest, RefusesAPixelOutsideTheFrame) {
    InteractiveRenderer irsg =
        sceneOf(plate(0.0, {1, 1}), greyDatabase(0.8, 320.0), environmentOf(clearAtmosphere()));
    const auto ready = irsg.explainer();
    EXPECT_THROW(ready(16, 0), LogicError);
    EXPECT_THROW(ready(0, -1), LogicError);
}

} // namespace
