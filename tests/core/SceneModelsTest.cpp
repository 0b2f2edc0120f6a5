#include "smatcore/project/SceneModels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/ModelFields.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {
namespace {

const std::filesystem::path here = "/projects/fleet/fleet.smat";

/// Three models: a target with settings, one with a state of its own, one without.
Project fleet() {
    Project project;
    project.file = here;
    project.models.resize(3);
    const char* files[] = {"ship.flt", "boat.flt", "gull.flt"};
    for (std::size_t i = 0; i < 3; ++i) {
        project.models[i].file = files[i];
    }
    project.models[1].pose = {{120, -40, 5},
                              {irsg::radians(30), irsg::radians(2), irsg::radians(-7)}};
    project.models[1].own = {0.75, std::nullopt, 4.0};
    project.models[2].pose.position_m = {-10, 20, 300};
    project.settings.set("target.altitude", 1.5);
    project.settings.set("target.yaw", 110);
    project.settings.set("state.power", 0.5);
    project.settings.set("state.time", 10);
    return project;
}

/// Where every model stands from the first one's place on the ground, by name, and what it does.
using Standing = std::map<std::string, std::pair<irsg::Pose, irsg::EntityState>>;
Standing standingFrom(const Project& project, const std::string& name) {
    Standing all;
    const irsg::Vec3 from =
        poseOf(project, project.settings, findModel(project, name, "")).position_m;
    for (std::size_t i = 0; i < project.models.size(); ++i) {
        irsg::Pose pose = poseOf(project, project.settings, i);
        pose.position_m = pose.position_m - irsg::Vec3{from.x, from.y, 0.0};
        all[project.models[i].shownName()] = {pose, stateOf(project, project.settings, i)};
    }
    return all;
}

void expectEqual(const Standing& one, const Standing& other) {
    ASSERT_EQ(one.size(), other.size());
    for (const auto& [name, does] : one) {
        const auto& [pose, state] = other.at(name);
        EXPECT_NEAR(irsg::length(does.first.position_m - pose.position_m), 0.0, 1e-9) << name;
        EXPECT_NEAR(does.first.attitude.yaw_rad, pose.attitude.yaw_rad, 1e-12) << name;
        EXPECT_NEAR(does.first.attitude.pitch_rad, pose.attitude.pitch_rad, 1e-12) << name;
        EXPECT_NEAR(does.first.attitude.roll_rad, pose.attitude.roll_rad, 1e-12) << name;
        EXPECT_EQ(does.second, state) << name;
    }
}

TEST(SceneModels, AnotherTargetMovesNothingAndChangesNoState) {
    const Project before = fleet();
    Project after = before;
    makeTarget(after, 1);
    EXPECT_EQ(after.models[0].shownName(), "boat");
    EXPECT_EQ(after.models[1].shownName(), "ship");
    EXPECT_EQ(after.models[0].pose, irsg::Pose());
    EXPECT_EQ(after.models[0].own, StateOverride());
    EXPECT_EQ(after.settings[key::targetYaw], 30.0);
    EXPECT_EQ(after.settings[key::targetAltitude], 5.0);
    EXPECT_EQ(after.settings[key::statePower], 0.75);
    EXPECT_EQ(after.settings[key::stateTime], 14.0);
    expectEqual(standingFrom(before, "ship"), standingFrom(after, "ship"));
    // And back again.
    makeTarget(after, 1);
    EXPECT_EQ(after.models[0].shownName(), "ship");
    expectEqual(standingFrom(before, "ship"), standingFrom(after, "ship"));
    for (const SettingInfo& setting : settingTable()) {
        EXPECT_EQ(after.settings.text(setting.key), before.settings.text(setting.key));
    }
    const Project untouched = after;
    makeTarget(after, 0);
    EXPECT_EQ(after, untouched);
}

TEST(SceneModels, TheGroundStaysUnderAnotherTarget) {
    Project project = fleet();
    project.settings.set("environment.terrain", "valley.osgb");
    project.settings.set("environment.terrainEast", 7);
    makeTarget(project, 1);
    EXPECT_EQ(project.settings[key::environmentTerrainEast], -113.0);
    EXPECT_EQ(project.settings[key::environmentTerrainNorth], 40.0);
}

TEST(SceneModels, OneThatSettingsCannotPlaceIsRefused) {
    Project project = fleet();
    project.models[2].pose.position_m.z = -3;
    const Project before = project;
    EXPECT_THROW(makeTarget(project, 2), irsg::InputError);
    EXPECT_EQ(project, before);
}

TEST(SceneModels, TheTargetMayGoButNotTheLast) {
    Project project = fleet();
    removeModel(project, 0);
    ASSERT_EQ(project.models.size(), 2U);
    EXPECT_EQ(project.models[0].shownName(), "boat");
    EXPECT_EQ(project.models[1].pose.position_m, irsg::Vec3(-130, 60, 300));
    removeModel(project, 1);
    EXPECT_THROW(removeModel(project, 0), irsg::InputError);
    EXPECT_EQ(project.models.size(), 1U);
}

TEST(SceneModels, AreFoundByNameOrNumber) {
    Project project = fleet();
    EXPECT_EQ(findModel(project, "gull", ""), 2U);
    EXPECT_EQ(findModel(project, " 1 ", ""), 1U);
    for (const char* wrong : {"", "3", "-1", "1.5", "hull"}) {
        EXPECT_THROW(findModel(project, wrong, "MODEL"), irsg::InputError) << wrong;
    }
    project.models[2].name = "boat";
    EXPECT_THROW(findModel(project, "boat", "MODEL"), irsg::InputError);
    EXPECT_EQ(freeModelName(project, "boat"), "boat-2");
    EXPECT_EQ(freeModelName(project, "gull"), "gull");
}

TEST(SceneModels, ANewOneStandsClearOfAllOthers) {
    const Project project = fleet();
    const ProjectModel added = besideOthers(project, "/x/tug.flt", {60, 10, 2, 25});
    EXPECT_EQ(added.name, "tug");
    EXPECT_GE(added.pose.position_m.x, 120 + 10 + 25);
    EXPECT_LT(added.pose.position_m.x, 120 + 10 + 3 * 25);
    EXPECT_EQ(added.pose.position_m.z, 1.5);
    EXPECT_NEAR(irsg::degrees(added.pose.attitude.yaw_rad), 110, 1e-9);
}

TEST(SceneModels, StateOverridesComeBackEqualAndTheTargetHasNone) {
    const Project project = fleet();
    EXPECT_EQ(projectFromJson(projectToJson(project, here), here), project);
    for (const char* key : {"power", "mach", "timeOffset_s", "yaw_deg"}) {
        try {
            projectFromJson(std::string(R"({"version": 1, "models": [{"file": "a.flt", ")") + key +
                                R"(": 1}]})",
                            here);
            ADD_FAILURE() << key;
        } catch (const irsg::InputError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("target"));
        }
    }
    for (const char* wrong : {R"("power": -1)", R"("mach": "fast")", R"("timeOffset_s": 1e10)"}) {
        EXPECT_THROW(projectFromJson(std::string(R"({"version": 1, "models": [{"file": "a.flt"},
                                                 {"file": "b.flt", )") +
                                         wrong + "}]}",
                                     here),
                     irsg::InputError)
            << wrong;
    }
}

TEST(ModelFields, SayAndSetEveryNumberOfAModel) {
    Project project = fleet();
    for (const ModelField& field : modelFields()) {
        const bool isChoice = field.info.kind == SettingKind::choiceOrReal;
        for (const std::string text : {"0.5", "17", isChoice ? "target" : "3"}) {
            setField(project, 1, field, text, "");
            EXPECT_EQ(textOf(project, 1, field), text) << field.key;
        }
        EXPECT_THROW(setField(project, 1, field, "much", ""), irsg::InputError) << field.key;
        if (field.ofTarget.empty()) {
            EXPECT_THROW(setField(project, 0, field, "1", ""), irsg::InputError) << field.key;
            continue;
        }
        setField(project, 0, field, "17", "");
        EXPECT_EQ(textOf(project, 0, field), "17") << field.key;
        EXPECT_TRUE(project.settings.isSet(field.ofTarget)) << field.key;
    }
    // Heading and yaw are one number.
    setField(project, 2, *findModelField("heading"), "270", "");
    EXPECT_EQ(textOf(project, 2, *findModelField("yaw")), "90");
    setField(project, 0, *findModelField("heading"), "90", "");
    EXPECT_EQ(project.settings[key::targetYaw], -90.0);
    EXPECT_EQ(findModelField("colour"), nullptr);
}

TEST(ModelFields, APlaceLiesAsFarToEitherSide) {
    for (const char* key : {"east", "north"}) {
        const SettingInfo& info = findModelField(key)->info;
        EXPECT_EQ(info.maximum, 1e7) << key;
        EXPECT_EQ(info.minimum, -info.maximum) << key;
    }
}

TEST(ModelFields, AnglesThatWereWrittenAreEqualWhenTheyAreReadAgain) {
    Project project = fleet();
    for (int tenth = -1799; tenth <= 1800; tenth += 7) {
        setField(project, 1, *findModelField("yaw"), std::to_string(tenth / 10.0), "");
        ASSERT_EQ(projectFromJson(projectToJson(project, here), here), project) << tenth;
    }
}

} // namespace
} // namespace smat
