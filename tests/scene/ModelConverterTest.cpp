#include "irsg/geometry/model/ModelConverter.h"

#include <functional>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/NodeVisitor>
#include <osg/PositionAttitudeTransform>
#include <osgDB/Options>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>
#include <osgSim/DOFTransform>
#include <osgSim/MultiSwitch>
#include <osgSim/ShapeAttribute>

#include "irsg/core/Errors.h"
#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/model/ModelSummary.h"
#include "irsg/geometry/reading/IrCodes.h"
#include "tests/support/FlightBytes.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using namespace irsg::test;
namespace fs = std::filesystem;
using smat::test::ownFolder;
using smat::test::writtenFile;
using testing::HasSubstr;

namespace {

const fs::path source = SMAT_SOURCE_DIR;
const fs::path data = source / "tests/data/models";

/// What the stock reader gives, with nothing of this program in between.
osg::ref_ptr<osg::Node> stockRead(const fs::path& file) {
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    options->setObjectCacheHint(osgDB::Options::CACHE_NONE);
    return osgDB::readRefNodeFile(file.string(), options);
}

/// Every drawable's two integers as a foreign reader finds them.
class AttributeReader : public osg::NodeVisitor {
  public:
    AttributeReader() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }
    void apply(osg::Drawable& drawable) override {
        const auto* list = dynamic_cast<const osgSim::ShapeAttributeList*>(drawable.getUserData());
        if (!list || list->size() != 2 || (*list)[0].getName() != "IRColor" ||
            (*list)[1].getName() != "IRMaterial") {
            ++without;
            return;
        }
        codes.insert({(*list)[0].getInt(), (*list)[1].getInt()});
        uncoloured += drawable.asGeometry()->getColorArray() == nullptr;
    }
    std::set<IrCodes> codes;
    int without = 0, uncoloured = 0;
};

std::string refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

/// Vertices of all drawables where their transformations put them, in double.
class PlacedVertices : public osg::NodeVisitor {
  public:
    explicit PlacedVertices(osg::Node& graph) : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {
        graph.accept(*this);
    }
    void apply(osg::Drawable& drawable) override {
        const osg::Matrixd matrix = osg::computeLocalToWorld(getNodePath());
        for (const osg::Vec3& vertex :
             dynamic_cast<const osg::Vec3Array&>(*drawable.asGeometry()->getVertexArray())) {
            places.push_back(osg::Vec3d(vertex) * matrix);
            bounds.expandBy(places.back());
        }
    }
    std::vector<osg::Vec3d> places;
    osg::BoundingBoxd bounds;
};

osg::ref_ptr<osg::Geode> square() {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
    for (const auto& [x, y] : {std::pair{0.1f, 0.0f}, {1.3f, 0.0f}, {1.3f, 1.7f}, {0.1f, 1.7f}}) {
        corners->push_back({x, y, 0.7f});
    }
    geometry->setVertexArray(corners);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    return geode;
}

class Conversion : public testing::TestWithParam<const char*> {};

} // namespace

TEST_P(Conversion, KeepsEveryCodeInTheUserDataOfDrawables) {
    const TemporaryFolder folder;
    for (const fs::path& in : {data / "tricky_1420.flt", data / "tricky_1640.flt",
                               source / "samples/box/box.flt", data / "plate.flt"}) {
        SCOPED_TRACE(in.filename().string());
        const auto out = folder.path() / (std::string("out.") + GetParam());
        const auto report = convertModel(in, out);

        // Read by the stock reader alone: the lists are there, and no code was lost or made.
        const auto graph = stockRead(out);
        ASSERT_NE(graph, nullptr);
        AttributeReader reader;
        graph->accept(reader);
        EXPECT_EQ(reader.without, 0);
        EXPECT_EQ(reader.uncoloured, 0);
        std::set<IrCodes> expected;
        for (const auto& [codes, faces] : loadGraph(in, LoadPurpose::visible).faces) {
            expected.insert(codes);
        }
        EXPECT_EQ(reader.codes, expected);
        EXPECT_EQ(polygonCounts(*graph), report.polygonsWritten);
    }
}

TEST_P(Conversion, GivesTheSameModelAsTheOriginal) {
    const TemporaryFolder folder;
    const auto in = data / "tricky_1640.flt",
               out = folder.path() / (std::string("out.") + GetParam());
    convertModel(in, out);
    const auto before = Model::load(in), after = Model::load(out);
    EXPECT_EQ(before->bounds(), after->bounds());
    for (const auto& [codes, use] : before->codes()) {
        if (use.area_m2 > 0.0) {
            ASSERT_TRUE(after->codes().contains(codes));
            EXPECT_NEAR(after->codes().at(codes).area_m2, use.area_m2, 1e-5 * use.area_m2);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Conversion, testing::Values("osgt", "osgb", "ive", "osg", "osgx"),
                         [](const auto& info) { return std::string(info.param); });

/// Puts a square somewhere by each kind of node that has a place of its own, in turn.
class Placer {
  public:
    osg::ref_ptr<osg::Node> placed(const osg::Vec3d& at_m) {
        const osg::Quat turn(within_(random_), osg::Vec3d(within_(random_), 1.0, 0.3));
        osg::ref_ptr<osg::Group> node;
        switch (count_++ % 3) {
        case 0:
            node = new osg::MatrixTransform(osg::Matrixd::rotate(turn) *
                                            osg::Matrixd::translate(at_m));
            break;
        case 1: {
            osg::ref_ptr<osg::PositionAttitudeTransform> own = new osg::PositionAttitudeTransform;
            own->setPosition(at_m);
            own->setAttitude(turn);
            node = own;
            break;
        }
        default: {
            const osg::Vec3d half = at_m * within_(random_);
            osg::ref_ptr<osg::Group> outer =
                new osg::MatrixTransform(osg::Matrixd::translate(at_m - half));
            node = new osg::MatrixTransform(osg::Matrixd::rotate(turn) *
                                            osg::Matrixd::translate(half));
            node->addChild(square());
            outer->addChild(node);
            return outer;
        }
        }
        node->addChild(square());
        return node;
    }
    osg::ref_ptr<osg::Node> placedWithin(const osg::Vec3d& far_m) {
        return placed({far_m.x() * within_(random_), far_m.y() * within_(random_),
                       far_m.z() * within_(random_)});
    }

  private:
    std::mt19937 random_{48};
    std::uniform_real_distribution<double> within_{-1.0, 1.0};
    int count_ = 0;
};

TEST_P(Conversion, KeepsPlacesFarFromTheOriginAndAnywhereElse) {
    const auto in = ownFolder() / "in.osgb";
    const auto out = ownFolder() / (std::string("out.") + GetParam());
    struct Row {
        const char* name;
        osg::Vec3d at_m, far_m; ///< about which place, and how far on either side
    };
    // The last is a model as large as a ship, as far from zero as maps of the Earth have it.
    for (const Row& row :
         {Row{"near", {0, 0, 0}, {1, 1, 1}}, Row{"on a field", {0, 0, 0}, {1e3, 1e3, 10}},
          Row{"on the Earth", {0, 0, 0}, {6e6, 6e6, 6e6}},
          Row{"a ship on it", {3.9e6, 0.7e6, 5.0e6}, {50, 10, 10}}}) {
        SCOPED_TRACE(row.name);
        osg::ref_ptr<osg::Group> root = new osg::Group;
        osg::ref_ptr<osg::MatrixTransform> there =
            new osg::MatrixTransform(osg::Matrixd::translate(row.at_m));
        root->addChild(there);
        Placer placer;
        for (int i = 0; i < 200; ++i) {
            there->addChild(placer.placedWithin(row.far_m));
        }
        // 1.5 m apart at 500 km, as the map of a country has them.
        if (row.far_m.x() > 1e6) {
            there->addChild(placer.placed({500123.25, 0.0, 0.0}));
            there->addChild(placer.placed({500124.75, 0.0, 0.0}));
        }
        ASSERT_TRUE(osgDB::writeNodeFile(*root, in.string()));
        convertModel(in, out);
        const PlacedVertices before(*root), after(*loadGraph(out, LoadPurpose::infrared).node);
        ASSERT_EQ(after.places.size(), before.places.size());
        const double extent = (before.bounds._max - before.bounds._min).length();
        for (std::size_t i = 0; i < before.places.size(); ++i) {
            ASSERT_LE((after.places[i] - before.places[i]).length(), 1e-7 * extent)
                << "corner " << i;
        }
    }
}

TEST(ModelConverter, RefusesASceneOfWhichNothingIsRead) {
    const auto in =
        writtenFile(ownFolder() / "a.osgt",
                    "#Ascii Scene \n#Version 161 \n#Generator OpenSceneGraph 3.6.5 \n\n"
                    "osg::Group {\n  UniqueID 1 \n  Children 1 {\n    osg::Gode {\n      "
                    "UniqueID 2 \n    }\n  }\n}\n");
    const auto out = ownFolder() / "a.osgb";
    EXPECT_NE(refusal([&] { convertModel(in, out); }), "accepted");
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(ModelConverter, KeepsTheNumberOfFacesOfEachCode) {
    const TemporaryFolder folder;
    const auto report =
        convertModel(source / "samples/turboprop4/turboprop4.flt", folder.path() / "t.osgb");
    EXPECT_EQ(report.polygonsRead, report.polygonsWritten);
    long faces = 0;
    for (const auto& [codes, count] : report.polygonsWritten) {
        faces += count;
    }
    EXPECT_EQ(faces, 862);
    EXPECT_EQ(report.drawablesRead, 862);
    EXPECT_LT(report.drawablesWritten, 50);

    // As whoever reads the file counts them: a disc of many corners is a face still.
    const auto before = Model::load(source / "samples/turboprop4/turboprop4.flt"),
               after = Model::load(folder.path() / "t.osgb");
    for (const auto& [codes, use] : before->codes()) {
        EXPECT_EQ(after->codes().at(codes).faces, use.faces);
    }
}

TEST(ModelConverter, CutsAFaceThatIsNotConvexAndNoOther) {
    const TemporaryFolder folder;
    SquareFile file;
    file.vertices.clear();
    const std::pair<double, double> corners[] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    for (const auto& [x, y] : corners) {
        file.vertices +=
            record(flight::vertexCN, i16(0) + i16(0x2000) + f64(x) + f64(y) + f64(0) + f32(0) +
                                         f32(0) + f32(1) + i32(-1) + i32(-1) + i32(0));
    }
    file.palette = record(flight::vertexPalette, i32(8 + 6 * 56));
    const auto written = [&](const std::vector<int>& order) {
        std::string list;
        for (const int vertex : order) {
            list += i32(8 + 56 * vertex);
        }
        file.list = record(flight::vertexList, list);
        const auto report =
            convertModel(folder.write("a.flt", file.bytes()), folder.path() / "a.osgb");
        const auto model = Model::load(folder.path() / "a.osgb");
        return std::pair(model->codes().at({1, 2}).faces, model->codes().at({1, 2}).area_m2);
    };
    EXPECT_EQ(written({0, 1, 2, 3, 4, 5}), std::pair(4, 3.0)) << "an L";
    EXPECT_EQ(written({0, 2, 3, 4}), std::pair(2, 1.0)) << "an arrow of four corners";
    EXPECT_EQ(written({0, 1, 2, 4, 5}), std::pair(1, 3.5)) << "convex";
}

TEST(ModelConverter, ConvertsAConvertedFileAgain) {
    const TemporaryFolder folder;
    const auto first = folder.path() / "a.osgt", second = folder.path() / "b.ive";
    convertModel(data / "tricky_1640.flt", first);
    const auto report = convertModel(first, second);
    EXPECT_EQ(report.polygonsRead, report.polygonsWritten);
    EXPECT_EQ(Model::load(first)->codes(), Model::load(second)->codes());
}

TEST(ModelConverter, KeepsJointsAndDescriptionsOfWhatPluginsRead) {
    const TemporaryFolder folder;
    const auto graph = loadGraph(source / "samples/box/box.flt", LoadPurpose::visible).node;
    osg::ref_ptr<osgSim::DOFTransform> joint = new osgSim::DOFTransform;
    joint->setMaxHPR({1, 2, 3});
    joint->setDescriptions({"a comment"});
    joint->addChild(graph);
    osg::ref_ptr<osgSim::MultiSwitch> sets = new osgSim::MultiSwitch;
    sets->addChild(joint);
    sets->setValue(0, 0, true);
    const fs::path in = folder.path() / "a.osgt", out = folder.path() / "b.osgb";
    ASSERT_TRUE(osgDB::writeNodeFile(*sets, in.string()));
    convertModel(in, out);

    const auto back = stockRead(out);
    const auto* written = dynamic_cast<const osgSim::MultiSwitch*>(back.get());
    ASSERT_TRUE(written);
    const auto* turned = dynamic_cast<const osgSim::DOFTransform*>(written->getChild(0));
    ASSERT_TRUE(turned);
    EXPECT_EQ(turned->getMaxHPR(), osg::Vec3(1, 2, 3));
    EXPECT_EQ(turned->getDescriptions(), joint->getDescriptions());
}

TEST(ModelConverter, SaysThatNamesOfSwitchSetsAreLost) {
    const TemporaryFolder folder;
    SquareFile file;
    file.group =
        record(96, std::string("wheels\0\0", 8) + zeros(4) + i32(0) + i32(1) + i32(1) + i32(1));
    file.pushGroup += record(132, i32(0) + std::string("wheels down\0", 12));
    const auto in = folder.write("switch.flt", file.bytes());
    const auto report = convertModel(in, folder.path() / "switch.osgb");
    EXPECT_THAT(report.remarks,
                testing::Contains(HasSubstr("sets of switches have names, which are not kept")));
}

TEST(ModelConverter, LeavesNothingBehindButItsOutput) {
    const TemporaryFolder folder;
    convertModel(data / "plate.flt", folder.path() / "plate.osgt");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(ModelConverter, RefusesWhatWouldLoseCodes) {
    const TemporaryFolder folder;
    const auto in = data / "plate.flt";
    const auto own = folder.write("own.osgt", "");
    convertModel(in, own);
    struct Row {
        const char* name;
        fs::path in, out;
        const char* says;
    };
    for (const auto& row : std::vector<Row>{
             {"OpenFlight", in, folder.path() / "a.flt", "without its infrared codes"},
             {"a kind without user data", in, folder.path() / "a.obj", "type \".obj\""},
             {"no kind", in, folder.path() / "a", "type \".\""},
             {"no folder", in, folder.path() / "no/a.osgt", "no such folder"},
             {"itself", own, own, "the input itself"},
             {"missing input", folder.path() / "x.flt", folder.path() / "a.osgt", "no such file"},
             {"damaged input", folder.write("d.flt", readBytes(in).substr(0, 4600)),
              folder.path() / "a.osgt", "truncated"}}) {
        EXPECT_THAT(refusal([&] { convertModel(row.in, row.out); }), HasSubstr(row.says))
            << row.name;
    }
}

TEST(ModelSummary, SaysWhatAFileHolds) {
    const auto summary = summarizeModel(data / "tricky_1640.flt");
    EXPECT_EQ(summary.format, "OpenFlight 16.4");
    EXPECT_EQ(summary.faces, 27);
    ASSERT_EQ(summary.references.size(), 1u);
    EXPECT_GT(summary.triangles, 7900);
    const auto text = toText(summary);
    EXPECT_THAT(text, HasSubstr("faces: 27"));
    EXPECT_THAT(text, HasSubstr("codes: temperature -1, material -2: 1 faces, 1 m2"));
    EXPECT_THAT(text, HasSubstr("remark: "));
}
