// How the axes, the unit and the origin of a file become those of a model, and what is guessed.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osg/MatrixTransform>

#include "irsg/geometry/model/ModelPlacing.h"
#include "tests/support/ModelAccess.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using namespace irsg::test;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

namespace {

/// The faces of a box.
void addBox(osg::Group& group, const osg::Vec3& low, const osg::Vec3& high) {
    const auto at = [&](int i) {
        return osg::Vec3(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                         i & 4 ? high.z() : low.z());
    };
    constexpr int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& face : faces) {
        group.addChild(polygon({at(face[0]), at(face[1]), at(face[2]), at(face[3])}, {1, 1}));
    }
}

/// An aircraft of boxes, 10 m long, in x starboard, y nose, z up: hull, wing, and a fin at the
/// tail.
osg::ref_ptr<osg::Group> aircraft() {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    addBox(*group, {-0.5f, -5.0f, -0.5f}, {0.5f, 5.0f, 0.5f});
    addBox(*group, {-4.0f, -0.5f, 0.0f}, {4.0f, 1.0f, 0.2f});
    addBox(*group, {-1.5f, -5.0f, 0.3f}, {1.5f, -4.2f, 0.4f});
    addBox(*group, {-0.1f, -5.0f, 0.5f}, {0.1f, -4.0f, 2.5f});
    return group;
}

/// The same as a file has it whose own axes are those: file's x, y, z along model directions.
osg::ref_ptr<osg::MatrixTransform> asFile(osg::Node& model, const ModelPlacing& placing) {
    const osg::Matrixd toModel = toOsg(turnAndScale(placing));
    osg::ref_ptr<osg::MatrixTransform> file =
        new osg::MatrixTransform(osg::Matrixd::inverse(toModel));
    file->addChild(&model);
    return file;
}

ModelPlacing whole(ModelAxis up, ModelAxis nose, double unit_m) {
    return {.up = up, .nose = nose, .unit_m = unit_m, .origin = {}};
}

} // namespace

TEST(ModelPlacing, EveryTurnIsOneAndBringsUpAndNoseHome) {
    for (int up = 0; up < 6; ++up) {
        for (int nose = 0; nose < 6; ++nose) {
            if (up / 2 == nose / 2) {
                continue;
            }
            const auto placing =
                whole(static_cast<ModelAxis>(up), static_cast<ModelAxis>(nose), 0.01);
            const osg::Matrixd m = toOsg(turnAndScale(placing));
            const auto along = [](int axis) {
                osg::Vec3d v;
                v[axis / 2] = axis % 2 == 0 ? 100.0 : -100.0;
                return v;
            };
            EXPECT_EQ(along(up) * m, osg::Vec3d(0, 0, 1));
            EXPECT_EQ(along(nose) * m, osg::Vec3d(0, 1, 0));
            const osg::Vec3d x(m(0, 0), m(0, 1), m(0, 2)), y(m(1, 0), m(1, 1), m(1, 2)),
                z(m(2, 0), m(2, 1), m(2, 2));
            EXPECT_NEAR((x ^ y) * z, 1e-6, 1e-18) << "a turn, not a reflection";
        }
    }
}

TEST(ModelPlacing, WhatIsNotSetIsAsTheFileStatesOrAsItAlwaysWas) {
    EXPECT_EQ(completed({}, {}, "a"), whole(ModelAxis::plusZ, ModelAxis::plusY, 1.0));
    EXPECT_EQ(completed({.up = ModelAxis::plusY}, {}, "a"),
              whole(ModelAxis::plusY, ModelAxis::plusZ, 1.0));
    const FileAxes stated{
        .unit_m = 0.01, .up = ModelAxis::plusY, .front = ModelAxis::plusZ, .reason = "r"};
    EXPECT_EQ(completed({}, stated, "a"), whole(ModelAxis::plusY, ModelAxis::plusZ, 0.01));
    EXPECT_EQ(completed({.up = ModelAxis::plusZ, .unit_m = 1.0}, stated, "a"),
              whole(ModelAxis::plusZ, ModelAxis::plusY, 1.0))
        << "a front that is no longer level is no statement";
    EXPECT_THAT(refusal([&] { completed({.nose = ModelAxis::minusZ}, {}, "plane.obj"); }),
                HasSubstr("plane.obj: noseAxis: found -z with +z up"));
    EXPECT_THAT(refusal([&] { completed({.unit_m = 0.0}, {}, "plane.obj"); }), HasSubstr("unit_m"));
}

TEST(ModelPlacing, AnAircraftIsTheSameHoweverItsFileHasIt) {
    const auto original = modelOfGraph(aircraft(), "aircraft");
    for (const auto& placing : {whole(ModelAxis::plusY, ModelAxis::minusZ, 0.01),
                                whole(ModelAxis::minusX, ModelAxis::plusY, 0.3048),
                                whole(ModelAxis::plusZ, ModelAxis::minusX, 1000.0)}) {
        const auto model =
            modelOfGraph(asFile(*aircraft(), placing), "aircraft", {.placing = placing});
        EXPECT_NEAR(model->codes().at({1, 1}).area_m2, original->codes().at({1, 1}).area_m2, 1e-4);
        EXPECT_LT(length(model->bounds().min - original->bounds().min), 1e-5);
        EXPECT_LT(length(model->bounds().max - original->bounds().max), 1e-5);
    }
}

TEST(ModelPlacing, OriginsAreThoseOfTheFileTheCentreTheBaseOrAPoint) {
    osg::ref_ptr<osg::MatrixTransform> moved =
        new osg::MatrixTransform(osg::Matrixd::translate(10, 20, 30));
    osg::ref_ptr<osg::Group> box = new osg::Group;
    addBox(*box, {-1, -2, -3}, {1, 2, 3});
    moved->addChild(box);
    const auto bounds = [&](const ModelOrigin& origin) {
        return modelOfGraph(moved, "box", {.placing = {.unit_m = 2.0, .origin = origin}})->bounds();
    };
    EXPECT_EQ(bounds({}), (BoundingBox{{18, 36, 54}, {22, 44, 66}}));
    EXPECT_EQ(bounds({ModelOrigin::At::centre, {}}), (BoundingBox{{-2, -4, -6}, {2, 4, 6}}));
    EXPECT_EQ(bounds({ModelOrigin::At::base, {}}), (BoundingBox{{-2, -4, 0}, {2, 4, 12}}));
    EXPECT_EQ(bounds({ModelOrigin::At::point, {10, 20, 20}}),
              (BoundingBox{{-2, -4, 14}, {2, 4, 26}}))
        << "a point in the unit of the file";
}

TEST(ModelPlacing, AModelFarFromItsOriginKeepsItsShape) {
    osg::ref_ptr<osg::Group> cube = new osg::Group;
    addBox(*cube, {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
    osg::ref_ptr<osg::MatrixTransform> far =
        new osg::MatrixTransform(osg::Matrixd::translate(1e6 + 0.3, 5e6 + 0.1, 100.7));
    far->addChild(cube);
    const auto model = modelOfGraph(far, "cube");
    EXPECT_NEAR(model->codes().at({1, 1}).area_m2, 6.0, 6e-5);
    EXPECT_LT(length(model->bounds().centre()), 1e-6);
    EXPECT_THAT(model->remarks(), Contains(HasSubstr("m becomes the origin")));
    const auto kept = modelOfGraph(far, "cube", {.placing = {.origin = ModelOrigin{}}});
    EXPECT_THAT(kept->remarks(), Contains(HasSubstr("single precision")));
    EXPECT_NEAR(kept->bounds().centre().x, 1e6 + 0.3, 0.1);
}

TEST(ModelPlacing, GuessesAnAircraftFromItsShape) {
    for (const auto& placing : {whole(ModelAxis::plusZ, ModelAxis::plusY, 1.0),
                                whole(ModelAxis::plusY, ModelAxis::minusZ, 0.001),
                                whole(ModelAxis::plusY, ModelAxis::plusX, 0.01),
                                whole(ModelAxis::plusZ, ModelAxis::minusX, 0.0254)}) {
        const auto guess = guessPlacing(loaded(asFile(*aircraft(), placing)), "aircraft");
        EXPECT_EQ(guess.placing.up, placing.up);
        EXPECT_EQ(guess.placing.nose, placing.nose);
        // A length alone does not tell inches from centimetres.
        EXPECT_GE(guess.size_m.y, 0.5);
        EXPECT_LE(guess.size_m.y, 500.0);
        EXPECT_EQ(guess.reasons.size(), 4u);
    }
}

TEST(ModelPlacing, FindsTheTailBeneathAHighWingAndAPropeller) {
    // A high wing at the front, a canopy above it and the disc of a propeller: the front half is
    // the higher one, and the fin is low.
    osg::ref_ptr<osg::Group> group = new osg::Group;
    addBox(*group, {-0.5f, -6.0f, -0.5f}, {0.5f, 3.0f, 0.5f});
    addBox(*group, {-5.0f, -0.5f, 1.2f}, {5.0f, 1.0f, 1.4f});
    addBox(*group, {-0.4f, -1.0f, 0.5f}, {0.4f, 0.5f, 1.6f});
    addBox(*group, {-1.2f, 3.0f, -1.2f}, {1.2f, 3.05f, 1.2f});
    addBox(*group, {-1.8f, -6.0f, 0.3f}, {1.8f, -5.2f, 0.4f});
    addBox(*group, {-0.1f, -6.0f, 0.5f}, {0.1f, -5.0f, 1.5f});
    for (const ModelAxis nose : {ModelAxis::plusX, ModelAxis::minusX, ModelAxis::plusZ}) {
        const auto guess =
            guessPlacing(loaded(asFile(*group, whole(ModelAxis::plusY, nose, 1.0))), "high wing");
        EXPECT_EQ(guess.placing.nose, nose);
    }
}

TEST(ModelPlacing, TheUsualFrontOfAFormatIsTakenWhereNobodySaysAnythingElse) {
    const FileAxes usual{.unit_m = {},
                         .up = ModelAxis::plusY,
                         .front = {},
                         .reason = "r",
                         .usualFront = ModelAxis::minusX};
    EXPECT_EQ(completed({}, usual, "a"), whole(ModelAxis::plusY, ModelAxis::minusX, 1.0));
    EXPECT_EQ(completed({.nose = ModelAxis::plusZ}, usual, "a"),
              whole(ModelAxis::plusY, ModelAxis::plusZ, 1.0));
    EXPECT_EQ(completed({.up = ModelAxis::plusX}, usual, "a"),
              whole(ModelAxis::plusX, ModelAxis::plusY, 1.0))
        << "it points up here";
    // A guess asks the shape first.
    osg::ref_ptr<osg::Group> cube = new osg::Group;
    addBox(*cube, {-1, -1, -1}, {1, 1, 1});
    EXPECT_EQ(guessPlacing(loaded(cube, usual), "cube").placing.nose, ModelAxis::minusX);
    const auto placing = whole(ModelAxis::plusY, ModelAxis::plusZ, 1.0);
    EXPECT_EQ(guessPlacing(loaded(asFile(*aircraft(), placing), usual), "a").placing.nose,
              ModelAxis::plusZ);
}

TEST(ModelPlacing, AnAc3dFileStandsUprightWithItsNoseInFront) {
    // A body along x with a fin at +x: AC3D and FlightGear have y up and the nose along -x.
    const std::string text = R"(AC3Db
MATERIAL "paint" rgb 1 1 1 amb 1 1 1 emis 0 0 0 spec 0 0 0 shi 1 trans 0
OBJECT world
kids 1
OBJECT poly
name "fin"
numvert 3
4 0 0
4 3 0
-4 0 0
numsurf 1
SURF 0x20
mat 0
refs 3
0 0 0
1 0 0
2 0 0
kids 0
)";
    const auto file = smat::test::writtenFile(smat::test::ownFolder() / "fin.ac", text);
    const auto model = Model::load(file);
    EXPECT_EQ(model->placing(), whole(ModelAxis::plusY, ModelAxis::minusX, 1.0));
    EXPECT_DOUBLE_EQ(model->bounds().max.z, 3.0);
    EXPECT_DOUBLE_EQ(model->bounds().min.z, 0.0);
    EXPECT_DOUBLE_EQ(model->bounds().max.y, 4.0);
    EXPECT_DOUBLE_EQ(model->bounds().min.y, -4.0);
    const Mesh& mesh = *model->mesh();
    for (const Float3& corner : mesh.partOf(mesh.pieces.front()).vertices) {
        EXPECT_TRUE(corner[2] == 0.0f || corner[1] == -4.0f) << "the fin is at the tail";
    }
    // Another placing is taken as it is.
    const auto other = Model::load(file, {.placing = {.up = ModelAxis::plusZ}});
    EXPECT_EQ(*other->placing().up, ModelAxis::plusZ);
    EXPECT_DOUBLE_EQ(other->bounds().max.z, 0.0);
}

TEST(ModelPlacing, BelievesTheFileBeforeTheShapeAndSaysSo) {
    const FileAxes stated{.unit_m = 0.3048,
                          .up = ModelAxis::plusX,
                          .front = ModelAxis::plusY,
                          .reason = "the file's header"};
    const auto guess = guessPlacing(loaded(aircraft(), stated), "aircraft");
    EXPECT_EQ(guess.placing.up, ModelAxis::plusX);
    EXPECT_EQ(guess.placing.nose, ModelAxis::plusY);
    EXPECT_EQ(guess.placing.unit_m, 0.3048);
    EXPECT_EQ(guess.reasons[0], "the file's header");
    for (std::size_t i = 1; i < 4; ++i) {
        EXPECT_THAT(guess.reasons[i], HasSubstr("as stated"));
    }
}

TEST(ModelPlacing, AUnitThatMakesAGiantOfAnAircraftIsNotBelieved) {
    const auto placing = whole(ModelAxis::plusY, ModelAxis::plusZ, 0.01);
    const FileAxes stated{
        .unit_m = 1.0, .up = ModelAxis::plusY, .front = ModelAxis::plusZ, .reason = "glTF"};
    const auto guess = guessPlacing(loaded(asFile(*aircraft(), placing), stated), "aircraft");
    EXPECT_EQ(guess.placing.unit_m, 0.01);
    EXPECT_EQ(guess.reasons[3],
              "it is in centimetres, not as stated: it would be 1000 m long; so it is 10 m long");
    EXPECT_NEAR(guess.size_m.y, 10.0, 1e-4);
}

TEST(ModelPlacing, ASphereSaysThatNothingTells) {
    osg::ref_ptr<osg::Group> cube = new osg::Group;
    addBox(*cube, {-1, -1, -1}, {1, 1, 1});
    const auto guess = guessPlacing(loaded(cube), "cube");
    EXPECT_THAT(guess.reasons[0], HasSubstr("neither"));
    EXPECT_THAT(guess.reasons[1], HasSubstr("neither"));
    EXPECT_EQ(guess.placing.up, ModelAxis::plusZ);
    EXPECT_EQ(guess.placing.nose, ModelAxis::plusY);
}
