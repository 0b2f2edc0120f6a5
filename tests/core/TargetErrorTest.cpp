// What is chosen for a target error, against sources whose errors and light follow laws.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/analysis/CostAccuracyStudy.h"
#include "smatcore/analysis/TargetChoice.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"
#include "tests/core/AnalyticSource.h"
#include "tests/support/Refusal.h"

namespace smat {
namespace {

using irsg::ReflectionMode;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

/// 100 W sr-1 by itself and what it reflects. Its error of samples falls with the window as n^-1.5
/// from 2 % at 128, its background is wrong by 1 % with one row and by 0.1 % with more.
class Lawful : public test::AnalyticSource {
  public:
    double sunlight_W_sr = 0.0; ///< if it faced the sun
    double shade = 0.0;         ///< part of what it has of the sun that is shadowed
    double skylight_W_sr = 0.0; ///< if it saw the sky alone, as bright as the ground
    double between_W_sr = 0.0;
    double worseBehind = 1.0; ///< error of samples behind the beam, in terms of that before
    bool hasBackground = false;

    double projectedArea_m2(const irsg::Vec3&) const override { return 1.0; }
    double intensity_W_sr(const irsg::Vec3&) const override {
        const irsg::RenderSettings& render = scene.settings;
        const double lit = render.sunShadows == irsg::SunShadowMode::off ? 1.0 : 1.0 - shade;
        const auto part = [](ReflectionMode mode, double smart, double approx) {
            return mode == ReflectionMode::off      ? 0.0
                   : mode == ReflectionMode::approx ? approx
                                                    : smart;
        };
        return 100.0 + sunlight_W_sr * part(render.sun, 0.6 * lit, 0.25) +
               skylight_W_sr * part(render.ambientReflection, 1.0, 1.0) +
               (render.bounces != 0 ? between_W_sr : 0.0);
    }
    irsg::RenderReport measure() override {
        irsg::RenderReport report = AnalyticSource::measure();
        const irsg::RenderSettings& render = scene.settings;
        largest = std::max(largest, render.tileSide_samples);
        irsg::ErrorParts error;
        error.sampling = 0.02 * std::pow(128.0 / render.tileSide_samples, 1.5) *
                         (towardsCamera().y < 0.0 ? worseBehind : 1.0);
        if (hasBackground) {
            error.background = render.backgroundRows == 1 ? 0.01 : 0.001;
        }
        if (render.mode == irsg::CalculationMode::wideband) {
            error.air = 0.8 * render.widebandError;
            trained.insert(render.widebandError);
        }
        irsg::RadiometryErrors errors;
        errors.intensity_W_sr = error.times(report.all.intensity_W_sr);
        errors.contrastIntensity_W_sr = error.times(report.all.contrastIntensity_W_sr);
        errors.irradiance_W_m2 = error.times(report.all.irradiance_W_m2);
        report.all.errors = errors;
        return report;
    }
    int largest = 0;          ///< window that was ever drawn
    std::set<double> trained; ///< what points of wideband-ck were ever trained to
};

/// The scene from ahead.
PlacedCase seenFromAhead(const SceneDescription& scene, std::size_t) {
    return {scene, {scene.sensor, irsg::Viewpoint::about({}, 0.0, 0.0, 0.0, 1000.0)}, {{}}};
}

TargetChoice chosen(Lawful& source, double target,
                    irsg::RenderSettings render = irsg::RenderSettings::direct(),
                    const TargetUse& use = {.mayStay = false}) {
    if (!source.hasBackground) {
        render.background = irsg::BackgroundMode::none;
    }
    SceneDescription scene;
    scene.settings = irsg::RenderSettings::direct();
    scene.entities.emplace_back();
    scene.settings = render;
    ProbedViews views(source, scene, 1, false, seenFromAhead);
    return chooseForTarget(views, target, use);
}

TEST(TargetChoice, TakesTheSmallestTileWhoseErrorIsBelow) {
    struct Row {
        double target;
        int window;
    };
    for (const Row& row : {Row{0.06, 64}, Row{0.05, 128}, Row{0.0199, 256}, Row{0.005, 512},
                           Row{0.001, 1024}, Row{0.0004, 2048}}) {
        Lawful source;
        const TargetChoice choice = chosen(source, row.target);
        EXPECT_TRUE(choice.isMet) << row.target;
        EXPECT_EQ(choice.configuration.render.tileSide_samples, row.window) << row.target;
        EXPECT_NEAR(choice.reached, 0.02 * std::pow(128.0 / row.window, 1.5), 1e-12);
        EXPECT_LE(source.largest, std::max(row.window, 128)) << "nothing dearer was drawn";
    }
}

TEST(TargetChoice, StaysAsSetWhereThatMeetsItAndASearchWouldTakeMoreThanItSaves) {
    // 256 samples: 0.71 %; of many cases those with 64 samples save more than the search takes.
    struct Row {
        double target;
        std::size_t cases;
        int window;
        bool stays;
    };
    for (const Row& row :
         {Row{0.06, 1, 256, true}, Row{0.06, 12, 256, true}, Row{0.007, 12, 512, false},
          Row{0.0072, 12, 256, true}, Row{0.007, 1, 512, false}, Row{0.07, 1000, 64, false}}) {
        Lawful source;
        source.sunlight_W_sr = 30.0; // too much to be left out
        const TargetChoice choice =
            chosen(source, row.target, irsg::RenderSettings::direct(), {.cases = row.cases});
        EXPECT_TRUE(choice.isMet) << row.target;
        EXPECT_EQ(choice.sentences.front().find("as set") != std::string::npos, row.stays)
            << choice.sentences.front();
        if (row.stays) {
            EXPECT_EQ(source.largest, 256) << "nothing else was drawn";
            EXPECT_NEAR(choice.reached, 0.02 * std::pow(0.5, 1.5), 1e-12);
        }
        EXPECT_EQ(choice.configuration.render.tileSide_samples, row.window) << row.target;
    }
    // What samples of pixels miss is in no error.
    Lawful source;
    irsg::RenderSettings pixels = irsg::RenderSettings::direct();
    pixels.tileSide_samples = 0;
    EXPECT_GT(chosen(source, 0.06, pixels, {}).configuration.render.tileSide_samples, 0);
}

TEST(TargetChoice, TrainsPointsOfWidebandNoFinerThanNeeded) {
    struct Row {
        double target, trained;
    };
    for (const Row& row : {Row{0.02, 0.01}, Row{0.005, 0.003}, Row{0.0015, 0.001}}) {
        Lawful source;
        irsg::RenderSettings wideband = irsg::RenderSettings::direct();
        wideband.mode = irsg::CalculationMode::wideband;
        const TargetChoice choice = chosen(source, row.target, wideband);
        EXPECT_TRUE(choice.isMet) << row.target;
        EXPECT_EQ(choice.configuration.render.widebandError, row.trained) << row.target;
        EXPECT_GE(*source.trained.begin(), row.trained) << "nothing dearer was trained";
        EXPECT_LE(choice.reached, row.target);
    }
    Lawful source;
    irsg::RenderSettings wideband = irsg::RenderSettings::direct();
    wideband.mode = irsg::CalculationMode::wideband;
    const TargetChoice none = chosen(source, 5e-4, wideband);
    EXPECT_FALSE(none.isMet);
    EXPECT_EQ(none.configuration.render.widebandError, 0.001);
    EXPECT_THAT(none.sentences.front(), HasSubstr("wideband-ck trained to 0.1 %"));
}

TEST(TargetChoice, SaysWhereNoConfigurationMeetsIt) {
    Lawful source;
    const TargetChoice choice = chosen(source, 1e-4);
    EXPECT_FALSE(choice.isMet);
    EXPECT_EQ(choice.configuration.render.tileSide_samples, 2048);
    EXPECT_THAT(choice.sentences, Contains(HasSubstr("no configuration meets it")));
    EXPECT_THAT(choice.sentences.front(), HasSubstr("0.031 %"));
}

TEST(TargetChoice, TakesRowsOfTheBackgroundOnlyWhereTheyAreNeeded) {
    Lawful source;
    source.hasBackground = true;
    EXPECT_EQ(chosen(source, 0.05).configuration.render.backgroundRows, 1);
    const TargetChoice finer = chosen(source, 0.009); // one row alone is wrong by 1 %
    EXPECT_TRUE(finer.isMet);
    EXPECT_EQ(finer.configuration.render.backgroundRows, 0);
    EXPECT_EQ(finer.configuration.render.tileSide_samples, 256);
}

TEST(TargetChoice, LeavesOutLightWhoseBoundIsAPartOfTheTarget) {
    Lawful source;
    source.sunlight_W_sr = 0.3; // at most 0.3 % of a target of 1 %
    const TargetChoice dim = chosen(source, 0.01);
    EXPECT_EQ(dim.configuration.render.sun, ReflectionMode::off);
    EXPECT_NEAR(dim.skipped, 0.3 / 100.18, 1e-9);
    EXPECT_THAT(dim.sentences, Contains(HasSubstr("skipped sun: at most 0.3 % (as if all faced")));
    source.sunlight_W_sr = 0.4; // more than a third of it
    const TargetChoice bright = chosen(source, 0.01);
    EXPECT_EQ(bright.configuration.render.sun, ReflectionMode::smart);
    EXPECT_EQ(bright.skipped, 0.0);
    EXPECT_THAT(bright.sentences, Contains(HasSubstr("kept sun: at most 0.4 %")));
}

TEST(TargetChoice, LeavesOutShadowsLightBetweenSurfacesAndSkyByThemselves) {
    Lawful source;
    source.sunlight_W_sr = 10.0, source.shade = 0.001, source.between_W_sr = 0.04;
    source.skylight_W_sr = 0.05;
    irsg::RenderSettings render = irsg::RenderSettings::direct();
    render.sunShadows = irsg::SunShadowMode::point;
    render.bounces = irsg::convergedBounces;
    const TargetChoice choice = chosen(source, 0.01, render);
    EXPECT_EQ(choice.configuration.render.sun, ReflectionMode::smart);
    EXPECT_EQ(choice.configuration.render.sunShadows, irsg::SunShadowMode::point)
        << "all that shadows may take is what the sun gives, 6 %";
    EXPECT_EQ(choice.configuration.render.bounces, 0);
    EXPECT_EQ(choice.configuration.render.ambientReflection, ReflectionMode::off);
    EXPECT_GE(choice.skipped, 2.0 * 0.04 / 106.1 + 0.05 / 106.1);
    EXPECT_LE(choice.skipped, 0.01 / 3.0);
}

TEST(TargetChoice, DoesNotTrustBoundsOfMirrors) {
    auto database = std::make_shared<irsg::SignatureDatabase>();
    database->materials[1].surfaceModel = "ggx";
    Lawful source;
    SceneDescription scene;
    scene.settings = irsg::RenderSettings::direct();
    scene.entities.emplace_back().database = database;
    scene.settings.background = irsg::BackgroundMode::none;
    ProbedViews views(source, scene, 1, false, seenFromAhead);
    EXPECT_EQ(chooseForTarget(views, 0.05, {.mayStay = false}).configuration.render.sun,
              ReflectionMode::smart);
}

TEST(TargetChoice, LooksAtBothEndsAndBetween) {
    EXPECT_EQ(probedCases(1), (std::vector<std::size_t>{0}));
    EXPECT_EQ(probedCases(3), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(probedCases(37), (std::vector<std::size_t>{0, 12, 24, 36}));
    EXPECT_EQ(probedCases(101), (std::vector<std::size_t>{0, 20, 40, 60, 80, 100}));
}

AnalysisData ran(AnalysisKind kind, Lawful& source,
                 const std::vector<std::pair<std::string, std::string>>& settings) {
    Settings overrides;
    overrides.set("render.background", "none");
    for (const auto& [key, text] : settings) {
        overrides.set(key, text);
    }
    AnalysisData data = AnalysisData::of(Project(), kind, overrides);
    AnalysisGenerator(source, test::sceneWithoutFiles).run(data);
    return data;
}

TEST(TargetError, IsWrittenIntoTheResultWithItsErrors) {
    Lawful source;
    const AnalysisData data =
        ran(AnalysisKind::polar, source,
            {{"polar.step", "30"}, {"render.targetError", "0.5%"}, {"render.bounces", "0"}});
    EXPECT_EQ(data.table.provenance.value("render.targetError"), "0.5 %");
    EXPECT_THAT(data.providedBy,
                Contains(HasSubstr("target error 0.5 %: windows of 512 samples a side")));
    EXPECT_THAT(data.table.toCsv(), HasSubstr("# answered by: target error 0.5 %: skipped sun"));
    ASSERT_NE(data.table.find("error_contrast_intensity"), nullptr);
    EXPECT_THAT(data.table.find("error_contrast_intensity")->values,
                Each(testing::DoubleNear(100.0 * 0.0025, 1e-9)));
    EXPECT_THAT(data.warnings, testing::IsEmpty());
    EXPECT_EQ(source.scene.settings.tileSide_samples, 512) << "of the run itself";
}

TEST(TargetError, NamesTheCasesThatMissIt) {
    Lawful source;
    source.worseBehind = 3.0; // at 91 deg alone
    const AnalysisData data = ran(AnalysisKind::polar, source,
                                  {{"polar.from", "0"},
                                   {"polar.to", "91"},
                                   {"polar.step", "90"},
                                   {"render.targetError", "0.5"},
                                   {"render.bounces", "0"}});
    EXPECT_THAT(data.providedBy, Contains(HasSubstr("windows of 1024 samples")));
    source.worseBehind = 1.0;
    const AnalysisData none =
        ran(AnalysisKind::polar, source, {{"polar.step", "90"}, {"render.targetError", "0.02"}});
    EXPECT_THAT(none.warnings, Contains(HasSubstr("errors of up to 0.031 %, where the target is "
                                                  "0.02 %")));
}

TEST(TargetError, LeavesSpectraAsTheyAreSet) {
    Lawful source;
    const AnalysisData data = ran(AnalysisKind::spectrum, source, {{"render.targetError", "0.5"}});
    EXPECT_EQ(data.state, AnalysisState::complete);
    EXPECT_THAT(data.providedBy, Not(Contains(HasSubstr("target error"))));
}

TEST(TargetError, IsAPercentageWithOrWithoutItsSign) {
    const SettingInfo& setting = settingInfo("render.targetError");
    EXPECT_EQ(canonicalText(setting, "0.5%"), "0.5");
    EXPECT_EQ(canonicalText(setting, "0.50 %"), "0.5");
    EXPECT_EQ(canonicalText(setting, "none"), "none");
    for (const char* wrong : {"0", "-1", "51", "%", "0.5%%", "half"}) {
        EXPECT_EQ(canonicalText(setting, wrong), std::nullopt) << wrong;
    }
    EXPECT_EQ(canonicalText(settingInfo("render.lightError"), "0.5%"), std::nullopt);
}

TEST(CostAccuracyStudy, HasEveryConfigurationThatDiffersAndNoOther) {
    SceneDescription scene;
    scene.settings = irsg::RenderSettings::direct();
    scene.settings.background = irsg::BackgroundMode::none;
    EXPECT_EQ(CostAccuracyStudy::configurationsOf(scene, true).size(), 6u * 2u)
        << "modes, with and without light";
    scene.settings.background = irsg::BackgroundMode::environment;
    EXPECT_EQ(CostAccuracyStudy::configurationsOf(scene, true).size(), 6u * 2u * 2u)
        << "one row or more";
    scene.settings.bounces = irsg::convergedBounces;
    scene.settings.sunShadows = irsg::SunShadowMode::disc;
    EXPECT_EQ(CostAccuracyStudy::configurationsOf(scene, true).size(), 6u * 2u * 4u);
    scene.settings.sun = scene.settings.ambientReflection = ReflectionMode::off;
    EXPECT_EQ(CostAccuracyStudy::configurationsOf(scene, true).size(), 6u * 2u * 3u)
        << "nothing to leave out";
}

/// Lawful, and wrong by what it says; slower the less so.
class Slow : public Lawful {
  public:
    double intensity_W_sr(const irsg::Vec3& u) const override {
        const double error = 0.5 * 0.02 * std::pow(128.0 / std::max(window(), 1), 1.5);
        return Lawful::intensity_W_sr(u) * (1.0 + error);
    }
    irsg::RenderReport measure() override {
        const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds(window());
        while (std::chrono::steady_clock::now() < end) {
        }
        return Lawful::measure();
    }

  private:
    int window() const {
        return scene.settings.tileSide_samples > 0 ? scene.settings.tileSide_samples
                                                   : scene.settings.samplesPerAxis;
    }
};

AnalysisData ofCostAccuracy(const std::vector<std::pair<std::string, std::string>>& settings) {
    AnalysisData data;
    data.kind = CostAccuracyStudy::kind();
    data.settings.set("render.background", "none");
    for (const auto& [key, text] : settings) {
        data.settings.set(key, text);
    }
    return data;
}

TEST(CostAccuracyStudy, MarksWhatNothingBeatsAndTheQuickestThatMeetsTheTarget) {
    Slow source;
    source.sunlight_W_sr = 5.0; // 3 % of it: no way without light meets the target
    AnalysisData data = ofCostAccuracy(
        {{"render.targetError", "0.5"}, {"render.bounces", "0"}, {"render.shadows", "off"}});
    CostAccuracyStudy::run(data, source, test::sceneWithoutFiles, {.repeats = 2});
    EXPECT_EQ(data.state, AnalysisState::complete);
    const auto values = [&](const char* key) { return data.table.find(key)->values; };
    ASSERT_EQ(data.table.rowCount(), 12u);
    EXPECT_TRUE(std::ranges::is_sorted(values("true_error")));
    EXPECT_TRUE(std::ranges::is_sorted(values("least_time"), std::greater<>()));
    const auto front = values("on_front"), time = values("time"), error = values("true_error");
    for (std::size_t i = 0; i < front.size(); ++i) {
        bool isBeaten = false;
        for (std::size_t k = 0; k < front.size(); ++k) {
            isBeaten |= time[k] <= time[i] && error[k] < error[i];
        }
        EXPECT_EQ(front[i], isBeaten ? 0.0 : 1.0) << i;
    }
    // 1 % at 128, 0.35 % at 256, 0.12 % at 512, less than 0.5 % of truth's 0.016 %.
    const auto chosen = values("chosen"), mode = values("antialiasing"), light = values("light");
    const auto at = static_cast<std::size_t>(std::ranges::find(chosen, 1.0) - chosen.begin());
    ASSERT_LT(at, chosen.size());
    EXPECT_EQ(std::ranges::count(chosen, 1.0), 1);
    EXPECT_EQ(mode[at], 4.0);
    EXPECT_EQ(light[at], 3.0) << "all that the settings have";
    EXPECT_NEAR(error[at],
                100.0 * (1.0 + 0.01 * std::pow(0.5, 1.5)) / (1.0 + 0.01 * std::pow(0.0625, 1.5)) -
                    100.0,
                1e-6);
    EXPECT_THAT(data.providedBy,
                Contains(HasSubstr("target error 0.5 %: windows of 256 samples a side, the "
                                   "quickest of 12 configurations that meet it")));
}

TEST(CostAccuracyStudy, KeepsWhatWasDoneBeforeAStop) {
    Slow source;
    AnalysisData data = ofCostAccuracy({});
    std::stop_source stop;
    CostAccuracyStudy::run(
        data, source, test::sceneWithoutFiles, {.repeats = 1},
        [&](const Progress& progress) {
            if (progress.done == 4) {
                stop.request_stop();
            }
        },
        stop.get_token());
    EXPECT_EQ(data.state, AnalysisState::partial);
    EXPECT_EQ(data.table.rowCount(), 4u);
    EXPECT_THAT(data.warnings, Contains(HasSubstr("stopped after 4 of ")));
}

/// By the way it is of: the true error, %.
std::map<std::vector<double>, double> errorsOf(const AnalysisData& data) {
    std::map<std::vector<double>, double> errors;
    for (std::size_t i = 0; i < data.table.rowCount(); ++i) {
        std::vector<double> configuration;
        for (const char* key : {"antialiasing", "bins", "wideband", "background_rows", "light"}) {
            configuration.push_back(data.table.find(key)->values[i]);
        }
        errors[configuration] = data.table.find("true_error")->values[i];
    }
    return errors;
}

TEST(CostAccuracyStudy, LeavesOutConfigurationsThatAModelOfCostsCallsBeaten) {
    Slow source;
    source.sunlight_W_sr = 5.0; // 3 % of it
    const auto settings = {std::pair<std::string, std::string>{"render.bounces", "0"},
                           {"render.shadows", "off"}};
    AnalysisData all = ofCostAccuracy(settings), likely = ofCostAccuracy(settings);
    CostAccuracyStudy::run(all, source, test::sceneWithoutFiles, {.repeats = 1});
    CostAccuracyStudy::run(likely, source, test::sceneWithoutFiles, {.repeats = 1, .likely = true});
    EXPECT_EQ(likely.state, AnalysisState::complete);
    const auto known = errorsOf(all), some = errorsOf(likely);
    ASSERT_EQ(known.size(), 12u);
    EXPECT_LT(some.size(), known.size());
    // Each of six modes with all light, and the finest without.
    EXPECT_GE(some.size(), 7u);
    for (const auto& [configuration, error] : some) {
        EXPECT_EQ(error, known.at(configuration)) << "the same number";
    }
    EXPECT_THAT(likely.providedBy, Contains(HasSubstr("configurations: ")));
    EXPECT_THAT(all.providedBy, Not(Contains(HasSubstr("configurations: "))));
    // Twice the same, whatever the clock says.
    AnalysisData again = ofCostAccuracy(settings);
    CostAccuracyStudy::run(again, source, test::sceneWithoutFiles, {.repeats = 1, .likely = true});
    EXPECT_EQ(errorsOf(again), some);
}

TEST(CostAccuracyStudy, SaysBeforeHowManyConfigurationsThereAre) {
    const AnalysisData data = ofCostAccuracy({{"render.bounces", "0"}, {"render.shadows", "off"}});
    const auto all = CostAccuracyStudy::sizeOf(data.project, data.settings, {.repeats = 2});
    EXPECT_EQ(all.all, 12u);
    EXPECT_EQ(all.alone, 7u);
    EXPECT_GT(all.most_s, all.least_s);
    EXPECT_GT(all.least_s, 0.0);
    EXPECT_GT(CostAccuracyStudy::sizeOf(data.project, data.settings, {.repeats = 20}).most_s,
              all.most_s);
    EXPECT_EQ(CostAccuracyStudy::optionWords({}), "");
    EXPECT_EQ(CostAccuracyStudy::optionWords({.repeats = 5, .likely = true}),
              " --repeats 5 --configurations likely");
}

TEST(CostAccuracyStudy, TellsTheSettingsOfEachConfiguration) {
    Slow source;
    AnalysisData data = ofCostAccuracy({{"render.targetError", "3"}, {"sensor.mode", "spectral"}});
    CostAccuracyStudy::run(data, source, test::sceneWithoutFiles, {.repeats = 1});
    const auto column = [&](const char* key) { return data.table.find(key)->values; };
    std::set<std::pair<int, int>> seen;
    for (std::size_t i = 0; i < data.table.rowCount(); ++i) {
        const Settings set = data.settings.with(CostAccuracyStudy::settingsOf(data.table, i));
        EXPECT_FALSE(set[key::renderTargetError]);
        const irsg::RenderSettings render = renderSettingsOf(set);
        const int mode = static_cast<int>(column("antialiasing")[i]);
        EXPECT_EQ(render.tileSide_samples, mode > 2 ? 128 << (mode - 3) : 0) << mode;
        if (mode <= 2) {
            EXPECT_EQ(render.samplesPerAxis, 1 << mode) << mode;
        }
        EXPECT_EQ(render.backgroundRows, static_cast<int>(column("background_rows")[i]));
        const int light = static_cast<int>(column("light")[i]);
        EXPECT_EQ(render.bounces != 0, light == CostAccuracyStudy::allLight);
        EXPECT_EQ(render.sunShadows != irsg::SunShadowMode::off,
                  light >= CostAccuracyStudy::withShadows);
        EXPECT_EQ(render.sun != ReflectionMode::off, light >= CostAccuracyStudy::sunAndSky);
        EXPECT_EQ(render.ambientReflection != ReflectionMode::off,
                  light >= CostAccuracyStudy::sunAndSky);
        seen.insert({mode, light});
    }
    EXPECT_EQ(seen.size(), 6u * 4u);
    EXPECT_THROW(CostAccuracyStudy::settingsOf(data.table, data.table.rowCount()),
                 irsg::LogicError);
}

TEST(EnvironmentBins, TakeThePlaceOfThoseOfTheFile) {
    Settings settings;
    settings.set("environment.atmospheres",
                 std::string(SMAT_SOURCE_DIR) + "/resources/atmospheres/temperate-maritime.xml");
    const irsg::Band band = irsg::Band::fromText("3-5");
    const auto nodes = [&](const char* bins) {
        settings.set("environment.bins", bins);
        return environmentOf(Project(), settings).nodesOf(band)->size();
    };
    const std::size_t own = nodes("native"), wide = nodes("15"), narrow = nodes("1");
    EXPECT_GT(narrow, 4 * wide) << "nodes of spectra beside those of bins";
    EXPECT_TRUE(own == nodes("1") || own == nodes("5") || own == nodes("15"));
    settings.set("environment.atmospheres", "none");
    EXPECT_THAT(test::refusalOf([&] { nodes("5"); }), HasSubstr("bins"));
}

} // namespace
} // namespace smat
