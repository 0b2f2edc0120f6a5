#include "smatcore/analysis/AnalysisGenerator.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "smatcore/analysis/ResultFile.h"
#include "tests/core/AnalyticSource.h"

namespace smat {
namespace {

using irsg::Quantity;
using test::GreySphere;
using test::SixSidedBox;

AnalysisData asked(AnalysisKind kind,
                   const std::vector<std::pair<std::string, std::string>>& settings) {
    Settings overrides;
    for (const auto& [key, text] : settings) {
        overrides.set(key, text);
    }
    return AnalysisData::of(Project(), kind, overrides);
}

const std::vector<double>& column(const AnalysisData& data, Quantity quantity) {
    const ResultColumn* found = data.table.find(quantity);
    if (found == nullptr) {
        throw irsg::LogicError("no such column");
    }
    return found->values;
}

AnalysisData ran(AnalysisData data, test::AnalyticSource& source) {
    AnalysisGenerator(source, test::sceneWithoutFiles).run(data);
    return data;
}

struct PolarRow {
    const char* name;
    const char* type;
    std::vector<double> sidesAtRightAngles; ///< intensity at 0, 90, 180, 270 deg
    std::vector<double> azimuth, elevation;
};

void PrintTo(const PolarRow& row, std::ostream* out) {
    *out << row.name;
}

class PolarMode : public testing::TestWithParam<PolarRow> {};

TEST_P(PolarMode, StartsAtTheNoseAndTurnsTheRightWay) {
    SixSidedBox box;
    const AnalysisData data = ran(
        asked(AnalysisKind::polar, {{"polar.type", GetParam().type}, {"polar.step", "90"}}), box);
    EXPECT_THAT(column(data, Quantity::angle), testing::ElementsAre(0, 90, 180, 270));
    EXPECT_THAT(column(data, Quantity::intensity),
                testing::Pointwise(testing::DoubleNear(1e-9), GetParam().sidesAtRightAngles));
    EXPECT_EQ(column(data, Quantity::azimuth), GetParam().azimuth);
    EXPECT_EQ(column(data, Quantity::elevation), GetParam().elevation);
}

TEST_P(PolarMode, GivesTheSameSidesWhicheverWayTheTargetStands) {
    // Camera-Azimuth is level, so that only yaw leaves it unchanged; the other two hold for all.
    const bool isLevel = std::string(GetParam().type) == "camera-azimuth";
    SixSidedBox box;
    box.referencePoint = {0.3, -0.7, 0.2};
    const AnalysisData data =
        ran(asked(AnalysisKind::polar, {{"polar.type", GetParam().type},
                                        {"polar.step", "90"},
                                        {"target.yaw", "37"},
                                        {"target.pitch", isLevel ? "0" : "20"},
                                        {"target.roll", isLevel ? "0" : "-50"},
                                        {"camera.azimuth", "70"}}),
            box);
    EXPECT_THAT(column(data, Quantity::intensity),
                testing::Pointwise(testing::DoubleNear(1e-9), GetParam().sidesAtRightAngles));
}

TEST_P(PolarMode, LeavesTheSettingsAndTellsItsFirstCaseAsItWasSeen) {
    SixSidedBox box;
    box.referencePoint = {0.3, -0.7, 0.2};
    AnalysisData data = asked(AnalysisKind::polar, {{"polar.type", GetParam().type},
                                                    {"target.yaw", "37"},
                                                    {"target.pitch", "20"},
                                                    {"camera.azimuth", "70"},
                                                    {"camera.elevation", "10"}});
    const Settings before = data.settings;
    const PlacedCase first = AnalysisGenerator(box, test::sceneWithoutFiles).run(data);

    EXPECT_EQ(data.settings, before);
    EXPECT_EQ(first.view.viewpoint.position_m, box.positions.front());
    EXPECT_LT(irsg::length(first.referencePoints_m.front() -
                           targetPoseOf(before).toWorld(box.referencePoint)),
              1e-9)
        << "the target turns about it";
}

INSTANTIATE_TEST_SUITE_P(
    AllTypes, PolarMode,
    testing::Values(
        PolarRow{"CameraAzimuth",
                 "camera-azimuth",
                 {SixSidedBox::front, SixSidedBox::starboard, SixSidedBox::tail, SixSidedBox::port},
                 {0, 90, 180, 270},
                 {0, 0, 0, 0}},
        PolarRow{"CameraElevation",
                 "camera-elevation",
                 {SixSidedBox::front, SixSidedBox::belly, SixSidedBox::tail, SixSidedBox::top},
                 {0, 0, 180, 0},
                 {0, -90, 0, 90}},
        PolarRow{"ModelYaw",
                 "model-yaw",
                 {SixSidedBox::front, SixSidedBox::starboard, SixSidedBox::tail, SixSidedBox::port},
                 {0, 90, 180, 270},
                 {0, 0, 0, 0}}),
    [](const auto& row) { return row.param.name; });

TEST(PolarAnalysis, ModelYawKeepsTheCameraWhereTheViewerIs) {
    SixSidedBox box;
    box.referencePoint = {0.0, 2.0, 0.0};
    AnalysisData data = asked(AnalysisKind::polar, {{"polar.type", "model-yaw"},
                                                    {"polar.step", "10"},
                                                    {"target.yaw", "37"},
                                                    {"camera.azimuth", "70"},
                                                    {"camera.elevation", "10"}});
    AnalysisGenerator(box, test::sceneWithoutFiles).run(data);
    for (const irsg::Vec3& position : box.positions) {
        EXPECT_LT(irsg::length(position - box.positions.back()), 1e-9);
    }
    EXPECT_EQ(box.positions.size(), 36u);
    // The nose's azimuth faces the camera first: its heading is the camera's, 37 - 70 deg.
    EXPECT_NEAR(column(data, Quantity::yaw).front(), 327, 1e-9);
    EXPECT_NEAR(column(data, Quantity::yaw)[1], 337, 1e-9);
}

TEST(PolarAnalysis, ViewOffsetIsTheElevationOfACameraAzimuthPlot) {
    SixSidedBox box;
    const AnalysisData data =
        ran(asked(AnalysisKind::polar, {{"polar.step", "90"}, {"polar.offset", "90"}}), box);
    EXPECT_THAT(column(data, Quantity::intensity), testing::Each(testing::DoubleNear(5, 1e-9)));
    EXPECT_THAT(column(data, Quantity::elevation), testing::Each(90));
}

TEST(PolarAnalysis, CameraElevationIsUprightOnBothSidesOfTheBelly) {
    SixSidedBox box;
    AnalysisData data = asked(AnalysisKind::polar, {{"polar.type", "camera-elevation"}});
    AnalysisGenerator generator(box, test::sceneWithoutFiles);
    for (const AnalysisCase& one : generator.plan(data).cases) {
        const irsg::Viewpoint view = one.viewpoint({});
        const double phi = one.angle_rad;
        EXPECT_NEAR(irsg::dot(view.up, {0, std::sin(phi), std::cos(phi)}), 1.0, 1e-12);
    }
}

TEST(RangeAnalysis, KeepsContrastIntensityAndFollowsTheInverseSquareLawInVacuum) {
    GreySphere sphere;
    const AnalysisData data = ran(asked(AnalysisKind::range, {{"range.from", "100"},
                                                              {"range.to", "1e7"},
                                                              {"range.points", "11"},
                                                              {"range.log", "true"},
                                                              {"render.background", "0.2"}}),
                                  sphere);
    const double expected =
        irsg::pi * (0.9 * irsg::bandRadiance_W_m2_sr(irsg::Band::topHat(3, 5), 320.0) - 0.2);
    const auto& range = column(data, Quantity::range);
    EXPECT_DOUBLE_EQ(range.front(), 100.0);
    EXPECT_DOUBLE_EQ(range.back(), 1e7);
    for (std::size_t i = 0; i < range.size(); ++i) {
        EXPECT_NEAR(range[i], 100.0 * std::pow(10.0, 0.5 * static_cast<double>(i)),
                    1e-9 * range[i]);
        EXPECT_NEAR(column(data, Quantity::contrastIntensity)[i], expected, 1e-9 * expected);
        EXPECT_NEAR(column(data, Quantity::irradiance)[i] * range[i] * range[i], expected,
                    1e-6 * expected);
    }
}

TEST(RangeAnalysis, LinearRangesAreEquallySpaced) {
    GreySphere sphere;
    const AnalysisData data =
        ran(asked(AnalysisKind::range,
                  {{"range.from", "1000"}, {"range.to", "2000"}, {"range.points", "5"}}),
            sphere);
    EXPECT_THAT(column(data, Quantity::range), testing::ElementsAre(1000, 1250, 1500, 1750, 2000));
}

TEST(TimeAnalysis, ALoopedTableRepeatsAfterItsPeriod) {
    GreySphere sphere;
    sphere.temperature_K = irsg::LookupTable({0, 1, 2}, {300, 400, 300}, true);
    const AnalysisData data =
        ran(asked(AnalysisKind::time, {{"time.from", "0"}, {"time.to", "6"}, {"time.step", "0.5"}}),
            sphere);
    const auto& intensity = column(data, Quantity::intensity);
    ASSERT_EQ(intensity.size(), 13u);
    for (std::size_t i = 4; i < intensity.size(); ++i) {
        EXPECT_NEAR(intensity[i], intensity[i - 4], 1e-9 * intensity[i]);
    }
    EXPECT_NEAR(intensity[2] / intensity[0],
                irsg::bandRadiance_W_m2_sr(irsg::Band::topHat(3, 5), 400.0) /
                    irsg::bandRadiance_W_m2_sr(irsg::Band::topHat(3, 5), 300.0),
                1e-9);
}

TEST(SpectrumAnalysis, CoversTheBandInWavenumbers) {
    GreySphere sphere;
    const AnalysisData data =
        ran(asked(AnalysisKind::spectrum, {{"sensor.band", "4-5"}, {"spectrum.resolution", "100"}}),
            sphere);
    EXPECT_THAT(column(data, Quantity::wavenumber),
                testing::ElementsAre(2000, 2100, 2200, 2300, 2400, 2500));
    EXPECT_NEAR(column(data, Quantity::spectralIntensity)[0],
                irsg::pi * irsg::planckRadiance_W_m2_sr_um(5.0, 320.0), 1e-9);
}

TEST(SpectrumAnalysis, PrintsTheSumsOfItsBand) {
    GreySphere sphere;
    const AnalysisData image = ran(asked(AnalysisKind::image, {{"sensor.band", "4-5"}}), sphere);
    const AnalysisData data =
        ran(asked(AnalysisKind::spectrum, {{"sensor.band", "4-5"}, {"spectrum.resolution", "100"}}),
            sphere);
    const auto printed = [](const AnalysisData& of, const std::string& label) {
        const auto found = std::ranges::find(of.summary, label, &SummaryItem::label);
        return found == of.summary.end() ? std::nan("") : found->value;
    };
    const double inBand_W_sr = printed(data, "in_band_intensity");
    EXPECT_EQ(inBand_W_sr, column(image, Quantity::intensity)[0]);
    EXPECT_EQ(printed(data, "in_band_contrast_intensity"),
              column(image, Quantity::contrastIntensity)[0]);
    // A result that was saved says it again.
    AnalysisData again = resultOf(data.table, "spectrum.csv");
    EXPECT_EQ(printed(again, "in_band_intensity"), inBand_W_sr);
}

TEST(ImageAnalysis, HasTheImageAndOneRowOfSums) {
    GreySphere sphere;
    const AnalysisData data =
        ran(asked(AnalysisKind::image, {{"sensor.width", "32"}, {"sensor.height", "24"}}), sphere);
    EXPECT_EQ(data.image.width(), 32);
    EXPECT_EQ(data.image.height(), 24);
    EXPECT_EQ(data.table.rowCount(), 1u);
    EXPECT_EQ(data.image.attributes.at("program"), irsg::programWithVersion());
    EXPECT_EQ(data.image.attributes.at("sensor.width"), "32 px");
}

TEST(ImageAnalysis, ApparentTemperatureIsThatOfTheBlackBodyOfEqualRadiance) {
    GreySphere sphere;
    const AnalysisData data =
        ran(asked(AnalysisKind::image, {{"image.quantity", "apparent-temperature"}}), sphere);
    const irsg::Band band = irsg::Band::topHat(3, 5);
    const double expected =
        irsg::apparentTemperature_K(band, 0.9 * irsg::bandRadiance_W_m2_sr(band, 320.0)).value();
    EXPECT_EQ(data.image.primary().name, "T_apparent");
    EXPECT_EQ(data.image.primary().unit, "K");
    EXPECT_NEAR(data.image.at(320, 256), expected, 1e-4);
    EXPECT_TRUE(std::isnan(data.image.at(0, 0)));
    EXPECT_THAT(data.warnings, testing::Contains(testing::HasSubstr("no apparent temperature")));
}

TEST(ImageAnalysis, IrradianceIsRadianceTimesSolidAngleTimesCosine) {
    GreySphere sphere;
    const AnalysisData data =
        ran(asked(AnalysisKind::image, {{"image.quantity", "irradiance"}, {"sensor.fov", "60"}}),
            sphere);
    const double radiance = 0.9 * irsg::bandRadiance_W_m2_sr(irsg::Band::topHat(3, 5), 320.0);
    const irsg::Sensor& sensor = sphere.scene.sensor;
    const double expected =
        radiance * sensor.pixelSolidAngle_sr(320, 256) * sensor.cosOffAxis(320, 256);
    EXPECT_NEAR(data.image.at(320, 256), expected, 1e-6 * expected);
    EXPECT_EQ(data.image.primary().unit, "W m-2");
}

TEST(AnalysisGenerator, PlansWithoutDrawing) {
    SixSidedBox box;
    AnalysisGenerator generator(box, test::sceneWithoutFiles);
    const AnalysisPlan plan = generator.plan(asked(AnalysisKind::polar, {{"polar.step", "7"}}));
    EXPECT_EQ(plan.cases.size(), 52u); // 0 to 357 deg
    EXPECT_EQ(plan.description, "polar: 52 cases, angle 0 to 357 deg, 640 x 512 px");
    EXPECT_EQ(box.drawings, 0);
}

TEST(AnalysisGenerator, StopsBetweenCasesKeepsWhatWasDoneAndSaysSo) {
    SixSidedBox box;
    AnalysisData data = asked(AnalysisKind::polar, {{"polar.step", "10"}});
    std::stop_source stop;
    AnalysisGenerator(box, test::sceneWithoutFiles)
        .run(
            data,
            [&](const Progress& progress) {
                if (progress.done == 5) {
                    stop.request_stop();
                }
            },
            stop.get_token());
    EXPECT_EQ(data.state, AnalysisState::partial);
    EXPECT_EQ(data.table.rowCount(), 5u);
    EXPECT_EQ(data.table.provenance.value("state"), "partial");
    EXPECT_THAT(data.warnings, testing::Contains("stopped after 5 of 36 cases"));
}

TEST(AnalysisGenerator, ReportsProgressFromZeroToTheEnd) {
    SixSidedBox box;
    AnalysisData data = asked(AnalysisKind::polar, {{"polar.step", "90"}});
    std::vector<std::size_t> done;
    AnalysisGenerator(box, test::sceneWithoutFiles).run(data, [&](const Progress& progress) {
        EXPECT_EQ(progress.total, 4u);
        done.push_back(progress.done);
    });
    EXPECT_THAT(done, testing::ElementsAre(0, 1, 2, 3, 4));
    EXPECT_EQ(data.state, AnalysisState::complete);
}

TEST(AnalysisGenerator, TellsWhatADrawingRefusesAndKeepsTheCasesBefore) {
    struct Failing : SixSidedBox {
        irsg::RenderReport measure() override {
            if (drawings >= 3) {
                throw irsg::InputError(irsg::Diagnostic{
                    .file = "box", .position = "", .value = "bad", .expected = ""});
            }
            return SixSidedBox::measure();
        }
    } box;
    AnalysisData data = asked(AnalysisKind::polar, {{"polar.type", "model-yaw"}});
    EXPECT_THROW(AnalysisGenerator(box, test::sceneWithoutFiles).run(data), irsg::InputError);
    EXPECT_EQ(data.table.rowCount(), 3u);
}

// Sweeps over range alone take their factors from few distances; the others agree with images.
TEST(AnalysisGenerator, MeasuresAlongTheRangeInRangeSweepsAlone) {
    struct Counting : GreySphere {
        int alongRange = 0;
        std::vector<irsg::RenderReport> reports(const irsg::Outputs& outputs) override {
            alongRange += outputs.isAlongRange() ? 1 : 0;
            return AnalyticSource::reports(outputs);
        }
    };
    for (const auto& [kind, expected] :
         {std::pair{AnalysisKind::range, 7}, {AnalysisKind::polar, 0}, {AnalysisKind::time, 0}}) {
        Counting sphere;
        ran(asked(kind, {{"range.points", "7"}, {"polar.step", "90"}}), sphere);
        EXPECT_EQ(sphere.alongRange, expected) << name(kind);
    }
}

TEST(AnalysisGenerator, GivesTheSameBytesTwice) {
    SixSidedBox box;
    const auto data = asked(AnalysisKind::polar, {});
    EXPECT_EQ(ran(data, box).table.toCsv(), ran(data, box).table.toCsv());
}

TEST(AnalysisGenerator, ProvenanceNamesSettingsThatDifferRendererAndWhoAnswered) {
    SixSidedBox box;
    const AnalysisData data = ran(asked(AnalysisKind::polar, {{"camera.range", "2500"}}), box);
    const Provenance& provenance = data.table.provenance;
    EXPECT_EQ(provenance.value("camera.range"), "2500 m");
    EXPECT_EQ(provenance.value("sensor.width"), "");
    EXPECT_EQ(provenance.value("renderer"), "closed form");
    EXPECT_EQ(provenance.value("answered by"), "transmittance: closed form");
}

TEST(AnalysisGenerator, StagesAddUpToTheWallTime) {
    GreySphere sphere;
    StageTimer timer;
    AnalysisData data = asked(AnalysisKind::range, {{"range.points", "200"}});
    AnalysisGenerator(sphere, test::sceneWithoutFiles).run(data, {}, {}, &timer);
    double sum = 0.0;
    for (const StageTimer::Stage& stage : timer.stages()) {
        sum += stage.seconds;
    }
    EXPECT_NEAR(sum, timer.wall_s(), 0.02 * timer.wall_s() + 1e-4);
}

struct RefusedRow {
    const char* name;
    AnalysisKind kind;
    std::vector<std::pair<std::string, std::string>> settings;
    const char* position;
};

void PrintTo(const RefusedRow& row, std::ostream* out) {
    *out << row.name;
}

class RefusedPlan : public testing::TestWithParam<RefusedRow> {};

TEST_P(RefusedPlan, NamesTheSetting) {
    try {
        planAnalysis(GetParam().kind, Project(),
                     asked(GetParam().kind, GetParam().settings).settings);
        FAIL() << "nothing was refused";
    } catch (const irsg::InputError& error) {
        EXPECT_EQ(error.diagnostics().front().position, GetParam().position);
        EXPECT_FALSE(error.diagnostics().front().value.empty());
        EXPECT_FALSE(error.diagnostics().front().expected.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(
    Plans, RefusedPlan,
    testing::Values(RefusedRow{"ReversedRange",
                               AnalysisKind::range,
                               {{"range.from", "10"}, {"range.to", "5"}},
                               "range.to"},
                    RefusedRow{"EmptyRange",
                               AnalysisKind::range,
                               {{"range.from", "10"}, {"range.to", "10"}},
                               "range.to"},
                    RefusedRow{"LogarithmFromZero",
                               AnalysisKind::range,
                               {{"range.from", "0"}, {"range.log", "true"}},
                               "range.from"},
                    RefusedRow{"ReversedTime",
                               AnalysisKind::time,
                               {{"time.from", "1"}, {"time.to", "0"}},
                               "time.to"},
                    RefusedRow{"MillionsOfTimes",
                               AnalysisKind::time,
                               {{"time.to", "1000"}, {"time.step", "1e-4"}},
                               "time.step"},
                    RefusedRow{"MillionsOfWavenumbers",
                               AnalysisKind::spectrum,
                               {{"sensor.band", "0.2-40"}, {"spectrum.resolution", "0.01"}},
                               "spectrum.resolution"},
                    RefusedRow{"OffsetOfAnotherMode",
                               AnalysisKind::polar,
                               {{"polar.type", "model-yaw"}, {"polar.offset", "5"}},
                               "polar.offset"}),
    [](const auto& row) { return row.param.name; });

TEST(AnalysisData, EquivalentCommandSaysWhatTheProjectFileDoesNot) {
    Project project;
    project.file = "/p/a b.smat";
    Settings overrides;
    overrides.set("polar.step", "4");
    overrides.set("range.from", "7"); // of another kind: not said
    overrides.set("environment.atmospheres", "air.csv");
    const AnalysisData data = AnalysisData::of(project, AnalysisKind::polar, overrides);
    EXPECT_EQ(data.equivalentCommand("out.csv"),
              "smat-batch polar '/p/a b.smat' --atmosphere=/p/air.csv --step=4 --out out.csv");
}

TEST(AnalysisData, ANameThatIsNotThereIsRefusedWithTheNamesThereAre) {
    Project project;
    project.analyses = {{.name = "one"}, {.name = "two"}};
    try {
        AnalysisData::of(project, "three");
        FAIL();
    } catch (const irsg::InputError& error) {
        EXPECT_EQ(error.diagnostics().front().expected, "one of one, two");
    }
}

} // namespace
} // namespace smat
