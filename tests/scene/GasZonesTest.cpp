#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/core/Errors.h"
#include "irsg/gas/GasColumn.h"
#include "irsg/gas/GasSpectrum.h"
#include "irsg/gas/GasThroughAir.h"
#include "irsg/geometry/view/PixelGrid.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/RaysBuilt.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

const Band redWing = Band::topHat(4.4, 4.8);
constexpr IrCodes hot{1, 1}, warm{2, 2}, wall{3, 3};

Material gasMaterial(double co2, double h2o) {
    Material gas;
    gas.gasPressure_atm = 1.0;
    gas.gasCO2 = co2;
    gas.gasH2O = h2o;
    return gas;
}

/// Hot and warm gas, and a black wall.
SignatureDatabase gases(double hot_K = 1000.0, double warm_K = 500.0, double wall_K = 400.0) {
    SignatureDatabase database;
    database.temperatures[1] = fixedTemperature(hot_K);
    database.temperatures[2] = fixedTemperature(warm_K);
    database.temperatures[3] = fixedTemperature(wall_K);
    database.materials[1] = gasMaterial(0.1, 0.1);
    database.materials[2] = gasMaterial(0.05, 0.06);
    database.materials[3] = greyMaterial(1.0);
    return database;
}

std::vector<EngineChoice> engines() {
    std::vector<EngineChoice> all{EngineChoice::opengl};
    if (areRaysBuilt()) {
        all.push_back(EngineChoice::rays);
    }
    return all;
}

/// A closed surface of revolution about z, of points (z, radius) that go up and end in flat caps.
Triangles turned(const std::vector<std::array<double, 2>>& outline, int sides) {
    Triangles mesh;
    const auto at = [&](std::size_t i, int side) {
        const double angle = 2.0 * pi * (side % sides) / sides;
        return Vec3{outline[i][1] * std::cos(angle), outline[i][1] * std::sin(angle),
                    outline[i][0]};
    };
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 normal = cross(b - a, c - a);
        if (length(normal) > 0.0) {
            mesh.push_back({{a, b, c}, {normal, normal, normal}, hot});
        }
    };
    const std::size_t last = outline.size() - 1;
    for (int side = 0; side < sides; ++side) {
        for (std::size_t i = 0; i < last; ++i) {
            add(at(i, side), at(i, side + 1), at(i + 1, side + 1));
            add(at(i, side), at(i + 1, side + 1), at(i + 1, side));
        }
        add({0, 0, outline[0][0]}, at(0, side + 1), at(0, side));
        add({0, 0, outline[last][0]}, at(last, side), at(last, side + 1));
    }
    return mesh;
}

/// Before nothing, in no air.
InteractiveRenderer sceneOf(const Triangles& mesh, const SignatureDatabase& database,
                            EngineChoice engine, const View& view) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.settings.engine = engine;
    irsg.scene.settings.background = BackgroundMode::constant;
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.entities = {entityOf(modelOf(mesh), database)};
    irsg.scene.entities[0].pose = {{0, 0, standingAltitude_m}, {}};
    look(irsg, view);
    return irsg;
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

/// Of layers in order from the sensor, without those of no length.
double radianceOf(std::vector<GasLayer> layers, double behind_K = 0.0) {
    std::erase_if(layers, [](const GasLayer& layer) { return !(layer.length_m > 0.0); });
    GasRequest request{.layers = std::move(layers), .band = redWing.range()};
    if (behind_K > 0.0) {
        request.background_K = behind_K;
    }
    return gasSpectrum(request).bandRadiance_W_m2_sr();
}

/// Integral of what a line of sight at a distance from the middle sends over a disc, by the rule of
/// midpoints in the square of the distance.
template <typename Radiance>
double overDisc(double radius_m, int steps, const Radiance& radiance) {
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        sum += radiance(radius_m * std::sqrt((i + 0.5) / steps));
    }
    return sum * pi * radius_m * radius_m / steps;
}

double chord(double radius_m, double off_m) {
    return 2.0 * std::sqrt(std::max(radius_m * radius_m - off_m * off_m, 0.0));
}

/// Far enough for lines of sight to be parallel.
View farView(double azimuth_rad = 0.0, double elevation_rad = 0.0) {
    return {.range_m = 200.0,
            .azimuth_rad = azimuth_rad,
            .elevation_rad = elevation_rad,
            .width_px = 48,
            .height_px = 48,
            .fieldOfView_rad = 0.03,
            .band = redWing};
}

double intensity_W_sr(InteractiveRenderer& irsg) {
    return irsg.measure().all.intensity_W_sr;
}

TEST(GasZones, OfASphereSendWhatItsChordsDo) {
    const SignatureDatabase database = gases();
    const double expected = overDisc(
        1.0, 100, [&](double b) { return radianceOf({layerOf(database, 1, chord(1.0, b))}); });
    for (const EngineChoice engine : engines()) {
        InteractiveRenderer irsg =
            sceneOf(sphereMesh(1.0, 64, 128, hot), database, engine, farView());
        EXPECT_NEAR(intensity_W_sr(irsg) / expected, 1.0, 0.005);
    }
}

TEST(GasZones, OfACylinderAndAConeSendWhatTheirChordsDo) {
    const SignatureDatabase database = gases();
    const double radius_m = 0.4, height_m = 2.0;
    // From beside: chords alike all along the axis.
    const Triangles cylinder = turned({{0.0, radius_m}, {height_m, radius_m}}, 96);
    double side = 0.0;
    constexpr int steps = 200;
    for (int i = 0; i < steps; ++i) {
        side += radianceOf({layerOf(database, 1, chord(radius_m, radius_m * (i + 0.5) / steps))});
    }
    side *= 2.0 * radius_m * height_m / steps;
    InteractiveRenderer irsg = sceneOf(cylinder, database, EngineChoice::opengl, farView());
    EXPECT_NEAR(intensity_W_sr(irsg) / side, 1.0, 0.006);
    // Along the axis: what is left of the cone's height there.
    const Triangles cone = turned({{0.0, radius_m}, {height_m, 0.0}}, 96);
    const double below = overDisc(radius_m, 200, [&](double b) {
        return radianceOf({layerOf(database, 1, height_m * (1.0 - b / radius_m))});
    });
    InteractiveRenderer fromAbove =
        sceneOf(cone, database, EngineChoice::opengl, farView(0.0, radians(90.0)));
    EXPECT_NEAR(intensity_W_sr(fromAbove) / below, 1.0, 0.006);
}

TEST(GasZones, WithinAnotherReplaceItThere) {
    const SignatureDatabase database = gases();
    const double outer_m = 1.0, inner_m = 0.5;
    const double expected = overDisc(outer_m, 100, [&](double b) {
        const double inside_m = chord(inner_m, b);
        const double before_m = 0.5 * (chord(outer_m, b) - inside_m);
        return radianceOf({layerOf(database, 2, before_m), layerOf(database, 1, inside_m),
                           layerOf(database, 2, before_m)});
    });
    const Triangles nest =
        joined(sphereMesh(outer_m, 64, 128, warm), sphereMesh(inner_m, 64, 128, hot));
    for (const EngineChoice engine : engines()) {
        InteractiveRenderer irsg = sceneOf(nest, database, engine, farView());
        EXPECT_NEAR(intensity_W_sr(irsg) / expected, 1.0, 0.005);
    }
}

/// Twelve gases, the hottest within the others, from 300 to 900 K.
constexpr int nested = 12;
SignatureDatabase nestedGases() {
    SignatureDatabase database;
    for (int i = 1; i <= nested; ++i) {
        database.temperatures[i] = fixedTemperature(250.0 + 54.0 * i);
        database.materials[i] = gasMaterial(0.0035 * i, 0.0035 * i);
    }
    return database;
}

TEST(GasZones, AsManyAsAJetHasSendWhatTheirChordsDoFromAllSides) {
    // Ellipsoids, whose chords are those of spheres times a number that the direction has.
    const SignatureDatabase database = nestedGases();
    const double radius_m = 0.8, longer = 4.0;
    const auto reach_m = [&](int i) { return radius_m * (nested + 1 - i) / nested; };
    Triangles nest;
    for (int i = 1; i <= nested; ++i) {
        Triangles zone = sphereMesh(reach_m(i), 24, 48, {i, i});
        double volume_m3 = 0.0;
        for (const Triangle& triangle : zone) {
            volume_m3 +=
                dot(triangle.vertex[0], cross(triangle.vertex[1], triangle.vertex[2])) / 6.0;
        }
        // Facets that hold as much gas as what they stand for.
        const double wider = reach_m(i) * std::cbrt(4.0 * pi / 3.0 / std::abs(volume_m3));
        for (Triangle& triangle : zone) {
            for (Vec3& corner : triangle.vertex) {
                corner = corner * wider;
                corner.z *= longer;
            }
        }
        nest = joined(nest, zone);
    }
    std::vector<GasLayer> gases;
    std::vector<double> wavenumbers_per_cm;
    for (int i = 1; i <= nested; ++i) {
        gases.push_back(layerOf(database, i, 1.0));
    }
    const double lower = 1e4 / 4.8, width = (1e4 / 4.4 - lower) / 38.0; // cells of about 5 cm-1
    for (int i = 0; i < 38; ++i) {
        wavenumbers_per_cm.push_back(lower + (i + 0.5) * width);
    }
    const GasColumns columns(gases, wavenumbers_per_cm);
    const auto radianceAlong = [&](const std::vector<GasStretch>& line) {
        const auto shares = columns.shares(line);
        double sum = 0.0;
        for (std::size_t g = 0; g < gases.size(); ++g) {
            for (std::size_t i = 0; i < wavenumbers_per_cm.size(); ++i) {
                const double um = 1e4 / wavenumbers_per_cm[i];
                sum += shares[g][i] * um * um * 1e-4 * width *
                       planckRadiance_W_m2_sr_um(um, gases[g].temperature_K);
            }
        }
        return sum;
    };
    for (const double elevation_deg : {0.0, 45.0, 80.0}) {
        const double sine = std::sin(radians(elevation_deg)),
                     cosine = std::cos(radians(elevation_deg));
        const double chords = 1.0 / std::hypot(cosine, sine / longer);
        const double expected =
            longer / chords * overDisc(radius_m, 60, [&](double b) {
                std::vector<GasStretch> line;
                for (int i = 1; i <= nested; ++i) {
                    const double inner = i < nested ? chord(reach_m(i + 1), b) : 0.0;
                    line.push_back({static_cast<std::size_t>(i - 1),
                                    0.5 * chords * (chord(reach_m(i), b) - inner)});
                }
                line.back().length_m *= 2.0;
                for (std::size_t i = nested - 1; i-- > 0;) {
                    line.push_back(line[i]);
                }
                return radianceAlong(line);
            });
        InteractiveRenderer irsg =
            sceneOf(nest, database, EngineChoice::opengl, farView(0.0, radians(elevation_deg)));
        EXPECT_NEAR(intensity_W_sr(irsg) / expected, 1.0, 0.005) << elevation_deg << " deg";
    }
}

TEST(GasZones, AreCutByWhatIsSolid) {
    const SignatureDatabase database = gases();
    // A black plate through the middle, across the line of sight from the nose, wider than the gas.
    const Triangles cut =
        joined(sphereMesh(1.0, 64, 128, hot), plateMesh({0, 0, 0}, {1.2, 0, 0}, {0, 0, 1.2}, wall));
    const double gas = overDisc(1.0, 100, [&](double b) {
        return radianceOf({layerOf(database, 1, 0.5 * chord(1.0, b))}, 400.0);
    });
    const double bare = bandRadiance_W_m2_sr(redWing, 400.0) * (2.4 * 2.4 - pi);
    for (const EngineChoice engine : engines()) {
        InteractiveRenderer irsg = sceneOf(cut, database, engine, farView());
        EXPECT_NEAR(intensity_W_sr(irsg) / (gas + bare), 1.0, 0.004);
    }
}

TEST(GasZones, AreSeenFromWithin) {
    const SignatureDatabase database = gases();
    for (const EngineChoice engine : engines()) {
        View view = farView();
        view.range_m = 0.25;
        view.width_px = view.height_px = 9;
        InteractiveRenderer irsg =
            sceneOf(joined(sphereMesh(1.0, 64, 128, hot),
                           plateMesh({0, -5, 0}, {9, 0, 0}, {0, 0, 9}, wall)),
                    database, engine, view);
        irsg.scene.entities[0].referencePoint_m = Vec3{0, 0, 0};
        look(irsg, view);
        const RadianceImage image = irsg.image().image;
        // From 0.25 m before the middle: 1.25 m of gas, and the wall behind.
        const double expected = radianceOf({layerOf(database, 1, 1.25)}, 400.0);
        EXPECT_NEAR(static_cast<double>(image.at(4, 4)) / expected, 1.0, 0.004);
        // A wall within the gas, too.
        view.range_m = 0.5;
        InteractiveRenderer before = sceneOf(
            joined(sphereMesh(1.0, 64, 128, hot), plateMesh({0, 0, 0}, {9, 0, 0}, {0, 0, 9}, wall)),
            database, engine, view);
        const RadianceImage near = before.image().image;
        EXPECT_NEAR(static_cast<double>(near.at(4, 4)) /
                        radianceOf({layerOf(database, 1, 0.5)}, 400.0),
                    1.0, 0.004);
    }
}

TEST(GasZones, OfTheTemperatureOfTheWallsAreBlack) {
    const SignatureDatabase database = gases(700.0, 700.0, 700.0);
    const Triangles room =
        joined(joined(sphereMesh(1.0, 24, 48, hot), sphereMesh(0.5, 24, 48, warm)),
               boxMesh({3, 3, 3}, std::vector<IrCodes>(6, wall)));
    for (const EngineChoice engine : engines()) {
        View view = farView();
        view.range_m = 2.5;
        view.fieldOfView_rad = radians(60.0);
        InteractiveRenderer irsg = sceneOf(room, database, engine, view);
        const RadianceImage image = irsg.image().image;
        const double black = bandRadiance_W_m2_sr(redWing, 700.0);
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                ASSERT_NEAR(static_cast<double>(image.at(x, y)) / black, 1.0, 1e-4)
                    << x << ", " << y;
            }
        }
    }
}

TEST(GasZones, AreTheSameInImagesReportsSpectraAndScales) {
    const SignatureDatabase database = gases();
    const Triangles nest =
        joined(joined(sphereMesh(1.0, 24, 48, warm), sphereMesh(0.5, 24, 48, hot)),
               plateMesh({0, 0.2, 0}, {0.3, 0, 0}, {0, 0, 1.5}, wall));
    InteractiveRenderer irsg = sceneOf(nest, database, EngineChoice::opengl, farView());
    irsg.scene.settings.background = BackgroundMode::constant;
    irsg.scene.settings.background_W_m2_sr = 1.3;
    const RenderedImage both = irsg.imageWithReport();
    const double whole = both.report.all.contrastIntensity_W_sr;
    double sum = 0.0;
    const PixelGrid grid(irsg.view.sensor);
    for (int y = 0; y < both.image.height(); ++y) {
        for (int x = 0; x < both.image.width(); ++x) {
            sum += (static_cast<double>(both.image.at(x, y)) - 1.3) * grid.at(x, y).solidAngle_sr *
                   200.0 * 200.0;
        }
    }
    EXPECT_NEAR(sum / whole, 1.0, 1e-5);
    const ObjectRadiometry measured = irsg.measure().all;
    EXPECT_NEAR(measured.contrastIntensity_W_sr / whole, 1.0, 1e-8);
    // Columns of gas whose weights are below 0 hide less, too.
    EXPECT_NEAR(measured.coveredPixels / both.report.all.coveredPixels, 1.0, 1e-6);
    const auto scaled = irsg.scaledView(
        {{0, ScalingKind::temperature, 1, 0.9, 1.1}, {0, ScalingKind::emissivity, 3, 0.5, 1.0}});
    ScaledValues values;
    scaled->evaluate(std::vector<double>{1.0, 1.0}, values);
    EXPECT_NEAR(values.contrastIntensity[0] / whole, 1.0, 1e-8);
    scaled->evaluate(std::vector<double>{1.02, 1.0}, values);
    EXPECT_GT(values.contrastIntensity[0], 1.02 * whole);
    // A spectrum at wavenumbers between those of the tables, where both are linear.
    std::vector<double> wavenumbers_per_cm;
    for (double n = 2085.0; n <= 2270.0; n += 0.5) {
        wavenumbers_per_cm.push_back(n);
    }
    irsg.scene.settings.background_W_m2_sr = 0.0;
    const IntensitySpectrum spectrum = irsg.measureSpectrum(wavenumbers_per_cm);
    irsg.view.sensor.band = Band::topHat(1e4 / 2270.0, 1e4 / 2085.0);
    double band = 0.0;
    for (std::size_t i = 0; i + 1 < wavenumbers_per_cm.size(); ++i) {
        band += 0.5 * (spectrum.intensity_W_sr_um[i] + spectrum.intensity_W_sr_um[i + 1]) *
                (spectrum.wavelengths_um[i] - spectrum.wavelengths_um[i + 1]);
    }
    EXPECT_NEAR(band / intensity_W_sr(irsg), 1.0, 1e-5);
}

TEST(GasZones, ArriveThroughAirWithTheCoincidenceOfLines) {
    const SignatureDatabase database = gases(700.0);
    const double range_m = 1000.0;
    AtmosphereSmartParameters parameters;
    const auto air = std::make_shared<const AtmosphereSmart>(parameters);
    View view = farView();
    view.range_m = range_m;
    view.fieldOfView_rad = 0.02;
    InteractiveRenderer irsg = sceneOf(boxMesh({5, 0.25, 5}, std::vector<IrCodes>(6, hot)),
                                       database, EngineChoice::opengl, view);
    irsg.scene.environment = Environment();
    irsg.scene.environment.add(air);
    irsg.scene.settings.atmosphereSliceFrom = 1.0;
    const double got = intensity_W_sr(irsg);
    // What smat-batch gas makes of the same layer and the same air.
    const GasRequest request{.layers = {layerOf(database, 1, 0.5)}, .band = redWing.range()};
    const GasSpectrum spectrum = gasSpectrum(request);
    const AtmosphericPath path{.sensorAltitude_m = standingAltitude_m,
                               .targetAltitude_m = standingAltitude_m,
                               .range_m = range_m};
    const auto correlations =
        lineCorrelations(request, spectrum.cells, *airOfPath(air.get(), path), range_m);
    const auto of = [&](AtmosphereProperty property) {
        return irsg.scene.environment
            .spectrum({.quantity = property, .path = path}, redWing.range())
            .value;
    };
    const Spectrum transmittance = of(AtmosphereProperty::transmittance),
                   emitted = of(AtmosphereProperty::pathRadiance);
    double expected = 0.0, product = 0.0;
    for (std::size_t i = 0; i < spectrum.cells.size(); ++i) {
        const GasSpectrum::Cell& cell = spectrum.cells[i];
        const SpectralRange range{wavelengthFromWavenumber_um(cell.upper_per_cm),
                                  wavelengthFromWavenumber_um(cell.lower_per_cm)};
        const Spectrum* const passes[] = {&transmittance};
        const Spectrum* const sends[] = {&emitted};
        const double gas = cell.radiance_W_m2_sr_um * integrateProduct(passes, range);
        const double own = (1.0 - cell.transmittance) * integrateProduct(sends, range);
        expected += gas * correlations[i].radiance + own;
        product += gas + own;
    }
    const double area_m2 = 100.0;
    EXPECT_NEAR(got / area_m2 / expected, 1.0, 0.005);
    EXPECT_GT(std::abs(product / expected - 1.0), 0.05) << "lines matter here";
}

TEST(GasZones, ThatCrossEachOtherAreNamed) {
    const auto warningsOf = [](double apart_m, const IrCodes& codes = warm) {
        Triangles other = sphereMesh(0.5, 24, 48, codes);
        for (Triangle& triangle : other) {
            for (Vec3& corner : triangle.vertex) {
                corner.y += apart_m;
            }
        }
        InteractiveRenderer irsg = sceneOf(joined(sphereMesh(1.0, 24, 48, hot), other), gases(),
                                           EngineChoice::opengl, farView());
        irsg.scene.environment = Environment::vacuum();
        std::string all;
        for (const std::string& warning : irsg.measure().warnings) {
            all += warning + "\n";
        }
        return all;
    };
    EXPECT_EQ(warningsOf(0.0), "") << "one holds the other";
    EXPECT_EQ(warningsOf(3.0), "") << "they are apart";
    EXPECT_NE(warningsOf(1.0).find("crosses that of material 1 and temperature 1"),
              std::string::npos);
    // Of one gas, too: the plumes of two engines, where they meet.
    EXPECT_EQ(warningsOf(3.0, hot), "") << "they are apart";
    EXPECT_NE(warningsOf(1.0, hot).find("material 1 and temperature 1 of"), std::string::npos)
        << warningsOf(1.0, hot);
    EXPECT_NE(warningsOf(1.0, hot).find("cross or hold each other"), std::string::npos);
    EXPECT_NE(warningsOf(0.0, hot).find("cross or hold each other"), std::string::npos);
}

TEST(GasZones, ThatAreOpenOrOutOfReachAreRefusedByName) {
    const auto refusal = [](const Triangles& mesh, const SignatureDatabase& database) {
        InteractiveRenderer irsg = sceneOf(mesh, database, EngineChoice::opengl, farView());
        try {
            irsg.check();
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    Triangles open = sphereMesh(1.0, 8, 16, hot);
    EXPECT_EQ(refusal(open, gases()), "");
    open.pop_back();
    EXPECT_NE(refusal(open, gases()).find("edges of an open mesh"), std::string::npos);
    EXPECT_NE(refusal(open, gases()).find("material index 1"), std::string::npos);
    const Triangles closed = sphereMesh(1.0, 8, 16, hot);
    EXPECT_NE(refusal(closed, gases(3500.0)).find("T_K"), std::string::npos);
    // In a state that a sweep comes to, too.
    SignatureDatabase heated = gases();
    heated.temperatures[1].terms.time = LookupTable({0.0, 10.0}, {0.0, 3000.0});
    InteractiveRenderer later = sceneOf(closed, heated, EngineChoice::opengl, farView());
    later.check();
    later.scene.entities[0].otherStates = {later.scene.entities[0].state};
    later.scene.entities[0].otherStates[0].time_s = 10.0;
    try {
        later.check();
        ADD_FAILURE() << "4000 K";
    } catch (const InputError& error) {
        for (const char* named : {"material index 1", "at time 10 s", "T_K", "4000"}) {
            EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
        }
    }
    SignatureDatabase full = gases();
    full.materials[1].gasCO2 = 0.95;
    EXPECT_NE(refusal(closed, full).find("1.05"), std::string::npos);
    SignatureDatabase measured = gases();
    measured.temperatures[1].mode = EmissionMode::userSpectrum;
    measured.temperatures[1].userSpectrum = "gas";
    measured.spectra["gas"] = {
        "gas", 0.0, "", "", {{"all", Spectrum({2.0, 4.0, 15.0}, {0.1, 0.9, 0.2})}}};
    EXPECT_NE(refusal(closed, measured).find("a gas has no spectrum of its own"),
              std::string::npos);
}

} // namespace
