#include <cmath>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Material>

#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/reading/MaterialNames.h"
#include "tests/support/DecimalCommas.h"
#include "tests/support/FlightBytes.h"
#include "tests/support/Refusal.h"

using namespace irsg;
using namespace irsg::test;
using smat::test::refusalOf;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

namespace {

double areaOf(const Model& model) {
    double area_m2 = 0.0;
    for (const auto& [codes, use] : model.codes()) {
        area_m2 += use.area_m2;
    }
    return area_m2;
}

int facesOf(const Model& model) {
    int faces = 0;
    for (const auto& [codes, use] : model.codes()) {
        faces += use.faces;
    }
    return faces;
}

/// A triangle of 0.5 m^2 and one of 1.5 x 2.5 / 2 m^2, with the numbers that a locale may split.
const std::string twoFaces = "# two\n"
                             "v 0.0 0.0 0.0\nv 1.0 0.0 0.0\nv 0.0 1.0 0.0\n"
                             "v 1.5 0 0.5\nv 0 2.5 0.5\nv 0 0 0.5\n"
                             "f 1 2 3\nf 6 4 5\n";

/// Facets of a tetrahedron with legs of 1 m: 1.5 m^2 and the root of 3 half.
std::string tetrahedron(const char* name = "t") {
    const char* facets[][3] = {{"0 0 0", "0 1 0", "1 0 0"},
                               {"0 0 0", "1 0 0", "0 0 1"},
                               {"0 0 0", "0 0 1", "0 1 0"},
                               {"1 0 0", "0 1 0", "0 0 1"}};
    std::string text = std::string("solid ") + name + "\n";
    for (const auto& facet : facets) {
        text += " facet normal 0 0 0\n  outer loop\n";
        for (const char* corner : facet) {
            text += std::string("   vertex ") + corner + "\n";
        }
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid " + name + "\n";
}

std::string binary(int facets, const std::string& head = "a box") {
    std::string bytes = head;
    bytes.resize(80, ' ');
    const auto count = static_cast<std::uint32_t>(facets);
    bytes.append(reinterpret_cast<const char*>(&count), 4);
    for (int i = 0; i < facets; ++i) {
        const float values[12] = {0, 0, 0,
                                  0, 0, static_cast<float>(i),
                                  1, 0, static_cast<float>(i),
                                  0, 1, static_cast<float>(i)};
        bytes.append(reinterpret_cast<const char*>(values), sizeof values);
        bytes.append(2, '\0');
    }
    return bytes;
}

} // namespace

TEST(ObjReader, ReadsFacesInAllTheirForms) {
    const TemporaryFolder folder;
    const struct {
        const char* name;
        std::string text;
        int faces;
        double area_m2;
    } rows[] = {
        {"two triangles", twoFaces, 2, 0.5 + 1.5 * 2.5 / 2},
        {"a quad with all numbers",
         "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nvt 0 0\nvn 0 0 1\n"
         "f 1/1/1 2/1/1 3/1/1 4/1/1\n",
         1, 6.0},
        {"numbers from the end", "v 0 0 0\nv 2 0 0\nv 0 3 0\nvn 0 0 1\nf -3//-1 -2//-1 -1//-1\n", 1,
         3.0},
        {"a concave face of six corners",
         "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n", 4, 3.0},
        {"a line that goes on", "v 0 0 0\nv 2 0 0\nv 0 3 0\nf 1 \\\n 2 3\n", 1, 3.0},
        {"lines of another system", "v 0 0 0\r\nv 2 0 0\r\nv 0 3 0\r\nf 1 2 3\r\n", 1, 3.0},
        {"weights and colours", "v 0 0 0 1\nv 2 0 0 0.5 0.5 0.5\nv 0 3 0\nf 1 2 3\n", 1, 3.0},
    };
    for (const auto& row : rows) {
        const auto model = Model::load(folder.write("a.obj", row.text));
        EXPECT_EQ(facesOf(*model), row.faces) << row.name;
        EXPECT_NEAR(areaOf(*model), row.area_m2, 1e-6) << row.name;
    }
}

TEST(ObjReader, HasYUp) {
    const TemporaryFolder folder;
    const auto model =
        Model::load(folder.write("a.obj", "v 1 20 30\nv 2 20 30\nv 2 21 30\nf 1 2 3\n"));
    EXPECT_EQ(model->bounds().min, (Vec3{1, -30, 20}));
    EXPECT_EQ(model->bounds().max, (Vec3{2, -30, 21}));
}

TEST(ObjReader, PaintsWithItsMaterials) {
    const TemporaryFolder folder;
    folder.write("a b.mtl", "newmtl red paint\nKd 1 0.25 0\nd 0.5\nnewmtl other\n");
    const auto loaded = loadGraph(
        folder.write("a.obj", "mtllib a b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                              "g one\nusemtl red paint\nf 1 2 3\ng two\nusemtl none\nf 3 2 1\n"),
        LoadPurpose::visible);
    const auto* group = loaded.node->asGroup();
    ASSERT_EQ(group->getNumChildren(), 2u);
    EXPECT_EQ(group->getChild(0)->getName(), "one");
    const auto* state = group->getChild(0)->asGeode()->getDrawable(0)->getStateSet();
    ASSERT_TRUE(state);
    const auto* material =
        dynamic_cast<const osg::Material*>(state->getAttribute(osg::StateAttribute::MATERIAL));
    ASSERT_TRUE(material);
    EXPECT_EQ(material->getDiffuse(osg::Material::FRONT), osg::Vec4(1, 0.25f, 0, 0.5f));
    EXPECT_EQ(state->getRenderingHint(), osg::StateSet::TRANSPARENT_BIN);
    EXPECT_EQ(materialNameOf(*state), "red paint");
    const auto* other = group->getChild(1)->asGeode()->getDrawable(0)->getStateSet();
    ASSERT_TRUE(other) << "a material that no library describes has its name";
    EXPECT_TRUE(other->getAttributeList().empty());
    EXPECT_EQ(materialNameOf(*other), "none");
}

TEST(ObjReader, KeepsNamesOfObjectsGroupsAndMaterials) {
    const TemporaryFolder folder;
    const std::string face = "f 1 2 3\n";
    const auto loaded = loadGraph(
        folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + face + "o hull\n" + face +
                                  "g port wing\nusemtl paint\n" + face + "usemtl glass\n" + face +
                                  "g tail\n" + face + "o engine\n" + face + "g fan\n" + face),
        LoadPurpose::infrared);
    std::vector<std::string> found;
    const auto say = [&](const std::string& above, osg::Geode& geode) {
        for (unsigned int i = 0; i < geode.getNumDrawables(); ++i) {
            const auto* state = geode.getDrawable(i)->getStateSet();
            found.push_back(above + geode.getName() + ":" + (state ? materialNameOf(*state) : ""));
        }
    };
    auto& root = *loaded.node->asGroup();
    for (unsigned int i = 0; i < root.getNumChildren(); ++i) {
        auto& child = *root.getChild(i)->asGroup();
        if (child.asGeode()) {
            say("", *child.asGeode());
            continue;
        }
        for (unsigned int j = 0; j < child.getNumChildren(); ++j) {
            say(child.getName() + "/", *child.getChild(j)->asGeode());
        }
    }
    EXPECT_THAT(found,
                testing::ElementsAre(":", "hull:", "hull/port wing:paint", "hull/port wing:glass",
                                     "hull/tail:glass", "engine:glass", "engine/fan:glass"));
}

TEST(ObjReader, SaysWhatItLeavesOut) {
    const TemporaryFolder folder;
    const auto loaded = loadGraph(
        folder.write("a.obj", "mtllib none.mtl\n" + twoFaces + "l 1 2\np 1\nfff 1 2 3\ns 1\n"),
        LoadPurpose::visible);
    EXPECT_THAT(loaded.remarks, Contains(HasSubstr("none.mtl, which is missing")));
    EXPECT_THAT(loaded.remarks, Contains(HasSubstr("2 lines, points and free forms")));
    EXPECT_THAT(loaded.remarks, Contains(AllOf(HasSubstr("line 13"), HasSubstr("\"fff\""))));
}

TEST(ObjReader, SaysThatTheFormatCannotTellWhetherItIsWhole) {
    const TemporaryFolder folder;
    const auto whole = loadGraph(folder.write("a.obj", twoFaces), LoadPurpose::infrared);
    EXPECT_THAT(whole.remarks, testing::ElementsAre(AllOf(HasSubstr("6 vertices and 2 faces"),
                                                          HasSubstr("cannot tell"))));
    const auto cut = loadGraph(folder.write("a.obj", twoFaces.substr(0, twoFaces.rfind("f "))),
                               LoadPurpose::infrared);
    EXPECT_THAT(cut.remarks,
                testing::ElementsAre(AllOf(HasSubstr("6 vertices and 1 faces"),
                                           HasSubstr("3 vertices belong to no face"))));
}

TEST(ObjReader, RefusesWhatIsWrongWithItsLine) {
    const TemporaryFolder folder;
    const struct {
        const char* text;
        const char* place;
        const char* value;
    } rows[] = {
        {"v 0 0\nf 1 1 1\n", "line 1", "2 numbers"},
        {"v 0 0 1,5\n", "line 1", "\"1,5\""},
        {"v 0 0 nan\n", "line 1", "\"nan\""},
        {"v 0 0 1e999\n", "line 1", "\"1e999\""},
        {"v 0 0 0\nf 1 1 2\n", "line 2", "\"2\""},
        {"v 0 0 0\nf 1 1 0\n", "line 2", "\"0\""},
        {"v 0 0 0\nf 1 1 -2\n", "line 2", "\"-2\""},
        {"v 0 0 0\nf 1/1 1 1\n", "line 2", "texture coordinate"},
        {"v 0 0 0\nf 1//1 1 1\n", "line 2", "normal"},
        {"v 0 0 0\nf 1 1\n", "line 2", "2 corners"},
        {"v 0 0 0\nf 1 1 99999999999999999999\n", "line 2", "vertex"},
    };
    for (const auto& row : rows) {
        EXPECT_THAT(refusalOf([&] { Model::load(folder.write("a.obj", row.text)); }),
                    AllOf(HasSubstr("a.obj"), HasSubstr(row.place), HasSubstr(row.value)))
            << row.text;
    }
    EXPECT_THAT(refusalOf([&] { Model::load(folder.write("a.obj", std::string("v 0\0 0", 6))); }),
                HasSubstr("byte 3"));
}

TEST(StlReader, ReadsTextAndBinary) {
    const TemporaryFolder folder;
    const auto text = Model::load(folder.write("a.stl", tetrahedron()));
    EXPECT_EQ(facesOf(*text), 4);
    EXPECT_NEAR(areaOf(*text), 1.5 + std::sqrt(3.0) / 2, 1e-6);
    const auto two = loadGraph(folder.write("b.stl", tetrahedron("one") + tetrahedron("two")),
                               LoadPurpose::visible);
    ASSERT_EQ(two.node->asGroup()->getNumChildren(), 2u);
    EXPECT_EQ(two.node->asGroup()->getChild(1)->getName(), "two");
    for (const char* head : {"a box", "solid but binary"}) {
        const auto model = Model::load(folder.write("c.stl", binary(3, head)));
        EXPECT_EQ(facesOf(*model), 3) << head;
        EXPECT_NEAR(areaOf(*model), 1.5, 1e-6) << head;
    }
}

TEST(StlReader, RefusesEveryCut) {
    const TemporaryFolder folder;
    for (const std::string& whole : {tetrahedron(), binary(3)}) {
        for (std::size_t size = 0; size + 2 < whole.size() - 8; ++size) {
            EXPECT_NE(refusalOf([&] { Model::load(folder.write("a.stl", whole.substr(0, size))); }),
                      "nothing was refused")
                << size;
        }
    }
}

TEST(StlReader, RefusesWhatIsWrongWithItsPlace) {
    const TemporaryFolder folder;
    const auto changed = [](const std::string& from, const std::string& to) {
        std::string text = tetrahedron();
        return text.replace(text.find(from), from.size(), to);
    };
    std::string infinite = binary(2);
    const float value = INFINITY;
    std::memcpy(infinite.data() + 84 + 50 + 12, &value, 4);
    const struct {
        std::string bytes;
        const char* named;
    } rows[] = {{changed("vertex 0 1 0", "vertex 0 1,0 0"), "line 5: found \"1,0\""},
                {changed("vertex 0 1 0", "vertex 0 1"), "line 5"},
                {changed("vertex 0 1 0\n", "\n"), "line 7: found \"endloop\", expected vertex"},
                {changed("endfacet", "endface"), "line 8"},
                {infinite, "byte 146: found an infinite number"},
                {binary(3).replace(80, 1, "\x04"), "4 facets, expected at most 3"}};
    for (const auto& row : rows) {
        EXPECT_THAT(refusalOf([&] { Model::load(folder.write("a.stl", row.bytes)); }),
                    HasSubstr(row.named));
    }
}

TEST(OurReaders, ReadNumbersWithPointsInEveryLocale) {
    const TemporaryFolder folder;
    const auto obj = folder.write("a.obj", twoFaces);
    const auto stl = folder.write("a.stl", tetrahedron());
    for (const char* name : {"de_DE", "fr_CA"}) {
        const smat::test::DecimalCommas locale(name, folder.path());
        if (!locale.isThere()) {
            GTEST_SKIP() << "this system cannot make the locale " << name;
        }
        EXPECT_NEAR(areaOf(*Model::load(obj)), 2.375, 1e-6) << name;
        EXPECT_NEAR(areaOf(*Model::load(stl)), 1.5 + std::sqrt(3.0) / 2, 1e-6) << name;
    }
}
