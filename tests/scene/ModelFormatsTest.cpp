#include <cmath>
#include <cstdlib>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osg/CullFace>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Image>
#include <osg/Material>
#include <osg/NodeVisitor>
#include <osg/Texture2D>
#include <osgDB/WriteFile>

#include "irsg/scene/model/MaterialNames.h"
#include "irsg/scene/model/Model.h"
#include "irsg/scene/model/ModelLoader.h"
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

/// Every placed polygon of a loaded graph in the axes of the file.
class Placed : public osg::NodeVisitor {
  public:
    explicit Placed(osg::Node& graph) : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {
        graph.accept(*this);
    }
    void apply(osg::Drawable& drawable) override {
        auto* geometry = drawable.asGeometry();
        ASSERT_TRUE(geometry);
        const auto matrix = osg::computeLocalToWorld(getNodePath());
        drawables.insert(geometry);
        std::string name;
        for (const auto* node : getNodePath()) {
            if (!node->getName().empty() && !node->asDrawable()) {
                name += "/" + node->getName();
            }
        }
        names.insert(name);
        const auto* state = geometry->getStateSet();
        const std::string material = state ? materialNameOf(*state) : "";
        const auto& places = dynamic_cast<const osg::Vec3Array&>(*geometry->getVertexArray());
        for (unsigned int i = 0; i < geometry->getNumPrimitiveSets(); ++i) {
            const auto& set = *geometry->getPrimitiveSet(i);
            const unsigned int count = set.getMode() == GL_QUADS ? 4 : 3;
            for (unsigned int j = 0; j + count <= set.getNumIndices(); j += count) {
                ++polygons;
                for (unsigned int k = 2; k < count; ++k) {
                    const auto corner = [&](unsigned int at) {
                        return osg::Vec3d(places[set.index(j + at)]) * matrix;
                    };
                    const auto a = corner(0), b = corner(k - 1), c = corner(k);
                    area += 0.5 * ((b - a) ^ (c - a)).length();
                    areaOfMaterials[material] += 0.5 * ((b - a) ^ (c - a)).length();
                    for (const auto& each : {a, b, c}) {
                        bounds.expandBy(each);
                    }
                }
            }
        }
    }

    double area = 0.0;
    int polygons = 0;
    std::map<std::string, double> areaOfMaterials;
    osg::BoundingBoxd bounds;
    std::set<const osg::Geometry*> drawables;
    std::set<std::string> names;
};

LoadedGraph load(const fs::path& file) {
    return loadGraph(file, LoadPurpose::visible);
}

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

FbxWriter fbxBox() {
    FbxWriter fbx;
    fbx.corners = boxCorners(1, 2, 3);
    fbx.polygons = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                    {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return fbx;
}

ColladaWriter colladaBox() {
    const FbxWriter box = fbxBox();
    ColladaWriter collada;
    collada.corners = box.corners;
    collada.polygons = box.polygons;
    return collada;
}

struct Sample {
    std::string name, bytes;
    double area;
    int polygons;
};

std::vector<Sample> samples() {
    return {{"a.gltf", smallAircraft().text(), 34.0, 36},
            {"a.glb", smallAircraft().binary(), 34.0, 36},
            {"a.fbx", fbxBox().text(), 22.0, 6},
            {"b.fbx", fbxBox().binary(), 22.0, 6},
            {"a.dae", colladaBox().text(), 22.0, 6}};
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

TEST(ForeignFormats, RefuseAGltfThatDoesNotHoldTogether) {
    const TemporaryFolder folder;
    using Change = void (*)(nlohmann::json&);
    const struct {
        const char* name;
        Change change;
        const char* position;
    } rows[] = {
        {"version 1", [](auto& g) { g["asset"]["version"] = "1.0"; }, "asset.version"},
        {"a count beyond its view", [](auto& g) { g["accessors"][0]["count"] = 9; },
         "accessors.0.count"},
        {"a count below", [](auto& g) { g["accessors"][1]["count"] = 35; },
         "meshes.0.primitives.0"},
        {"a view beyond its buffer", [](auto& g) { g["bufferViews"][1]["byteLength"] = 4000; },
         "bufferViews.1.byteLength"},
        {"a node below itself", [](auto& g) { g["nodes"][2]["children"] = {1}; }, "nodes."},
        {"a mesh that is not there", [](auto& g) { g["nodes"][0]["mesh"] = 7; }, "nodes.0.mesh"},
        {"positions of another type", [](auto& g) { g["accessors"][0]["componentType"] = 5123; },
         "POSITION"},
        {"an extension", [](auto& g) { g["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
         "extensionsRequired.0"},
        {"perspective",
         [](auto& g) {
             g["nodes"][0]["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
         },
         "nodes.0.matrix"},
        {"no scene", [](auto& g) { g.erase("scenes"); }, "scenes"},
    };
    for (const auto& row : rows) {
        GltfWriter gltf = smallAircraft();
        row.change(gltf.json);
        EXPECT_THAT(refusalOf([&] { load(folder.write("a.gltf", gltf.text())); }),
                    HasSubstr(row.position))
            << row.name;
    }
    // An index that leads to no vertex.
    GltfWriter gltf;
    gltf.node({{"mesh",
                gltf.mesh("m", {{"attributes", {{"POSITION", gltf.positions(boxCorners(1, 1, 1))}}},
                                {"indices", gltf.indices({0, 1, 8})}})}});
    EXPECT_NE(refusalOf([&] { load(folder.write("a.gltf", gltf.text())); }), "nothing was refused");
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

TEST(ForeignFormats, RefuseFilesOfWhichLessWasRead) {
    const TemporaryFolder folder;
    auto collada = colladaBox().text();
    const auto replaced = [](std::string text, const std::string& what, const std::string& by) {
        const auto at = text.find(what);
        EXPECT_NE(at, text.npos) << what;
        return text.replace(at, what.size(), by);
    };
    for (const std::string& text :
         {replaced(collada, "<vcount>4 4", "<vcount>4 "), replaced(collada, "3 0 4 7 </p>", "</p>"),
          replaced(collada, "url=\"#mesh\"", "url=\"#mash\""),
          replaced(collada, "url=\"#mesh\"", "url=\"other.dae#mesh\"")}) {
        EXPECT_NE(refusalOf([&] { load(folder.write("a.dae", text)); }), "nothing was refused");
    }
    // A mesh that no node places, alone and beside another.
    EXPECT_THAT(refusalOf([&] {
                    load(folder.write("a.fbx", replaced(fbxBox().text(), "C: \"OO\", 100, 200",
                                                        "C: \"OO\", 101, 200")));
                }),
                HasSubstr("without polygons"));
    GltfWriter gltf = smallAircraft();
    gltf.json["nodes"][0].erase("mesh");
    gltf.json["nodes"][1]["children"] = {2};
    EXPECT_THAT(load(folder.write("a.gltf", gltf.text())).remarks,
                testing::ElementsAre("1 meshes are placed nowhere",
                                     "1 nodes belong to no scene that is shown"));
    gltf = smallAircraft();
    gltf.json["accessors"][1]["count"] = 30;
    gltf.json["nodes"][3]["meqh"] = 1;
    gltf.json["nodes"][3].erase("mesh");
    EXPECT_THAT(
        load(folder.write("a.gltf", gltf.text())).remarks,
        testing::UnorderedElementsAre("12 bytes of its buffers belong to nothing in the file",
                                      "nodes.3.meqh is no word of the format"));
}

TEST(ForeignFormats, RefuseCutFiles) {
    const TemporaryFolder folder;
    for (const auto& sample : samples()) {
        ASSERT_NEAR(Placed(*load(folder.write(sample.name, sample.bytes)).node).area, sample.area,
                    1e-4)
            << sample.name;
        // The foot of a binary .fbx holds nothing.
        const std::size_t size = sample.bytes.size() - (sample.name == "b.fbx" ? 173 : 2);
        for (std::size_t i = 1; i <= 12; ++i) {
            const auto cut = folder.write(sample.name, sample.bytes.substr(0, i * size / 13));
            EXPECT_NE(refusalOf([&] { load(cut); }), "nothing was refused")
                << sample.name << " cut at " << i << "/13";
        }
        const auto most = folder.write(sample.name, sample.bytes.substr(0, size * 4 / 5));
        EXPECT_NE(refusalOf([&] { load(most); }), "nothing was refused") << sample.name;
    }
    const GltfWriter gltf = smallAircraft();
    folder.write("a.bin", gltf.buffer().substr(0, gltf.buffer().size() * 4 / 5));
    EXPECT_THAT(refusalOf([&] { load(folder.write("c.gltf", gltf.text("a.bin"))); }),
                HasSubstr("buffers.0.byteLength"));
}

TEST(ForeignFormats, LoseNothingInSilenceOfDamagedFiles) {
    const TemporaryFolder folder;
    const char* given = std::getenv("SMAT_MUTANTS");
    const int count = given ? std::atoi(given) : 20;
    std::mt19937 random(7);
    std::map<std::string, std::map<std::string, int>> results;
    for (const auto& sample : samples()) {
        for (int i = 0; i < count; ++i) {
            std::string bytes = sample.bytes;
            const auto at = random() % bytes.size();
            switch (random() % 4) {
            case 0:
                bytes[at] = static_cast<char>(random());
                break;
            case 1:
                bytes.erase(at, 1 + random() % 40);
                break;
            case 2:
                bytes.insert(at, bytes.substr(random() % bytes.size(), 1 + random() % 40));
                break;
            default:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
            }
            const auto file = folder.write(sample.name, bytes);
            auto& result = results[sample.name];
            try {
                const auto loaded = load(file);
                const Placed placed(*loaded.node);
                const bool whole = std::isfinite(placed.area) && placed.polygons >= sample.polygons;
                ++result[whole ? "read" : loaded.remarks.empty() ? "silent" : "remarked"];
                EXPECT_TRUE(whole || !loaded.remarks.empty())
                    << sample.name << ", mutant " << i << ": " << placed.polygons << " polygons";
            } catch (const InputError& error) {
                const std::string said = error.what();
                ++result[said.find("crashes") != said.npos      ? "crashed"
                         : said.find("takes more") != said.npos ? "too much"
                                                                : "refused"];
            }
        }
    }
    for (const auto& [name, result] : results) {
        std::string line = name + ":";
        for (const auto& [what, number] : result) {
            line += " " + std::to_string(number) + " " + what;
        }
        RecordProperty(name, line);
        if (given) {
            std::printf("%s\n", line.c_str());
        }
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
