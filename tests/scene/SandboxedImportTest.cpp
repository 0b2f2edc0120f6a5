#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osg/AlphaFunc>
#include <osg/Billboard>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/LOD>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/ProxyNode>
#include <osg/Sequence>
#include <osg/Switch>
#include <osg/Texture2D>
#include <osgDB/WriteFile>
#include <osgSim/DOFTransform>
#include <osgSim/MultiSwitch>

#include "irsg/core/Bytes.h"
#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/conversion/TextureImage.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/reading/IrCodes.h"
#include "irsg/geometry/reading/MaterialNames.h"
#include "irsg/geometry/reading/sandbox/AxesCoding.h"
#include "irsg/geometry/reading/sandbox/CompletenessCheck.h"
#include "irsg/geometry/reading/sandbox/GraphCoding.h"
#include "irsg/geometry/reading/sandbox/ReaderMessages.h"
#include "irsg/geometry/reading/sandbox/StateCoding.h"
#include "tests/support/FlightBytes.h"
#include "tests/support/QuietListener.h"
#include "tests/support/Refusal.h"
#include "tests/support/SharedMaterial.h"
#include "tests/support/WalkedReaders.h"

using namespace irsg;
using namespace irsg::test;
using smat::test::QuietListener;
using smat::test::refusalOf;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

osg::ref_ptr<osg::Geometry> square(const IrCodes& codes = {}) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    const osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array(4);
    (*vertices)[1] = {1, 0, 0};
    (*vertices)[2] = {1, 1, 0};
    (*vertices)[3] = {0, 1, 0};
    geometry->setVertexArray(vertices);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
    if (codes != IrCodes{}) {
        setCodes(*geometry, codes);
    }
    return geometry;
}

osg::ref_ptr<osg::Geode> geode(const IrCodes& codes = {}) {
    osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(square(codes));
    return node;
}

/// Through bytes and back.
osg::ref_ptr<osg::Node> handedOver(osg::Node& graph, std::vector<std::string>& remarks) {
    ByteSink sink;
    putGraph(sink, graph, "a", remarks);
    const std::string bytes = sink.take();
    ByteSource source(bytes);
    const auto back = getGraph(source, "a", remarks);
    EXPECT_TRUE(source.atEnd());
    return back;
}

osg::ref_ptr<osg::Node> handedOver(osg::Node& graph) {
    std::vector<std::string> remarks;
    const auto back = handedOver(graph, remarks);
    EXPECT_THAT(remarks, testing::IsEmpty());
    return back;
}

template <typename Kind>
const Kind& as(const osg::Node& node) {
    return dynamic_cast<const Kind&>(node);
}

/// Groups of twice the same: 2^levels squares in a file of some kilobytes.
osg::ref_ptr<osg::Node> doubled(int levels) {
    osg::ref_ptr<osg::Node> node = geode();
    for (int i = 0; i < levels; ++i) {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->addChild(node);
        group->addChild(node);
        node = group;
    }
    return node;
}

} // namespace

TEST(GraphCoding, KeepsNodesStatesAndCodes) {
    osg::ref_ptr<osg::Group> root = new osg::Group;
    osg::ref_ptr<osg::MatrixTransform> moved =
        new osg::MatrixTransform(osg::Matrixd::translate(1, 2, 3));
    moved->setName("moved");
    moved->setNodeMask(0x12);
    moved->addChild(geode({1, 2}));
    root->addChild(moved);
    osg::ref_ptr<osg::Switch> choice = new osg::Switch;
    choice->addChild(geode(), false);
    choice->addChild(moved, true);
    root->addChild(choice);
    osg::ref_ptr<osg::LOD> lod = new osg::LOD;
    lod->addChild(geode(), 10.0f, 20.0f);
    root->addChild(lod);
    osg::ref_ptr<osgSim::MultiSwitch> sets = new osgSim::MultiSwitch;
    sets->addChild(geode());
    sets->setValue(1, 0, false);
    sets->setActiveSwitchSet(1);
    sets->setDescriptions({"a comment", "and another"});
    root->addChild(sets);
    osg::ref_ptr<osg::Sequence> film = new osg::Sequence;
    film->addChild(geode(), 0.5);
    root->addChild(film);
    osg::ref_ptr<osg::Billboard> tree = new osg::Billboard;
    tree->addDrawable(square({3, 4}), osg::Vec3(5, 6, 7));
    root->addChild(tree);

    osg::ref_ptr<osgSim::DOFTransform> joint = new osgSim::DOFTransform;
    joint->addChild(geode());
    joint->setMaxHPR({1, 2, 3});
    joint->setIncrementTranslate({4, 5, 6});
    joint->setCurrentHPR({0.5f, 0, 0});
    joint->setPutMatrix(osg::Matrixd::translate(7, 8, 9));
    joint->setLimitationFlags(0x84000000ul);
    joint->setHPRMultOrder(osgSim::DOFTransform::RPH);
    root->addChild(joint);

    const auto back = handedOver(*root);
    EXPECT_EQ(polygonCounts(*back), polygonCounts(*root));
    const auto& group = as<osg::Group>(*back);
    ASSERT_EQ(group.getNumChildren(), 7u);
    const auto& transform = as<osg::MatrixTransform>(*group.getChild(0));
    EXPECT_EQ(transform.getMatrix().getTrans(), osg::Vec3d(1, 2, 3));
    EXPECT_EQ(transform.getName(), "moved");
    EXPECT_EQ(transform.getNodeMask(), 0x12u);
    const auto& switched = as<osg::Switch>(*group.getChild(1));
    EXPECT_FALSE(switched.getValue(0));
    EXPECT_TRUE(switched.getValue(1));
    EXPECT_EQ(switched.getChild(1), group.getChild(0)) << "one node in two places stays one";
    EXPECT_EQ(as<osg::LOD>(*group.getChild(2)).getMinRange(0), 10.0f);
    EXPECT_EQ(as<osg::LOD>(*group.getChild(2)).getMaxRange(0), 20.0f);
    const auto& multi = as<osgSim::MultiSwitch>(*group.getChild(3));
    EXPECT_EQ(multi.getActiveSwitchSet(), 1u);
    EXPECT_FALSE(multi.getValue(1, 0));
    EXPECT_EQ(multi.getSwitchSetList().size(), 2u);
    EXPECT_EQ(multi.getDescriptions(), sets->getDescriptions());
    EXPECT_EQ(as<osg::Sequence>(*group.getChild(4)).getTime(0), 0.5);
    EXPECT_EQ(as<osg::Billboard>(*group.getChild(5)).getPosition(0), osg::Vec3(5, 6, 7));
    const auto& turned = as<osgSim::DOFTransform>(*group.getChild(6));
    EXPECT_EQ(turned.getMaxHPR(), osg::Vec3(1, 2, 3));
    EXPECT_EQ(turned.getIncrementTranslate(), osg::Vec3(4, 5, 6));
    EXPECT_EQ(turned.getLimitationFlags(), 0x84000000ul);
    EXPECT_EQ(turned.getHPRMultOrder(), osgSim::DOFTransform::RPH);
    osg::Matrixd before, after;
    joint->computeLocalToWorldMatrix(before, nullptr);
    turned.computeLocalToWorldMatrix(after, nullptr);
    EXPECT_EQ(before, after);
}

TEST(GraphCoding, KeepsMaterialsAndPictures) {
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(3, 2, 1, GL_RGB, GL_UNSIGNED_BYTE, 4);
    for (unsigned int i = 0; i < image->getTotalSizeInBytes(); ++i) {
        image->data()[i] = static_cast<unsigned char>(i);
    }
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::MIRROR);
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setDiffuse(osg::Material::FRONT_AND_BACK, osg::Vec4(0.25f, 0.5f, 0.75f, 1));
    material->setName("red paint");
    texture->setName("of the wall");
    const auto drawable = square();
    auto* state = drawable->getOrCreateStateSet();
    state->setName("a state");
    state->setTextureAttributeAndModes(0, texture);
    state->setAttributeAndModes(material, osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    state->setMode(GL_BLEND, osg::StateAttribute::ON);
    osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(drawable);

    const auto back = handedOver(*node);
    const auto& read = *as<osg::Geode>(*back).getDrawable(0)->getStateSet();
    EXPECT_EQ(read.getMode(GL_BLEND), static_cast<unsigned int>(osg::StateAttribute::ON));
    EXPECT_EQ(read.getAttributePair(osg::StateAttribute::MATERIAL)->second,
              static_cast<unsigned int>(osg::StateAttribute::OVERRIDE));
    const auto* paint =
        dynamic_cast<const osg::Material*>(read.getAttribute(osg::StateAttribute::MATERIAL));
    ASSERT_TRUE(paint);
    EXPECT_EQ(paint->getDiffuse(osg::Material::BACK), osg::Vec4(0.25f, 0.5f, 0.75f, 1));
    EXPECT_EQ(read.getName(), "a state");
    EXPECT_EQ(materialNameOf(read), "red paint");
    const auto* wall = dynamic_cast<const osg::Texture2D*>(
        read.getTextureAttribute(0, osg::StateAttribute::TEXTURE));
    ASSERT_TRUE(wall && wall->getImage());
    EXPECT_EQ(wall->getWrap(osg::Texture::WRAP_S), osg::Texture::MIRROR);
    EXPECT_EQ(std::memcmp(wall->getImage()->data(), image->data(), image->getTotalSizeInBytes()),
              0);
}

TEST(GraphCoding, KeepsWhatAFileSaysOfItsAxes) {
    const FileAxes rows[] = {{},
                             {0.0254, ModelAxis::plusX, std::nullopt, "inches"},
                             {std::nullopt, ModelAxis::minusZ, ModelAxis::plusY, ""},
                             {1.0, std::nullopt, ModelAxis::minusX, "metres"}};
    for (const auto& axes : rows) {
        ByteSink sink;
        putAxes(sink, axes);
        const std::string bytes = sink.take();
        ByteSource source(bytes);
        EXPECT_EQ(getAxes(source), axes);
        EXPECT_TRUE(source.atEnd());
    }
    for (const double unit_m : {-1.0, HUGE_VAL, std::nan("")}) {
        ByteSink sink;
        putAxes(sink, {unit_m, {}, {}, ""});
        const std::string bytes = sink.take();
        ByteSource source(bytes);
        EXPECT_THROW(getAxes(source), DamagedBytes) << unit_m;
    }
    ByteSink sink;
    putAxes(sink, {1.0, ModelAxis::plusZ, {}, ""});
    std::string bytes = sink.take();
    bytes[8] = 7;
    ByteSource source(bytes);
    EXPECT_THROW(getAxes(source), DamagedBytes);
}

TEST(GraphCoding, HandsLargeModelsOverInPiecesThatAreNotCopied) {
    const std::vector<std::uint32_t> numbers(700000, 7);
    ByteSink large;
    large.putBytes(numbers.data(), 4 * numbers.size());
    const char* const place = large.pieces().front().data();
    ByteSink sink;
    sink.putText("head");
    sink.append(std::move(large));
    sink.putEach<std::uint16_t>(3, [](std::size_t i) { return 10 * i; });

    ASSERT_EQ(sink.pieces().size(), 3u);
    EXPECT_EQ(sink.pieces()[1].data(), place);
    const std::size_t size = sink.size();
    EXPECT_EQ(size, 8 + 4 + 4 * numbers.size() + 6);
    const std::string bytes = sink.take();
    ASSERT_EQ(bytes.size(), size);
    ByteSource source(bytes);
    EXPECT_EQ(source.getText(), "head");
    EXPECT_EQ(
        std::memcmp(source.getBytes(4 * numbers.size()).data(), numbers.data(), 4 * numbers.size()),
        0);
    for (const int number : {0, 10, 20}) {
        EXPECT_EQ(source.get<std::uint16_t>(), number);
    }
    EXPECT_TRUE(source.atEnd());
}

TEST(GraphCoding, RefusesArraysOfNoTypeAndRefusalsOfNoWords) {
    ByteSink sink;
    std::vector<std::string> remarks;
    const auto node = geode();
    node->getOrCreateStateSet()->setAttributeAndModes(new osg::AlphaFunc);
    putGraph(sink, *node, "a", remarks);
    const std::string good = sink.take();
    // Values of every byte, among them types and modes that there are not.
    for (std::size_t i = 0; i < good.size(); ++i) {
        for (int value = 1; value < 256; value += 6) {
            std::string bytes = good;
            bytes[i] = static_cast<char>(value);
            ByteSource changed(bytes);
            try {
                getGraph(changed, "a", remarks);
            } catch (const DamagedBytes&) {
            } catch (const InputError&) {
            }
        }
    }

    // Without words, and with a place alone.
    for (const char* place : {"", "a"}) {
        ByteSink refusal;
        refusal.putCount(1);
        for (const char* text : {place, place, "", ""}) {
            refusal.putText(text);
        }
        EXPECT_THROW(throwRefusal(refusal.take()), DamagedBytes);
    }
    EXPECT_THROW(throwRefusal(std::string(8, '\0')), DamagedBytes);
}

TEST(GraphCoding, RefusesBytesThatDoNotHoldTogether) {
    ByteSink sink;
    std::vector<std::string> remarks;
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(geode({1, 2}));
    putGraph(sink, *root, "a", remarks);
    const std::string good = sink.take();
    // Every cut, and every byte changed: refused, or another graph, but never anything else.
    for (std::size_t i = 0; i < good.size(); ++i) {
        ByteSource cut(std::string_view(good).substr(0, i));
        EXPECT_THROW(getGraph(cut, "a", remarks), DamagedBytes) << i;
        for (const int flip : {0x01, 0x80, 0xff}) {
            std::string bytes = good;
            bytes[i] = static_cast<char>(bytes[i] ^ flip);
            ByteSource changed(bytes);
            try {
                getGraph(changed, "a", remarks);
            } catch (const DamagedBytes&) {
            } catch (const InputError&) {
            }
        }
    }
}

TEST(SandboxedImport, RefusesFacesOfVerticesThatThereAreNot) {
    const TemporaryFolder folder;
    for (const char* kind : {"osgt", "osgb", "ive"}) {
        auto node = geode();
        auto& geometry = *node->getDrawable(0)->asGeometry();
        geometry.setPrimitiveSet(0, new osg::DrawArrays(GL_TRIANGLES, 0, 6));
        const auto file = folder / ("a." + std::string(kind));
        ASSERT_TRUE(osgDB::writeNodeFile(*node, file.string()));
        EXPECT_THAT(refusalOf([&] { loadGraph(file, LoadPurpose::visible); }),
                    AllOf(HasSubstr(file.string()), HasSubstr("number of vertices, 4")));
    }
}

TEST(SandboxedImport, RefusesGraphsThatGrowOutOfAllProportion) {
    const TemporaryFolder folder;
    for (const char* kind : {"osgt", "osgb", "ive"}) {
        const auto file = folder / ("a." + std::string(kind));
        ASSERT_TRUE(osgDB::writeNodeFile(*doubled(15), file.string()));
        EXPECT_EQ(polygonCounts(*loadGraph(file, LoadPurpose::visible).node).begin()->second,
                  32768);
    }
    std::vector<std::string> remarks;
    const auto many = doubled(40);
    EXPECT_THAT(refusalOf([&] { handedOver(*many, remarks); }), HasSubstr("copies of parts"));
    osg::ref_ptr<osg::Node> deep = geode();
    for (int i = 0; i < 1500; ++i) {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->addChild(deep);
        deep = group;
    }
    EXPECT_THAT(refusalOf([&] { handedOver(*deep, remarks); }), HasSubstr("1000 levels"));
}

TEST(SandboxedImport, HasNothingToSayOfNodesThatItKnows) {
    const TemporaryFolder folder;
    const osg::ref_ptr<osgSim::DOFTransform> joint = new osgSim::DOFTransform;
    joint->addChild(geode({1, 2}));
    for (const char* kind : {"osg", "osgt", "osgb", "osgx", "ive"}) {
        const auto file = folder / ("a." + std::string(kind));
        ASSERT_TRUE(osgDB::writeNodeFile(*joint, file.string()));
        EXPECT_THAT(loadGraph(file, LoadPurpose::visible).remarks, testing::IsEmpty()) << kind;
    }
}

TEST(SandboxedImport, RefusesChunksThatStandInEachOtherWithoutEnd) {
    const TemporaryFolder folder;
    const auto nested = [](std::uint32_t levels) {
        std::string bytes;
        for (std::uint32_t left = 6 * levels; left > 0; left -= 6) {
            bytes += "\x4d\x4d";
            for (int shift = 0; shift < 32; shift += 8) {
                bytes += static_cast<char>(left >> shift & 0xff);
            }
        }
        return bytes;
    };
    const auto file = folder.write("a.3ds", nested(300'000));
    EXPECT_THAT(refusalOf([&] { checkCompleteness(file, "a.3ds"); }),
                HasSubstr("a chunk in 8 others"));
    EXPECT_NO_THROW(checkCompleteness(folder.write("b.3ds", nested(8)), "b.3ds"));
}

TEST(SandboxedImport, RefusesCutFilesWhereTheFormatCanTell) {
    const TemporaryFolder folder;
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(geode({1, 2}));
    root->addChild(geode({3, 4}));
    for (const char* kind : {"osg", "osgt", "osgx"}) {
        const auto whole = folder / ("whole." + std::string(kind));
        ASSERT_TRUE(osgDB::writeNodeFile(*root, whole.string()));
        const std::string bytes = readBytes(whole);
        const auto last = bytes.find_last_not_of(" \t\r\n");
        for (int part = 1; part < 20; ++part) {
            const std::size_t size = last * static_cast<std::size_t>(part) / 20;
            const auto file = folder.write("cut." + std::string(kind), bytes.substr(0, size));
            EXPECT_NE(refusalOf([&] { Model::load(file); }), "nothing was refused")
                << kind << " of " << size << " of " << bytes.size() << " bytes";
        }
    }
}

TEST(SandboxedImport, RefusesAnAcThatIsCut) {
    const TemporaryFolder folder;
    const std::string vertices = "numvert 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    const std::string surface = "SURF 0x0\nmat 1\nrefs 4\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n";
    const std::string object = "OBJECT poly\nname \"hull\"\ndata 9\nnumvert 7\n" + vertices +
                               "numsurf 2\n" + surface + surface + "kids 0\n";
    const std::string colours = "rgb 1 0 0 amb 1 0 0 emis 0 0 0 spec 0 0 0 shi 1 trans 0\n";
    const std::string bytes = "AC3Db\nMATERIAL \"first\" " + colours + "MATERIAL \"red paint\" " +
                              colours + "OBJECT world\nkids 2\n" + object + object;
    const auto loaded = loadGraph(folder.write("a.ac", bytes), LoadPurpose::visible);
    EXPECT_EQ(polygonCounts(*loaded.node).at({}), 4);
    // What ends behind a whole object may have been counted wrongly.
    const std::size_t behindOne = bytes.find("kids 0") + 6;
    for (std::size_t size = 1; size < bytes.size() - 3; ++size) {
        const bool near = size + 3 > behindOne && size < behindOne + 9;
        if ((near || size % 5 == 0) && size != behindOne && size != behindOne + 1) {
            EXPECT_NE(refusalOf([&] { Model::load(folder.write("b.ac", bytes.substr(0, size))); }),
                      "nothing was refused")
                << size << " of " << bytes.size() << " bytes";
        }
    }
    const auto half =
        loadGraph(folder.write("c.ac", bytes.substr(0, behindOne + 1)), LoadPurpose::visible);
    EXPECT_THAT(half.remarks, Contains(HasSubstr("1 more objects than it has")));
}

TEST(SandboxedImport, RefusesLevelsWithoutEndBeforeAReaderOfOthersSeesThem) {
    const TemporaryFolder folder;
    const auto repeated = [](const std::string& text, int times) {
        std::string all;
        for (int i = 0; i < times; ++i) {
            all += text;
        }
        return all;
    };
    constexpr int levels = 20'000;
    const std::map<std::string, std::string> deep = {
        {"a.osg", repeated("Group {\n", levels) + repeated("}\n", levels)},
        {"a.osgt", "#Ascii Scene\n" + repeated("osg::Group {\n", levels) + repeated("}\n", levels)},
        {"a.x", "xof 0303txt 0032\n" + repeated("Frame {\n", levels) + repeated("}\n", levels)},
        {"a.osgx",
         "<?xml version=\"1.0\"?>\n" + repeated("<a>", levels) + repeated("</a>", levels)},
        {"a.ac", "AC3Db\n" + repeated("OBJECT group\nkids 1\n", levels)}};
    smat::test::expectWalked("levels in each other without end", deep.size());
    for (const auto& [name, text] : deep) {
        EXPECT_THAT(refusalOf([&] { checkCompleteness(folder.write(name, text), name); }),
                    HasSubstr("levels in each other"))
            << name;
    }
}

TEST(SandboxedImport, OpensNoConnectionAndRunsNothing) {
    const TemporaryFolder folder;
    const QuietListener listener;
    const auto trace = folder / "ran";
    const std::string script = "os.execute('touch " + trace.string() + "')\n";
    folder.write("evil.lua", script);
    for (const std::string& name :
         {std::string("evil.lua"), listener.address("evil.lua"), listener.address("a.png"),
          listener.address("a.osgt"), std::string("evil.lua.gz"), std::string("x.zip/evil.lua")}) {
        // As another scene, as a picture, and as materials.
        osg::ref_ptr<osg::ProxyNode> proxy = new osg::ProxyNode;
        proxy->setFileName(0, name);
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->setFileName(name);
        const auto node = geode();
        node->getOrCreateStateSet()->setTextureAttributeAndModes(0, new osg::Texture2D(image));
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(node);
        root->addChild(proxy);
        for (const char* kind : {"osgt", "osgb", "osgx", "osg"}) {
            const auto file = folder / ("a." + std::string(kind));
            osg::ref_ptr<osgDB::Options> options = new osgDB::Options("WriteImageHint=UseExternal");
            ASSERT_TRUE(osgDB::writeNodeFile(*root, file.string(), options));
            EXPECT_NO_THROW(loadGraph(file, LoadPurpose::visible)) << kind << ": " << name;
        }
        folder.write("a.mtl", "newmtl m\nmap_Kd " + name + "\n");
        loadGraph(folder.write("a.obj", "mtllib a.mtl\nmtllib " + name +
                                            "\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl m\nf 1 2 3\n"),
                  LoadPurpose::visible);
        EXPECT_NE(refusalOf([&] { readTexture(name); }), "nothing was refused");
        EXPECT_NE(refusalOf([&] { Model::load(name); }), "nothing was refused");
    }
    EXPECT_FALSE(listener.heard());
    EXPECT_FALSE(fs::exists(trace));
}

TEST(SandboxedImport, RefusesDamagedModelsByName) {
    const fs::path damaged = smat::test::sharedMaterial("data/damaged");
    if (damaged.empty()) {
        GTEST_SKIP() << "the shared folder data/damaged is absent";
    }
    int tried = 0;
    for (const auto& entry : fs::directory_iterator(damaged)) {
        if (!entry.path().filename().string().starts_with("model-")) {
            continue;
        }
        ++tried;
        EXPECT_THAT(refusalOf([&] { Model::load(entry.path()); }),
                    AllOf(HasSubstr(entry.path().string()), HasSubstr("expected")));
    }
    EXPECT_GT(tried, 0);
}
