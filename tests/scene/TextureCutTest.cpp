// What the alpha of a texture leaves of a face, in area and in what either engine draws.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osg/AlphaFunc>
#include <osg/TexMat>
#include <osg/Texture2D>
#include <osgDB/WriteFile>

#include "irsg/render/rays/RayMesh.h"
#include "tests/support/ModelAccess.h"
#include "tests/support/SceneFixtures.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using namespace irsg::test;
using smat::test::TemporaryFolder;
using testing::Contains;
using testing::HasSubstr;

namespace {

using Alpha = std::function<double(int, int)>;

osg::ref_ptr<osg::Image> pictureOf(int width, int height, const Alpha& alpha) {
    osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(width, height, 1, GL_RGBA, GL_FLOAT);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            auto* texel = reinterpret_cast<float*>(
                picture->data(static_cast<unsigned int>(column), static_cast<unsigned int>(row)));
            texel[0] = texel[1] = texel[2] = 0.5f;
            texel[3] = static_cast<float>(alpha(column, row));
        }
    }
    return picture;
}

/// A square of 2 m, front up, whose texture is laid `repeated` times over it, across and along.
osg::ref_ptr<osg::Geode> sheet(osg::Image* picture, osg::Texture::WrapMode wrap,
                               double repeated = 1.0) {
    auto geode = polygon(
        {osg::Vec3(-1, -1, 0), osg::Vec3(1, -1, 0), osg::Vec3(1, 1, 0), osg::Vec3(-1, 1, 0)},
        {1, 1});
    const auto most = static_cast<float>(repeated);
    osg::ref_ptr<osg::Vec2Array> places = new osg::Vec2Array;
    for (const auto& [s, t] : {std::pair{0.0f, 0.0f}, {most, 0.0f}, {most, most}, {0.0f, most}}) {
        places->push_back({s, t});
    }
    auto& geometry = *geode->getDrawable(0)->asGeometry();
    geometry.setTexCoordArray(0, places, osg::Array::BIND_PER_VERTEX);
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(picture);
    texture->setWrap(osg::Texture::WRAP_S, wrap);
    texture->setWrap(osg::Texture::WRAP_T, wrap);
    geode->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    return geode;
}

std::shared_ptr<const Model> cutModel(osg::Node* graph) {
    return modelOfGraph(graph, "sheet", {.cutsTextureAlpha = true});
}

double areaOf(const Model& model) {
    double area_m2 = 0.0;
    for (const auto& [codes, use] : model.codes()) {
        area_m2 += use.area_m2;
    }
    return area_m2;
}

/// Of 8 columns the first three leave the face out.
const Alpha threeColumns = [](int column, int) { return column < 3 ? 0.0 : 1.0; };

} // namespace

TEST(TextureCut, LeavesTheFaceBetweenTheMiddlesOfTexelsAtAHalf) {
    struct Row {
        const char* name;
        int width, height;
        Alpha alpha;
        osg::Texture::WrapMode wrap;
        double repeated, share;
    };
    const Row rows[] = {
        // Where a picture meets itself the edge lies between its last and its first column.
        {"step, repeated", 8, 4, threeColumns, osg::Texture::REPEAT, 1.0, 5.0 / 8},
        {"step, three times", 8, 4, threeColumns, osg::Texture::REPEAT, 3.0, 5.0 / 8},
        {"step, mirrored twice", 8, 4, threeColumns, osg::Texture::MIRROR, 2.0, 5.0 / 8},
        {"step, ends kept", 8, 4, threeColumns, osg::Texture::CLAMP_TO_EDGE, 1.0, 5.0 / 8},
        {"step, ends kept outside", 8, 4, threeColumns, osg::Texture::CLAMP_TO_EDGE, 4.0,
         1.0 - 3.0 / 32},
        // 0 to 1 over 9 columns reaches a half at the middle of the fifth.
        {"slope", 9, 2, [](int column, int) { return column / 8.0; }, osg::Texture::CLAMP_TO_EDGE,
         1.0, 0.5},
        // 0.25 in column 0, 1 in column 1: a half a third of the way.
        {"steep slope", 2, 2, [](int column, int) { return column == 0 ? 0.25 : 1.0; },
         osg::Texture::CLAMP_TO_EDGE, 1.0, 1.0 - (0.25 + 0.5 / 3.0)},
        {"all there", 4, 4, [](int, int) { return 0.5; }, osg::Texture::REPEAT, 1.0, 1.0},
        // A half on the way to a neighbour, a third to the mean of a cell: a sixth of each cell.
        {"one texel in a border of nothing", 1, 1, [](int, int) { return 1.0; },
         osg::Texture::CLAMP_TO_BORDER, 4.0, 4.0 / 6 / 16},
    };
    for (const Row& row : rows) {
        const auto model =
            cutModel(sheet(pictureOf(row.width, row.height, row.alpha), row.wrap, row.repeated));
        EXPECT_NEAR(areaOf(*model) / 4.0, row.share, 1e-6) << row.name;
    }
}

TEST(TextureCut, FollowsARoundEdge) {
    // A cone of alpha whose half is a circle of 20 texels of 64.
    const auto disc = [](int column, int row) {
        return 0.5 + 0.05 * (20.0 - std::hypot(column - 31.5, row - 31.5));
    };
    const auto model = cutModel(sheet(pictureOf(64, 64, disc), osg::Texture::REPEAT));
    const double radius_m = 20.0 * 2.0 / 64.0;
    EXPECT_NEAR(areaOf(*model) / (3.14159265358979 * radius_m * radius_m), 1.0, 2e-3);
    // Cuts keep the sides of a face and its normals.
    for (const Mesh::Part& part : model->mesh()->parts) {
        for (std::size_t t = 0; t < part.triangles.size() / 3; ++t) {
            ASSERT_GT(faceNormal(part, t).z(), 0.99f) << t;
        }
    }
}

TEST(TextureCut, HappensOnlyWhereItIsAskedFor) {
    const auto graph = sheet(pictureOf(8, 4, threeColumns), osg::Texture::REPEAT);
    const auto whole = modelOfGraph(graph, "sheet");
    EXPECT_EQ(areaOf(*whole), 4.0);
    EXPECT_EQ(whole->codes().at({1, 1}).faces, 1);
    EXPECT_THAT(cutModel(graph)->remarks(), Contains(HasSubstr("cut along the alpha")));

    // A file that says that alpha means nothing, one with its own threshold, and a turned texture.
    graph->getStateSet()->setMode(GL_ALPHA_TEST, osg::StateAttribute::OFF);
    EXPECT_EQ(areaOf(*cutModel(graph)), 4.0);
    graph->getStateSet()->setAttributeAndModes(new osg::AlphaFunc(osg::AlphaFunc::GEQUAL, 0.25f));
    // The threshold of a quarter lies a quarter of the way from column 2 to column 3, and as far
    // from column 7 to the first of the next picture.
    EXPECT_NEAR(areaOf(*cutModel(graph)) / 4.0, (5.0 + 0.5) / 8, 1e-6);
    graph->getStateSet()->removeAttribute(osg::StateAttribute::ALPHAFUNC);
    graph->getStateSet()->removeMode(GL_ALPHA_TEST);
    graph->getStateSet()->setTextureAttributeAndModes(
        0, new osg::TexMat(osg::Matrixd::translate(0.5, 0, 0)));
    const auto moved = cutModel(graph);
    EXPECT_NEAR(areaOf(*moved) / 4.0, 5.0 / 8, 1e-6);
    // Texels 3 to 8 from the left now begin at 7/8: what is left out is from 4/8 to 7/8.
    EXPECT_TRUE(std::ranges::any_of(partOf(*moved, 0).vertices, [](const Float3& p) {
        return std::abs(p[0] - 0.75f) < 1e-6f;
    }));
}

TEST(TextureCut, RefusesAFaceOverTooMuchOfATexture) {
    const auto model = [&] {
        cutModel(sheet(pictureOf(64, 64, threeColumns), osg::Texture::REPEAT, 1e4));
    };
    EXPECT_THAT(refusal(model), HasSubstr("texels"));
}

TEST(TextureCut, IsDrawnAlikeByOpenGlAndByRays) {
    const auto disc = [](int column, int row) {
        return 0.5 + 0.05 * (20.0 - std::hypot(column - 31.5, row - 31.5));
    };
    const auto model = cutModel(sheet(pictureOf(64, 64, disc), osg::Texture::REPEAT));
    const auto whole = modelOfGraph(sheet(pictureOf(64, 64, disc), osg::Texture::REPEAT), "whole");
    const auto intensity = [](const std::shared_ptr<const Model>& drawn, EngineChoice engine) {
        InteractiveRenderer irsg{RenderSettings::direct()};
        RenderSettings settings = RenderSettings::direct();
        settings.engine = engine;
        irsg.scene.settings = settings;
        irsg.scene.environment = environmentOf(ConstantAtmosphere{});
        irsg.scene.entities = {entityOf(drawn, greyDatabase(1.0, 400.0))};
        look(irsg, {.elevation_rad = 1.0});
        return irsg.measure().all.intensity_W_sr;
    };
    const double share = areaOf(*model) / 4.0;
    const double opengl = intensity(model, EngineChoice::opengl);
    EXPECT_NEAR(opengl / intensity(whole, EngineChoice::opengl), share, 2e-3 * share);
    if (!areRaysBuilt()) {
        GTEST_SKIP() << whyNoRays();
    }
    EXPECT_NEAR(intensity(model, EngineChoice::rays) / opengl, 1.0, 1e-3);
}

TEST(TextureCut, HoldsForFilesWhosePictureLiesBeside) {
    const TemporaryFolder folder;
    osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(8, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (unsigned int row = 0; row < 4; ++row) {
        for (unsigned int column = 0; column < 8; ++column) {
            picture->setColor(osg::Vec4(1, 1, 1, column < 3 ? 0.0f : 1.0f), column, row);
        }
    }
    ASSERT_TRUE(osgDB::writeImageFile(*picture, (folder / "fence.png").string()));
    std::ofstream(folder / "fence.mtl") << "newmtl fence\nmap_Kd fence.png\n";
    std::ofstream(folder / "fence.obj")
        << "mtllib fence.mtl\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
           "usemtl fence\nf 1/1 2/2 3/3 4/4\n";
    EXPECT_NEAR(areaOf(*Model::load(folder / "fence.obj")), 4.0, 1e-6);
    EXPECT_NEAR(areaOf(*Model::load(folder / "fence.obj", {.cutsTextureAlpha = true})), 2.5, 1e-6);
}
