// Reports that are begun before others are finished are those of one call each, bit by bit.
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/render/opengl/GlEngine.h"
#include "irsg/render/opengl/TileStream.h"
#include "irsg/scene/InteractiveRenderer.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

/// A glass box around a body and a plate, of which the body's light is measured and falls from the
/// nose to the tail.
SignatureDatabase measuredBody() {
    SignatureDatabase database;
    database.temperatures[1].mode = EmissionMode::userSpectrum;
    database.temperatures[1].userSpectrum = "flame";
    database.temperatures[1].factors = {{"core", 1.0, {}, LookupTable({0, 180}, {2.0, 0.5})}};
    database.temperatures[2] = fixedTemperature(300.0);
    database.temperatures[3] = fixedTemperature(350.0);
    database.materials[1] = database.materials[2] = greyMaterial(0.8);
    database.materials[3] = greyMaterial(0.3, 0.6);
    UserSpectrum flame;
    flame.name = "flame";
    flame.components = {{"core", Spectrum({2.0, 4.0, 6.0}, {0.0, 100.0, 0.0})}};
    database.spectra["flame"] = flame;
    return database;
}

void aim(InteractiveRenderer& irsg, double azimuth_rad) {
    look(irsg, {.range_m = 80.0, .azimuth_rad = azimuth_rad, .elevation_rad = 0.1});
}

InteractiveRenderer glazedBody() {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = brightAtmosphere();
    irsg.scene.entities = {entityOf(modelOf(glazedMesh()), measuredBody())};
    return irsg;
}

auto numbersOf(const std::vector<RenderReport>& reports) {
    const ObjectRadiometry& all = reports.front().all;
    return std::tuple{all.intensity_W_sr, all.contrastIntensity_W_sr, all.irradiance_W_m2,
                      all.coveredPixels, reports.front().totalIrradiance_W_m2};
}

constexpr std::array azimuths_rad{0.0, 0.7, 1.9, 3.1};

} // namespace

TEST(BegunReports, AreThoseOfOneCallEachInWhateverOrderTheyAreFinished) {
    std::vector<decltype(numbersOf({}))> expected;
    for (const double azimuth_rad : azimuths_rad) {
        InteractiveRenderer alone = glazedBody();
        aim(alone, azimuth_rad);
        expected.push_back(numbersOf(alone.measure(std::vector<Band>{})));
    }
    EXPECT_NE(std::get<0>(expected[0]), std::get<0>(expected[1]));

    for (const auto& order : {std::array<std::size_t, 4>{0, 1, 2, 3}, {3, 1, 0, 2}}) {
        InteractiveRenderer irsg = glazedBody();
        std::vector<PendingRender> begun;
        for (const double azimuth_rad : azimuths_rad) {
            aim(irsg, azimuth_rad);
            begun.push_back(irsg.begin(Outputs::reports()));
        }
        for (const std::size_t i : order) {
            EXPECT_EQ(numbersOf(begun[i].get().reports), expected[i]) << i;
        }
    }
}

TEST(BegunReports, OfOneViewShareItsDrawing) {
    InteractiveRenderer irsg = glazedBody();
    aim(irsg, 0.4);
    PendingRender first = irsg.begin(Outputs::reports());
    EntityState hotter = irsg.scene.entities.front().state;
    hotter.time_s = 5.0;
    irsg.scene.entities[0].state = hotter;
    PendingRender second = irsg.begin(Outputs::reports({Band::topHat(3.5, 4.5)}));
    const auto ofSecond = numbersOf(second.get().reports);
    const auto ofFirst = numbersOf(first.get().reports);
    for (const StageTimes::Stage& stage : irsg.stageTimes().stages) {
        EXPECT_TRUE(stage.name != "factor sums" || stage.calls == 1);
    }

    InteractiveRenderer alone = glazedBody();
    aim(alone, 0.4);
    EXPECT_EQ(ofFirst, numbersOf(alone.measure(std::vector<Band>{})));
    alone.scene.entities[0].state = hotter;
    EXPECT_EQ(ofSecond, numbersOf(alone.measure(std::vector<Band>{Band::topHat(3.5, 4.5)})));
}

TEST(BegunReports, MayBeDroppedUnfinished) {
    InteractiveRenderer irsg = glazedBody();
    aim(irsg, 0.4);
    const auto expected = numbersOf(irsg.measure(std::vector<Band>{}));
    for (const double azimuth_rad : azimuths_rad) {
        aim(irsg, azimuth_rad);
        irsg.begin(Outputs::reports());
    }
    aim(irsg, 0.4);
    EXPECT_EQ(numbersOf(irsg.measure(std::vector<Band>{})), expected);
}

TEST(BegunReports, OfAPictureAreThoseOfASweepHoweverLarge) {
    RenderSettings settings = RenderSettings::direct();
    settings.tileSide_samples = 128;
    for (const double fieldOfView_deg : {60.0, 6.0}) { // a few dozen pixels, and most of the frame
        InteractiveRenderer irsg = glazedBody();
        irsg.scene.settings = settings;
        irsg.view.sensor = sensorOf(640, 512, fieldOfView_deg);
        aim(irsg, 0.7);
        const RenderedImage picture = irsg.imageWithReport();
        const ObjectRadiometry swept = irsg.measure().all;
        EXPECT_NEAR(picture.report.all.intensity_W_sr / swept.intensity_W_sr, 1.0, 1e-6);
        EXPECT_NEAR(picture.report.all.contrastIntensity_W_sr / swept.contrastIntensity_W_sr, 1.0,
                    1e-6);

        // The pixels themselves are sampled more finely.
        double above_W_m2_sr = 0.0;
        for (const float pixel : picture.image.primary().values) {
            above_W_m2_sr += static_cast<double>(pixel) - picture.report.background_W_m2_sr;
        }
        const double pitch = irsg.view.sensor.pixelPitch();
        const double ofPixels_W_sr = above_W_m2_sr * pitch * pitch * 80.0 * 80.0;
        EXPECT_NEAR(ofPixels_W_sr / swept.contrastIntensity_W_sr, 1.0, 0.01) << fieldOfView_deg;
    }
}

TEST(TileStream, TakesTilesInOrderAndStreamsOneAfterTheOther) {
    GlEngine engine;
    TileStream stream;
    std::vector<std::pair<int, std::size_t>> taken;
    std::vector<std::future<TileStream::Seconds>> all;
    for (int number = 0; number < 3; ++number) {
        TileStream::Work work;
        work.drawings = 5;
        work.draw = [](std::size_t tile, GeometrySamples& samples, TileStream::Seconds&) {
            samples.words.clear();
            samples.width = static_cast<int>(tile);
        };
        work.take = [&taken, number](std::size_t tile, const GeometrySamples& samples) {
            EXPECT_EQ(samples.width, static_cast<int>(tile));
            taken.emplace_back(number, tile);
        };
        all.push_back(stream.start(engine, std::move(work)));
    }
    for (auto& one : all) {
        one.get();
    }
    std::vector<std::pair<int, std::size_t>> expected;
    for (int number = 0; number < 3; ++number) {
        for (std::size_t tile = 0; tile < 5; ++tile) {
            expected.emplace_back(number, tile);
        }
    }
    EXPECT_EQ(taken, expected);
}

TEST(TileStream, TellsWhatFailedAndGoesOn) {
    GlEngine engine;
    TileStream stream;
    const auto streamThat = [&](bool failsInRendering, bool failsInTaking) {
        TileStream::Work work;
        work.drawings = 4;
        work.draw = [=](std::size_t tile, GeometrySamples&, TileStream::Seconds&) {
            if (failsInRendering && tile == 2) {
                throw std::runtime_error("drawing");
            }
        };
        work.take = [=](std::size_t tile, const GeometrySamples&) {
            if (failsInTaking && tile == 1) {
                throw std::runtime_error("taking");
            }
        };
        return stream.start(engine, std::move(work));
    };
    const auto failureOf = [](std::future<TileStream::Seconds> done) -> std::string {
        try {
            done.get();
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(failureOf(streamThat(true, false)), "drawing");
    EXPECT_EQ(failureOf(streamThat(false, true)), "taking");
    EXPECT_EQ(failureOf(streamThat(false, false)), "");
}
