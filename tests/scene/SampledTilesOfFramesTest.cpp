#include <gtest/gtest.h>

#include <cmath>

#include "irsg/image/SampledTiles.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr int frame_px = 64;
constexpr double pixel_rad = 1e-4;

Entity sphere(const std::string& name, double x_m) {
    Entity entity = entityOf(modelOf(sphereMesh(1.0, 24, 48, {1, 1})), greyDatabase(0.9, 320.0));
    entity.name = name;
    entity.pose.position_m.x += x_m;
    return entity;
}

/// The tiles that a frame of 64 pixels tells of, in which 2 m are `size_px` wide.
std::vector<SampledTile> tilesIn(const std::vector<Entity>& entities, double size_px,
                                 const std::function<void(RenderSettings&)>& change = {}) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    RenderSettings settings = RenderSettings::direct();
    settings.background = BackgroundMode::constant;
    if (change) {
        change(settings);
    }
    irsg.scene.settings = settings;
    irsg.scene.entities = entities;
    irsg.scene.entities[0].pose = {{entities[0].pose.position_m}, {}};
    look(irsg, {.range_m = 2.0 / (size_px * pixel_rad),
                .width_px = frame_px,
                .height_px = frame_px,
                .fieldOfView_rad = 2.0 * std::atan(0.5 * frame_px * pixel_rad)});
    const RenderedImage frame = irsg.imageWithReport();
    EXPECT_EQ(tilesOf(frame.image).size(), frame.report.tiles.size());
    return frame.report.tiles;
}

/// That a tile holds a ball in the middle of the frame, and little more.
void expectAround(const SampledTile& tile, double diameter_px, double margin_px) {
    const double middle_px = 0.5 * frame_px, radius_px = 0.5 * diameter_px;
    for (const double low : {tile.left_px, tile.top_px}) {
        EXPECT_LE(low, middle_px - radius_px);
        EXPECT_GE(low, middle_px - radius_px - margin_px);
    }
    for (const double high : {tile.right_px, tile.bottom_px}) {
        EXPECT_GE(high, middle_px + radius_px);
        EXPECT_LE(high, middle_px + radius_px + margin_px);
    }
}

} // namespace

TEST(TilesOfAFrame, LieCloselyAroundAnObjectOfAnySize) {
    for (const double size_px : {40.3, 3.1, 0.2}) {
        const auto tiles = tilesIn({sphere("ball", 0.0)}, size_px);
        ASSERT_EQ(tiles.size(), 1u) << size_px;
        expectAround(tiles[0], size_px, std::min(0.15 * size_px + 0.01, 1.5));
        // 256 samples over the object or nearly so, all in all.
        EXPECT_NEAR(std::sqrt(tiles[0].across * tiles[0].down) * size_px, 215.0, 40.0);
        EXPECT_EQ(tiles[0].objects, "ball");
    }
}

TEST(TilesOfAFrame, AreSharedByObjectsThatOverlap) {
    const auto together = tilesIn({sphere("near", 0.0), sphere("far", 1.2)}, 10.0);
    ASSERT_EQ(together.size(), 1u);
    EXPECT_EQ(together[0].objects, "near, far");
    EXPECT_NEAR(together[0].right_px - together[0].left_px, 16.0, 2.5);
    const auto apart = tilesIn({sphere("near", 0.0), sphere("far", 4.0)}, 10.0);
    ASSERT_EQ(apart.size(), 2u);
    EXPECT_EQ(apart[0].objects, "near");
    EXPECT_EQ(apart[1].objects, "far");
}

TEST(TilesOfAFrame, OfAPointHaveNoSamples) {
    const auto tiles = tilesIn({sphere("ball", 0.0)}, 0.01);
    ASSERT_EQ(tiles.size(), 1u);
    EXPECT_EQ(tiles[0].across, 0.0);
    EXPECT_NEAR(tiles[0].right_px - tiles[0].left_px, 0.01, 1e-3);
    EXPECT_EQ(tiles[0].objects, "ball");
}

TEST(TilesOfAFrame, TellTheSamplesOfAModeAndThePublishedSquare) {
    const auto supersampled = tilesIn({sphere("ball", 0.0)}, 10.0, [](RenderSettings& settings) {
        settings.tileSide_samples = 0;
        settings.samplesPerAxis = 4;
    });
    ASSERT_EQ(supersampled.size(), 1u);
    EXPECT_EQ(supersampled[0].across, 4.0);
    EXPECT_EQ(supersampled[0].down, 4.0);

    const auto published = tilesIn({sphere("ball", 0.0)}, 10.0, [](RenderSettings& settings) {
        settings.tileStrategy = TileStrategy::published;
    });
    ASSERT_EQ(published.size(), 1u);
    expectAround(published[0], 16.0, 1.5); // the next power of two
    EXPECT_EQ(published[0].across, 16.0);  // 256 / 16
}

TEST(TilesOfAFrame, OfHotSpotsFollowTheTileThatLeavesThemOut) {
    Triangles mesh = plateMesh({}, {0, 0, 0.5}, {1.0, 0, 0}, {1, 1});
    mesh = joined(mesh, plateMesh({0.4, 1e-3, 0.0}, {0, 0, 0.05}, {0.002, 0, 0}, {2, 1}));
    SignatureDatabase database;
    database.materials[1] = greyMaterial(1.0);
    database.temperatures[1] = fixedTemperature(290.0);
    database.temperatures[2] = fixedTemperature(900.0);
    const auto tiles = tilesIn({entityOf(modelOf(mesh), std::move(database))}, 20.0);
    ASSERT_GT(tiles.size(), 1u);
    const SampledTile &whole = tiles.front(), &part = tiles.back();
    EXPECT_GT(part.across, 2.0 * whole.across);
    EXPECT_GT(part.left_px, whole.left_px);
    EXPECT_LT(part.right_px, whole.right_px);
    // Wherever the part is seen: left or right of the middle, as the camera stands.
    EXPECT_NEAR(std::abs(0.5 * (part.left_px + part.right_px) - 0.5 * frame_px), 4.0, 0.3);
}
