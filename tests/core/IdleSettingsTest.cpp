#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/IdleSettings.h"
#include "smatcore/settings/AnalysisSections.h"

namespace smat {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

AnalysisKind kindOf(const std::string& name) {
    return analysisKindFromName(name).value();
}

/// Remarks of an analysis with settings of its own, `ofProject` before them.
std::vector<std::string> remarksOf(const std::string& kind, const std::vector<std::string>& own,
                                   const std::vector<std::string>& ofProject = {}) {
    Project project;
    for (const std::string& assignment : ofProject) {
        project.settings.setFromArgument(assignment);
    }
    Settings settings;
    for (const std::string& assignment : own) {
        settings.setFromArgument(assignment);
    }
    return idleSettingRemarks(AnalysisData::of(project, kindOf(kind), settings));
}

std::vector<std::string> with(std::vector<std::string> assignments, const std::string& one) {
    assignments.push_back(one);
    return assignments;
}

struct Idle {
    const char* name;
    const char* kind;
    const char* assignment;
    const char* reason;
    std::vector<std::string> unless = {}; ///< with these it has an effect
    std::vector<std::string> beside = {}; ///< without these it has
};

class IdleSettings : public testing::TestWithParam<Idle> {};

TEST_P(IdleSettings, AreNamedWithTheReason) {
    const Idle& idle = GetParam();
    const std::string assignment = idle.assignment;
    const std::string key = assignment.substr(0, assignment.find('='));
    EXPECT_THAT(remarksOf(idle.kind, with(idle.beside, assignment)),
                ElementsAre(testing::AllOf(testing::StartsWith(key + " = "),
                                           HasSubstr("has no effect on this analysis: "),
                                           HasSubstr(idle.reason))));
    // What a project has for all of its analyses is meant for others.
    if (key != "image.sensor") {
        EXPECT_THAT(remarksOf(idle.kind, {}, {assignment}), IsEmpty());
    }
    if (!idle.unless.empty() || !idle.beside.empty()) {
        EXPECT_THAT(remarksOf(idle.kind, with(idle.unless, assignment)), IsEmpty());
    }
}

INSTANTIATE_TEST_SUITE_P(
    Tables, IdleSettings,
    testing::Values(
        Idle{"SensorOfSweep", "polar", "image.sensor=a.smatsensor", "the analysis image alone"},
        Idle{"SensorOfSpectrum", "spectrum", "image.sensor=a.smatsensor", "the analysis image"},
        Idle{"StepOfOtherPlot", "range", "polar.step=5", "the analysis polar alone"},
        Idle{"VariedByPolar", "polar", "camera.azimuth=30", "sets it by itself"},
        Idle{"VariedByRange", "range", "camera.range=300", "sets it by itself"},
        Idle{"VariedByTime", "time", "state.time=300", "sets it by itself"},
        Idle{"ColoursOfSweep", "polar", "display.colorMap=inferno", "only images have colours"},
        Idle{"PartsOfImage", "image", "render.parts=material", "only sweeps"},
        Idle{"PartsOfSpectrum", "spectrum", "render.parts=material", "only sweeps"},
        Idle{"TargetErrorOfSpectrum", "spectrum", "render.targetError=1", "as they are set"},
        Idle{"NoSensor", "image", "image.noiseSeed=3", "no sensor", {"image.sensor=a.smatsensor"}},
        Idle{"NoSkybox",
             "image",
             "environment.skyboxSlope=3",
             "no skybox",
             {"environment.skybox=sky"}},
        Idle{"NoTerrain",
             "polar",
             "environment.terrainEast=3",
             "no terrain",
             {"environment.terrain=hills.osgt"}},
        Idle{"NothingHides",
             "polar",
             "render.terrainHides=false",
             "no terrain",
             {"environment.terrain=hills.osgt"}},
        Idle{
            "NoTiles", "polar", "render.hotSpots=false", "no tiles", {}, {"render.antialiasing=1"}},
        Idle{"NoSupersampling",
             "polar",
             "render.supersampling=perPixel",
             "supersample",
             {"render.antialiasing=1"}},
        Idle{"NoSmartBackground",
             "polar",
             "render.backgroundRows=3",
             "background is a number",
             {},
             {"render.background=0.5"}},
        Idle{"NoSmartSun", "polar", "render.shadows=disc", "not smart", {}, {"render.sun=approx"}},
        Idle{"NoSmartSky",
             "polar",
             "render.fluxWeights=report",
             "not smart",
             {},
             {"render.ambientReflection=off"}},
        Idle{"NoInterReflection",
             "polar",
             "render.lightError=0.01",
             "no inter-reflection",
             {},
             {"render.bounces=0"}},
        Idle{"NoCk",
             "polar",
             "render.widebandError=0.001",
             "mode is spectral",
             {},
             {"sensor.mode=spectral"}},
        Idle{"NoScalings", "polar", "scaling.seed=3", "scalings", {"scaling.use=true"}}),
    [](const testing::TestParamInfo<Idle>& one) { return std::string(one.param.name); });

TEST(IdleSettingsOfProjects, ASensorOfImagesIsNamedWhereOneMayTakeItForThatOfEveryAnalysis) {
    const std::vector<std::string> project{"image.sensor=a.smatsensor"};
    for (const AnalysisKind kind : allAnalysisKinds()) {
        const auto remarks = remarksOf(name(kind), {}, project);
        if (kind->form == AnalysisForm::image) {
            EXPECT_THAT(remarks, IsEmpty());
        } else {
            EXPECT_THAT(remarks, ElementsAre(HasSubstr("image.sensor = a.smatsensor of the project "
                                                       "has no effect on this analysis")))
                << name(kind);
        }
    }
}

TEST(IdleSettingsOfProjects, SettingsThatHaveAnEffectAreNotNamed) {
    // Of every analysis its own settings, and of all what is of no other one.
    for (const AnalysisKind kind : allAnalysisKinds()) {
        EXPECT_THAT(remarksOf(name(kind), {"sensor.band=8-12", "render.sun=off",
                                           "environment.ambientTemperature=280"}),
                    IsEmpty())
            << name(kind);
    }
    EXPECT_THAT(remarksOf("polar", {"polar.step=5", "polar.offset=3", "camera.range=300"}),
                IsEmpty());
    // The default, given or not, is no change.
    EXPECT_THAT(remarksOf("polar", {"camera.azimuth=0"}), IsEmpty());
}

TEST(IdleSettingsOfProjects, WhereScalesAreDrawnTheirSeedHasAnEffect) {
    Settings settings;
    settings.set("scaling.seed", "3");
    const AnalysisData data = AnalysisData::of(Project(), kindOf("polar"), settings);
    EXPECT_THAT(idleSettingRemarks(data, true), IsEmpty());
    EXPECT_EQ(idleSettingRemarks(data).size(), 1u);
}

} // namespace

} // namespace smat
