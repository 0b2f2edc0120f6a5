// What gas sends to surfaces, and takes of what these send each other: direct integrals over solid
// angle, and rooms of one temperature.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "irsg/gas/GasSpectrum.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/SurfaceModels.h"
#include "tests/support/LightScenes.h"
#include "tests/support/RaysTest.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class GasLight : public RaysTest {};

const Band redWing = Band::topHat(4.4, 4.8);
constexpr IrCodes hot{1, 1}, warm{2, 2}, plate{3, 3}, wall{4, 4};

Material gasMaterial(double co2, double h2o) {
    Material gas;
    gas.gasPressure_atm = 1.0;
    gas.gasCO2 = co2;
    gas.gasH2O = h2o;
    return gas;
}

/// Hot and warm gas, a cold grey plate and a black wall.
SignatureDatabase gases(double hot_K = 1000.0, double warm_K = 600.0, double plate_K = 2.0,
                        double wall_K = 2.0) {
    SignatureDatabase database = greyDatabase(1.0, 2.0);
    database.temperatures[1] = fixedTemperature(hot_K);
    database.temperatures[2] = fixedTemperature(warm_K);
    database.temperatures[3] = fixedTemperature(plate_K);
    database.temperatures[4] = fixedTemperature(wall_K);
    database.materials[1] = gasMaterial(0.1, 0.1);
    database.materials[2] = gasMaterial(0.05, 0.06);
    database.materials[3] = greyMaterial(0.5);
    database.materials[4] = greyMaterial(1.0);
    return database;
}

GasLayer layerOf(const SignatureDatabase& database, int index, double length_m) {
    const Material& material = database.materials.at(index);
    GasLayer layer;
    layer.temperature_K = database.temperatures.at(index).terms.base_K;
    layer.pressure_atm = material.gasPressure_atm;
    layer.length_m = length_m;
    layer.fraction(HotGas::CO2) = material.gasCO2;
    layer.fraction(HotGas::H2O) = material.gasH2O;
    return layer;
}

/// Of layers in order, without those of no length.
double radianceOf(std::vector<GasLayer> layers, double behind_K = 0.0) {
    std::erase_if(layers, [](const GasLayer& layer) { return !(layer.length_m > 0.0); });
    if (layers.empty()) {
        return behind_K > 0.0 ? bandRadiance_W_m2_sr(redWing, behind_K) : 0.0;
    }
    GasRequest request{.layers = std::move(layers), .band = redWing.range()};
    if (behind_K > 0.0) {
        request.background_K = behind_K;
    }
    return gasSpectrum(request).bandRadiance_W_m2_sr();
}

double chord(double radius_m, double off_m) {
    return 2.0 * std::sqrt(std::max(radius_m * radius_m - off_m * off_m, 0.0));
}

Triangles raised(Triangles mesh, double up_m) {
    for (Triangle& triangle : mesh) {
        for (Vec3& corner : triangle.vertex) {
            corner.z += up_m;
        }
    }
    return mesh;
}

/// A level plate of 20 cm.
Triangles smallPlate() {
    return plateMesh({}, {0.1, 0, 0}, {0, 0.1, 0}, plate);
}

/// The mean radiance of what lies within 5 cm of the origin, seen low from the side.
double radianceOfPlate(const std::vector<Triangles>& meshes, const SignatureDatabase& database,
                       double elevation_rad = radians(10.0)) {
    std::vector<Entity> entities;
    for (const Triangles& mesh : meshes) {
        entities.push_back(entityOf(modelOf(mesh), database));
        entities.back().pose.position_m.z = standingAltitude_m;
        entities.back().referencePoint_m = Vec3{};
    }
    InteractiveRenderer irsg = rendererOf(entities, lightSettings(convergedBounces));
    look(irsg, {.range_m = 1000.0,
                .azimuth_rad = 0.3,
                .elevation_rad = elevation_rad,
                .width_px = 3,
                .height_px = 3,
                .fieldOfView_rad = 0.03 / 1000.0,
                .band = redWing});
    const RadianceImage image = irsg.image().image;
    double sum = 0.0;
    for (const float value : image.find("L")->values) {
        sum += static_cast<double>(value);
    }
    return sum / 9.0;
}

/// Integral of radiance times cosine over a cone about the normal, by the rule of midpoints in the
/// square of the sine.
template <typename Radiance>
double overCone(double halfAngle_rad, int steps, const Radiance& radiance) {
    const double square = std::pow(std::sin(halfAngle_rad), 2.0);
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        sum += radiance(std::asin(std::sqrt(square * (i + 0.5) / steps)));
    }
    return pi * square * sum / steps;
}

} // namespace

TEST_F(GasLight, OfASphereFallsOnAPlateBesideIt) {
    const SignatureDatabase database = gases();
    for (const double distance_m : {1.5, 4.0}) {
        const double falls = overCone(std::asin(1.0 / distance_m), 100, [&](double angle_rad) {
            return radianceOf({layerOf(database, 1, chord(1.0, distance_m * std::sin(angle_rad)))});
        });
        const double expected = 0.5 / pi * falls;
        const Triangles sphere = raised(sphereMesh(1.0, 48, 96, hot), distance_m);
        const double together = radianceOfPlate({joined(smallPlate(), sphere)}, database);
        const double apart = radianceOfPlate({smallPlate(), sphere}, database);
        std::printf("  at %g m: %.4f of the integral, of two entities %.4f\n", distance_m,
                    together / expected, apart / expected);
        EXPECT_NEAR(together / expected, 1.0, 0.01) << distance_m;
        EXPECT_NEAR(apart / expected, 1.0, 0.01) << distance_m;
    }
}

TEST_F(GasLight, OfANestFallsOnAPlateBesideIt) {
    const SignatureDatabase database = gases();
    const double distance_m = 2.0;
    const double falls = overCone(std::asin(1.0 / distance_m), 100, [&](double angle_rad) {
        const double off_m = distance_m * std::sin(angle_rad);
        const double inside_m = chord(0.5, off_m), before_m = 0.5 * (chord(1.0, off_m) - inside_m);
        return radianceOf({layerOf(database, 2, before_m), layerOf(database, 1, inside_m),
                           layerOf(database, 2, before_m)});
    });
    const Triangles nest =
        raised(joined(sphereMesh(1.0, 48, 96, warm), sphereMesh(0.5, 48, 96, hot)), distance_m);
    const double found = radianceOfPlate({joined(smallPlate(), nest)}, database);
    std::printf("  %.4f of the integral\n", found / (0.5 / pi * falls));
    EXPECT_NEAR(found / (0.5 / pi * falls), 1.0, 0.015);
}

TEST_F(GasLight, FallsOnAPlateInTheMiddleOfIt) {
    // Of each direction a radius of gas; the plate is seen through as much.
    const SignatureDatabase database = gases();
    GasRequest request{.layers = {layerOf(database, 1, 1.0)}, .band = redWing.range()};
    double expected = 0.0;
    for (const GasSpectrum::Cell& cell : gasSpectrum(request).cells) {
        const double width_um = wavelengthFromWavenumber_um(cell.lower_per_cm) -
                                wavelengthFromWavenumber_um(cell.upper_per_cm);
        expected += cell.radiance_W_m2_sr_um * (1.0 + 0.5 * cell.transmittance) * width_um;
    }
    const double found =
        radianceOfPlate({joined(smallPlate(), sphereMesh(1.0, 48, 96, hot))}, database);
    std::printf("  %.4f of the closed form\n", found / expected);
    EXPECT_NEAR(found / expected, 1.0, 0.005);
}

TEST_F(GasLight, DimsWhatASurfaceSendsToAnother) {
    // A hot wall above the plate, and a layer of colder gas between them.
    const SignatureDatabase database = gases(400.0, 400.0, 2.0, 900.0);
    const double half_m = 1.0, height_m = 1.0, thick_m = 0.6, middle_m = 0.6;
    double falls = 0.0, free = 0.0;
    constexpr int steps = 40;
    for (int i = 0; i < steps; ++i) {
        for (int k = 0; k <= i; ++k) { // an eighth of the wall
            const double x = half_m * (i + 0.5) / steps, y = half_m * (k + 0.5) / steps;
            const double distance_m = std::sqrt(x * x + y * y + height_m * height_m);
            const double cosine = height_m / distance_m;
            const double part = 8.0 * (k == i ? 0.5 : 1.0) * std::pow(half_m / steps, 2.0) *
                                cosine * cosine / (distance_m * distance_m);
            falls += part * radianceOf({layerOf(database, 1, thick_m / cosine)}, 900.0);
            free += part * radianceOf({}, 900.0);
        }
    }
    const Triangles hotWall = oneSidedPlate({0, 0, height_m}, {0, half_m, 0}, {half_m, 0, 0}, wall);
    const Triangles gas =
        raised(boxMesh({1.4, 1.4, 0.5 * thick_m}, std::vector<IrCodes>(6, hot)), middle_m);
    const double found = radianceOfPlate({joined(joined(smallPlate(), hotWall), gas)}, database);
    const double without = radianceOfPlate({joined(smallPlate(), hotWall)}, database);
    std::printf("  %.4f of the integral, without gas %.4f; it takes %.3f\n",
                found / (0.5 / pi * falls), without / (0.5 / pi * free), 1.0 - falls / free);
    EXPECT_NEAR(found / without, falls / free, 0.01);
    EXPECT_LT(falls / free, 0.9) << "the gas matters";
}

TEST_F(GasLight, FallsOnPaintAsOnTheWhole) {
    // Lobes reflect what gas sends as if it came from everywhere: as the reflectance at the angle
    // of view does.
    SignatureDatabase database = gases();
    const double distance_m = 1.5, elevation_rad = radians(10.0);
    const Triangles mesh = joined(smallPlate(), raised(sphereMesh(1.0, 24, 48, hot), distance_m));
    const double ofGrey = radianceOfPlate({mesh}, database, elevation_rad) / 0.5;
    Material& paint = database.materials[3];
    paint.surfaceModel = "ggx";
    paint.roughness = 0.3;
    const auto model = surfaceModelOf(paint);
    const double reflects = model->reflected(model->amountsAt(paint, 4.6), std::sin(elevation_rad));
    const double found = radianceOfPlate({mesh}, database, elevation_rad);
    std::printf("  %.4f of what is expected, at a reflectance of %.3f\n",
                found / (reflects * ofGrey), reflects);
    EXPECT_NEAR(found / (reflects * ofGrey), 1.0, 0.01);
}

TEST_F(GasLight, InARoomOfItsTemperatureIsBlack) {
    SignatureDatabase database = gases(700.0, 700.0, 700.0, 700.0);
    database.materials[4].surfaceModel = "ggx"; // a mirror in the room
    database.materials[4].emissivity = Spectrum::constant(0.2);
    database.materials[4].roughness = 0.1;
    const Triangles room =
        joined(joined(raised(sphereMesh(0.9, 12, 24, warm), 0.5), sphereMesh(0.4, 12, 24, hot)),
               joined(boxMesh({3, 2, 2}, std::vector<IrCodes>(6, plate)),
                      plateMesh({0, 1.0, 0}, {0.5, 0, 0}, {0, 0.2, 0.5}, wall)));
    const auto image = [&](const SignatureDatabase& of) {
        InteractiveRenderer irsg =
            rendererOf({entityOf(modelOf(room), of)}, lightSettings(convergedBounces));
        irsg.scene.entities[0].pose.position_m.z = standingAltitude_m;
        irsg.scene.entities[0].referencePoint_m = Vec3{};
        look(irsg, {.range_m = 1.5,
                    .azimuth_rad = 0.4,
                    .elevation_rad = 0.2,
                    .width_px = 16,
                    .height_px = 16,
                    .fieldOfView_rad = radians(80.0),
                    .band = redWing});
        return irsg.image().image;
    };
    const double black = bandRadiance_W_m2_sr(redWing, 700.0);
    double worst = 0.0;
    const RadianceImage found = image(database);
    for (const float value : found.find("L")->values) {
        worst = std::max(worst, std::abs(static_cast<double>(value) / black - 1.0));
    }
    std::printf("  black to %.2g\n", worst);
    EXPECT_LT(worst, 2e-4);
    // Hotter gas lights the walls.
    database.temperatures[1] = fixedTemperature(1200.0);
    EXPECT_GT(static_cast<double>(image(database).at(0, 0)), 1.02 * black);
}
