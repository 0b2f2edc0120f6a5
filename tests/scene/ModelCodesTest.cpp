// Codes beside a model: rules over names, painted surfaces, and what is left of both when the model
// was exported anew.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osg/Material>
#include <osg/MatrixTransform>

#include "irsg/geometry/conversion/CodedGraph.h"
#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/model/FirstSignature.h"
#include "irsg/geometry/model/ModelConverter.h"
#include "irsg/signature/MaterialLibrary.h"
#include "tests/support/ModelAccess.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using namespace irsg::test;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

using Of = CodeRule::Of;

/// A checkered plate of n by n squares in z = 0, each of `pieces` parts, as one drawable.
osg::ref_ptr<osg::Geode> plate(int n, GLenum mode = GL_QUADS) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    auto* corners = new osg::Vec3Array;
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const auto at = [&](int dx, int dy) {
                return osg::Vec3(static_cast<float>(x + dx), static_cast<float>(y + dy), 0.0f);
            };
            if (mode == GL_QUADS) {
                for (const auto& c : {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}) {
                    corners->push_back(c);
                }
            } else {
                for (const auto& c : {at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1)}) {
                    corners->push_back(c);
                }
            }
        }
    }
    geometry->setVertexArray(corners);
    geometry->addPrimitiveSet(new osg::DrawArrays(mode, 0, static_cast<GLsizei>(corners->size())));
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("plate");
    geode->addDrawable(geometry);
    return geode;
}

/// A square of the plate, painted, as two triangles.
void paint(PaintedSurface& surface, double x, double y, double side = 1.0) {
    surface.triangles.push_back({x, y, 0, x + side, y, 0, x + side, y + side, 0});
    surface.triangles.push_back({x, y, 0, x + side, y + side, 0, x, y + side, 0});
}

std::map<IrCodes, long> given(osg::ref_ptr<osg::Node> graph, const ModelCodes& codes,
                              std::vector<std::string>* remarks = nullptr) {
    auto said = giveCodes(graph, codes, "plate.glb");
    if (remarks) {
        *remarks = std::move(said);
    }
    return polygonCounts(*graph);
}

void call(osg::Node& node, const std::string& material) {
    osg::ref_ptr<osg::Material> made = new osg::Material;
    made->setName(material);
    node.getOrCreateStateSet()->setAttribute(made);
}

/// Two quads of material "Paint grey" below group "Hull", one of "Glass" below "Cockpit".
osg::ref_ptr<osg::Group> named() {
    osg::ref_ptr<osg::Group> root = new osg::Group, hull = new osg::Group, cockpit = new osg::Group;
    hull->setName("Hull");
    cockpit->setName("Cockpit");
    for (int i = 0; i < 3; ++i) {
        auto geode = plate(1);
        geode->setName(i == 0 ? "left" : i == 1 ? "right" : "pane");
        call(*geode, i < 2 ? "Paint grey" : "Glass");
        (i < 2 ? hull : cockpit)->addChild(geode);
    }
    root->addChild(hull);
    root->addChild(cockpit);
    return root;
}

} // namespace

TEST(ModelCodes, PatternsFitAsInAShell) {
    for (const auto& [name, pattern] : {std::pair{"Paint grey", "Paint*"},
                                        {"Paint grey", "*grey"},
                                        {"Paint grey", "*"},
                                        {"", "*"},
                                        {"", ""},
                                        {"ab", "?b"},
                                        {"a*b", "a*b"},
                                        {"abcabd", "*abd"},
                                        {"aXbYc", "a*b*c"}}) {
        EXPECT_TRUE(fitsPattern(name, pattern)) << name << " " << pattern;
    }
    for (const auto& [name, pattern] : {std::pair{"Paint grey", "paint*"},
                                        {"Paint", "Paint?"},
                                        {"ab", "a"},
                                        {"", "?"},
                                        {"abcab", "*abd"},
                                        {"a", ""}}) {
        EXPECT_FALSE(fitsPattern(name, pattern)) << name << " " << pattern;
    }
}

TEST(ModelCodes, RulesTakeMaterialsObjectsAndGroupsAndTheLastOneWins) {
    std::vector<std::string> remarks;
    const ModelCodes codes{{{Of::material, "*", {1, 1}},
                            {Of::material, "Glass", {std::nullopt, 7}},
                            {Of::group, "Hull", {4, std::nullopt}},
                            {Of::object, "right", {5, 6}},
                            {Of::object, "Wing*", {9, 9}}},
                           {}};
    EXPECT_THAT(given(named(), codes, &remarks),
                ElementsAre(std::pair(IrCodes{1, 7}, 1), std::pair(IrCodes{4, 1}, 1),
                            std::pair(IrCodes{5, 6}, 1)));
    EXPECT_THAT(remarks, ElementsAre("plate.codes.json: nothing is called object \"Wing*\""));
}

TEST(ModelCodes, WhatANodeSharesIsToldApartByWhereItStands) {
    auto shared = plate(1);
    osg::ref_ptr<osg::Group> root = new osg::Group, left = new osg::Group;
    osg::ref_ptr<osg::MatrixTransform> right =
        new osg::MatrixTransform(osg::Matrixd::translate(5, 0, 0));
    left->setName("left");
    right->setName("right");
    for (osg::Group* side : {left.get(), static_cast<osg::Group*>(right.get())}) {
        side->addChild(shared);
        root->addChild(side);
    }
    EXPECT_EQ(given(root, {{{Of::group, "left", {1, 1}}}, {}}),
              (std::map<IrCodes, long>{{{0, 0}, 1}, {{1, 1}, 1}}));
    ModelCodes painted{{}, {{{3, 3}, {}}}};
    paint(painted.painted[0], 5, 0);
    EXPECT_EQ(given(root, painted), (std::map<IrCodes, long>{{{0, 0}, 1}, {{3, 3}, 1}}));
}

TEST(ModelCodes, PaintedSquaresCutADrawableAndKeepItsPolygons) {
    ModelCodes codes{{{Of::object, "plate", {1, 2}}}, {{{3, std::nullopt}, {}}, {{5, 6}, {}}}};
    paint(codes.painted[0], 0, 0);
    paint(codes.painted[0], 2, 2);
    paint(codes.painted[1], 2, 2);
    std::vector<std::string> remarks;
    EXPECT_EQ(given(plate(4), codes, &remarks),
              (std::map<IrCodes, long>{{{1, 2}, 14}, {{3, 2}, 1}, {{5, 6}, 1}}));
    EXPECT_THAT(remarks, IsEmpty()) << "what is painted over is not lost";
}

TEST(ModelCodes, TheBackOfAPaintedFaceIsNotPainted) {
    osg::ref_ptr<osg::Geode> back = polygon(
        {osg::Vec3(0, 0, 0), osg::Vec3(0, 1, 0), osg::Vec3(1, 1, 0), osg::Vec3(1, 0, 0)}, {});
    osg::ref_ptr<osg::Group> both = new osg::Group;
    both->addChild(plate(1));
    both->addChild(back);
    ModelCodes codes{{}, {{{3, 3}, {}}}};
    paint(codes.painted[0], 0, 0);
    EXPECT_EQ(given(both, codes), (std::map<IrCodes, long>{{{0, 0}, 1}, {{3, 3}, 1}}));
}

TEST(ModelCodes, PaintSurvivesAnotherCutOfTheSameSurface) {
    // Squares of two, drawn anew as squares of one and as triangles; and the other way round.
    ModelCodes coarse{{}, {{{3, 3}, {}}}};
    for (int i = 0; i < 4; ++i) {
        paint(coarse.painted[0], 2.0 * i, 2.0 * i, 2.0);
    }
    std::vector<std::string> remarks;
    EXPECT_EQ(given(plate(8), coarse, &remarks).at({3, 3}), 16);
    EXPECT_THAT(remarks, IsEmpty());
    EXPECT_EQ(given(plate(8, GL_TRIANGLES), coarse, &remarks).at({3, 3}), 32);
    EXPECT_THAT(remarks, IsEmpty());

    ModelCodes fine{{}, {{{3, 3}, {}}}};
    for (int i = 0; i < 2; ++i) {
        for (int k = 0; k < 2; ++k) {
            paint(fine.painted[0], i, k);
        }
    }
    osg::ref_ptr<osg::MatrixTransform> larger =
        new osg::MatrixTransform(osg::Matrixd::scale(2, 2, 1));
    larger->addChild(plate(4));
    EXPECT_EQ(given(larger, fine, &remarks).at({3, 3}), 1);
    EXPECT_THAT(remarks, IsEmpty());
}

TEST(ModelCodes, AnExportWithATenthOfItsFacesMovedKeepsTheOthersAndTellsWhichAreLost) {
    ModelCodes codes{{}, {{{3, 3}, {}}}};
    for (int i = 0; i < 10; ++i) {
        for (int k = 0; k < 10; ++k) {
            paint(codes.painted[0], i, k);
        }
    }
    auto moved = plate(10);
    auto& corners =
        dynamic_cast<osg::Vec3Array&>(*moved->getDrawable(0)->asGeometry()->getVertexArray());
    for (std::size_t face = 0; face < 100; face += 10) {
        for (std::size_t c = 0; c < 4; ++c) {
            corners[4 * face + c].z() = 0.4f;
        }
    }
    std::vector<std::string> remarks;
    EXPECT_EQ(given(moved, codes, &remarks), (std::map<IrCodes, long>{{{0, 0}, 10}, {{3, 3}, 90}}));
    EXPECT_THAT(remarks,
                ElementsAre(HasSubstr("20 of 200 triangles (10 % of its area) lie on no face")));
}

TEST(ModelCodes, FarFromTheOriginAPaintedFaceIsStillFound) {
    osg::ref_ptr<osg::MatrixTransform> far =
        new osg::MatrixTransform(osg::Matrixd::translate(4.5e6, 5e6, 300));
    far->addChild(plate(3));
    ModelCodes codes{{}, {{{3, 3}, {}}}};
    codes.painted[0].triangles.push_back(
        {4.5e6 + 1, 5e6 + 1, 300, 4.5e6 + 2, 5e6 + 1, 300, 4.5e6 + 2, 5e6 + 2, 300});
    codes.painted[0].triangles.push_back(
        {4.5e6 + 1, 5e6 + 1, 300, 4.5e6 + 2, 5e6 + 2, 300, 4.5e6 + 1, 5e6 + 2, 300});
    EXPECT_EQ(given(far, codes), (std::map<IrCodes, long>{{{0, 0}, 8}, {{3, 3}, 1}}));
}

TEST(ModelCodes, AFileComesBackEqualAndIsReadByLines) {
    ModelCodes codes{{{Of::material, "Paint \"grey\" *", {1, std::nullopt}},
                      {Of::group, "Hull", {std::nullopt, -5}}},
                     {{{3, 4}, {}}}};
    paint(codes.painted[0], 0.1, 1e-7);
    const std::string text = modelCodesToJson(codes);
    EXPECT_EQ(modelCodesFromJson(text, "a"), codes);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 14);
    EXPECT_EQ(modelCodesFromJson(modelCodesToJson({}), "a"), ModelCodes());
}

TEST(ModelCodes, EverythingThatIsWrongInAFileIsNamedWithItsLine) {
    const auto refused = [](const std::string& text) {
        return refusal([&] { modelCodesFromJson(text, "plane.codes.json"); });
    };
    const std::string head = "{\"format\": \"smat-codes\", \"version\": 1,\n";
    const std::string several = refused(head + R"("rules": [
{"material": "a"},
{"material": "a", "object": "b", "materialIndex": 1},
{"temperatureIndex": 1},
{"group": "a", "temperatureIndex": 1.5},
{"group": "a", "temperatureIndex": 1, "colour": 2},
7],
"painted": [
{"materialIndex": 1},
{"materialIndex": 1, "triangles": [[0, 0, 0, 1, 0, 0, 0, 1]]}]})");
    for (const char* said :
         {"plane.codes.json: rules.0, line 3: found no index, expected temperatureIndex, "
          "materialIndex or both",
          "rules.1, line 4: found a rule for several, expected one of material, object and group",
          "rules.2, line 5: found a rule for nothing",
          "rules.3.temperatureIndex, line 6: found 1.5", "rules.4.colour, line 7",
          "rules.5, line 8", "painted.0.triangles", "line 10", "painted.1.triangles.0, line 11"}) {
        EXPECT_THAT(several, HasSubstr(said));
    }
    EXPECT_THAT(refused("{}"), HasSubstr("format"));
    EXPECT_THAT(refused("{\"format\": \"smat-codes\", \"version\": 2}"), HasSubstr("version"));
    EXPECT_THAT(refused(head + "\"rules\": {}}"), HasSubstr("a list"));
    EXPECT_THAT(refused(head + "\"rules\": [{\"material\": \"a\", \"material\": \"b\"}]}"),
                HasSubstr("material"));
    EXPECT_THAT(refused("not JSON"), HasSubstr("codes of a model"));
}

TEST(ModelCodes, TheFileBesideAModelWinsOverTheModelAndGoesWithEveryReader) {
    const auto folder = smat::test::ownFolder();
    const auto model =
        smat::test::writtenFile(folder / "plate.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                                      "o Floor\nusemtl Wood\nf 1 2 3 4\n");
    EXPECT_EQ(codesFileOf(model), folder / "plate.codes.json");
    const auto before = modelStampOf(model);
    EXPECT_EQ(Model::load(model)->codes().begin()->first, (IrCodes{0, 0}));
    saveModelCodes({{{Of::material, "Wood", {2, 3}}}, {}}, model);
    EXPECT_NE(modelStampOf(model), before);
    EXPECT_EQ(Model::load(model)->codes().begin()->first, (IrCodes{2, 3}));
    EXPECT_EQ(polygonCounts(*loadGraph(model, LoadPurpose::visible).node).begin()->first,
              (IrCodes{2, 3}));

    convertModel(model, folder / "plate.osgt");
    saveModelCodes({}, model);
    EXPECT_FALSE(std::filesystem::exists(codesFileOf(model)));
    EXPECT_EQ(Model::load(model)->codes().begin()->first, (IrCodes{0, 0}));
    EXPECT_EQ(Model::load(folder / "plate.osgt")->codes().begin()->first, (IrCodes{2, 3}))
        << "saved in the model";

    smat::test::writtenFile(codesFileOf(model), "{\"format\": \"smat-codes\"");
    EXPECT_THAT(refusal([&] { Model::load(model); }), HasSubstr("plate.codes.json"));
}

/// What all names of a graph suggest.
std::vector<FirstSurface> suggestedFor(osg::Node& graph) {
    NamedParts parts;
    namesIn(graph, "a", &parts);
    return suggestedSurfaces(parts);
}

TEST(ModelCodes, AFirstSignatureComesFromMaterialsElseObjectsElseAllAsOne) {
    const auto surfaces = suggestedFor(*named());
    ASSERT_EQ(surfaces.size(), 2u);
    EXPECT_EQ(surfaces[0].name, "Paint grey");
    EXPECT_EQ(surfaces[0].because, "grey");
    EXPECT_EQ(surfaces[1].because, "glass");
    const auto first = firstSignatureOf(surfaces, "a");
    EXPECT_EQ(first.codes.rules.size(), 2u);
    EXPECT_EQ(first.database.materials.at(2).name, "window glass, 4 mm");
    EXPECT_EQ(first.database.temperatures.at(1).terms.recoveryFactor, 0.89);
    EXPECT_EQ(first.database.temperatures.at(2).name, "air");

    osg::ref_ptr<osg::Group> objects = new osg::Group;
    for (int i = 0; i < 101; ++i) {
        auto geode = plate(1);
        geode->setName(i == 0 ? "Exhaust" : "part " + std::to_string(i));
        objects->addChild(geode);
        if (i != 1 && i != 100) {
            continue;
        }
        const auto found = suggestedFor(*objects);
        ASSERT_EQ(found.size(), 2u);
        EXPECT_EQ(found[0].name, i == 1 ? "Exhaust" : "*");
        EXPECT_EQ(found[0].polygons, i == 1 ? 1 : 100);
        EXPECT_EQ(found[1].name, i == 1 ? "part 1" : "Exhaust");
        auto codes = firstSignatureOf(found, "a").codes;
        const auto pairs = given(objects, codes);
        EXPECT_EQ(pairs.count({0, 0}), 0u) << "every face has its codes";
        EXPECT_EQ(pairs.size(), 2u) << "the exhaust has its own";
    }
}

/// An aircraft as modellers export it: names of parts, materials that say little.
struct PartOfAircraft {
    const char *group, *object, *material, *says, *because;
};
const PartOfAircraft partsOfAircraft[] = {
    {"Fuselage", "body_main", "Material.001", "body_main", "body"},
    {"Fuselage", "LeftNozzle", "Material.001", "LeftNozzle", "nozzle"},
    {"Fuselage", "nozzle_R", "Material.002", "nozzle_R", "nozzle"},
    {"Fuselage", "canopy", "Glass", "Glass", "glass"},
    {"Fuselage", "canopy frame", "Material.001", "canopy frame", "canopy"},
    {"Fuselage", "left_air_brake", "Material.001", "left_air_brake", "airbrake"},
    {"Gear", "NoseWheel", "black", "NoseWheel", "wheel"},
    {"Engine left", "cowling", "white paint", "Engine left", "engine"},
    {"Engine left", "exhaust pipe", "steel", "exhaust pipe", "exhaust"},
    {"Cockpit", "pilot seat", "cloth", "cloth", "cloth"},
    {"Tail", "Surface.7", "Environment", "Environment", ""},
    {"Tail", "radome", "fiberglass", "fiberglass", "fiberglas"},
};

TEST(ModelCodes, ObjectsGroupsAndMaterialsCountTogetherForAFirstSignature) {
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->setName("turbine test aircraft"); // the name of the whole makes nothing hot
    for (const PartOfAircraft& part : partsOfAircraft) {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->setName(part.group);
        auto geode = plate(1);
        geode->setName(part.object);
        call(*geode, part.material);
        group->addChild(geode);
        root->addChild(group);
    }
    const auto surfaces = suggestedFor(*root);
    const auto first = firstSignatureOf(surfaces, "a");
    for (const PartOfAircraft& part : partsOfAircraft) {
        const auto found = std::ranges::find(surfaces, part.says, &FirstSurface::name);
        ASSERT_NE(found, surfaces.end()) << part.says;
        EXPECT_EQ(found->because, part.because) << part.object;
        // The rules give each part what the list says of it.
        IrCodes codes;
        for (const CodeRule& rule : first.codes.rules) {
            if (fits(rule, {part.material, part.object, {"turbine test aircraft", part.group}})) {
                codes = rule.codes.over(codes);
            }
        }
        const auto& material = first.database.materials.at(codes.material);
        EXPECT_EQ(material.name, materialLibrary().materials.at(found->libraryMaterial).name)
            << part.object;
        EXPECT_EQ(first.database.temperatures.at(codes.temperature).name,
                  nameOf(found->temperature))
            << part.object;
    }
    long polygons = 0;
    for (const FirstSurface& surface : surfaces) {
        polygons += surface.polygons;
    }
    EXPECT_EQ(polygons, std::ssize(partsOfAircraft)) << "each face counts once";
}

TEST(ModelCodes, SeriesOfNamedPartsAreOneSurfaceWhereTheyAreMany) {
    osg::ref_ptr<osg::Group> root = new osg::Group;
    for (int i = 0; i < 120; ++i) {
        auto geode = plate(1);
        geode->setName("blade" + std::to_string(i) + (i % 2 == 0 ? "" : "_tip"));
        root->addChild(geode);
    }
    const auto surfaces = suggestedFor(*root);
    ASSERT_EQ(surfaces.size(), 2u);
    EXPECT_EQ(surfaces[0].name, "blade*");
    EXPECT_EQ(surfaces[0].polygons, 60);
    EXPECT_EQ(surfaces[1].name, "blade*_tip");
    EXPECT_EQ(given(root, firstSignatureOf(surfaces, "a").codes).count({0, 0}), 0u);
}

TEST(ModelCodes, NamesAreListedWithWhatCarriesThem) {
    const auto names = namesIn(*named(), "a");
    ASSERT_EQ(names.size(), 3u);
    EXPECT_EQ(names[0].at("Paint grey").polygons, 2);
    EXPECT_NEAR(names[0].at("Paint grey").area, 2.0, 1e-6);
    EXPECT_EQ(names[0].at("Glass").polygons, 1);
    EXPECT_EQ(names[1].size(), 3u);
    EXPECT_EQ(names[2].at("Hull").polygons, 2);
    EXPECT_EQ(names[2].at("pane").polygons, 1);
}
