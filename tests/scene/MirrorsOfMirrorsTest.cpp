// What mirrors show of other mirrors and behind panes: products of reflectivities in closed form,
// and a rough mirror by an own quadrature.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "irsg/radiometry/Units.h"
#include "irsg/reference/PlanckReference.h"
#include "irsg/signature/SurfaceModels.h"
#include "tests/support/LightScenes.h"
#include "tests/support/RaysTest.h"
#include "tests/support/RevolvedMeshes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class MirrorsOfMirrors : public RaysTest {};

constexpr double smooth = 0.002, wavelength_um = 4.0;
constexpr IrCodes floorMirror{1, 1}, hotWall{2, 2}, otherMirror{1, 3}, pane{9, 9};

Material mirror(double emissivity, double roughness) {
    Material material = greyMaterial(emissivity);
    material.surfaceModel = "ggx";
    material.roughness = roughness;
    return material;
}

double black_W_m2_sr(double temperature_K) {
    return static_cast<double>(reference::bandRadiance({3.0, 5.0}, temperature_K));
}

/// Schlick's of what reflects `straight` at normal incidence.
double reflectivity(double straight, double cosine) {
    return straight + (1.0 - straight) * std::pow(1.0 - cosine, 5);
}

/// Cold mirrors of emissivities 0.1 and 0.2, and a black wall of 600 K.
SignatureDatabase mirrors(double roughness = smooth) {
    SignatureDatabase database = greyDatabase(1.0, 2.0);
    database.materials[1] = mirror(0.1, smooth);
    database.materials[2] = greyMaterial(1.0);
    database.materials[3] = mirror(0.2, roughness);
    database.temperatures[2] = fixedTemperature(600.0);
    return database;
}

/// The mean of a square of 2 cm about a place of the mesh as seen from a direction.
double radianceAt(const Triangles& mesh, const SignatureDatabase& database, const Vec3& place_m,
                  const Vec3& towardsViewer, int bounces = convergedBounces,
                  const Environment& environment = Environment::vacuum()) {
    Entity entity = entityOf(modelOf(mesh), database);
    RenderSettings settings = lightSettings(bounces);
    settings.sun = ReflectionMode::smart;
    settings.sunShadows = SunShadowMode::point;
    InteractiveRenderer irsg = rendererOf({entity}, settings, environment);
    Sensor sensor = sensorOf(5, 5, degrees(0.02 / 100.0));
    sensor.band = Band::topHat(3.0, 5.0);
    irsg.view.sensor = sensor;
    const Vec3 at_m = place_m + Vec3{0, 0, standingAltitude_m};
    irsg.scene.entities[0].pose.position_m.z = standingAltitude_m;
    irsg.view.viewpoint = Viewpoint::lookAt(at_m + towardsViewer * 100.0, at_m);
    const RadianceImage image = irsg.imageWithReport().image;
    double sum = 0.0;
    for (const float value : image.find("L")->values) {
        sum += static_cast<double>(value);
    }
    return sum / 25.0;
}

/// A level mirror of 1 m, another one that stands on its edge at x = 0.5, and a hot wall beside
/// both, at y = 0.6.
Triangles corner() {
    const Triangles two = joined(plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, floorMirror),
                                 plateMesh({0.5, 0, 0.25}, {0, 0, 0.25}, {0, 0.5, 0}, otherMirror));
    return joined(two, plateMesh({-0.5, 0.6, 0.5}, {1, 0, 0}, {0, 0, 0.5}, hotWall));
}

/// Towards a viewer who sees the wall in the second mirror of the corner in the first.
Vec3 towardsViewer() {
    const double across = std::cos(radians(30.0)) * std::sqrt(0.5);
    return {-across, -across, std::sin(radians(30.0))};
}

} // namespace

TEST_F(MirrorsOfMirrors, OfACornerMultiplyTheirReflectivities) {
    const Vec3 to = towardsViewer();
    const double found = radianceAt(corner(), mirrors(), {0.4, 0, 0}, to);
    const double both = reflectivity(0.9, to.z) * reflectivity(0.8, -to.x);
    const double expected = both * black_W_m2_sr(600.0);
    std::printf("  %.5f of the closed form\n", found / expected);
    EXPECT_NEAR(found / expected, 1.0, 0.003);
    // Light that is reflected once comes from where it was sent.
    EXPECT_LT(radianceAt(corner(), mirrors(), {0.4, 0, 0}, to, 1), 0.01 * expected);
}

TEST_F(MirrorsOfMirrors, FaceEachOtherThreeTimes) {
    // Up to a mirror above, down to the first one again, and from there to the wall.
    const double elevation_rad = radians(30.0);
    const Triangles two = joined(plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, floorMirror),
                                 plateMesh({0.1, 0, 0.2}, {0.4, 0, 0}, {0, 0.5, 0}, otherMirror));
    const Triangles all = joined(two, plateMesh({0.5, 0, 0.1}, {0, 0, 0.1}, {0, 0.5, 0}, hotWall));
    const double found = radianceAt(all, mirrors(), {-0.4, 0, 0},
                                    {-std::cos(elevation_rad), 0, std::sin(elevation_rad)});
    const double cosine = std::sin(elevation_rad);
    const double expected =
        std::pow(reflectivity(0.9, cosine), 2) * reflectivity(0.8, cosine) * black_W_m2_sr(600.0);
    std::printf("  %.5f of the closed form\n", found / expected);
    EXPECT_NEAR(found / expected, 1.0, 0.003);
}

TEST_F(MirrorsOfMirrors, ShowRoughOnes) {
    const Vec3 to = towardsViewer();
    for (const double roughness : {0.05, 0.15}) {
        const SignatureDatabase database = mirrors(roughness);
        const double found = radianceAt(corner(), database, {0.4, 0, 0}, to);
        // Where the mirror direction of the floor meets the second mirror, in axes of that one.
        const double step = 0.1 / -to.x;
        const Vec3 place_m{0.5, -step * to.y, step * to.z};
        const SurfaceDirection back{to.y, -to.z, -to.x};
        const auto model = surfaceModelOf(database.materials.at(3));
        const auto amounts = model->amountsAt(database.materials.at(3), wavelength_um);
        constexpr int slopes = 80, turns = 81;
        double sum = 0.0;
        for (int i = 0; i < slopes; ++i) {
            const double share = (i + 0.5) / slopes;
            const double tan2 = roughness * roughness * share / (1.0 - share);
            const double cosine = 1.0 / std::sqrt(1.0 + tan2);
            const double sine = std::sqrt(1.0 - cosine * cosine);
            for (int j = 0; j < turns; ++j) {
                const double around = 2.0 * pi * (j + 0.5) / turns;
                const SurfaceDirection facet{sine * std::cos(around), sine * std::sin(around),
                                             cosine};
                const SurfaceDirection from = mirrored(back, facet);
                const double distance = (0.6 - place_m.y) / from.x; // y of the scene
                const double x = place_m.x - distance * from.z, z = place_m.z + distance * from.y;
                if (!(from.z > 0.0) || !(from.x > 0.0) || x < -1.5 || std::abs(z) > 1.0) {
                    continue;
                }
                // What goes down comes to the wall by the floor, once more.
                double arrives = 1.0;
                if (z < 0.0) {
                    const double down = place_m.z / -from.y;
                    const bool isMet = std::abs(place_m.x - down * from.z) < 0.5 &&
                                       std::abs(place_m.y + down * from.x) < 0.5;
                    arrives = isMet ? reflectivity(0.9, -from.y) : 0.0;
                }
                for (std::size_t k = 0; k < model->components(); ++k) {
                    sum += model->hasLobe(k)
                               ? arrives * amounts[k] * model->facetWeight(k, back, facet)
                               : 0.0;
                }
            }
        }
        const double expected =
            reflectivity(0.9, to.z) * sum / (slopes * turns) * black_W_m2_sr(600.0);
        std::printf("  roughness %g: %.5f of the quadrature\n", roughness, found / expected);
        EXPECT_NEAR(found / expected, 1.0, 0.01) << roughness;
    }
}

TEST_F(MirrorsOfMirrors, ShowTheGlintOfTheSun) {
    const Vec3 to = towardsViewer();
    const SignatureDatabase database = mirrors(0.15);
    const SunPosition sun{radians(-40.0), radians(33.0)};
    ConstantAtmosphere air;
    air.sunValue = 100.0;
    Triangles two = corner();
    two.resize(4); // without the wall
    const double found =
        radianceAt(two, database, {0.4, 0, 0}, to, convergedBounces, environmentOf(air, sun));
    const Vec3 towards = direction(sun.azimuth_rad, sun.elevation_rad);
    const SurfaceDirection back{to.y, -to.z, -to.x}, from{towards.y, towards.z, -towards.x};
    const auto model = surfaceModelOf(database.materials.at(3));
    const auto amounts = model->amountsAt(database.materials.at(3), wavelength_um);
    double brdf_per_sr = 0.0;
    for (std::size_t k = 0; k < model->components(); ++k) {
        brdf_per_sr += amounts[k] * model->brdf_per_sr(k, back, from);
    }
    const double expected = reflectivity(0.9, to.z) * brdf_per_sr * from.z * 200.0;
    std::printf("  %.5f of the closed form, BRDF %.3f per sr\n", found / expected, brdf_per_sr);
    EXPECT_NEAR(found / expected, 1.0, 0.01);
}

TEST_F(MirrorsOfMirrors, ShowWallsThroughPanes) {
    const double elevation_rad = radians(25.0);
    for (const double pane_K : {2.0, 500.0}) {
        SignatureDatabase database = mirrors();
        database.materials[9] = greyMaterial(0.2998, 0.7);
        database.temperatures[9] = fixedTemperature(pane_K);
        const Triangles two = joined(plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, floorMirror),
                                     plateMesh({0.5, 0, 0.15}, {0, 0, 0.15}, {0, 0.5, 0}, hotWall));
        const Triangles all =
            joined(two, plateMesh({0.25, 0, 0.2}, {0, 0, 0.19}, {0, 0.5, 0}, pane));
        const double found =
            radianceAt(all, database, {}, {-std::cos(elevation_rad), 0, std::sin(elevation_rad)});
        const double sent = pane_K > 100.0 ? 0.2998 * black_W_m2_sr(pane_K) : 0.0;
        const double expected =
            reflectivity(0.9, std::sin(elevation_rad)) * (0.7 * black_W_m2_sr(600.0) + sent);
        std::printf("  pane of %g K: %.5f of the closed form\n", pane_K, found / expected);
        EXPECT_NEAR(found / expected, 1.0, 0.003) << pane_K;
    }
}
