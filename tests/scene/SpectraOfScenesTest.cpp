#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

const IrCodes one{1, 1};
const Band midwave = Band::topHat(3.0, 5.0);

/// Air whose transmittance falls with range as one exponential a wavelength: 3-4 um clear, 4-5 um
/// not.
class TwoBandAtmosphere : public ConstantAtmosphere {
  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query,
                            const SpectralRange& range) const override {
        if (query.quantity != AtmosphereProperty::transmittance) {
            return ConstantAtmosphere::nativeSpectrum(query, range);
        }
        const double t = std::exp(-1e-3 * query.path.range_m);
        return Spectrum({0.2, 4.0, 4.0001, 40.0}, {1.0, 1.0, t, t});
    }
};

/// Air whose lines are saturated: exp(-sqrt(range / km)) beyond 4 um.
class SaturatedAtmosphere : public ConstantAtmosphere {
  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query,
                            const SpectralRange& range) const override {
        if (query.quantity != AtmosphereProperty::transmittance) {
            return ConstantAtmosphere::nativeSpectrum(query, range);
        }
        const double t = std::exp(-std::sqrt(1e-3 * query.path.range_m));
        return Spectrum({0.2, 4.0, 4.0001, 40.0}, {1.0, 1.0, t, t});
    }
};

/// Tables of air over exactly these ranges, which pass half and add 2 W m-2 sr-1 um-1 along
/// horizontal paths.
Environment tabulatedAtmosphere(const std::vector<SpectralRange>& ranges) {
    Environment environment;
    for (const SpectralRange& range : ranges) {
        std::vector<SpectralRun> runs;
        for (const AtmosphericPath& path :
             {AtmosphericPath{1000.0, 1000.0, 100.0}, AtmosphericPath{1000.0, 1000.0, 200.0}}) {
            SpectralRun run;
            run.source = "table";
            run.kind = RunKind::thermalRadiance;
            run.geometry.sensorAltitude_m = path.sensorAltitude_m;
            run.geometry.targetAltitude_m = path.targetAltitude_m;
            run.geometry.range_m = path.range_m;
            for (int i = 0; i <= 10; ++i) {
                run.wavenumbers_per_cm.push_back(
                    std::lerp(wavenumberFromWavelength_per_cm(range.max_um),
                              wavenumberFromWavelength_per_cm(range.min_um), i / 10.0));
            }
            run.transmittance.assign(11, 0.5);
            run.pathRadiance_W_m2_sr_um.assign(11, 2.0);
            run.totalRadiance_W_m2_sr_um.assign(11, 3.0);
            runs.push_back(run);
        }
        environment.add(std::make_shared<TabulatedAtmosphere>(runs, "table"));
    }
    return environment;
}

SignatureDatabase gasDatabase(double referenceDistance_m) {
    SignatureDatabase database = greyDatabase(1.0, 300.0);
    TemperatureEntry& entry = database.temperatures[1];
    entry.mode = EmissionMode::userSpectrum;
    entry.userSpectrum = "gas";
    ComponentFactor factor;
    factor.component = "CO2";
    factor.constant = 2.0;
    factor.angle = LookupTable({0.0, 180.0}, {1.0, 3.0});
    entry.factors = {factor};
    database.spectra["gas"] = {
        "gas",
        referenceDistance_m,
        "W m-2 sr-1 um-1",
        "",
        {{"CO2", Spectrum({4.1, 4.3, 4.6}, {0.0, 10.0, 0.0}, Spectrum::Outside::zero)},
         {"H2O", Spectrum({3.0, 5.0}, {0.5, 0.5}, Spectrum::Outside::zero)}}};
    return database;
}

double centreRadiance(InteractiveRenderer& irsg) {
    const RadianceImage image = irsg.imageWithReport().image;
    return static_cast<double>(image.at(image.width() / 2, image.height() / 2));
}

} // namespace

TEST(IntensitySpectrumOfASphere, IsPlancksLawTimesItsArea) {
    const Triangles mesh = sphereMesh(1.0, 64, 128, one);
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.entities = {entityOf(modelOf(mesh), greyDatabase(0.9, 450.0))};
    look(irsg, {.range_m = 1000.0, .width_px = 200, .height_px = 200, .fieldOfView_rad = 0.0024});
    const std::vector<double> wavenumbers_per_cm{2000.0, 3333.0, 2500.0, 2100.5};
    const IntensitySpectrum spectrum = irsg.measureSpectrum(wavenumbers_per_cm);

    EXPECT_EQ(spectrum.wavenumbers_per_cm, wavenumbers_per_cm) << "in the order that was asked for";
    const Vec3 from = irsg.view.viewpoint.position_m - irsg.referencePoint(0);
    const double area_m2 = convexSolidAngle_sr(mesh, from) * dot(from, from);
    for (std::size_t i = 0; i < wavenumbers_per_cm.size(); ++i) {
        const double expected =
            0.9 * planckRadiance_W_m2_sr_um(1e4 / wavenumbers_per_cm[i], 450.0) * area_m2;
        EXPECT_NEAR(spectrum.intensity_W_sr_um[i] / expected, 1.0, 1e-3);
        EXPECT_NEAR(spectrum.intensity_W_sr_um[i] / spectrum.intensity_W_sr_um[0],
                    planckRadiance_W_m2_sr_um(1e4 / wavenumbers_per_cm[i], 450.0) /
                        planckRadiance_W_m2_sr_um(5.0, 450.0),
                    1e-9);
    }
}

TEST(IntensitySpectrumOfAScene, IntegratesToItsInBandIntensity) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    auto air = std::make_shared<TwoBandAtmosphere>();
    air->sunValue = 2.0;
    Environment environment;
    environment.add(air);
    irsg.scene.environment = environment;
    irsg.scene.entities = {entityOf(modelOf(boxMesh({1, 2, 1}, std::vector<IrCodes>(6, one))),
                                    greyDatabase(0.7, 330.0))};
    look(irsg, {.azimuth_rad = 0.4, .fieldOfView_rad = 0.08});
    std::vector<double> wavelengths_um, wavenumbers_per_cm;
    for (int i = 0; i <= 4000; ++i) {
        wavelengths_um.push_back(3.0 + i * 2.0 / 4000.0);
        wavenumbers_per_cm.push_back(1e4 / wavelengths_um.back());
    }
    const IntensitySpectrum spectrum = irsg.measureSpectrum(wavenumbers_per_cm);
    double integral = 0.0;
    for (std::size_t i = 1; i < wavelengths_um.size(); ++i) {
        integral +=
            0.5 *
            (spectrum.contrastIntensity_W_sr_um[i] + spectrum.contrastIntensity_W_sr_um[i - 1]) *
            (wavelengths_um[i] - wavelengths_um[i - 1]);
    }
    EXPECT_NEAR(integral / irsg.measure().all.contrastIntensity_W_sr, 1.0, 1e-4);
}

TEST(IntensitySpectrumOfAScene, ReachesTheEndsOfATable) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 32, 64, one)), greyDatabase(0.9, 450.0))};
    for (const SpectralRange range : {SpectralRange{3.0, 5.0}, SpectralRange{8.0, 12.0}}) {
        look(irsg, {.band = Band::topHat(range.min_um, range.max_um)});
        RenderSettings settings = irsg.scene.settings;
        settings.sun = settings.ambientReflection = ReflectionMode::off;
        settings.background = BackgroundMode::constant;
        settings.background_W_m2_sr = 0.0;
        irsg.scene.settings = settings;

        std::vector<double> wavenumbers_per_cm;
        for (int i = 0; i <= 40; ++i) {
            wavenumbers_per_cm.push_back(
                wavenumberFromWavelength_per_cm(std::lerp(range.max_um, range.min_um, i / 40.0)));
        }
        wavenumbers_per_cm.front() = 1e4 / range.max_um;
        wavenumbers_per_cm.back() = 1e4 / range.min_um;
        irsg.scene.environment = Environment::vacuum();
        const IntensitySpectrum bare = irsg.measureSpectrum(wavenumbers_per_cm);
        irsg.scene.environment = tabulatedAtmosphere({range});
        const IntensitySpectrum all = irsg.measureSpectrum(wavenumbers_per_cm);
        const double area_m2 =
            bare.intensity_W_sr_um[0] / (0.9 * planckRadiance_W_m2_sr_um(range.max_um, 450.0));
        for (std::size_t i = 0; i < wavenumbers_per_cm.size(); ++i) {
            EXPECT_NEAR(all.intensity_W_sr_um[i] /
                            (0.5 * bare.intensity_W_sr_um[i] + 2.0 * area_m2),
                        1.0, 1e-6)
                << wavenumbers_per_cm[i];
        }

        // One wavelength is a spectrum, too: at both ends and between.
        for (const std::size_t i :
             {std::size_t{0}, std::size_t{17}, wavenumbers_per_cm.size() - 1}) {
            EXPECT_NEAR(irsg.measureSpectrum({wavenumbers_per_cm[i]}).intensity_W_sr_um.at(0) /
                            all.intensity_W_sr_um[i],
                        1.0, 1e-6);
        }

        // What lies beyond the end by more than rounding is refused as before.
        EXPECT_THROW(irsg.measureSpectrum({1e4 / (range.max_um * (1.0 + 1e-6))}), InputError);
        EXPECT_THROW(irsg.measureSpectrum({1e4 / (range.min_um * (1.0 - 1e-6))}), InputError);
    }
}

TEST(IntensitySpectrumOfAScene, MayEndWhereTwoTablesMeet) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 32, 64, one)), greyDatabase(0.9, 450.0))};
    look(irsg, {.band = Band::topHat(3.0, 4.0)});
    RenderSettings settings = irsg.scene.settings;
    settings.sun = settings.ambientReflection = ReflectionMode::off;
    settings.background = BackgroundMode::constant;
    irsg.scene.settings = settings;
    irsg.scene.environment = tabulatedAtmosphere({{3.0, 4.0}, {4.0, 5.0}});
    const double first = irsg.measureSpectrum({3000.0}).intensity_W_sr_um.at(0);
    EXPECT_GT(irsg.measureSpectrum({2500.0}).intensity_W_sr_um.at(0), first);
    EXPECT_GT(irsg.measureSpectrum({2500.0, 2000.0}).intensity_W_sr_um.at(1), first);
}

TEST(UserSpectrum, AddsItsComponentsWithTheirFactors) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.entities = {entityOf(modelOf(sphereMesh(1.0, 32, 64, one)), gasDatabase(0.0))};
    // CO2 is a triangle of area 2.5, H2O a constant of area 1; the aspect angle is the azimuth
    // here.
    for (double azimuth_deg : {0.0, 45.0, 90.0, 180.0}) {
        look(irsg, {.azimuth_rad = radians(azimuth_deg)});
        const double expected = 2.0 * (1.0 + azimuth_deg / 90.0) * 2.5 + 1.0;
        EXPECT_NEAR(centreRadiance(irsg) / expected, 1.0, 1e-6) << azimuth_deg;
    }
}

TEST(UserSpectrum, IsCalibratedAsAWhole) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    SignatureDatabase database = gasDatabase(0.0);
    for (const double calibration : {1.0, 0.8, 1.25, 0.0}) {
        database.spectra["gas"].calibrationFactor = calibration;
        irsg.scene.entities = {entityOf(modelOf(sphereMesh(1.0, 32, 64, one)), database)};
        for (const double azimuth_deg : {0.0, 90.0}) {
            look(irsg, {.azimuth_rad = radians(azimuth_deg)});
            const double expected = calibration * (2.0 * (1.0 + azimuth_deg / 90.0) * 2.5 + 1.0);
            EXPECT_NEAR(centreRadiance(irsg), expected, 1e-5) << azimuth_deg;
        }
    }
}

TEST(UserSpectrum, LosesTheAirBeyondItsReferenceDistanceOnly) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    Environment environment;
    environment.add(std::make_shared<TwoBandAtmosphere>());
    irsg.scene.environment = environment;
    auto radianceAt = [&](double range_m, double reference_m) {
        irsg.scene.entities = {
            entityOf(modelOf(sphereMesh(1.0, 32, 64, one)), gasDatabase(reference_m))};
        look(irsg, {.range_m = range_m, .fieldOfView_rad = 1.0 / range_m});
        return centreRadiance(irsg);
    };
    const double clear = 2.0 * 2.5 + 1.0;            // nothing lost
    const double inFoulAtmosphere = 2.0 * 2.5 + 0.5; // CO2 all in 4-5 um, half of H2O
    EXPECT_NEAR(radianceAt(400.0, 500.0), clear, 1e-5) << "nearer than the reference distance";
    EXPECT_NEAR(radianceAt(500.0, 500.0), clear, 1e-5);
    EXPECT_NEAR(radianceAt(1500.0, 500.0), 0.5 + inFoulAtmosphere * std::exp(-1.0), 1e-3);
    EXPECT_NEAR(radianceAt(1500.0, 0.0), 0.5 + inFoulAtmosphere * std::exp(-1.5), 1e-3);
}

TEST(UserSpectrum, PassesARatioOrTheSegmentThatIsLeft) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    Environment environment;
    environment.add(std::make_shared<SaturatedAtmosphere>());
    irsg.scene.environment = environment;
    irsg.scene.entities = {entityOf(modelOf(sphereMesh(1.0, 32, 64, one)), gasDatabase(500.0))};
    look(irsg, {.range_m = 1500.0, .fieldOfView_rad = 1.0 / 1500.0});
    const double inFoulAtmosphere = 2.0 * 2.5 + 0.5; // CO2 all in 4-5 um, half of H2O
    const std::vector<std::pair<ReferenceTransmittance, double>> expected = {
        {ReferenceTransmittance::ratio, std::exp(-(std::sqrt(1.5) - std::sqrt(0.5)))},
        {ReferenceTransmittance::segment, std::exp(-std::sqrt(1.0))},
        {ReferenceTransmittance::ratio, std::exp(-(std::sqrt(1.5) - std::sqrt(0.5)))}};
    for (const auto& [rule, transmittance] : expected) {
        RenderSettings settings = irsg.scene.settings;
        settings.referenceTransmittance = rule;
        irsg.scene.settings = settings;
        EXPECT_NEAR(centreRadiance(irsg), 0.5 + inFoulAtmosphere * transmittance, 1e-3);
    }
}

TEST(UserSpectrum, SaysWhenItIsSeenFromNearerThanItWasMeasured) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.entities = {entityOf(modelOf(sphereMesh(1.0, 16, 32, one)), gasDatabase(500.0))};
    look(irsg, {.range_m = 100.0});
    const RenderReport report = irsg.measure();
    ASSERT_EQ(report.warnings.size(), 1u);
    EXPECT_NE(report.warnings[0].find("gas"), std::string::npos);
}

TEST(ProjectedGeometryOfAScene, MultiplySpectrallyWhatAScalarCannot) {
    // A filter that passes 3-4 um only before a body at 400 K and another at 300 K.
    SignatureDatabase database = greyDatabase(1.0, 400.0);
    database.temperatures[2] = fixedTemperature(1.0);
    database.materials[2] = greyMaterial(0.0);
    database.materials[2].transmissivity =
        Spectrum({3.0, 4.0, 4.000001, 5.0}, {1.0, 1.0, 0.0, 0.0});
    const Triangles mesh = joined(plateMesh({0, 0, 0}, {0.5, 0, 0}, {0, 0, 0.5}, one),
                                  plateMesh({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {2, 2}));
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.entities = {entityOf(modelOf(mesh), database)};
    look(irsg, {.range_m = 200.0, .fieldOfView_rad = 0.02});
    const RenderReport report = irsg.measure();
    const double exact = bandRadiance_W_m2_sr(Band::topHat(3.0, 4.0), 400.0);
    const double area_m2 = 1.0;
    EXPECT_NEAR(report.all.intensity_W_sr / (exact * area_m2), 1.0, 2e-2)
        << "edges fall on samples";

    // The image multiplies at every wavelength, too (trap T10).
    EXPECT_NEAR(centreRadiance(irsg), exact, 1e-4 * exact);
}

TEST(ProjectedGeometryOfAScene, AreKeptWhileOnlySignaturesChange) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 32, 64, one)), greyDatabase(0.9, 320.0))};
    look(irsg, {});
    auto drawings = [&] {
        for (const StageTimes::Stage& stage : irsg.stageTimes().stages) {
            if (stage.name == "drawing") {
                return stage.calls;
            }
        }
        return 0L;
    };
    const double before = irsg.measure().all.intensity_W_sr;
    const long drawn = drawings();
    irsg.scene.entities[0].database =
        std::make_shared<const SignatureDatabase>(greyDatabase(0.3, 320.0));
    EXPECT_NEAR(irsg.measure().all.intensity_W_sr / before, 1.0 / 3.0, 1e-12);
    EXPECT_EQ(drawings(), drawn) << "another emissivity is a dot product";
    irsg.scene.entities[0].database =
        std::make_shared<const SignatureDatabase>(greyDatabase(0.3, 320.0, 1.0));
    irsg.measure();
    EXPECT_EQ(drawings(), drawn + 1) << "another N is another drawing";
    look(irsg, {.azimuth_rad = 0.1});
    irsg.measure();
    EXPECT_EQ(drawings(), drawn + 2) << "and so is another view";
}

TEST(TruthLayersOfAnImage, AddUpToItsRadianceAndNameTheSurfaces) {
    ConstantAtmosphere air;
    air.transmittanceValue = 0.7;
    air.pathRadianceValue = 0.1;
    air.backgroundValue = 0.3;
    air.sunValue = 2.0;
    air.upValue = 1.0;
    air.downValue = 0.5;
    SignatureDatabase database = greyDatabase(0.6, 320.0);
    database.temperatures[7] = fixedTemperature(350.0);
    database.materials[9] = greyMaterial(0.2, 0.5);
    const Triangles mesh =
        joined(sphereMesh(1.0, 32, 64, one), plateMesh({0, 2, 0}, {0.5, 0, 0}, {0, 0, 2}, {7, 9}));
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(air);
    RenderSettings settings = RenderSettings::direct();
    settings.truthLayers = true;
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = 3;
    irsg.scene.settings = settings;
    irsg.scene.entities = {entityOf(modelOf(mesh), database)};
    look(irsg, {.range_m = 100.0, .width_px = 65, .height_px = 65, .fieldOfView_rad = 0.05});
    const RadianceImage image = irsg.imageWithReport().image;

    const std::vector<float>& radiance = image.primary().values;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        double sum = 0.0;
        for (const char* term : {"thermal", "sun", "up", "down", "path", "background"}) {
            sum += static_cast<double>(image.find(term)->values[i]);
        }
        EXPECT_NEAR(sum, static_cast<double>(radiance[i]), 2e-6 * sum);
    }
    const std::size_t centre = image.offset(32, 32);
    EXPECT_EQ(image.find("temperature_index")->values[centre], 7.0f);
    EXPECT_EQ(image.find("material_index")->values[centre], 9.0f);
    EXPECT_NEAR(image.find("range")->values[centre], 98.0, 1e-4);
    const std::size_t side = image.offset(32 + 10, 32);
    EXPECT_EQ(image.find("temperature_index")->values[side], 1.0f);
    EXPECT_TRUE(std::isnan(image.find("range")->values[0]));
}

TEST(StageTimesOfAnImage, NameEveryStageThatTookTime) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 32, 64, one)), greyDatabase(0.9, 320.0))};
    look(irsg, {});
    irsg.imageWithReport();
    std::vector<std::string> names;
    for (const StageTimes::Stage& stage : irsg.stageTimes().stages) {
        names.push_back(stage.name);
        EXPECT_GE(stage.seconds, 0.0);
        EXPECT_EQ(stage.calls, 1) << stage.name;
    }
    for (const char* expected :
         {"radiometry", "drawing", "read back", "layer sorting", "reduction", "composition"}) {
        EXPECT_TRUE(std::ranges::find(names, expected) != names.end()) << expected;
    }
    irsg.resetStageTimes();
    EXPECT_TRUE(irsg.stageTimes().stages.empty());
}

TEST(SeveralEntities, AreMeasuredEachAndTogether) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    const auto sphere = modelOf(sphereMesh(1.0, 32, 64, one));
    Entity first = entityOf(sphere, greyDatabase(0.9, 320.0));
    Entity second = entityOf(sphere, greyDatabase(0.9, 350.0));
    first.name = "first";
    second.name = "second";
    second.pose.position_m.x += 3.0;
    irsg.scene.entities = {first, second};
    look(irsg, {.range_m = 200.0, .width_px = 128, .height_px = 64});
    const RenderReport report = irsg.imageWithReport().report;
    ASSERT_EQ(report.objects.size(), 2u);
    EXPECT_NEAR(report.objects[1].intensity_W_sr / report.objects[0].intensity_W_sr,
                bandRadiance_W_m2_sr(midwave, 350.0) / bandRadiance_W_m2_sr(midwave, 320.0), 5e-3);
    EXPECT_NEAR((report.objects[0].irradiance_W_m2 + report.objects[1].irradiance_W_m2) /
                    report.all.irradiance_W_m2,
                1.0, 1e-5);
}
