#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/model/Model.h"

#include <filesystem>
#include <fstream>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/PagedLOD>
#include <osg/ProxyNode>
#include <osg/ScriptEngine>
#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/conversion/TextureImage.h"
#include "irsg/geometry/reading/GuardedReading.h"
#include "irsg/geometry/reading/IrCodes.h"
#include "irsg/render/background/Terrain.h"
#include "tests/support/FlightBytes.h"
#include "tests/support/Refusal.h"

using namespace irsg;
using namespace irsg::test;
using smat::test::refusalOf;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

/// Says that it reads scripts, archives, transformed models and addresses, and counts who asks.
class Witness : public osgDB::ReaderWriter {
  public:
    Witness() {
        for (const char* extension : {"lua", "js", "curl", "rot", "scale", "osga", "zip", "tgz",
                                      "gz", "net", "path", "cfg"}) {
            supportsExtension(extension, "counted");
        }
        supportsProtocol("http", "counted");
        supportsProtocol("https", "counted");
        supportsProtocol("ftp", "counted");
    }
    const char* className() const override { return "Witness"; }

    ReadResult openArchive(const std::string& name, ArchiveStatus, unsigned int,
                           const Options*) const override {
        return saw(name);
    }
    ReadResult readObject(const std::string& name, const Options*) const override {
        return saw(name);
    }
    ReadResult readImage(const std::string& name, const Options*) const override {
        return saw(name);
    }
    ReadResult readHeightField(const std::string& name, const Options*) const override {
        return saw(name);
    }
    ReadResult readNode(const std::string& name, const Options*) const override {
        return saw(name);
    }
    ReadResult readShader(const std::string& name, const Options*) const override {
        return saw(name);
    }
    ReadResult readScript(const std::string& name, const Options*) const override {
        return saw(name);
    }

    mutable std::vector<std::string> seen;

  private:
    ReadResult saw(const std::string& name) const {
        // OpenSceneGraph asks every reader it has for every file.
        if (name.find("://") != name.npos ||
            acceptsExtension(osgDB::getLowerCaseFileExtension(name))) {
            seen.push_back(name);
        }
        return ReadResult::FILE_NOT_HANDLED;
    }
};

/// With a witness in OpenSceneGraph's list, and a folder with a script that would leave a trace.
class OpenedFiles : public testing::Test {
  protected:
    OpenedFiles() {
        auto* registry = osgDB::Registry::instance();
        registry->addReaderWriter(witness);
        registry->addArchiveExtension("zip");
        folder.write("evil.lua", script());
    }
    ~OpenedFiles() override { osgDB::Registry::instance()->removeReaderWriter(witness); }

    std::string script() const { return "os.execute('touch " + trace().string() + "')\n"; }
    fs::path trace() const { return folder / "ran"; }
    void nothingRan(const std::string& what) const {
        EXPECT_TRUE(witness->seen.empty()) << what << ": " << testing::PrintToString(witness->seen);
        EXPECT_FALSE(fs::exists(trace())) << what;
    }

    TemporaryFolder folder;
    osg::ref_ptr<Witness> witness = new Witness;
};

osg::ref_ptr<osg::Node> square() {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    const osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array(4);
    (*vertices)[1] = {1, 0, 0};
    (*vertices)[2] = {1, 1, 0};
    (*vertices)[3] = {0, 1, 0};
    geometry->setVertexArray(vertices);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    return geode;
}

std::string objWith(const std::string& material) {
    return "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl " + material +
           "\nf 1/1 2/2 3/3\n";
}

} // namespace

TEST(OpenableFiles, AreJudgedByTheirNames) {
    const struct {
        const char* name;
        FileKind kind;
        const char* refusal; ///< nullptr where it is opened
    } rows[] = {
        {"a.flt", FileKind::model, nullptr},
        {"/models/A.FLT", FileKind::model, nullptr},
        {"../a.b/c.osgt", FileKind::model, nullptr},
        {"C:/models/a.ive", FileKind::model, nullptr},
        {"a.png", FileKind::picture, nullptr},
        {"a.JPG", FileKind::picture, nullptr},
        {"a.rgb.attr", FileKind::attributes, nullptr},
        {"a.png", FileKind::model, "type \".png\""},
        {"a.flt", FileKind::picture, "type \".flt\""},
        {"evil.lua", FileKind::model, "type \".lua\""},
        {"evil.LUA", FileKind::picture, "type \".lua\""},
        {"evil.flt.lua", FileKind::model, "type \".lua\""},
        {"evil", FileKind::model, "type \".\""},
        {"a.flt/evil", FileKind::model, "type \".\""},
        {"model.flt.90,0,0.rot", FileKind::model, "type \".rot\""},
        {"a.curl", FileKind::model, "type \".curl\""},
        {"x.zip", FileKind::model, "type \".zip\""},
        {"x.zip/a.flt", FileKind::model, "archive"},
        {"x.OSGA/a.flt", FileKind::model, "archive"},
        {"http://x/y.flt", FileKind::model, "address"},
        {"HTTPS://x/y.png", FileKind::picture, "address"},
        {"/projects/http:/x/y.flt", FileKind::model, "address"},
        {"file:///a.flt", FileKind::model, "address"},
    };
    for (const auto& row : rows) {
        const auto refusal = irsg::refusalOf(row.name, row.kind);
        EXPECT_EQ(refusal.has_value(), row.refusal != nullptr) << row.name;
        if (refusal && row.refusal) {
            EXPECT_THAT(*refusal, HasSubstr(row.refusal)) << row.name;
        }
    }
    EXPECT_TRUE(irsg::refusalOf(std::string("a.lua\0.flt", 10), FileKind::model));
    EXPECT_THAT(expectationOf(FileKind::model), HasSubstr("model of type .flt, .osgt"));
}

TEST(OpenableFiles, AreThoseOfTheManual) {
    std::ifstream page(fs::path(SMAT_SOURCE_DIR) / "docs/formats-models.md");
    std::vector<std::string> lists;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("| ") && line.find("| .") != line.npos) {
            lists.push_back(line.substr(line.find("| .") + 2));
        }
    }
    ASSERT_EQ(lists.size(), 5u);
    const FileKind kinds[] = {FileKind::model, FileKind::picture, FileKind::attributes,
                              FileKind::materials, FileKind::buffers};
    for (std::size_t i = 0; i < 5; ++i) {
        std::string list;
        for (const FileFormat& format : formatsOf(kinds[i])) {
            list += "." + std::string(format.extension) + " ";
        }
        EXPECT_EQ(lists[i], list + "|");
    }
}

TEST(OpenableFiles, NeedNoLibrariesButTheirOwn) {
    for (const char* name :
         {"osgPlugins-3.6.5/osgdb_openflight.so", "osgPlugins-3.6.5/osgdb_osg.so",
          "osgPlugins-3.6.5/osgdb_serializers_osgsim.so", "osgdb_jpeg.so", "libosgSim.so"}) {
        EXPECT_TRUE(mayLoadLibrary(name)) << name;
    }
    for (const char* name :
         {"osgPlugins-3.6.5/osgdb_lua.so", "osgPlugins-3.6.5/osgdb_curl.so",
          "osgPlugins-3.6.5/osgdb_tgz.so", "osgPlugins-3.6.5/osgdb_.so", "liblua.so",
          "osgPlugins-3.6.5/osgdb_png/../../../tmp/osgdb_png.so", "/tmp/osgdb_png.so"}) {
        EXPECT_FALSE(mayLoadLibrary(name)) << name;
    }
}

TEST_F(OpenedFiles, AreNoScriptsArchivesOrAddressesWhereAModelIsNamed) {
    fs::create_directories(folder / "http:/x");
    for (const char* name :
         {"evil.lua", "EVIL.LUA", "evil.flt.lua", "model.flt.90,0,0.rot", "a.curl", "x.zip",
          "x.tgz", "x.osga", "x.gz", "http:/x/evil.lua", "http:/x/y.flt"}) {
        const auto file = folder.write(name, script());
        for (const auto& act : std::vector<std::function<void()>>{
                 [&] { Model::load(file); }, [&] { loadGraph(file, LoadPurpose::visible); },
                 [&] { Terrain::load(file, {}); }}) {
            EXPECT_THAT(refusalOf(act), AllOf(HasSubstr(name), HasSubstr("expected a model of "
                                                                         "type .flt, .osgt")));
        }
        EXPECT_THAT(refusalOf([&] { readTexture(file); }),
                    AllOf(HasSubstr(name), HasSubstr("expected a picture of type .png")));
        nothingRan(name);
    }
    EXPECT_THAT(refusalOf([] { Model::load("http://x/y.flt"); }),
                AllOf(HasSubstr("an address"), HasSubstr(".flt, .osgt")));
    nothingRan("an address");
}

TEST_F(OpenedFiles, AreNoScriptsOrAddressesWhereAnObjNamesAPicture) {
    for (const char* name : {"evil.lua", "http://127.0.0.1:9/evil.lua", "http://127.0.0.1:9/a.png",
                             "a.png.rot", "x.zip/a.png"}) {
        folder.write("a.mtl", "newmtl m\nKd 1 1 1\nmap_Kd " + std::string(name) + "\n");
        const auto file = folder.write("a.obj", objWith("m"));
        const auto loaded = loadGraph(file, LoadPurpose::visible);
        EXPECT_THAT(loaded.remarks, Contains(AllOf(HasSubstr(name), HasSubstr("not opened"))));
        EXPECT_THAT(Model::load(file)->remarks(), Contains(HasSubstr(name)));
        nothingRan(name);
    }
}

TEST_F(OpenedFiles, AreNoScriptsWhereAnObjNamesItsMaterials) {
    const auto file =
        folder.write("a.obj", "mtllib evil.lua\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    EXPECT_THAT(Model::load(file)->remarks(),
                Contains(AllOf(HasSubstr("evil.lua"), HasSubstr("not opened"))));
    nothingRan("material library");
}

TEST_F(OpenedFiles, AreNoScriptsWhereOpenFlightNamesAPicture) {
    SquareFile flight;
    std::string texture = "evil.lua";
    texture.resize(200, '\0');
    flight.colours += record(flight::texturePalette, texture + i32(0) + i32(0) + i32(0));
    const auto loaded = loadGraph(folder.write("a.flt", flight.bytes()), LoadPurpose::visible);
    EXPECT_THAT(loaded.remarks, Contains(AllOf(HasSubstr("evil.lua"), HasSubstr("not opened"))));
    nothingRan("texture palette");
}

TEST_F(OpenedFiles, AreNoScriptsWhereOpenFlightNamesAnotherModel) {
    SquareFile flight;
    std::string path = "evil.lua";
    path.resize(200, '\0');
    flight.object = record(63, path + zeros(12));
    flight.pushObject = flight.face = flight.pushFace = flight.list = flight.popFace =
        flight.popObject = "";
    const auto file = folder.write("a.flt", flight.bytes());
    EXPECT_THAT(refusalOf([&] { Model::load(file); }), HasSubstr("evil.lua"));
    nothingRan("external reference");
}

TEST_F(OpenedFiles, AreNoScriptsArchivesOrAddressesWhereASceneRefersToAnother) {
    for (const char* kind : {"osgt", "osgb", "osgx", "osg"}) {
        for (const char* name :
             {"evil.lua", "http://127.0.0.1:9/y.flt", "x.zip/y.flt", "model.flt.90,0,0.rot"}) {
            osg::ref_ptr<osg::ProxyNode> proxy = new osg::ProxyNode;
            proxy->setFileName(0, name);
            osg::ref_ptr<osg::Group> group = new osg::Group;
            group->addChild(square());
            group->addChild(proxy);
            const auto file = folder / ("a." + std::string(kind));
            ASSERT_TRUE(osgDB::writeNodeFile(*group, file.string()));
            witness->seen.clear();
            const auto loaded = loadGraph(file, LoadPurpose::visible);
            EXPECT_THAT(loaded.remarks, Contains(AllOf(HasSubstr(name), HasSubstr("not opened"))))
                << kind;
            nothingRan(name + std::string(" in .") + kind);
        }
    }
}

TEST_F(OpenedFiles, AreNoScriptsWhereAnIveRefersToAnother) {
    // The writer puts its own extension behind the names of others.
    osg::ref_ptr<osg::ProxyNode> proxy = new osg::ProxyNode;
    proxy->setFileName(0, "evil.ive");
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(square());
    group->addChild(proxy);
    ASSERT_TRUE(osgDB::writeNodeFile(*group, (folder / "a.ive").string()));
    std::string bytes = readBytes(folder / "a.ive");
    const auto at = bytes.find("evil.ive");
    ASSERT_NE(at, bytes.npos);
    const auto file = folder.write("a.ive", bytes.replace(at, 8, "evil.lua"));
    witness->seen.clear();
    EXPECT_THAT(loadGraph(file, LoadPurpose::visible).remarks,
                Contains(AllOf(HasSubstr("evil.lua"), HasSubstr("not opened"))));
    nothingRan("evil.lua in .ive");
}

TEST_F(OpenedFiles, OfOpenFlightAreScannedWhereASceneRefersToThem) {
    SquareFile flight;
    const std::string sound = flight.bytes();
    for (const char* kind : {"osgt", "osg", "osgb"}) {
        osg::ref_ptr<osg::ProxyNode> proxy = new osg::ProxyNode;
        proxy->setFileName(0, "a.flt");
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->addChild(square());
        group->addChild(proxy);
        const auto file = folder / ("b." + std::string(kind));
        ASSERT_TRUE(osgDB::writeNodeFile(*group, file.string()));
        folder.write("a.flt", sound);
        const auto whole = loadGraph(file, LoadPurpose::infrared);
        EXPECT_THAT(whole.remarks, Contains(HasSubstr("refers to a.flt, which is read as well")))
            << kind;
        EXPECT_EQ(polygonCounts(*whole.node).size(), 2u) << "its codes are there: " << kind;
        // The end is missing, which OpenSceneGraph's plug-in does not mind.
        folder.write("a.flt", sound.substr(0, sound.size() - 6));
        const auto cut = loadGraph(file, LoadPurpose::infrared);
        EXPECT_THAT(cut.remarks, Contains(AllOf(HasSubstr("a.flt"), HasSubstr("byte")))) << kind;
        EXPECT_THAT(cut.remarks, testing::Not(Contains(HasSubstr("missing"))))
            << "it is there: " << kind;
        EXPECT_EQ(polygonCounts(*cut.node).size(), 1u) << "what is damaged is left out: " << kind;
    }
}

TEST_F(OpenedFiles, AreStillTheModelsAndPicturesThatOthersReferTo) {
    osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(2, 2, 1, GL_RGB, GL_UNSIGNED_BYTE);
    std::fill_n(picture->data(), picture->getTotalSizeInBytes(), 200);
    ASSERT_TRUE(osgDB::writeImageFile(*picture, (folder / "a.rgb").string()));
    folder.write("a.mtl", "newmtl m\nKd 1 1 1\nmap_Kd a.rgb\n");
    folder.write("a.obj", objWith("m"));
    osg::ref_ptr<osg::ProxyNode> proxy = new osg::ProxyNode;
    proxy->setFileName(0, "a.obj");
    ASSERT_TRUE(osgDB::writeNodeFile(*proxy, (folder / "b.osgt").string()));
    osgDB::Registry::instance()->removeReaderWriter(witness);

    const auto loaded = loadGraph(folder / "b.osgt", LoadPurpose::visible);
    EXPECT_THAT(loaded.remarks, testing::ElementsAre(HasSubstr("cannot tell whether it is whole"),
                                                     HasSubstr("refers to a.obj, which is read")));
    class Images : public osg::NodeVisitor {
      public:
        Images() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
        void apply(osg::Node& node) override {
            const auto* texture =
                node.getStateSet()
                    ? dynamic_cast<const osg::Texture*>(
                          node.getStateSet()->getTextureAttribute(0, osg::StateAttribute::TEXTURE))
                    : nullptr;
            found += texture && texture->getImage(0) ? 1 : 0;
            traverse(node);
        }
        int found = 0;
    } images;
    loaded.node->accept(images);
    EXPECT_EQ(images.found, 1);
}

TEST_F(OpenedFiles, AreNotReadLaterEither) {
    osg::ref_ptr<osg::PagedLOD> pages = new osg::PagedLOD;
    pages->addChild(square(), 0.0f, 1e3f);
    pages->setFileName(1, "http://127.0.0.1:9/page.lua");
    pages->setRange(1, 1e3f, 1e6f);
    osg::ref_ptr<osg::Script> text = new osg::Script("lua", script());
    pages->setUpdateCallback(new osg::ScriptNodeCallback(text));
    ASSERT_TRUE(osgDB::writeNodeFile(*pages, (folder / "a.osgt").string()));
    witness->seen.clear();

    const auto loaded = loadGraph(folder / "a.osgt", LoadPurpose::visible);
    EXPECT_THAT(loaded.remarks, Contains(HasSubstr("the page http://127.0.0.1:9/page.lua")));
    EXPECT_THAT(loaded.remarks, Contains(HasSubstr("a script, which is removed")));
    EXPECT_FALSE(dynamic_cast<osg::PagedLOD*>(loaded.node.get()));
    EXPECT_TRUE(dynamic_cast<osg::LOD*>(loaded.node.get()));
    EXPECT_EQ(loaded.node->getUpdateCallback(), nullptr);
    nothingRan("pages and callbacks");
}

TEST_F(OpenedFiles, AreGuardedOnThisThreadAloneAndOnlyWhileReading) {
    osgDB::readRefNodeFile("evil.lua");
    EXPECT_EQ(witness->seen.size(), 1u) << "the test could not fail";
    witness->seen.clear();
    {
        GuardedReading guard;
        osgDB::readRefNodeFile("evil.lua");
        osgDB::readRefImageFile("http://127.0.0.1:9/a.png");
        osgDB::readRefObjectFile("evil.lua");
        osgDB::readRefScriptFile("evil.lua");
        osgDB::readRefShaderFile("evil.lua");
        nothingRan("guarded");
        EXPECT_EQ(guard.take().size(), 3u) << "as a model, as a picture, as nothing of a model";
    }
    osgDB::readRefNodeFile("evil.lua");
    EXPECT_EQ(witness->seen.size(), 1u);

    // Options keep their guard wherever they are carried.
    osgDB::readRefNodeFile("evil.lua", GuardedReading::options());
    EXPECT_EQ(witness->seen.size(), 1u);
}

TEST(GuardedReading, LoadsNoPlugInThatIsNotOfTheList) {
    GuardedReading guard;
    auto* registry = osgDB::Registry::instance();
    for (const char* extension : {"tgz", "logo", "../../../tmp/x"}) {
        EXPECT_EQ(registry->getReaderWriterForExtension(extension), nullptr) << extension;
        EXPECT_THAT(guard.take(), Contains(HasSubstr(extension))) << extension;
    }
    EXPECT_NE(registry->getReaderWriterForExtension("osgt"), nullptr);
    EXPECT_TRUE(guard.take().empty());
}
