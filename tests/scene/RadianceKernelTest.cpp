// One list of terms, one evaluator: what lies in front multiplies at every node, every way to a
// number gives the same number, and the air may change over an object.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/RadianceTerms.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/RaysBuilt.h"
#include "irsg/scene/InteractiveRenderer.h"
#include "irsg/scene/Renderer.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes body{1, 1}, gas{2, 2}, otherGas{3, 3};
constexpr double body_K = 700.0, gas_K = 900.0, otherGas_K = 500.0;

double inBand(double from_um, double to_um, double temperature_K) {
    return bandRadiance_W_m2_sr(Band::topHat(from_um, to_um), temperature_K);
}

/// A material that is black between two wavelengths and not there outside.
Material blackBetween(double from_um, double to_um) {
    constexpr double edge_um = 1e-7;
    const std::vector<double> axis{3.0, from_um - edge_um, from_um, to_um, to_um + edge_um, 5.0};
    Material material;
    material.emissivity = Spectrum(axis, {0, 0, 1, 1, 0, 0});
    material.transmissivity = Spectrum(axis, {1, 1, 0, 0, 1, 1});
    return material;
}

SignatureDatabase bodyInGas() {
    SignatureDatabase database;
    database.temperatures[1] = fixedTemperature(body_K);
    database.temperatures[2] = fixedTemperature(gas_K);
    database.temperatures[3] = fixedTemperature(otherGas_K);
    database.materials[1] = greyMaterial(1.0);
    database.materials[2] = blackBetween(4.2, 4.5);
    database.materials[3] = blackBetween(4.4, 4.7);
    return database;
}

/// A plate that fills the field, before it one wall of a gas, and before that one of another.
Triangles platesBehindEachOther(bool withOther) {
    const auto wall = [](double y_m, IrCodes codes) {
        return plateMesh({0, y_m, 0}, {5, 0, 0}, {0, 0, -5}, codes);
    };
    const Triangles mesh = joined(wall(0.0, body), wall(1.0, gas));
    return withOther ? joined(mesh, wall(2.0, otherGas)) : mesh;
}

double centreRadiance(InteractiveRenderer& irsg) {
    const RadianceImage image = irsg.imageWithReport().image;
    return static_cast<double>(
        image.primary().values[image.offset(image.width() / 2, image.height() / 2)]);
}

RenderSettings emissionAlone() {
    RenderSettings settings = RenderSettings::direct();
    settings.sun = settings.ambientReflection = ReflectionMode::off;
    settings.background = BackgroundMode::constant;
    return settings;
}

} // namespace

TEST(BodyInGas, ShowsWhatItsClosedFormSays) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = Environment::vacuum();
    irsg.scene.settings = emissionAlone();
    irsg.scene.entities = {entityOf(modelOf(platesBehindEachOther(false)), bodyInGas())};
    look(irsg, {.range_m = 100.0, .fieldOfView_rad = 0.02});
    const double expected =
        inBand(3.0, 4.2, body_K) + inBand(4.2, 4.5, gas_K) + inBand(4.5, 5.0, body_K);
    EXPECT_NEAR(centreRadiance(irsg) / expected, 1.0, 1e-5);
}

TEST(BodyInGas, ShowsWhatItsClosedFormSaysInTwoGasesThatOverlap) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = Environment::vacuum();
    irsg.scene.settings = emissionAlone();
    irsg.scene.entities = {entityOf(modelOf(platesBehindEachOther(true)), bodyInGas())};
    look(irsg, {.range_m = 100.0, .fieldOfView_rad = 0.02});
    // The nearer gas hides the farther one where both are black.
    const double expected = inBand(3.0, 4.2, body_K) + inBand(4.2, 4.4, gas_K) +
                            inBand(4.4, 4.7, otherGas_K) + inBand(4.7, 5.0, body_K);
    EXPECT_NEAR(centreRadiance(irsg) / expected, 1.0, 1e-5);
}

TEST(BodyInGas, ShowsWhatItDoesInAFirstPictureWhateverWasDrawnBefore) {
    // Where all kinds of surfaces are known samples are gone through once, else twice.
    const auto pictureOf = [](InteractiveRenderer& irsg, double azimuth_rad) {
        look(irsg, {.range_m = 30.0, .azimuth_rad = azimuth_rad, .fieldOfView_rad = 0.2});
        return irsg.imageWithReport().image.primary().values;
    };
    const auto prepare = [](InteractiveRenderer& irsg) {
        irsg.scene.environment = brightAtmosphere();
        irsg.scene.entities = {
            entityOf(modelOf(joined(boxMesh({2, 2, 2}, std::vector<IrCodes>(6, gas)),
                                    plateMesh({6, 0, 0}, {0, 3, 0}, {0, 0, -3}, otherGas))),
                     bodyInGas())};
    };
    InteractiveRenderer irsg{RenderSettings::direct()};
    prepare(irsg);
    for (const double azimuth_deg : {0.0, 0.0, 60.0, 90.0, 0.0}) {
        InteractiveRenderer anew{RenderSettings::direct()};
        prepare(anew);
        EXPECT_EQ(pictureOf(irsg, radians(azimuth_deg)), pictureOf(anew, radians(azimuth_deg)))
            << azimuth_deg;
    }
}

TEST(EveryWayToANumber, GivesTheSameNumber) {
    for (const int tileSide_samples : {0, 128}) {
        InteractiveRenderer irsg{RenderSettings::direct()};
        irsg.scene.environment = brightAtmosphere();
        SignatureDatabase database = bodyInGas();
        database.materials[1] = greyMaterial(0.7);
        irsg.scene.entities = {
            entityOf(modelOf(joined(sphereMesh(1.0, 24, 48, body),
                                    boxMesh({2, 2, 2}, std::vector<IrCodes>(6, gas)))),
                     database)};
        RenderSettings settings = RenderSettings::direct();
        settings.tileSide_samples = tileSide_samples;
        settings.truthLayers = true;
        irsg.scene.settings = settings;
        look(irsg, {.range_m = 150.0, .azimuth_rad = 0.4, .elevation_rad = 0.3});
        const RenderedImage image = irsg.imageWithReport();
        const RenderReport sweep = irsg.measure();
        const double intensity = sweep.all.intensity_W_sr;
        EXPECT_NEAR(image.report.all.intensity_W_sr / intensity, 1.0, 2e-6);
        EXPECT_NEAR(image.report.all.contrastIntensity_W_sr, sweep.all.contrastIntensity_W_sr,
                    2e-6 * intensity);

        // Truth layers add up to the pixels.
        const std::vector<float>& pixels = image.image.primary().values;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            double sum = static_cast<double>(image.image.find("background")->values[i]);
            for (const RadianceTerm& term : RadianceTerms::standard().terms) {
                if (term.surface == SurfaceQuantity::specular) {
                    EXPECT_EQ(image.image.find(term.name), nullptr); // no surface has lobes
                    continue;
                }
                sum += static_cast<double>(image.image.find(term.name)->values[i]);
            }
            ASSERT_NEAR(sum, static_cast<double>(pixels[i]), 2e-5 * static_cast<double>(pixels[i]));
        }

        // The spectrum integrates to the band.
        std::vector<double> wavenumbers_per_cm;
        constexpr int steps = 8000;
        for (int i = 0; i < steps; ++i) { // in the middle of steps, on whose borders the gas begins
            wavenumbers_per_cm.push_back(1e4 / (3.0 + 2.0 * (i + 0.5) / steps));
        }
        const IntensitySpectrum spectrum = irsg.measureSpectrum(wavenumbers_per_cm);
        double integral = 0.0;
        for (const double intensity_W_sr_um : spectrum.intensity_W_sr_um) {
            integral += intensity_W_sr_um * 2.0 / steps;
        }
        EXPECT_NEAR(integral / intensity, 1.0, 1e-5);
    }
}

TEST(SeveralBands, AreThoseOfRunsOfTheirOwnAndAddUp) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = brightAtmosphere();
    irsg.scene.entities = {entityOf(modelOf(glazedMesh()), [] {
        SignatureDatabase database = bodyInGas();
        database.materials[3] = greyMaterial(0.3, 0.6);
        return database;
    }())};
    RenderSettings settings = RenderSettings::direct();
    settings.hotSpots = false; // windows do not follow the bands
    irsg.scene.settings = settings;
    look(irsg, {.range_m = 150.0, .azimuth_rad = 0.4});
    const std::vector<Band> bands{Band::topHat(3.0, 4.0), Band::topHat(4.0, 5.0),
                                  Band::topHat(3.0, 5.0), Band::topHat(4.2, 4.5)};
    irsg.resetStageTimes();
    const std::vector<RenderReport> together = irsg.measure(bands);
    long drawings = 0;
    for (const StageTimes::Stage& stage : irsg.stageTimes().stages) {
        if (stage.name == "factor sums") {
            drawings = stage.calls;
        }
    }
    EXPECT_EQ(drawings, 1) << "one drawing serves all bands";
    ASSERT_EQ(together.size(), bands.size());
    EXPECT_NEAR((together[0].all.intensity_W_sr + together[1].all.intensity_W_sr) /
                    together[2].all.intensity_W_sr,
                1.0, 1e-6);
    for (std::size_t k = 0; k < bands.size(); ++k) {
        look(irsg, {.range_m = 150.0, .azimuth_rad = 0.4, .band = bands[k]});
        const RenderReport alone = irsg.measure();
        EXPECT_NEAR(together[k].all.intensity_W_sr / alone.all.intensity_W_sr, 1.0, 1e-9);
        EXPECT_NEAR(together[k].all.contrastIntensity_W_sr, alone.all.contrastIntensity_W_sr,
                    1e-9 * alone.all.intensity_W_sr);
        EXPECT_NEAR(together[k].background_W_m2_sr, alone.background_W_m2_sr,
                    1e-9 * alone.background_W_m2_sr);
    }
}

TEST(Threads, LeaveEveryBitAsItIs) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = brightAtmosphere();
    irsg.scene.entities = {entityOf(modelOf(glazedMesh()), [] {
        SignatureDatabase database = bodyInGas();
        database.materials[3] = greyMaterial(0.3, 0.6);
        return database;
    }())};
    look(irsg, {.range_m = 100.0, .azimuth_rad = 0.5, .elevation_rad = 0.2});
    const auto all = [&](unsigned threads) {
        setMostThreads(threads);
        InteractiveRenderer fresh{RenderSettings::direct()};
        fresh.scene.environment = irsg.scene.environment;
        fresh.scene.entities = irsg.scene.entities;
        fresh.view.sensor = irsg.view.sensor;
        fresh.view.viewpoint = irsg.view.viewpoint;
        const RenderReport report = fresh.measure();
        std::vector<float> pixels = fresh.imageWithReport().image.primary().values;
        for (int i = 0; i < 2; ++i) { // the second is a sum of factors
            const std::vector<float> followed = fresh.picture().primary().values;
            pixels.insert(pixels.end(), followed.begin(), followed.end());
        }
        setMostThreads(0);
        return std::tuple{report.all.intensity_W_sr, report.all.contrastIntensity_W_sr,
                          report.all.irradiance_W_m2, report.all.coveredPixels, pixels};
    };
    const auto one = all(1);
    EXPECT_EQ(one, all(2));
    EXPECT_EQ(one, all(7));
}

// A plain shader adds up the radiances of what has nothing transparent before it; the evaluator
// does it from factors. Both are the same picture.
TEST(PlainShader, AddsUpWhatTheEvaluatorDoes) {
    for (const ReflectionMode mode :
         {ReflectionMode::off, ReflectionMode::approx, ReflectionMode::smart}) {
        InteractiveRenderer irsg{RenderSettings::direct()};
        irsg.scene.environment = brightAtmosphere();
        RenderSettings settings = RenderSettings::direct();
        settings.tileSide_samples = 0;
        settings.sun = settings.ambientReflection = mode;
        irsg.scene.settings = settings;
        SignatureDatabase database = bodyInGas();
        database.materials[1] = greyMaterial(0.6, 0.0, 1.7);
        database.materials[2] = greyMaterial(0.5, 0.5);
        const Triangles opaque = sphereMesh(1.0, 24, 48, body);
        const auto imageOf = [&](const Triangles& mesh) {
            Entity entity = entityOf(modelOf(mesh), database);
            entity.referencePoint_m = Vec3{};
            irsg.scene.entities = {entity};
            look(irsg, {.range_m = 60.0, .azimuth_rad = 0.4, .elevation_rad = 0.3});
            return irsg.imageWithReport().image.primary().values;
        };
        const std::vector<float> plain = imageOf(opaque);
        // A pane beyond the field's edge: it is in the window's scene and nowhere in the picture.
        const std::vector<float> evaluated =
            imageOf(joined(opaque, plateMesh({0, -0.5, 0}, {0.01, 0, 0}, {0, 0, 0.01}, gas)));
        const float brightest = *std::ranges::max_element(plain);
        for (std::size_t i = 0; i < plain.size(); ++i) {
            ASSERT_NEAR(plain[i], evaluated[i], 1e-6F * brightest) << i;
        }
    }
}

// A term that nothing of the program knows: light of a second sun. This is all it takes.
TEST(RadianceTerms, TakeAnotherTermFromOneRecord) {
    const Vec3 second = direction(radians(30.0), radians(20.0));
    RadianceTerms list = RadianceTerms::standard();
    list.directions.push_back({"secondSunEye", [=](const SunPosition&) { return second; }});
    const std::size_t place = list.directions.size() - 1;
    list.factors.push_back(
        {"second sun",
         [](const RenderSettings&) { return std::string("max(dot(normal, secondSunEye), 0.0)"); },
         [=](const RenderSettings&) -> GeometryFactorFunction {
             return [=](const SampleGeometry& sample) {
                 return std::max(dot(sample.normal, sample.directionsEye[place].second), 0.0);
             };
         }});
    RadianceTerm term;
    term.name = "second_sun";
    term.factor.drawn = static_cast<int>(list.factors.size()) - 1;
    term.surface = SurfaceQuantity::reflectance;
    term.light = AtmosphereProperty::solarIrradiance;
    term.passesAtmosphere = true;
    term.isOn = [](const RenderSettings&) { return true; };
    list.terms.push_back(term);

    ConstantAtmosphere air;
    air.transmittanceValue = 0.8;
    air.sunValue = 3.0;
    Scene scene;
    scene.settings = RenderSettings::direct();
    scene.environment = environmentOf(air, {radians(200.0), radians(50.0)});
    scene.settings.background = BackgroundMode::constant;
    scene.settings.ambientReflection = ReflectionMode::off;
    scene.settings.truthLayers = true;
    // A plate that lies flat, seen from above; a pane of half transmissivity beside it makes the
    // evaluator add it up, too.
    const IrCodes codes{1, 1};
    const std::vector<EngineChoice> engines =
        areRaysBuilt() ? std::vector{EngineChoice::opengl, EngineChoice::rays}
                       : std::vector{EngineChoice::opengl};
    for (std::size_t i = 0; i < 2 * engines.size(); ++i) {
        const bool fromFactors = i % 2 == 1;
        scene.settings.engine = engines[i / 2];
        SignatureDatabase database = greyDatabase(0.25, 300.0);
        database.temperatures[2] = fixedTemperature(300.0);
        database.materials[2] = greyMaterial(0.1, 0.5);
        Triangles mesh = plateMesh({}, {5, 0, 0}, {0, 5, 0}, codes);
        if (fromFactors) {
            mesh = joined(mesh, plateMesh({4.9, 4.9, 0.01}, {0.01, 0, 0}, {0, 0.01, 0}, {2, 2}));
        }
        Entity entity = entityOf(modelOf(mesh), database);
        entity.pose.position_m.z = standingAltitude_m;
        scene.entities = {entity};
        SensorView view;
        view.sensor = sensorOf(32, 32, 1.0);
        view.viewpoint = Viewpoint::lookAt({0, 0, standingAltitude_m + 500.0},
                                           {0, 0, standingAltitude_m}, {0, 1, 0}, {0, 1, 0});
        Renderer renderer(list);
        const Rendered made = renderer.render(scene, view, Outputs::imageWithReports());
        const std::size_t middle = made.image.offset(16, 16);
        const double width_um = 2.0;
        const double lit = 0.75 / pi * 3.0 * 0.8 * width_um;
        EXPECT_NEAR(static_cast<double>(made.image.find("second_sun")->values[middle]) /
                        (lit * second.z),
                    1.0, 1e-5);
        EXPECT_NEAR(static_cast<double>(made.image.find("sun")->values[middle]) /
                        (lit * std::sin(radians(50.0))),
                    1.0, 1e-5);
        const double emitted = 0.25 * 0.8 * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 300.0);
        EXPECT_NEAR(static_cast<double>(made.image.primary().values[middle]) /
                        (emitted + lit * (second.z + std::sin(radians(50.0)))),
                    1.0, 1e-5);
    }
}

// Strong air: what is farther away is darker, also within one object.
TEST(AtmosphereAlongAnObject, IsTakenAtTheRangeOfEverySample) {
    const double perMetre = 0.1; // 100 /km
    Environment environment;
    BeerLambertParameters parameters;
    parameters.extinction_per_m = Spectrum::constant(perMetre);
    parameters.airTemperature_K = parameters.groundTemperature_K = 50.0; // it does not shine
    environment.add(std::make_shared<BeerLambert>(parameters));
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environment;
    RenderSettings settings = emissionAlone();
    irsg.scene.settings = settings;
    // Two walls, one 3 m behind the other and beside it: each fills half of the field.
    const Triangles mesh = joined(plateMesh({-5, 1.5, 0}, {5, 0, 0}, {0, 0, -5}, body),
                                  plateMesh({5, -1.5, 0}, {5, 0, 0}, {0, 0, -5}, body));
    Entity entity = entityOf(modelOf(mesh), greyDatabase(1.0, 600.0));
    entity.referencePoint_m = Vec3{};
    irsg.scene.entities = {entity};
    look(irsg, {.range_m = 20.0, .fieldOfView_rad = 0.2});
    const RenderedImage rendered = irsg.imageWithReport();
    const RadianceImage& image = rendered.image;
    const double black = bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 600.0);
    const Viewpoint eye = irsg.view.viewpoint;
    for (const int x : {8, 24, 40, 56}) {
        // The pixel's ray: from the nose the camera's right is the model's left.
        const double across = (x + 0.5 - 32.0) / 32.0 * std::tan(0.1);
        const double along = std::sqrt(1.0 + across * across);
        const double depth_m = across * eye.right.x < 0.0 ? 18.5 : 21.5;
        const double expected = black * std::exp(-perMetre * depth_m * along);
        const double found = static_cast<double>(image.primary().values[image.offset(x, 32)]);
        EXPECT_NEAR(found / expected, 1.0, 2e-3) << x;
    }
    EXPECT_LT(rendered.report.all.atmosphereError, 5e-3);
    EXPECT_NEAR(irsg.measure().all.intensity_W_sr / rendered.report.all.intensity_W_sr, 1.0, 2e-6);

    // In one slice, the bound that is told covers what is wrong.
    settings.atmosphereSliceFrom = 1e9;
    irsg.scene.settings = settings;
    const RenderedImage coarse = irsg.imageWithReport();
    const double wrong = static_cast<double>(coarse.image.primary().values[image.offset(8, 32)]) /
                             static_cast<double>(image.primary().values[image.offset(8, 32)]) -
                         1.0;
    EXPECT_GT(std::abs(wrong), 0.05);
    EXPECT_GE(coarse.report.objects.front().atmosphereError, std::abs(wrong));
    EXPECT_FALSE(coarse.report.warnings.empty());
}

// The ship of the samples from its bow: 122 m of depth. The integral over depth is exact where the
// distance of every sample is known.
TEST(AtmosphereAlongAnObject, IsTakenAlongAShipThatIsSeenFromItsBow) {
    const double perMetre = 2e-3;
    Environment environment;
    BeerLambertParameters parameters;
    parameters.extinction_per_m = Spectrum::constant(perMetre);
    parameters.airTemperature_K = parameters.groundTemperature_K = 50.0; // it does not shine
    environment.add(std::make_shared<BeerLambert>(parameters));
    Entity ship =
        entityOf(Model::load(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/ship/ship.flt"),
                 greyDatabase(1.0, 320.0));
    ship.fallbackTemperature = ship.fallbackMaterial = 1;
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environment;
    irsg.scene.entities = {ship};
    RenderSettings settings = emissionAlone();
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = 1; // whose distance is that of the pixel
    settings.truthLayers = true;
    look(irsg, {.range_m = 300.0, .elevation_rad = 0.14, .fieldOfView_rad = 0.2});

    const double black = bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 320.0);
    struct Sums {
        double found = 0.0, exact = 0.0, nearest_m = 1e9, farthest_m = 0.0, atmosphereError = 0.0;
        double wrong() const { return std::abs(found / exact - 1.0); }
    };
    const auto sumsWith = [&](double atmosphereSliceFrom) {
        settings.atmosphereSliceFrom = atmosphereSliceFrom;
        irsg.scene.settings = settings;
        RenderedImage rendered = irsg.imageWithReport();
        Sums sums;
        sums.atmosphereError = rendered.report.all.atmosphereError;
        const std::vector<float>& ranges = rendered.image.channel("range", "m").values;
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            if (std::isnan(ranges[i])) {
                continue;
            }
            const auto range_m = static_cast<double>(ranges[i]);
            sums.nearest_m = std::min(sums.nearest_m, range_m);
            sums.farthest_m = std::max(sums.farthest_m, range_m);
            sums.found += static_cast<double>(rendered.image.primary().values[i]);
            sums.exact += black * std::exp(-perMetre * range_m);
        }
        return sums;
    };
    const Sums sliced = sumsWith(RenderSettings().atmosphereSliceFrom);
    EXPECT_GT(sliced.farthest_m - sliced.nearest_m, 80.0);
    EXPECT_LT(sliced.wrong(), 5e-3);
    EXPECT_LE(sliced.wrong(), sliced.atmosphereError);
    const Sums whole = sumsWith(1e9);
    EXPECT_GT(whole.wrong(), 5e-3);
    EXPECT_LE(whole.wrong(), whole.atmosphereError);
}

// Views that share a path ask for its air once.
TEST(AtmosphereOfASweep, IsAskedOnceForAPathThatItsCasesShare) {
    class CountingAtmosphere : public ConstantAtmosphere {
      public:
        mutable long asked = 0;

      protected:
        Spectrum nativeSpectrum(const AtmosphericQuery& query,
                                const SpectralRange& range) const override {
            ++asked;
            return ConstantAtmosphere::nativeSpectrum(query, range);
        }
    };
    auto air = std::make_shared<CountingAtmosphere>();
    Environment environment;
    environment.add(air);
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environment;
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 16, 32, body)), greyDatabase(0.9, 320.0))};
    look(irsg, {.range_m = 100.0});
    irsg.measure();
    const long first = air->asked;
    EXPECT_GT(first, 0);
    for (int i = 1; i < 12; ++i) {
        look(irsg, {.range_m = 100.0, .azimuth_rad = 0.5 * i});
        irsg.measure();
    }
    EXPECT_EQ(air->asked, first) << "of the azimuth nothing of this air depends";
    look(irsg, {.range_m = 101.0});
    irsg.measure();
    EXPECT_GT(air->asked, first);
}
