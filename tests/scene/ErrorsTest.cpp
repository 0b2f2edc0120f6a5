// The errors that sums come with: contrasts of interleaved lattices, and what they say of scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "irsg/radiance/RangeGeometry.h"
#include "irsg/radiance/ViewGeometry.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/RandomScenes.h"
#include "tests/support/RaysTest.h"
#include "tests/support/SampleAircraft.h"
#include "tests/support/SceneFixtures.h"
#include "tests/support/WidebandScenes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

/// Samples of a tile of one surface, which is seen where `isSeen` says of row and column.
GeometrySamples samplesOf(const SampleTile& tile, const std::function<bool(int, int)>& isSeen) {
    GeometrySamples samples;
    samples.width = tile.width();
    samples.height = tile.height();
    samples.factorCount = 3;
    for (int row = samples.height - 1; row >= 0; --row) {
        for (int column = 0; column < samples.width; ++column) {
            const float code = isSeen(row, column) ? 1.0F : 0.0F;
            samples.opaque.insert(samples.opaque.end(), {code, 0.5F * code, 0.0F, 0.0F});
        }
    }
    return samples;
}

SampleTile sampleTileOf(int shearRows) {
    SampleTile tile;
    tile.blockX = tile.blockY = 4;
    tile.blocksWide = tile.blocksHigh = 8;
    tile.samplesAcross = 7;
    tile.samplesDown = 6;
    tile.shearRows = shearRows;
    tile.entities = {0};
    return tile;
}

ViewGeometry sumsOf(const SampleTile& tile, const GeometrySamples& samples,
                    bool withSublatticeDifferences) {
    const Sensor sensor = sensorOf(16, 16, 0.01);
    const SurfaceRows rows({{0, {1, 1}}}, {false}, {{}});
    OccluderStacks occluderStacks;
    GeometrySums sums(sensor, rows, occluderStacks, 3, {}, nullptr, withSublatticeDifferences);
    ViewGeometry view = sums.emptyView();
    sums.addToView(tile, samples, view);
    return view;
}

/// In samples.
double coverageOf(const ViewGeometry& view, const SampleTile& tile) {
    double pixels = 0.0;
    view.field.forEach(0, [&](std::size_t, std::span<const double> numbers) {
        pixels += numbers[view.layout.pixels()];
    });
    return pixels / tile.share();
}

double contrastOf(const ViewGeometry& view, const SampleTile& tile) {
    double sum = 0.0;
    for (const ViewGeometry& contrast : view.sublatticeDifferences) {
        sum += std::pow(coverageOf(contrast, tile), 2);
    }
    return std::sqrt(sum);
}

RenderReport measured(InteractiveRenderer& irsg, bool errors, bool alongRange = false) {
    return irsg.begin(Outputs::reports().alongRange(alongRange).withErrors(errors))
        .get()
        .reports.front();
}

class ErrorsOfExchange : public RaysTest {};

} // namespace

TEST(SublatticeDifferencesOfViews, AreNothingWhereAllSamplesSeeTheSame) {
    for (const int shearRows : {0, 5, 16}) {
        SampleTile tile = sampleTileOf(shearRows);
        const GeometrySamples samples = samplesOf(tile, [](int, int) { return true; });
        EXPECT_LT(contrastOf(sumsOf(tile, samples, true), tile), 1e-9) << shearRows;
        // Parts left to finer tiles, of odd numbers of cells.
        const double side = tile.cellWidth_px(), high = tile.cellHeight_px();
        tile.leftOut = {{6.0, 6.0, 6.0 + 5 * side, 6.0 + 7 * high},
                        {9.0, 9.0, 9.0 + 6 * side, 9.0 + 2 * high}};
        EXPECT_LT(contrastOf(sumsOf(tile, samples, true), tile), 1e-9) << shearRows;
        tile.only = ImageRectangle{4.3, 4.4, 11.7, 11.2};
        EXPECT_LT(contrastOf(sumsOf(tile, samples, true), tile), 1e-9) << shearRows;
    }
}

TEST(SublatticeDifferencesOfViews, OfALevelEdgeAreHalfARowWhateverItsPhase) {
    const SampleTile tile = sampleTileOf(0);
    for (int edge = 13; edge < 29; ++edge) {
        const GeometrySamples samples = samplesOf(tile, [&](int row, int) { return row >= edge; });
        const double rows = contrastOf(sumsOf(tile, samples, true), tile) / tile.width();
        // At a border of two parts it is of neither, or of both.
        EXPECT_TRUE((rows > 0.49 && rows < 0.75) || edge % 6 == 0) << edge << ": " << rows;
    }
}

TEST(SublatticeDifferencesOfViews, LeaveTheSumsAsTheyAre) {
    SampleTile tile = sampleTileOf(16);
    tile.leftOut = {{6.0, 6.0, 7.0, 7.0}};
    const GeometrySamples samples =
        samplesOf(tile, [](int row, int column) { return row + 2 * column > 40 && column < 44; });
    const double plain = coverageOf(sumsOf(tile, samples, false), tile);
    EXPECT_GT(plain, 500.0);
    EXPECT_NEAR(coverageOf(sumsOf(tile, samples, true), tile), plain, 1e-9 * plain);
    EXPECT_TRUE(sumsOf(tile, samples, false).sublatticeDifferences.empty());
}

TEST(RangeGeometry, KnowThatParabolasAreInterpolatedExactlyAndCubicsAreNot) {
    for (const double nearness : {1e-4, 0.01, 0.02, 0.04, 0.06}) {
        double sum = 0.0, square = 0.0, cube = 0.0, mean = 0.0;
        for (const auto& [node, weight] : RangeGeometry::errorWeightsAt(nearness)) {
            const double at = RangeGeometry::nodes[node];
            sum += weight, square += weight * at * at, cube += weight * at * at * at;
        }
        for (const auto& [node, weight] : RangeGeometry::weightsAt(nearness)) {
            mean += weight * std::pow(RangeGeometry::nodes[node], 3);
        }
        EXPECT_NEAR(sum, 0.0, 1e-12) << nearness;
        EXPECT_NEAR(square, 0.0, 1e-14) << nearness;
        EXPECT_NEAR(cube, std::pow(nearness, 3) - mean, 1e-15) << nearness;
    }
}

TEST(ErrorsOfScenes, CoverWhatIsWrong) {
    // bench_errors has 200 of them.
    Renderer renderer;
    int covered = 0, count = 0;
    std::vector<double> ratios;
    for (unsigned number = 400; number < 412; ++number) {
        const RandomScene scene = randomScene(number, number % 4 == 3 ? RandomAtmosphere::spectral
                                                                      : RandomAtmosphere::none);
        for (const JudgedNumber& one : judged(renderer, scene)) {
            ++count;
            covered += one.isCovered() ? 1 : 0;
            ratios.push_back(one.error.sum() / std::max(one.wrong(), 1e-300));
            EXPECT_GT(one.error.sampling, 0.0) << scene.name;
            EXPECT_LT(one.wrong(), 4.0 * one.error.sum()) << scene.name;
        }
    }
    EXPECT_GE(covered, count - 2);
    std::ranges::nth_element(ratios, ratios.begin() + 12);
    EXPECT_LT(ratios[12], 8.0);
    EXPECT_GT(ratios[12], 1.5);
}

TEST(ErrorsOfScenes, AreThoseOfTheScatterOfARangeCurve) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = Environment::vacuum();
    irsg.scene.entities = {sampleAircraft()};
    for (const bool alongRange : {true, false}) {
        double sum = 0.0, squares = 0.0, errors = 0.0;
        constexpr int count = 15;
        for (int i = 0; i < count; ++i) {
            look(irsg, {.range_m = 3000.0 + 500.0 * i,
                        .azimuth_rad = radians(60.0),
                        .width_px = 320,
                        .height_px = 256,
                        .fieldOfView_rad = radians(2.0)});
            const ObjectRadiometry all = measured(irsg, true, alongRange).all;
            sum += all.intensity_W_sr;
            squares += all.intensity_W_sr * all.intensity_W_sr;
            errors += all.errors->intensity_W_sr.sum();
        }
        const double mean = sum / count;
        const double scatter = std::sqrt(std::max(squares / count - mean * mean, 0.0));
        EXPECT_LT(scatter, errors / count) << alongRange;
        EXPECT_LT(errors / count, 0.02 * mean) << alongRange;
    }
}

TEST(ErrorsOfScenes, OfLevelEdgesAreNotThoseOfEverySecondRow) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = Environment::vacuum();
    irsg.scene.settings.sun = irsg.scene.settings.ambientReflection = ReflectionMode::off;
    irsg.scene.entities = {
        entityOf(modelOf(boxMesh({20.0, 1.0, 0.8}, std::vector<IrCodes>(6, IrCodes{1, 1}))),
                 greyDatabase(0.9, 300.0))};
    constexpr int count = 12;
    int covered = 0;
    double stated = 0.0;
    for (int i = 0; i < count; ++i) {
        look(irsg, {.range_m = 800.0 + 37.0 * i,
                    .azimuth_rad = radians(2.0 + 0.3 * i),
                    .width_px = 320,
                    .height_px = 256,
                    .fieldOfView_rad = radians(3.0)});
        irsg.scene.settings.tileSide_samples = 256;
        const ObjectRadiometry own = measured(irsg, true).all;
        irsg.scene.settings.tileSide_samples = 2048;
        const double truth = measured(irsg, false).all.intensity_W_sr;
        covered += std::abs(own.intensity_W_sr - truth) <= own.errors->intensity_W_sr.sum() ? 1 : 0;
        stated += own.errors->intensity_W_sr.sum() / truth / count;
    }
    EXPECT_GE(covered, count - 1);
    EXPECT_LT(stated, 0.01);
}

TEST(ErrorsOfScenes, OfLobesAreLargerInWhatLobesSendAlone) {
    struct Ball {
        const char* model;
        double roughness, emissivity, temperature_K, sun;
    };
    struct Stated {
        double mean = 0.0; // of the intensity
        int covered = 0;
    };
    constexpr int count = 16;
    const auto statedOf = [](const Ball& ball) {
        SignatureDatabase database = greyDatabase(ball.emissivity, ball.temperature_K);
        database.materials[1].surfaceModel = ball.model;
        database.materials[1].roughness = ball.roughness;
        ConstantAtmosphere air;
        air.sunValue = ball.sun;
        InteractiveRenderer irsg{RenderSettings::direct()};
        irsg.scene.environment = environmentOf(air, {0.7, 0.3});
        irsg.scene.settings.ambientReflection = ReflectionMode::off;
        irsg.scene.settings.background = BackgroundMode::none;
        irsg.scene.entities = {entityOf(modelOf(sphereMesh(1.0, 96, 192, {1, 1})), database)};
        Stated stated;
        for (int i = 0; i < count; ++i) {
            look(irsg, {.range_m = 3000.0 + 41.0 * i,
                        .elevation_rad = 0.3,
                        .width_px = 64,
                        .height_px = 64,
                        .fieldOfView_rad = 0.002});
            irsg.scene.settings.tileSide_samples = 128;
            const ObjectRadiometry own = measured(irsg, true).all;
            irsg.scene.settings.tileSide_samples = 1024;
            const double truth = measured(irsg, false).all.intensity_W_sr;
            stated.mean += own.errors->intensity_W_sr.sampling / truth / count;
            stated.covered +=
                std::abs(own.intensity_W_sr - truth) <= own.errors->intensity_W_sr.sampling ? 1 : 0;
        }
        return stated;
    };
    // Paint that is warm sends nearly all of it as if it were Lambertian.
    const Stated plain = statedOf({"", 0.0, 0.9, 300.0, 0.0}),
                 painted = statedOf({"ggx", 0.3, 0.9, 300.0, 0.0}),
                 glint = statedOf({"ggx", 0.3, 0.1, 2.0, 1.0});
    std::printf("  stated: Lambertian %.2e, painted %.2e, glint %.2e\n", plain.mean, painted.mean,
                glint.mean);
    EXPECT_NEAR(painted.mean / plain.mean, 1.0, 0.3);
    for (const Stated& one : {plain, painted, glint}) {
        EXPECT_GE(one.covered, count - 1);
    }
}

TEST(ErrorsOfScenes, AreOfferedOnRequestAndChangeNoNumber) {
    const RandomScene scene = randomScene(403, RandomAtmosphere::none);
    Renderer renderer;
    const auto reportOf = [&](bool image, bool errors) {
        const Outputs outputs = image ? Outputs(Outputs::imageWithReports().withErrors(errors))
                                      : Outputs::reports().withErrors(errors);
        return renderer.render(scene.scene, scene.view, outputs).reports.front();
    };
    for (const bool image : {false, true}) {
        const RenderReport plain = reportOf(image, false), with = reportOf(image, true);
        EXPECT_FALSE(plain.all.errors);
        ASSERT_TRUE(with.all.errors);
        ASSERT_TRUE(with.objects.front().errors);
        EXPECT_NEAR(with.all.intensity_W_sr, plain.all.intensity_W_sr,
                    1e-12 * plain.all.intensity_W_sr);
        EXPECT_GT(with.all.errors->intensity_W_sr.sampling, 0.0);
        // Of one object the sum is its own.
        EXPECT_NEAR(with.objects.front().errors->irradiance_W_m2.sum(),
                    with.all.errors->irradiance_W_m2.sum(),
                    1e-12 * with.all.errors->irradiance_W_m2.sum());
    }
}

TEST(ErrorsOfScenes, OfASpectrumAreThoseOfItsBand) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = Environment::vacuum();
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(5.0, 24, 48, {1, 1})), greyDatabase(0.9, 290.0))};
    // What it emits has the same outline at every wavelength, what it reflects has not.
    RenderSettings settings = irsg.scene.settings;
    settings.sun = settings.ambientReflection = ReflectionMode::off;
    irsg.scene.settings = settings;
    look(irsg, {.range_m = 3000.0, .fieldOfView_rad = 0.06});
    const std::vector<double> wavenumbers_per_cm = {3000.0, 2000.0, 2500.0};
    EXPECT_TRUE(irsg.measureSpectrum(wavenumbers_per_cm).errors.empty());
    irsg.scene.settings.errors = true;
    const IntensitySpectrum grey = irsg.measureSpectrum(wavenumbers_per_cm);
    const ObjectRadiometry band = measured(irsg, true).all;
    ASSERT_EQ(grey.errors.size(), 3U);
    const double part = band.errors->intensity_W_sr.sampling / band.intensity_W_sr;
    EXPECT_GT(part, 1e-5);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(grey.errors[i].intensity_W_sr.sampling, part * grey.intensity_W_sr_um[i],
                    1e-9 * grey.intensity_W_sr_um[i]);
        EXPECT_EQ(grey.errors[i].intensity_W_sr.air, 0.0);
    }
    // Of air and what lies behind: what the wavenumbers of a band have adds to that of the band.
    irsg.scene.environment = environmentOf(smartAtmosphere(6));
    look(irsg, {.range_m = 300.0, .fieldOfView_rad = 0.06});
    const RenderReport report = measured(irsg, true);
    std::vector<double> fine_per_cm;
    constexpr double step_um = 0.005;
    for (double wavelength_um = 3.0 + 0.5 * step_um; wavelength_um < 5.0;
         wavelength_um += step_um) {
        fine_per_cm.push_back(1e4 / wavelength_um);
    }
    const IntensitySpectrum spectrum = irsg.measureSpectrum(fine_per_cm);
    double sampling = 0.0, background = 0.0, intensity = 0.0;
    for (std::size_t i = 0; i < fine_per_cm.size(); ++i) {
        intensity += step_um * spectrum.intensity_W_sr_um[i];
        sampling += step_um * spectrum.errors[i].intensity_W_sr.sampling;
        background += step_um * spectrum.errors[i].contrastIntensity_W_sr.background;
    }
    const RadiometryErrors& errors = *report.all.errors;
    EXPECT_NEAR(intensity, report.all.intensity_W_sr, 0.01 * report.all.intensity_W_sr);
    EXPECT_NEAR(sampling, errors.intensity_W_sr.sampling, 0.02 * sampling);
    EXPECT_GT(background, 0.9 * errors.contrastIntensity_W_sr.background);
    EXPECT_LT(background, 1.5 * errors.contrastIntensity_W_sr.background);
}

TEST(ErrorsOfScenes, OfTheBackgroundAreThoseOfAHorizonBehindTheObject) {
    // Seen level from its own height, with the horizon behind its lower part.
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(smartAtmosphere(6));
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(5.0, 24, 48, {1, 1})), greyDatabase(0.9, 290.0))};
    look(irsg, {.range_m = 300.0, .fieldOfView_rad = 0.06});
    const ObjectRadiometry rough = measured(irsg, true).all;
    RenderSettings settings = irsg.scene.settings;
    settings.backgroundRows = 65;
    irsg.scene.settings = settings;
    const ObjectRadiometry fine = measured(irsg, true).all;
    const double wrong = std::abs(rough.contrastIntensity_W_sr - fine.contrastIntensity_W_sr);
    EXPECT_GT(wrong, 0.0);
    EXPECT_GE(rough.errors->contrastIntensity_W_sr.sum(), wrong);
    EXPECT_LT(fine.errors->contrastIntensity_W_sr.background,
              0.5 * rough.errors->contrastIntensity_W_sr.background);
}

TEST_F(ErrorsOfExchange, ArePartOfWhatItChanges) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    // Whoever looks, plates that cross are seen with others before them.
    const Triangles cross = joined(plateMesh({}, {1, 0, 0}, {0, 0.7, 0.7}, {1, 1}),
                                   plateMesh({}, {1, 0, 0}, {0, 0.7, -0.7}, {1, 1}));
    irsg.scene.entities = {entityOf(modelOf(cross), greyDatabase(0.5, 400.0))};
    irsg.scene.settings.ambientReflection = ReflectionMode::off;
    irsg.scene.settings.bounces = convergedBounces;
    look(irsg, {.range_m = 300.0, .fieldOfView_rad = 0.03});
    const ObjectRadiometry with = measured(irsg, true).all;
    irsg.scene.settings.bounces = 0;
    const ObjectRadiometry without = measured(irsg, true).all;
    const double changed = with.intensity_W_sr - without.intensity_W_sr;
    EXPECT_GT(changed, 0.01 * without.intensity_W_sr);
    EXPECT_EQ(without.errors->intensity_W_sr.exchange, 0.0);
    EXPECT_GT(with.errors->intensity_W_sr.exchange, 0.0);
    EXPECT_LT(with.errors->intensity_W_sr.exchange, 0.2 * changed);
    EXPECT_NEAR(with.errors->irradiance_W_m2.exchange,
                with.errors->intensity_W_sr.exchange / (300.0 * 300.0),
                1e-2 * with.errors->irradiance_W_m2.exchange);
    // Less of it where less is asked for.
    irsg.scene.settings.bounces = convergedBounces;
    irsg.scene.settings.lightError = 0.1 * RenderSettings{}.lightError;
    const ObjectRadiometry finer = measured(irsg, true).all;
    EXPECT_LT(finer.errors->intensity_W_sr.exchange, 0.5 * with.errors->intensity_W_sr.exchange);
    // Of a single convex body there is nothing.
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 24, 48, {1, 1})), greyDatabase(0.5, 400.0))};
    EXPECT_EQ(measured(irsg, true).all.errors->intensity_W_sr.exchange, 0.0);
}
