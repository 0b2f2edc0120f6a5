// Transparent surfaces in inter-reflection: what they hide, send and transmit between surfaces, in
// closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "irsg/radiometry/Units.h"
#include "irsg/reference/PlanckReference.h"
#include "tests/support/LightScenes.h"
#include "tests/support/RaysTest.h"
#include "tests/support/RevolvedMeshes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class PanesTest : public RaysTest {};

/// Squares of side 1 that share an edge at a right angle (Howell C-14).
constexpr double cornerFactor = 0.20004;
/// The least that a pane reflects here: twice what tells it from gas.
constexpr double leastReflectivity = 2e-4;

/// Parallel squares of side 1 (Howell C-11).
double parallelFactor(double distance_m) {
    const double x = 1.0 / distance_m, square = x * x, root = std::sqrt(1.0 + square);
    return 2.0 / (pi * square) *
           (std::log((1.0 + square) / std::sqrt(1.0 + 2.0 * square)) +
            2.0 * x * root * std::atan(x / root) - 2.0 * x * std::atan(x));
}

double black_W_m2_sr(double temperature_K) {
    return static_cast<double>(reference::bandRadiance({3.0, 5.0}, temperature_K));
}

/// A pane of material 9, which reflects at least a little, else it would be gas, at a temperature
/// of its own, in a database of black and cold surfaces.
SignatureDatabase databaseOf(double emissivity, double transmissivity, double pane_K) {
    SignatureDatabase database = greyDatabase(1.0, 2.0);
    database.materials[9] = greyMaterial(emissivity, transmissivity);
    database.temperatures[9] = fixedTemperature(pane_K);
    return database;
}

/// 0.9 up to 4 um and 0.1 from there on: a mean of one half over the band.
Spectrum inHalves(double below, double above) {
    return Spectrum({2.0, 3.999999, 4.000001, 6.0}, {below, below, above, above});
}

Entity placed(const Triangles& mesh, const SignatureDatabase& database) {
    Entity entity = entityOf(modelOf(mesh), database);
    entity.pose.position_m.z = standingAltitude_m;
    entity.referencePoint_m = Vec3{};
    return entity;
}

double intensity_W_sr(InteractiveRenderer& irsg, double azimuth_rad, double elevation_rad) {
    look(irsg, {.range_m = 30'000.0,
                .azimuth_rad = azimuth_rad,
                .elevation_rad = elevation_rad,
                .width_px = 16,
                .height_px = 16,
                .fieldOfView_rad = 0.0001});
    return irsg.measure().all.intensity_W_sr;
}

constexpr double plate_K = 450.0;

/// A grey plate of side 1 that faces up to a black hot one at height 1, which is seen from below
/// alone, with panes between them.
Triangles plateBelowHotOne(const std::vector<double>& heights_m) {
    Triangles mesh = joined(plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, {1, 1}),
                            oneSidedPlate({0, 0, 1}, {0, 0.5, 0}, {0.5, 0, 0}, {2, 2}));
    for (const double height_m : heights_m) {
        mesh = joined(mesh, plateMesh({0, 0, height_m}, {0.5, 0, 0}, {0, 0.5, 0}, {9, 9}));
    }
    return mesh;
}

} // namespace

TEST_F(PanesTest, LetThroughHideAndSendBetweenSurfaces) {
    const double elevation_rad = radians(20.0), sine = std::sin(elevation_rad);
    struct Row {
        const char* name;
        std::vector<double> heights_m;
        double pane_K, emissivity, transmissivity;
    };
    for (const Row& row :
         {Row{"no pane", {}, 2.0, 0.2998, 0.7}, Row{"cold", {0.5}, 2.0, 0.2998, 0.7},
          Row{"opaque and cold", {0.5}, 2.0, 1.0, 0.0},
          Row{"two, cold", {0.4, 0.6}, 2.0, 0.2998, 0.7}, Row{"warm", {0.5}, 500.0, 0.3998, 0.6}}) {
        SignatureDatabase database = databaseOf(row.emissivity, row.transmissivity, row.pane_K);
        database.materials[1] = greyMaterial(0.4);
        database.temperatures[1] = fixedTemperature(plate_K);
        database.materials[2] = greyMaterial(1.0);
        database.temperatures[2] = fixedTemperature(600.0);
        InteractiveRenderer irsg = rendererOf({placed(plateBelowHotOne(row.heights_m), database)},
                                              lightSettings(convergedBounces));
        const double found = intensity_W_sr(irsg, 0.5 * pi, elevation_rad);
        double passed = 1.0, mirrored = 0.0; // by the panes, to the viewer
        for (std::size_t i = row.heights_m.size(); i-- > 0; passed *= row.transmissivity) {
            mirrored += leastReflectivity * passed * parallelFactor(1.0 - row.heights_m[i]);
        }
        const double sent = row.pane_K > 100.0 ? row.emissivity * black_W_m2_sr(row.pane_K) : 0.0;
        const double expected = sine * (0.4 * black_W_m2_sr(plate_K) +
                                        0.6 * (parallelFactor(1.0) * passed * black_W_m2_sr(600.0) +
                                               parallelFactor(0.5) * sent) +
                                        mirrored * black_W_m2_sr(600.0) + sent);
        std::printf("  %s: %.5f of the closed form\n", row.name, found / expected);
        if (row.transmissivity > 0.0) {
            EXPECT_NEAR(found / expected, 1.0, 0.003) << row.name;
        } else {
            EXPECT_NEAR(found / (sine * 0.4 * black_W_m2_sr(plate_K)), 1.0, 1e-3);
        }
    }
}

TEST_F(PanesTest, TransmitWavelengthByWavelength) {
    // What the upper half of the band transmits is not what the mean would.
    const double elevation_rad = radians(20.0);
    SignatureDatabase database = databaseOf(0.0998, 0.9, 2.0);
    database.materials[1].emissivity = inHalves(0.2, 0.8);
    database.temperatures[1] = fixedTemperature(plate_K);
    database.materials[2] = greyMaterial(1.0);
    database.temperatures[2] = fixedTemperature(600.0);
    database.materials[9].emissivity = inHalves(0.0998, 0.8998);
    database.materials[9].transmissivity = inHalves(0.9, 0.1);
    const auto half = [](double from_um, double to_um, double temperature_K = 600.0) {
        return static_cast<double>(reference::bandRadiance({from_um, to_um}, temperature_K));
    };
    for (const int panes : {1, 2}) {
        std::vector<double> heights_m{0.5};
        if (panes == 2) {
            heights_m.push_back(0.7);
        }
        InteractiveRenderer irsg = rendererOf({placed(plateBelowHotOne(heights_m), database)},
                                              lightSettings(convergedBounces));
        double expected = std::sin(elevation_rad) *
                          (0.2 * half(3.0, 4.0, plate_K) + 0.8 * half(4.0, 5.0, plate_K) +
                           parallelFactor(1.0) * (0.8 * std::pow(0.9, panes) * half(3.0, 4.0) +
                                                  0.2 * std::pow(0.1, panes) * half(4.0, 5.0)));
        for (int i = 0; i < panes; ++i) { // what the panes reflect to the viewer
            expected += std::sin(elevation_rad) * leastReflectivity *
                        parallelFactor(i == panes - 1 ? 1.0 - heights_m.back() : 0.5) *
                        (std::pow(0.9, panes - 1 - i) * half(3.0, 4.0) +
                         std::pow(0.1, panes - 1 - i) * half(4.0, 5.0));
        }
        const double found = intensity_W_sr(irsg, 0.5 * pi, elevation_rad);
        std::printf("  %d panes: %.5f\n", panes, found / expected);
        EXPECT_NEAR(found / expected, 1.0, 0.003) << panes;
    }
}

TEST_F(PanesTest, OfAHotPlateSendItsLightBackToIt) {
    // Two large parallel planes: radiosities in closed form, seen from outside.
    constexpr double plate_K = 600.0, pane_K = 450.0, gap_m = 0.001;
    for (const auto& [emissivity, transmissivity] :
         {std::pair{0.2, 0.5}, std::pair{0.05, 0.8}, std::pair{0.5, 0.1}}) {
        const double reflectivity = 1.0 - emissivity - transmissivity, plate = 0.7;
        SignatureDatabase database = databaseOf(emissivity, transmissivity, pane_K);
        database.materials[1] = greyMaterial(plate);
        database.temperatures[1] = fixedTemperature(plate_K);
        const Triangles mesh = joined(plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, {1, 1}),
                                      plateMesh({0, 0, gap_m}, {0.5, 0, 0}, {0, 0.5, 0}, {9, 9}));
        InteractiveRenderer irsg =
            rendererOf({placed(mesh, database)}, lightSettings(convergedBounces));
        const double hot = black_W_m2_sr(plate_K), warm = black_W_m2_sr(pane_K);
        const double up = (plate * hot + (1.0 - plate) * emissivity * warm) /
                          (1.0 - (1.0 - plate) * reflectivity);
        const double expected = emissivity * warm + transmissivity * up;
        const double direct = emissivity * warm + transmissivity * plate * hot;
        const double found = intensity_W_sr(irsg, 0.3, 0.5 * pi);
        std::printf("  e %g, t %g: %.5f of the closed form, without inter-reflection %.4f\n",
                    emissivity, transmissivity, found / expected, direct / expected);
        EXPECT_NEAR(found / expected, 1.0, 0.003);
    }
}

TEST_F(PanesTest, OfOneTemperatureWithARoomAreBlack) {
    // A room that a pane divides, and a ball of glass in it.
    const auto room = [](bool isBlack) {
        Triangles mesh =
            reversed(boxMesh({2, 1.5, 1}, {{1, 1}, {1, 2}, {1, 3}, {1, 4}, {1, 5}, {1, 6}}));
        mesh = joined(mesh, plateMesh({-0.6, 0, 0}, {0, 1.5, 0}, {0, 0, 1}, {1, 9}));
        mesh = joined(mesh, sphereMesh(0.4, 6, 10, {1, 8}));
        SignatureDatabase database = greyDatabase(0.9, 400.0);
        for (const auto& [material, emissivity] :
             {std::pair{2, 0.5}, std::pair{3, 0.2}, std::pair{4, 0.7}, std::pair{5, 0.35},
              std::pair{6, 0.6}}) {
            database.materials[material] = greyMaterial(isBlack ? 1.0 : emissivity);
        }
        database.materials[1] = greyMaterial(isBlack ? 1.0 : 0.9);
        database.materials[8] = isBlack ? greyMaterial(1.0) : greyMaterial(0.3, 0.4);
        database.materials[9] = isBlack ? greyMaterial(1.0) : greyMaterial(0.1, 0.7);
        return placed(mesh, database);
    };
    const std::vector<double> black = pixelsInRoom(room(true), 0, 0.005);
    const auto [least, greatest] =
        ratiosOf(pixelsInRoom(room(false), convergedBounces, 0.005), black);
    std::printf("  pixels %.2e to %.2e off\n", least - 1.0, greatest - 1.0);
    EXPECT_GE(least, 1.0 - 1e-3);
    EXPECT_LE(greatest, 1.0 + 1e-3);
}

namespace {

/// What falls on a surface from a sky and a ground of 400 K at 4 um, W m-2 um-1.
ConstantAtmosphere isothermalAir() {
    ConstantAtmosphere air;
    air.upValue = air.downValue = pi * static_cast<double>(reference::planck(4.0, 400.0));
    return air;
}

RenderSettings narrowSettings() {
    RenderSettings settings = lightSettings(convergedBounces);
    settings.ambientReflection = ReflectionMode::smart;
    return settings;
}

} // namespace

TEST_F(PanesTest, OfABoxInSurroundingsOfItsTemperatureAreBlack) {
    for (const double tilt_rad : {0.0, 0.7}) {
        Triangles mesh = reversed(boxMesh({1, 1, 1}, std::vector<IrCodes>(6, {1, 1})));
        for (Triangle& triangle : mesh) {
            const bool isWindow = std::abs(triangle.vertex[0].z + triangle.vertex[1].z +
                                           triangle.vertex[2].z - 3.0) < 1e-9;
            triangle.codes = isWindow ? IrCodes{1, 9} : triangle.codes;
        }
        mesh = joined(mesh, sphereMesh(0.3, 8, 12, {1, 2}));
        SignatureDatabase database = databaseOf(0.2, 0.6, 400.0);
        database.temperatures[1] = fixedTemperature(400.0);
        database.materials[1] = greyMaterial(0.4);
        database.materials[2] = greyMaterial(0.2);
        Entity entity = placed(mesh, database);
        entity.pose.attitude.pitch_rad = tilt_rad;
        InteractiveRenderer irsg =
            rendererOf({entity}, narrowSettings(), environmentOf(isothermalAir()));
        look(irsg, {.range_m = 60.0,
                    .azimuth_rad = 0.0,
                    .elevation_rad = 0.5 * pi - 0.2,
                    .width_px = 48,
                    .height_px = 48,
                    .fieldOfView_rad = 0.025,
                    .band = Band::topHat(3.999, 4.001)});
        const RadianceImage image = irsg.imageWithReport().image;
        const double black = 0.002 * static_cast<double>(reference::planck(4.0, 400.0));
        const float middle = image.find("L")->values[image.offset(24, 24)];
        std::printf("  tilt %g: %.6f\n", tilt_rad, static_cast<double>(middle) / black);
        for (const float value : image.find("L")->values) {
            EXPECT_NEAR(static_cast<double>(value) / black, 1.0, 1e-3);
        }
    }
}

TEST_F(PanesTest, LetTheSunAndTheSkyThrough) {
    // A floor below panes: a wall beside it gets the sun that they let through.
    ConstantAtmosphere air;
    air.sunValue = 100.0;
    const Environment environment = environmentOf(air, {0.5 * pi, 0.5 * pi});
    Triangles mesh = joined(plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, {1, 1}),
                            plateMesh({0.5, 0, 0.5}, {0, 0, 0.5}, {0, 0.5, 0}, {2, 2}));
    for (const int panes : {0, 1, 2}) {
        Triangles all = mesh;
        for (int i = 0; i < panes; ++i) {
            all = joined(all, plateMesh({0, 0, 1.5 + i}, {3, 0, 0}, {0, 3, 0}, {9, 9}));
        }
        SignatureDatabase database = databaseOf(0.2998, 0.7, 2.0);
        database.materials[1] = greyMaterial(0.2);
        database.materials[2] = greyMaterial(0.4);
        database.temperatures[2] = fixedTemperature(340.0);
        RenderSettings settings = lightSettings(1);
        settings.sun = ReflectionMode::smart;
        settings.sunShadows = SunShadowMode::point;
        InteractiveRenderer irsg = rendererOf({placed(all, database)}, settings, environment);
        const double found = intensity_W_sr(irsg, -0.5 * pi, 0.0);
        const double expected = 0.4 * black_W_m2_sr(340.0) +
                                0.6 / pi * cornerFactor * 0.8 * 200.0 * std::pow(0.7, panes);
        std::printf("  sun, %d panes: %.5f\n", panes, found / expected);
        EXPECT_NEAR(found / expected, 1.0, 0.003) << panes;
    }
    // A plate inside of boxes of glass sees the sky through them, and is seen so.
    ConstantAtmosphere bright;
    bright.upValue = bright.downValue = 50.0;
    for (const int panes : {0, 1, 2}) {
        Triangles all = plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, {1, 1});
        for (int i = 0; i < panes; ++i) {
            all =
                joined(all, boxMesh({1.0 + i, 1.0 + i, 1.0 + i}, std::vector<IrCodes>(6, {9, 9})));
        }
        SignatureDatabase database = databaseOf(0.2998, 0.7, 2.0);
        database.materials[1] = greyMaterial(0.4);
        InteractiveRenderer irsg =
            rendererOf({placed(all, database)}, narrowSettings(), environmentOf(bright));
        look(irsg, {.range_m = 60.0,
                    .azimuth_rad = 0.0,
                    .elevation_rad = 0.5 * pi,
                    .width_px = 8,
                    .height_px = 8,
                    .fieldOfView_rad = 0.012});
        double expected = 0.6 / pi * 100.0 * std::pow(0.7, 2 * panes);
        for (int i = 0; i < panes; ++i) { // what their fronts reflect
            expected += leastReflectivity / pi * 100.0 * std::pow(0.7, 2 * i);
        }
        const RadianceImage image = irsg.imageWithReport().image;
        for (const float found : image.find("L")->values) {
            EXPECT_NEAR(static_cast<double>(found) / expected, 1.0, 1e-3) << panes;
        }
    }
}

TEST_F(PanesTest, OfAnotherEntityAreThoseOfTheSame) {
    SignatureDatabase database = databaseOf(0.2, 0.5, 450.0);
    database.materials[1] = greyMaterial(0.4);
    database.temperatures[2] = fixedTemperature(600.0);
    database.materials[2] = greyMaterial(0.9);
    ConstantAtmosphere air;
    air.sunValue = 30.0;
    air.upValue = 8.0;
    air.downValue = 5.0;
    const Environment environment = environmentOf(air, {0.4, 0.6});
    RenderSettings settings = narrowSettings();
    settings.sun = ReflectionMode::smart;
    settings.sunShadows = SunShadowMode::point;
    Triangles plates = plateBelowHotOne({}),
              pane = plateMesh({0.1, 0, 0.5}, {0.6, 0, 0}, {0, 0.6, 0}, {9, 9});
    const auto intensity = [&](const std::vector<Entity>& entities) {
        InteractiveRenderer irsg = rendererOf(entities, settings, environment);
        look(irsg, {.range_m = 30'000.0,
                    .azimuth_rad = 1.1,
                    .elevation_rad = 0.5,
                    .width_px = 16,
                    .height_px = 16,
                    .fieldOfView_rad = 0.001});
        return irsg.measure().all.intensity_W_sr;
    };
    const double one = intensity({placed(joined(plates, pane), database)});
    const double two = intensity({placed(plates, database), placed(pane, database)});
    std::printf("  two entities: %.5f of one\n", two / one);
    EXPECT_NEAR(two / one, 1.0, 0.002);
}

TEST_F(PanesTest, GiveTheSameByEveryWay) {
    Triangles mesh = joined(plateBelowHotOne({0.3}),
                            plateMesh({-0.5, 0, 0.5}, {0, 0.5, 0}, {0, 0, 0.5}, {3, 3}));
    mesh = joined(mesh, sphereMesh(0.12, 8, 12, {8, 8}));
    SignatureDatabase database = databaseOf(0.2, 0.5, 450.0);
    database.materials[1] = greyMaterial(0.4);
    database.materials[2] = greyMaterial(0.9);
    database.materials[3] = greyMaterial(0.3);
    database.temperatures[2] = fixedTemperature(600.0);
    database.temperatures[3] = fixedTemperature(350.0);
    database.materials[8] = greyMaterial(0.1, 0.3);
    database.temperatures[8] = fixedTemperature(500.0);
    database.materials[9].transmissivity = Spectrum({2.0, 3.5, 4.2, 6.0}, {0.7, 0.1, 0.6, 0.4});
    RenderSettings settings = RenderSettings::direct();
    settings.engine = EngineChoice::rays;
    settings.bounces = convergedBounces;
    settings.sunShadows = SunShadowMode::point;
    InteractiveRenderer irsg = rendererOf({placed(mesh, database)}, settings, brightAtmosphere());
    const View view{.azimuth_rad = 1.2, .elevation_rad = 0.7, .fieldOfView_rad = 0.03};
    look(irsg, view);
    const double swept = irsg.measure().all.intensity_W_sr;
    EXPECT_NEAR(irsg.imageWithReport().report.all.intensity_W_sr / swept, 1.0, 2e-3);
    std::vector<double> wavenumbers_per_cm;
    for (int i = 0; i < 400; ++i) {
        wavenumbers_per_cm.push_back(1e4 / (3.0 + 2.0 * (i + 0.5) / 400));
    }
    double sum = 0.0;
    for (const double value : irsg.measureSpectrum(wavenumbers_per_cm).intensity_W_sr_um) {
        sum += value * 2.0 / 400;
    }
    EXPECT_NEAR(sum / swept, 1.0, 1e-3);
    const std::vector<ScalingInput> inputs{{0, ScalingKind::temperature, 2, 0.9, 1.1},
                                           {0, ScalingKind::emissivity, 3, 0.8, 1.2},
                                           {0, ScalingKind::temperature, 9, 0.9, 1.1}};
    const auto scaled = irsg.scaledView(inputs);
    ScaledValues values;
    for (const std::array<double, 3>& scales :
         {std::array{1.0, 1.0, 1.0}, std::array{1.06, 1.0, 0.95}, std::array{0.95, 1.03, 1.04}}) {
        scaled->evaluate(scales, values);
        Entity other = placed(mesh, database);
        other.temperatureScale[2] = scales[0];
        other.emissivityScale[3] = scales[1];
        other.temperatureScale[9] = scales[2];
        InteractiveRenderer there = rendererOf({other}, settings, brightAtmosphere());
        look(there, view);
        const double expected = there.measure().all.intensity_W_sr;
        std::printf("  draw: %.6f\n", values.intensity[0] / expected);
        EXPECT_NEAR(values.intensity[0] / expected, 1.0, 3e-4);
    }
}
