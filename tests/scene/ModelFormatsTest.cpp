#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osg/CullFace>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Image>
#include <osg/Material>
#include <osg/Texture2D>
#include <osgDB/WriteFile>

#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/reading/MaterialNames.h"
#include "tests/scene/PlacedPolygons.h"
#include "tests/support/FlightBytes.h"
#include "tests/support/ForeignModels.h"
#include "tests/support/GltfReference.h"
#include "tests/support/Refusal.h"

using namespace irsg;
using namespace irsg::test;
using smat::test::refusalOf;
using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

void expectAsReference(const fs::path& file) {
    const auto expected = readGltfReference(file);
    const auto loaded = load(file);
    const Placed placed(*loaded.node);
    EXPECT_NEAR(placed.area, expected.area, 1e-5 * expected.area) << file;
    const double size = (expected.bounds._max - expected.bounds._min).length();
    EXPECT_NEAR((placed.bounds._min - expected.bounds._min).length(), 0.0, 1e-5 * size) << file;
    EXPECT_NEAR((placed.bounds._max - expected.bounds._max).length(), 0.0, 1e-5 * size) << file;
    for (const auto& [name, area] : expected.areaOfMaterials) {
        const auto found = placed.areaOfMaterials.find(name);
        ASSERT_NE(found, placed.areaOfMaterials.end()) << file << " " << name;
        EXPECT_NEAR(found->second, area, 1e-5 * expected.area) << file << " " << name;
    }
}

} // namespace

TEST(ForeignFormats, GiveTheAreaTheNamesAndTheSharedPartsOfAGltf) {
    const TemporaryFolder folder;
    const GltfWriter gltf = smallAircraft();
    folder.write("numbers of it.bin", gltf.buffer());
    for (const auto& [name, bytes] : {std::pair<std::string, std::string>{"a.gltf", gltf.text()},
                                      {"b.gltf", gltf.text("numbers of it.bin")},
                                      {"c.gltf", gltf.text("numbers%20of%20it.bin")},
                                      {"A.GLB", gltf.binary()}}) {
        const auto file = folder.write(name, bytes);
        if (name != "c.gltf") {
            expectAsReference(file);
        }
        const auto loaded = load(file);
        EXPECT_THAT(loaded.remarks, testing::IsEmpty()) << name;
        const Placed placed(*loaded.node);
        EXPECT_NEAR(placed.area, 34.0, 1e-5);
        EXPECT_EQ(placed.drawables.size(), 2u) << "two engines are one mesh";
        EXPECT_THAT(placed.names, testing::IsSupersetOf({std::string("/wing/engine 1/engine mesh"),
                                                         std::string("/wing/engine 2/engine mesh"),
                                                         std::string("/hull/hull mesh")}));
        EXPECT_EQ(placed.areaOfMaterials.size(), 2u);
        EXPECT_NEAR(placed.areaOfMaterials.at("red paint"), 22.0, 1e-5);
        EXPECT_NEAR(placed.areaOfMaterials.at("blue"), 12.0, 1e-5);
        EXPECT_EQ(loaded.axes.unit_m, 1.0);
        EXPECT_EQ(loaded.axes.up, ModelAxis::plusY);
        EXPECT_EQ(loaded.axes.front, ModelAxis::plusZ);
        EXPECT_THAT(loaded.axes.reason, HasSubstr("glTF"));
        for (const auto* geometry : placed.drawables) {
            const auto& state = *geometry->getStateSet();
            const bool red = materialNameOf(state) == "red paint";
            const auto& material = dynamic_cast<const osg::Material&>(
                *state.getAttribute(osg::StateAttribute::MATERIAL));
            EXPECT_EQ(material.getName(), red ? "red paint" : "blue");
            EXPECT_EQ(material.getDiffuse(osg::Material::FRONT),
                      red ? osg::Vec4(1, 0.25f, 0, 1) : osg::Vec4(1, 1, 1, 1));
            EXPECT_EQ((state.getMode(GL_CULL_FACE) & osg::StateAttribute::ON) != 0, !red)
                << "one is double-sided, the other is not";
        }
    }
}

TEST(ForeignFormats, ReadEveryKindOfFacesOfAGltf) {
    const TemporaryFolder folder;
    const std::vector<osg::Vec3d> square = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {2, 3, 0}};
    const struct {
        const char* name;
        int mode, bytes;
        std::vector<unsigned int> indices;
        double area;
    } rows[] = {{"strip", 5, 1, {0, 1, 2, 3}, 6.0},
                {"strip without indices", 5, 0, {}, 6.0},
                {"fan", 6, 2, {0, 1, 3, 2}, 6.0},
                {"triangles", 4, 4, {0, 1, 2, 2, 1, 3}, 6.0},
                {"one triangle", 4, 1, {0, 1, 3}, 3.0}};
    for (const auto& row : rows) {
        GltfWriter gltf;
        nlohmann::json primitive = {{"attributes", {{"POSITION", gltf.positions(square)}}},
                                    {"mode", row.mode}};
        if (!row.indices.empty()) {
            primitive["indices"] = gltf.indices(row.indices, row.bytes);
        }
        gltf.node({{"mesh", gltf.mesh("m", primitive)}});
        const auto file = folder.write("a.gltf", gltf.text());
        expectAsReference(file);
        EXPECT_NEAR(Placed(*load(file).node).area, row.area, 1e-6) << row.name;
    }
}

TEST(ForeignFormats, KeepTheShapeOfAGltfFarFromTheOrigin) {
    const TemporaryFolder folder;
    GltfWriter gltf;
    const auto box =
        gltf.mesh("box", {{"attributes", {{"POSITION", gltf.positions(boxCorners(1, 1, 1))}}},
                          {"indices", gltf.indices(boxTriangles())}});
    gltf.node({{"name", "a"}, {"mesh", box}, {"translation", {4000000.1, 500000.2, 30.3}}});
    gltf.node({{"name", "b"}, {"mesh", box}, {"translation", {4000001.4, 500000.2, 30.3}}});
    const auto file = folder.write("a.gltf", gltf.text());
    expectAsReference(file);
    const Placed placed(*load(file).node);
    EXPECT_NEAR(placed.bounds._max.x() - placed.bounds._min.x(), 2.3, 1e-8);
}

TEST(ForeignFormats, ReadPicturesInAGltfAndBesideIt) {
    const TemporaryFolder folder;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2, 3, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (unsigned int i = 0; i < 24; ++i) {
        image->data()[i] = static_cast<unsigned char>(10 * i);
    }
    ASSERT_TRUE(osgDB::writeImageFile(*image, (folder / "a b.png").string()));
    const std::string png = readBytes(folder / "a b.png");
    for (const std::string& uri :
         {std::string("a%20b.png"), "data:image/png;base64," + base64(png)}) {
        GltfWriter gltf = smallAircraft();
        gltf.json["images"] = {{{"uri", uri}, {"mimeType", "image/png"}}};
        gltf.json["textures"] = {{{"source", 0}}};
        gltf.json["materials"][1] = {
            {"name", "glass"},
            {"alphaMode", "MASK"},
            {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}};
        const auto loaded = load(folder.write("a.gltf", gltf.text()));
        EXPECT_THAT(loaded.remarks, testing::IsEmpty()) << uri;
        int found = 0;
        for (const auto* geometry : Placed(*loaded.node).drawables) {
            const auto* texture = dynamic_cast<const osg::Texture2D*>(
                geometry->getStateSet()->getTextureAttribute(0, osg::StateAttribute::TEXTURE));
            if (!texture) {
                continue;
            }
            ++found;
            ASSERT_TRUE(texture->getImage());
            EXPECT_EQ(texture->getImage()->s(), 2);
            EXPECT_EQ(texture->getImage()->t(), 3);
            EXPECT_EQ(texture->getImage()->getPixelFormat(), static_cast<GLenum>(GL_RGBA))
                << "with its alpha";
        }
        EXPECT_EQ(found, 1);
    }
}

TEST(ForeignFormats, OpenNothingButWhatIsListed) {
    const TemporaryFolder folder;
    const GltfWriter gltf = smallAircraft();
    folder.write("a.lua", gltf.buffer());
    for (const char* name : {"http://host/a.bin", "a.lua", "/etc/passwd", "file:///etc/passwd"}) {
        EXPECT_THAT(refusalOf([&] { load(folder.write("a.gltf", gltf.text(name))); }),
                    AllOf(HasSubstr("buffers.0.uri"), HasSubstr("of type .bin")))
            << name;
    }
    EXPECT_THAT(refusalOf([&] { load(folder.write("a.gltf", gltf.text("none.bin"))); }),
                HasSubstr("none.bin, which is missing"));
    for (const char* name : {"http://host/a.png", "a.lua", "/etc/passwd", "none.png"}) {
        GltfWriter painted = smallAircraft();
        painted.json["images"] = {{{"uri", name}}};
        painted.json["textures"] = {{{"source", 0}}};
        painted.json["materials"][1]["pbrMetallicRoughness"] = {
            {"baseColorTexture", {{"index", 0}}}};
        EXPECT_THAT(
            load(folder.write("a.gltf", painted.text())).remarks,
            Contains(AllOf(HasSubstr(name), AnyOf(HasSubstr("not opened"), HasSubstr("missing")))));
    }
}

TEST(ForeignFormats, TellAxesAndUnitOfAnFbxAndTurnNothing) {
    const TemporaryFolder folder;
    const struct {
        double unit_cm;
        int axis, sign;
        ModelAxis up;
    } rows[] = {{1.0, 1, 1, ModelAxis::plusY},
                {100.0, 2, 1, ModelAxis::plusZ},
                {2.54, 0, 1, ModelAxis::plusX},
                {100.0, 2, -1, ModelAxis::minusZ}};
    for (const auto& row : rows) {
        FbxWriter fbx = fbxBox();
        fbx.unit_cm = row.unit_cm;
        fbx.upAxis = row.axis;
        fbx.upSign = row.sign;
        fbx.translation = {10, 20, 30};
        for (const std::string& bytes : {fbx.text(), fbx.binary()}) {
            const auto loaded = load(folder.write("a.fbx", bytes));
            EXPECT_THAT(loaded.remarks, testing::IsEmpty());
            ASSERT_TRUE(loaded.axes.unit_m);
            EXPECT_NEAR(*loaded.axes.unit_m, row.unit_cm / 100, 1e-9);
            EXPECT_EQ(loaded.axes.up, row.up);
            EXPECT_THAT(loaded.axes.reason,
                        AllOf(HasSubstr("UnitScaleFactor"), HasSubstr("UpAxis")));
            const Placed placed(*loaded.node);
            EXPECT_NEAR(placed.area, 22.0, 1e-5);
            EXPECT_NEAR((placed.bounds._min - osg::Vec3d(10, 20, 30)).length(), 0.0, 1e-5);
            EXPECT_NEAR((placed.bounds._max - osg::Vec3d(11, 22, 33)).length(), 0.0, 1e-5);
            EXPECT_EQ(placed.polygons, 6);
            EXPECT_NEAR(placed.areaOfMaterials.at("red paint"), 22.0, 1e-5);
            EXPECT_THAT(placed.names, Contains(HasSubstr("/hull")));
        }
    }
}

TEST(ForeignFormats, TellAxesAndUnitOfAColladaAndTurnNothing) {
    const TemporaryFolder folder;
    ColladaWriter collada = colladaBox();
    collada.copies = 3;
    const auto loaded = load(folder.write("a.dae", collada.text()));
    EXPECT_THAT(loaded.remarks, testing::IsEmpty());
    EXPECT_EQ(loaded.axes.unit_m, 0.0254);
    EXPECT_EQ(loaded.axes.up, ModelAxis::plusZ);
    EXPECT_THAT(loaded.axes.reason, AllOf(HasSubstr("0.0254 m"), HasSubstr("Z_UP")));
    const Placed placed(*loaded.node);
    EXPECT_NEAR(placed.area, 66.0, 1e-5);
    EXPECT_NEAR((placed.bounds._max - osg::Vec3d(21, 2, 3)).length(), 0.0, 1e-5);
    EXPECT_EQ(placed.drawables.size(), 1u) << "three copies are one mesh";
    EXPECT_EQ(placed.polygons, 18);
    EXPECT_EQ(placed.areaOfMaterials.count("red paint"), 1u);
    EXPECT_THAT(placed.names, Contains(HasSubstr("hull 2")));

    collada.unit = collada.up = "";
    const auto silent = load(folder.write("b.dae", collada.text()));
    EXPECT_EQ(silent.axes, FileAxes{});
}

TEST(ForeignFormats, CutPolygonsOfManyCornersRightly) {
    const TemporaryFolder folder;
    // An L, an arrow of four corners that is not convex, and a circle of 40 corners.
    auto corners = cornersOfL();
    std::vector<std::vector<std::int32_t>> polygons = {{0, 1, 2, 3, 4, 5}, {6, 7, 8, 9}, {}};
    for (const auto& corner : {osg::Vec3d(0, 0, 5), {4, 2, 5}, {0, 4, 5}, {2, 2, 5}}) {
        corners.push_back(corner);
    }
    for (int i = 0; i < 40; ++i) {
        polygons[2].push_back(static_cast<std::int32_t>(corners.size()));
        corners.emplace_back(std::cos(i * M_PI / 20), std::sin(i * M_PI / 20), 9);
    }
    const double area = 3.0 + 4.0 + 20 * std::sin(M_PI / 20);
    FbxWriter fbx;
    ColladaWriter collada;
    fbx.corners = collada.corners = corners;
    fbx.polygons = collada.polygons = polygons;
    for (const auto& [name, bytes] : {std::pair<std::string, std::string>{"a.fbx", fbx.text()},
                                      {"b.fbx", fbx.binary()},
                                      {"a.dae", collada.text()}}) {
        EXPECT_NEAR(Placed(*load(folder.write(name, bytes)).node).area, area, 1e-5) << name;
    }
}

/// Files that others wrote: SMAT_GLTF_MODELS names a folder of them.
TEST(ForeignFormats, ReadWhatOthersWroteAsAnIndependentReaderDoes) {
    const char* folder = std::getenv("SMAT_GLTF_MODELS");
    if (!folder) {
        GTEST_SKIP() << "SMAT_GLTF_MODELS names no folder";
    }
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (const auto type = entry.path().extension(); type == ".gltf" || type == ".glb") {
            std::printf("%s\n", entry.path().filename().c_str());
            EXPECT_EQ(refusalOf([&] { expectAsReference(entry.path()); }), "nothing was refused");
        }
    }
}
