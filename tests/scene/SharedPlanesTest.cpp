// Faces of different codes in one plane: the order in the file decides, in both engines.
#include <chrono>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/geometry/model/ModelUse.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/render/rays/RayMesh.h"
#include "tests/support/ModelAccess.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

/// A rectangle in a tilted plane, from (x, y) to (X, Y) of that plane.
osg::ref_ptr<osg::Geode> tile(double x, double y, double X, double Y, IrCodes codes,
                              double above = 0.0, bool isTurned = false) {
    const osg::Vec3d u(0.8, 0.0, -0.6), v(0.36, 0.8, 0.48), w = u ^ v;
    std::vector<osg::Vec3> corners;
    for (const auto& [a, b] : {std::pair{x, y}, {X, y}, {X, Y}, {x, Y}}) {
        corners.emplace_back(u * a + v * b + w * above);
    }
    if (isTurned) {
        std::ranges::reverse(corners);
    }
    return polygon(corners, codes);
}

std::shared_ptr<const Model> modelOfTiles(const std::vector<osg::ref_ptr<osg::Geode>>& tiles) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    for (const auto& geode : tiles) {
        group->addChild(geode);
    }
    return modelOfGraph(group, "tiles");
}

double intensity(const std::shared_ptr<const Model>& model, EngineChoice engine,
                 double azimuth_rad) {
    auto database = greyDatabase(1.0, 300.0);
    database.temperatures[2] = fixedTemperature(500.0);
    database.temperatures[3] = fixedTemperature(900.0);
    InteractiveRenderer irsg{RenderSettings::direct()};
    RenderSettings settings = RenderSettings::direct();
    settings.engine = engine;
    irsg.scene.settings = settings;
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.entities = {entityOf(model, database)};
    look(irsg, {.range_m = 1000.0, .azimuth_rad = azimuth_rad, .elevation_rad = 0.9});
    return irsg.measure().all.intensity_W_sr;
}

} // namespace

TEST(SharedPlanes, ShowWhatComesFirstInTheFileInBothEngines) {
    // A plate of 3 m with two plates over parts of it, of which one reaches over the other. Cut
    // differently, so that the depths of neither are those of the others.
    const auto big = tile(-1.5, -1.5, 1.5, 1.5, {2, 1}), left = tile(-1.0, -0.9, 0.3, 0.8, {1, 1}),
               right = tile(-0.2, -0.5, 1.1, 0.7, {3, 1});
    struct Row {
        const char* name;
        std::vector<osg::ref_ptr<osg::Geode>> order;
        double areas_m2[3]; ///< of codes 1, 2, 3 that are seen
    };
    const double both = 0.5 * 1.2, ofLeft = 1.3 * 1.7, ofRight = 1.3 * 1.2;
    const Row rows[] = {
        {"big last", {left, right, big}, {ofLeft, 9 - ofLeft - ofRight + both, ofRight - both}},
        {"big last, right first",
         {right, left, big},
         {ofLeft - both, 9 - ofLeft - ofRight + both, ofRight}},
        {"big first", {big, left, right}, {0, 9, 0}},
        {"big between", {right, big, left}, {0, 9 - ofRight, ofRight}},
    };
    const auto band = Band::topHat(3.0, 5.0);
    const double radiances[3] = {bandRadiance_W_m2_sr(band, 300.0),
                                 bandRadiance_W_m2_sr(band, 500.0),
                                 bandRadiance_W_m2_sr(band, 900.0)};
    for (const Row& row : rows) {
        const auto model = modelOfTiles(row.order);
        for (const double azimuth_rad : {0.3, 1.7}) {
            const Vec3 to{std::cos(0.9) * std::sin(azimuth_rad),
                          std::cos(0.9) * std::cos(azimuth_rad), std::sin(0.9)};
            const osg::Vec3d w = osg::Vec3d(0.8, 0, -0.6) ^ osg::Vec3d(0.36, 0.8, 0.48);
            double expected = 0.0;
            for (std::size_t i = 0; i < 3; ++i) {
                expected += row.areas_m2[i] * radiances[i];
            }
            expected *= std::abs(to.x * w.x() + to.y * w.y() + to.z * w.z());
            EXPECT_NEAR(intensity(model, EngineChoice::opengl, azimuth_rad) / expected, 1.0, 0.02)
                << row.name << ", OpenGL";
            if (areRaysBuilt()) {
                EXPECT_NEAR(intensity(model, EngineChoice::rays, azimuth_rad) / expected, 1.0, 0.02)
                    << row.name << ", rays";
            }
        }
    }
}

TEST(SharedPlanes, AreNamedWithCodesFacesAndArea) {
    const auto model = modelOfTiles(
        {tile(0, 0, 1, 1, {1, 1}), tile(0.5, 0, 2, 1, {2, 3}), tile(5, 5, 6, 6, {2, 3})});
    ASSERT_EQ(model->sharedPlanes().size(), 1U);
    const SharedPlane& shared = model->sharedPlanes().front();
    EXPECT_EQ(shared.drawn, (IrCodes{1, 1}));
    EXPECT_EQ(shared.hidden, (IrCodes{2, 3}));
    EXPECT_EQ(shared.faces, 1);
    EXPECT_NEAR(shared.area_m2, 0.5, 1e-5);
    EXPECT_THAT(model->remarks(), Contains(toText(shared)));
    const auto findings = lint(SignatureDatabase{}, {.models = {useOf(*model)}});
    EXPECT_TRUE(std::ranges::any_of(findings, [&](const Finding& finding) {
        return finding.value == toText(shared) && !finding.isError();
    }));
}

TEST(SharedPlanes, AreNoneWhereFacesOnlyTouchOrAreNeverSeenTogether) {
    // Neighbours, one code, one a millimetre above, and two walls that turn their backs.
    const auto culled = [](const osg::ref_ptr<osg::Geode>& geode) {
        geode->getOrCreateStateSet()->setMode(GL_CULL_FACE, osg::StateAttribute::ON);
        return geode;
    };
    const std::vector<std::vector<osg::ref_ptr<osg::Geode>>> models{
        {tile(0, 0, 1, 1, {1, 1}), tile(1, 0, 2, 1, {2, 1}), tile(0, 1, 2, 3, {3, 1})},
        {tile(0, 0, 1, 1, {1, 1}), tile(0, 0, 1, 1, {1, 1})},
        {tile(0, 0, 1, 1, {1, 1}), tile(0, 0, 1, 1, {2, 1}, 1e-3)},
        {culled(tile(0, 0, 1, 1, {1, 1})), culled(tile(0, 0, 1, 1, {2, 1}, 0.0, true))},
    };
    for (const auto& tiles : models) {
        EXPECT_THAT(modelOfTiles(tiles)->sharedPlanes(), IsEmpty());
    }
    // Of two walls that are seen from both sides one is in the way.
    EXPECT_EQ(modelOfTiles({tile(0, 0, 1, 1, {1, 1}), tile(0, 0, 1, 1, {2, 1}, 0.0, true)})
                  ->sharedPlanes()
                  .size(),
              1U);
}

TEST(SharedPlanes, AreFoundAmongManyNeighbours) {
    // A floor of 40000 fields of two codes, and one field of a third over four of them.
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(tile(10.5, 20.5, 11.5, 21.5, {3, 1}));
    for (int i = 0; i < 200; ++i) {
        for (int k = 0; k < 200; ++k) {
            group->addChild(tile(i, k, i + 1, k + 1, {1 + (i + k) % 2, 1}));
        }
    }
    const auto model = modelOfGraph(group, "floor");
    ASSERT_EQ(model->sharedPlanes().size(), 2U);
    for (const SharedPlane& shared : model->sharedPlanes()) {
        EXPECT_EQ(shared.drawn, (IrCodes{3, 1}));
        EXPECT_EQ(shared.faces, 2);
        EXPECT_NEAR(shared.area_m2, 0.5, 1e-3);
    }
}
