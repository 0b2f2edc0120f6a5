#include "smatcore/analysis/SweepTable.h"

#include <cmath>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/Vacuum.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/analysis/CaseWarnings.h"
#include "smatcore/data/ColumnName.h"
#include "tests/core/AnalyticSource.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

using test::GreySphere;
using testing::ElementsAre;
using testing::HasSubstr;

AnalysisData asked(AnalysisKind kind,
                   const std::vector<std::pair<std::string, std::string>>& settings) {
    Settings overrides;
    for (const auto& [key, text] : settings) {
        overrides.set(key, text);
    }
    return AnalysisData::of(Project(), kind, overrides);
}

const std::vector<double>& column(const AnalysisData& data, const std::string& key) {
    const ResultColumn* found = data.table.find(key);
    if (found == nullptr) {
        throw irsg::LogicError("no column " + key);
    }
    return found->values;
}

std::vector<std::string> headers(const ResultTable& table) {
    std::vector<std::string> list;
    for (const ResultColumn& one : table.columns()) {
        list.push_back(one.header());
    }
    return list;
}

/// Grey spheres of radius 1 m at 320 K, one beside the other; a part of each sum is what is asked
/// of an object at its own range.
class GreySpheres : public GreySphere {
  public:
    irsg::RenderReport measure() override {
        irsg::RenderReport report = GreySphere::measure();
        report.all.intensity_W_sr = report.all.contrastIntensity_W_sr = 0.0;
        for (std::size_t i = 0; i < scene.entities.size(); ++i) {
            irsg::ObjectRadiometry object;
            object.name = scene.entities[i].name;
            object.range_m = irsg::length(viewpoint.position_m - scene.entities[i].pose.position_m);
            object.intensity_W_sr = object.contrastIntensity_W_sr = intensity_W_sr({});
            object.irradiance_W_m2 = object.intensity_W_sr / std::pow(object.range_m, 2);
            object.coveredPixels = 1.0;
            report.all.intensity_W_sr += object.intensity_W_sr;
            report.all.contrastIntensity_W_sr += object.contrastIntensity_W_sr;
            report.objects.push_back(object);
        }
        if (warnsBelow_m > report.all.range_m) {
            report.warnings.push_back("too near");
        }
        return report;
    }
    double warnsBelow_m = 0.0;
};

/// Two spheres of one name, the second 1000 m behind the first.
SceneDescription twoSpheres(const Project& project, const Settings& settings) {
    SceneDescription scene = test::sceneWithoutFiles(project, settings);
    irsg::Entity behind = scene.entities.front();
    scene.entities.front().name = behind.name = "ball";
    behind.pose.position_m.y -= 1000.0;
    scene.entities.push_back(behind);
    return scene;
}

TEST(SweepTable, HasTheColumnsOfOneObjectInOneBandWithoutObjectOrBand) {
    GreySphere sphere;
    AnalysisData data = asked(AnalysisKind::range, {{"range.points", "2"}});
    AnalysisGenerator(sphere, test::sceneWithoutFiles).run(data);
    EXPECT_THAT(headers(data.table),
                ElementsAre("range [m]", "intensity [W sr-1]", "contrast_intensity [W sr-1]",
                            "irradiance [W m-2]", "pixels", "error_intensity [W sr-1]",
                            "error_contrast_intensity [W sr-1]", "error_irradiance [W m-2]"));
}

/// No air over a round earth.
class RoundEarth : public irsg::Vacuum {
  public:
    irsg::TargetView targetView(const irsg::AtmosphericPath& path) const override {
        return irsg::sphericalTargetView(path);
    }
};

TEST(SweepTable, SaysWhatTheHorizonHidesWhereAPathReachesBehindIt) {
    class Hidden : public GreySpheres {
      public:
        irsg::RenderReport measure() override {
            irsg::RenderReport report = GreySpheres::measure();
            for (irsg::ObjectRadiometry& object : report.objects) {
                object.hiddenByHorizon = object.range_m > 20e3 ? 0.25 : 0.0;
            }
            return report;
        }
    };
    const auto ran = [](AnalysisKind kind, const std::string& to_m) {
        Hidden sphere;
        AnalysisData data = asked(kind, {{"range.points", "2"},
                                         {"range.steps", "fixed"},
                                         {"range.from", "5000"},
                                         {"range.to", to_m},
                                         {"camera.range", to_m},
                                         {"target.altitude", "5"},
                                         {"polar.step", "90"}});
        AnalysisGenerator(sphere, [](const Project& project, const Settings& settings) {
            SceneDescription scene = test::sceneWithoutFiles(project, settings);
            scene.environment = {};
            scene.environment.add(std::make_shared<RoundEarth>());
            return scene;
        }).run(data);
        return data;
    };
    EXPECT_THAT(column(ran(AnalysisKind::range, "40000"), "hidden_by_horizon"),
                ElementsAre(0.0, 0.25));
    EXPECT_EQ(ran(AnalysisKind::range, "7000").table.find("hidden_by_horizon"), nullptr);
    EXPECT_EQ(ran(AnalysisKind::polar, "40000").table.find("hidden_by_horizon"), nullptr);
}

/// A sphere whose numbers are known to 1, 2 and 2 % by cause.
class Uncertain : public GreySphere {
  public:
    std::vector<irsg::RenderReport> reports(const irsg::Outputs& outputs) override {
        asked = outputs.errors().value_or(true);
        std::vector<irsg::RenderReport> made = GreySphere::reports(outputs);
        for (irsg::RenderReport& report : made) {
            if (asked) {
                report.all.errors = errorsOf(report.all);
            }
        }
        return made;
    }
    irsg::Rendered image(const irsg::Outputs& outputs) override {
        irsg::Rendered rendered = GreySphere::image(outputs);
        irsg::ObjectRadiometry& all = rendered.reports.front().all;
        if (outputs.errors().value_or(true)) {
            all.errors = errorsOf(all);
        }
        return rendered;
    }
    bool asked = false;

  private:
    static irsg::RadiometryErrors errorsOf(const irsg::ObjectRadiometry& sums) {
        const irsg::ErrorParts one{0.01, 0.02, 0.02, 0.04};
        return {one.times(sums.intensity_W_sr), one.times(sums.contrastIntensity_W_sr),
                one.times(sums.irradiance_W_m2)};
    }
};

TEST(SweepTable, HasTheErrorsOfItsNumbersBehindThemWhereTheyAreAskedFor) {
    for (const char* errors : {"off", "sum", "causes"}) {
        Uncertain sphere;
        AnalysisData data =
            asked(AnalysisKind::range,
                  {{"range.points", "2"}, {"render.errors", errors}, {"sensor.band", "3-5,8-12"}});
        AnalysisGenerator(sphere, test::sceneWithoutFiles).run(data);
        const bool isAsked = errors != std::string("off");
        EXPECT_EQ(sphere.asked, isAsked);
        EXPECT_EQ(data.table.columns().size(),
                  isAsked ? (errors == std::string("sum") ? 15u : 39u) : 9u);
        if (!isAsked) {
            continue;
        }
        for (const char* quantity : {"intensity@8-12um", "irradiance@3-5um"}) {
            const ResultColumn* error = data.table.find(std::string("error_") + quantity);
            ASSERT_NE(error, nullptr);
            EXPECT_EQ(error->unit, data.table.find(quantity)->unit);
            EXPECT_NEAR(error->values[1], 0.05 * column(data, quantity)[1],
                        1e-12 * column(data, quantity)[1]);
        }
        if (errors == std::string("causes")) {
            EXPECT_NEAR(column(data, "error_background_contrast_intensity@3-5um")[0],
                        0.02 * column(data, "contrast_intensity@3-5um")[0], 1e-9);
            EXPECT_NEAR(column(data, "error_exchange_irradiance@8-12um")[1],
                        0.04 * column(data, "irradiance@8-12um")[1], 1e-9);
            EXPECT_NEAR(column(data, "error_sampling_intensity@3-5um")[0],
                        0.01 * column(data, "intensity@3-5um")[0], 1e-9);
        }
    }
}

TEST(SweepTable, SaysThatASourceDoesNotKnowItsErrors) {
    GreySphere sphere;
    sphere.statesErrors = false;
    AnalysisData data =
        asked(AnalysisKind::range, {{"range.points", "2"}, {"render.errors", "sum"}});
    AnalysisGenerator(sphere, test::sceneWithoutFiles).run(data);
    EXPECT_TRUE(std::isnan(column(data, "error_intensity")[0]));
}

TEST(SweepTable, ErrorsOfAnImageAreItsAttributesByCause) {
    Uncertain sphere;
    AnalysisData data = asked(AnalysisKind::image, {{"render.errors", "sum"}});
    AnalysisGenerator(sphere, test::sceneWithoutFiles).run(data);
    const auto number = [&](const char* key) { return std::stod(data.image.attributes.at(key)); };
    EXPECT_NEAR(number("error_intensity_W_sr"), 0.05 * column(data, "intensity")[0], 1e-6);
    EXPECT_NEAR(number("error_sampling_irradiance_W_m2") / column(data, "irradiance")[0], 0.01,
                1e-8);
    EXPECT_NEAR(column(data, "error_intensity")[0], number("error_intensity_W_sr"), 1e-6);
}

TEST(SweepTable, BandsThatMeetAddToTheBandOfBoth) {
    for (const AnalysisKind kind : {AnalysisKind::polar, AnalysisKind::range, AnalysisKind::time}) {
        GreySphere sphere;
        AnalysisData data = asked(kind, {{"sensor.band", "3-4,4-5,3-5"}, {"polar.step", "90"}});
        AnalysisGenerator(sphere, test::sceneWithoutFiles).run(data);
        for (const char* quantity : {"intensity", "contrast_intensity", "irradiance"}) {
            const auto& low = column(data, quantity + std::string("@3-4um"));
            const auto& high = column(data, quantity + std::string("@4-5um"));
            const auto& both = column(data, quantity + std::string("@3-5um"));
            ASSERT_FALSE(both.empty());
            for (std::size_t i = 0; i < both.size(); ++i) {
                EXPECT_NEAR((low[i] + high[i]) / both[i], 1.0, 1e-6) << quantity << " " << i;
            }
        }
        EXPECT_EQ(data.table.find("intensity"), nullptr);
        EXPECT_EQ(sphere.scene.sensor.band, irsg::Band::topHat(3, 4)) << "is put back";
        std::vector<std::string> bands;
        for (const auto& [key, value] : data.table.provenance.entries) {
            if (key == "band") {
                bands.push_back(value);
            }
        }
        EXPECT_EQ(bands.size(), 3u);
    }
}

TEST(SweepTable, OneBandOfSeveralIsThatBandAlone) {
    GreySphere sphere;
    AnalysisData several = asked(AnalysisKind::range, {{"sensor.band", "8-12,3-5"}});
    AnalysisData alone = asked(AnalysisKind::range, {{"sensor.band", "3-5"}});
    AnalysisGenerator(sphere, test::sceneWithoutFiles).run(several);
    AnalysisGenerator(sphere, test::sceneWithoutFiles).run(alone);
    EXPECT_EQ(column(several, "intensity@3-5um"), column(alone, "intensity"));
    EXPECT_THAT(several.summary.front().label, HasSubstr("8-12 um"));
}

TEST(SweepTable, SeveralResponsesStandInForTheBandsEachWithTheNameOfItsFile) {
    const auto folder = test::ownFolder();
    test::writtenFile(folder / "near.csv", "um,response\n3,1\n5,1\n");
    test::writtenFile(folder / "far.csv", "um,response\n8,1\n12,1\n");
    const std::string near = (folder / "near.csv").string(), far = (folder / "far.csv").string();
    GreySphere sphere;
    AnalysisData data = asked(AnalysisKind::range, {{"sensor.response", near + ";" + far}});
    AnalysisGenerator(sphere, test::sceneWithoutFiles).run(data);
    const double expected =
        irsg::pi * 0.9 * irsg::bandRadiance_W_m2_sr(irsg::Band::topHat(8, 12), 320.0);
    EXPECT_NEAR(column(data, "intensity@far").front() / expected, 1.0, 1e-6);
    EXPECT_NE(data.table.find("intensity@near"), nullptr);
    EXPECT_THAT(test::refusalOf([&] {
                    AnalysisData twice =
                        asked(AnalysisKind::range, {{"sensor.response", near + ";" + near}});
                    AnalysisGenerator(sphere, test::sceneWithoutFiles).run(twice);
                }),
                HasSubstr("each response once"));
}

TEST(SweepTable, SaysByNameWhatCannotTakeSeveralBands) {
    GreySphere sphere;
    for (const AnalysisKind kind : {AnalysisKind::image, AnalysisKind::spectrum}) {
        const std::string refusal = test::refusalOf([&] {
            AnalysisData data = asked(kind, {{"sensor.band", "3-5,8-12"}});
            AnalysisGenerator(sphere, test::sceneWithoutFiles).run(data);
        });
        EXPECT_THAT(refusal, HasSubstr("sensor.band"));
        EXPECT_THAT(refusal, HasSubstr("one band"));
        EXPECT_THAT(refusal, HasSubstr(name(kind)));
    }
    EXPECT_EQ(sphere.drawings, 0);
}

TEST(SweepTable, EveryObjectHasItsColumnsAtItsOwnRangeBesideTheirSum) {
    GreySpheres spheres;
    AnalysisData data = asked(
        AnalysisKind::range, {{"range.from", "1000"}, {"range.to", "2000"}, {"range.points", "2"}});
    AnalysisGenerator(spheres, twoSpheres).run(data);
    EXPECT_THAT(
        headers(data.table),
        ElementsAre("range [m]", "intensity [W sr-1]", "contrast_intensity [W sr-1]",
                    "irradiance [W m-2]", "pixels", "error_intensity [W sr-1]",
                    "error_contrast_intensity [W sr-1]", "error_irradiance [W m-2]",
                    "ball.range [m]", "ball.intensity [W sr-1]", "ball.contrast_intensity [W sr-1]",
                    "ball.irradiance [W m-2]", "ball.pixels", "error_ball.intensity [W sr-1]",
                    "error_ball.contrast_intensity [W sr-1]", "error_ball.irradiance [W m-2]",
                    "ball-2.range [m]", "ball-2.intensity [W sr-1]",
                    "ball-2.contrast_intensity [W sr-1]", "ball-2.irradiance [W m-2]",
                    "ball-2.pixels", "error_ball-2.intensity [W sr-1]",
                    "error_ball-2.contrast_intensity [W sr-1]", "error_ball-2.irradiance [W m-2]"));
    const double one = irsg::pi * 0.9 * irsg::bandRadiance_W_m2_sr(irsg::Band::topHat(3, 5), 320.0);
    for (std::size_t row = 0; row < 2; ++row) {
        EXPECT_NEAR(column(data, "intensity")[row] / (2.0 * one), 1.0, 1e-9);
        EXPECT_NEAR(column(data, "ball.intensity")[row] / one, 1.0, 1e-9);
        EXPECT_NEAR(column(data, "ball-2.intensity")[row] / one, 1.0, 1e-9);
        EXPECT_NEAR(column(data, "ball-2.range")[row], column(data, "range")[row] + 1000.0, 1e-6);
    }
}

TEST(SweepTable, ObjectAndBandStandInOneNameWhereThereAreSeveralOfBoth) {
    GreySpheres spheres;
    AnalysisData data = asked(AnalysisKind::time, {{"sensor.band", "3-5,8-12"}});
    AnalysisGenerator(spheres, twoSpheres).run(data);
    EXPECT_EQ(data.table.find("ball-2.contrast_intensity@8-12um")->header(),
              "ball-2.contrast_intensity@8-12um [W sr-1]");
    EXPECT_EQ(data.table.find("ball-2.contrast_intensity@8-12um")->axisTitle(),
              "Contrast intensity, ball-2, 8-12 um (W·sr⁻¹)");
}

TEST(SweepTable, AWarningIsToldOnceWithTheCasesItHoldsFor) {
    GreySpheres spheres;
    spheres.warnsBelow_m = 2500.0;
    AnalysisData data = asked(
        AnalysisKind::range, {{"range.from", "500"}, {"range.to", "5000"}, {"range.points", "10"}});
    AnalysisGenerator(spheres, test::sceneWithoutFiles).run(data);
    EXPECT_THAT(data.warnings, ElementsAre("at 500 m (and 3 more): too near"));
    EXPECT_EQ(data.table.provenance.value("warning"), "at 500 m (and 3 more): too near");
    for (std::size_t row = 0; row < 10; ++row) {
        EXPECT_EQ(data.table.warningOf(row), row < 4 ? "too near" : "") << row;
    }
    EXPECT_THAT(data.table.toCsv(), HasSubstr(",warning\n500,"));

    spheres.warnsBelow_m = 0.0;
    AnalysisGenerator(spheres, test::sceneWithoutFiles).run(data);
    EXPECT_TRUE(data.table.warnings().empty());
    EXPECT_THAT(data.table.toCsv(), testing::Not(HasSubstr("warning")));
}

TEST(SweepTable, PublishedTilesAreRefusedInSweepsWithTheReason) {
    GreySphere sphere;
    for (const AnalysisKind kind :
         {AnalysisKind::polar, AnalysisKind::range, AnalysisKind::time, AnalysisKind::spectrum}) {
        const auto run = [&](const char* mode) {
            return test::refusalOf([&] {
                AnalysisData data =
                    asked(kind, {{"render.zoom", "sills"}, {"render.antialiasing", mode}});
                AnalysisGenerator(sphere, test::sceneWithoutFiles).plan(data);
            });
        };
        EXPECT_THAT(run("4"), HasSubstr("render.zoom"));
        EXPECT_THAT(run("4"), HasSubstr("do not add to pixels"));
        EXPECT_THAT(run("2"), testing::Not(HasSubstr("render.zoom"))) << "modes 0 to 2 have none";
    }
    AnalysisData image = asked(AnalysisKind::image, {{"render.zoom", "sills"}});
    AnalysisGenerator(sphere, test::sceneWithoutFiles).run(image);
    EXPECT_EQ(image.state, AnalysisState::complete);
}

TEST(CaseWarnings, TellsTheWorstOfAKind) {
    CaseWarnings warnings;
    for (const int layers : {0, 70, 90, 80}) {
        warnings.beginCase(std::to_string(layers) + " m");
        irsg::RenderReport report;
        report.all.coveredPixels = 1.0;
        report.layersLeftOver = layers;
        warnings.addReport(report, 64);
        warnings.addReport(report, 64); // a second band of the same case
    }
    ASSERT_EQ(warnings.sentences().size(), 1u);
    EXPECT_THAT(warnings.sentences().front(), HasSubstr("at 70 m (and 2 more): up to 90 samples"));
}

TEST(CaseWarnings, WhatHoldsInEveryCaseNamesNone) {
    CaseWarnings warnings;
    for (const char* one : {"1 m", "2 m"}) {
        warnings.beginCase(one);
        warnings.add("always");
    }
    EXPECT_THAT(warnings.sentences(), ElementsAre("always"));
}

struct NameRow {
    const char* key;
    ColumnName parts;
};

TEST(ColumnName, IsReadAndWritten) {
    for (const NameRow& row : std::initializer_list<NameRow>{
             {"intensity", {"", "", "intensity", ""}},
             {"intensity@3.4-4.1um", {"", "", "intensity", "3.4-4.1um"}},
             {"near.intensity", {"", "near", "intensity", ""}},
             {"a.b.contrast_intensity@mwir", {"", "a.b", "contrast_intensity", "mwir"}},
             {"relative_difference_near.pixels", {"relative_difference_", "near", "pixels", ""}},
             {"mean@8-12um", {"", "", "mean", "8-12um"}},
             {"p2.5", {"", "", "p2.5", ""}},
             {"a@b.intensity", {"", "a@b", "intensity", ""}},
             {"error_a@b.intensity@3.4-4.1um", {"error_", "a@b", "intensity", "3.4-4.1um"}},
             {"intensity@mwir@20C", {"", "", "intensity", "mwir@20C"}},
             {"ship: grey, new [2].pixels@mwir", {"", "ship: grey, new [2]", "pixels", "mwir"}},
             {"engine.load", {"", "", "engine.load", ""}}}) {
        EXPECT_EQ(ColumnName::of(row.key), row.parts) << row.key;
        EXPECT_EQ(row.parts.key(), row.key);
    }
    EXPECT_EQ(ColumnName::of("near.intensity@3-5um").which(), "near, 3-5 um");
    EXPECT_EQ(ColumnName::of("near.intensity@3-5um").series(), "intensity");
}

TEST(ColumnName, TellsTheErrorOfACauseFromTheirSum) {
    const ColumnName name = ColumnName::of("error_air_near.contrast_intensity@3-5um");
    EXPECT_EQ(name, (ColumnName{"error_air_", "near", "contrast_intensity", "3-5um"}));
    EXPECT_EQ(name.key(), "error_air_near.contrast_intensity@3-5um");
    EXPECT_EQ(ColumnName::of("error_intensity").prefix, "error_");
    EXPECT_EQ((ResultColumn{"error_sampling_intensity", "W sr-1", {}}).axisTitle(),
              "Error by sampling of intensity (W·sr⁻¹)");
}

TEST(ColumnName, LabelsAreDistinctAndAsTheyWereWritten) {
    EXPECT_THAT(distinctLabels({"a", "b", "a", "a-2", "a"}),
                ElementsAre("a", "b", "a-3", "a-2", "a-4"));
    EXPECT_THAT(
        distinctLabels({"engine: hot, new", "[x]", "\"y\"@#\\", "two\nlines", " ", ""}),
        ElementsAre("engine: hot, new", "[x]", "\"y\"@#\\", "two lines", "object", "object-2"));
    // A slash stands before a part.
    const std::string label = distinctLabels({"F/A-18"}).front();
    EXPECT_EQ(label, "F\u2215A-18");
    const ColumnName name =
        ColumnName::of(ColumnName{"", ColumnName::ofPart(label, "nozzle"), "intensity", ""}.key());
    EXPECT_EQ(name.part(), "nozzle");
}

TEST(ColumnName, LabelsOfFilesAreSafeAndDistinct) {
    EXPECT_THAT(distinctFileLabels({"a: b, c", "a; b, c", "F/A-18", "..\\x", "3.4-4.1um", ""}),
                ElementsAre("a_ b_ c", "a_ b_ c-2", "F_A-18", ".._x", "3.4-4.1um", "object"));
}

} // namespace
} // namespace smat
