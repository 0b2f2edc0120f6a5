#include "gui/plot/ResultPlot.h"

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "smatcore/data/ResultDifference.h"
#include "tests/gui/ResultTables.h"

namespace smat::gui {
namespace {

TEST(ResultPlotTest, OffersWhatWasMeasuredContrastFirst) {
    const auto keys = plottableQuantities(test::polarTable());
    ASSERT_EQ(keys.size(), 2U);
    EXPECT_EQ(keys[0], "contrast_intensity");
    EXPECT_EQ(keys[1], "intensity");
}

TEST(ResultPlotTest, DrawsAnAngleOnAPolarPlotAndTheRestOnAxes) {
    EXPECT_TRUE(isPolar(test::polarTable()));
    EXPECT_FALSE(isPolar(test::rangeTable()));
}

TEST(ResultPlotTest, MarksWhereTheHorizonHidesAnObjectAlongTheRange) {
    const auto tableWith = [](const std::vector<double>& hidden) {
        ResultTable table;
        table.add("range", "m").values = {10e3, 20e3, 30e3, 40e3};
        table.add("contrast_intensity", "W sr-1").values = {4.0, 3.0, 1.0, 0.0};
        table.add("hidden_by_horizon", "").values = hidden;
        return table;
    };
    const ResultTable table = tableWith({0.0, 0.3, 0.8, 1.0});
    const PlotData data = cartesianData({{"run", &table}}, "contrast_intensity");
    ASSERT_EQ(data.marks.size(), 2u);
    EXPECT_EQ(data.marks[0], (PlotMark{20e3, "partly behind the horizon"}));
    EXPECT_EQ(data.marks[1], (PlotMark{40e3, "behind the horizon"}));
    // The same of two results is marked once; where nothing is hidden there is none.
    EXPECT_EQ(cartesianData({{"a", &table}, {"b", &table}}, "contrast_intensity").marks.size(), 2u);
    const ResultTable clear = tableWith({0.0, 0.0, 0.0, 0.0});
    EXPECT_TRUE(cartesianData({{"run", &clear}}, "contrast_intensity").marks.empty());
}

TEST(ResultPlotTest, StatesModeOffsetAndDirection) {
    const auto table = test::polarTable("camera-azimuth");
    const auto data = polarData({{"run", &table}}, "contrast_intensity");
    EXPECT_TRUE(data.clockwise);
    EXPECT_TRUE(data.title.contains("camera azimuth, view offset 12°")) << data.title.toStdString();
    EXPECT_TRUE(data.directionNote.contains("clockwise"));
    EXPECT_TRUE(data.radiusTitle.contains("W·sr⁻¹"));
    EXPECT_DOUBLE_EQ(data.curves.at(0).y.at(9), 190.0);
}

TEST(ResultPlotTest, SaysTheNameOfALoneResultOnce) {
    auto table = test::polarTable();
    const auto data = polarData({{"run", &table}}, "intensity");
    EXPECT_EQ(data.curves.at(0).name, "run");
    EXPECT_FALSE(data.title.contains("run")) << data.title.toStdString();
    for (int angle = 0; angle < 360; angle += 10) {
        table.addRow({1.0 * angle, 1.0 * angle, 30.0, 0.0, 1.0, 2.0 + angle});
    }
    // Its curves are named after their turns.
    EXPECT_TRUE(polarData({{"run", &table}}, "intensity").title.endsWith(" – run"));
}

TEST(ResultPlotTest, SaysTheConditionsUnderTheTitle) {
    auto table = test::polarTable("camera-azimuth");
    table.provenance.add("analysis", "polar");
    table.provenance.add("sensor.band", "8-12 um");
    table.provenance.add("target.altitude", "1500 m");
    const auto data = polarData({{"run", &table}}, "contrast_intensity");
    EXPECT_EQ(data.conditions,
              "8-12 µm · range 1000 m · elevation 12° · altitude 1500 m · vacuum · time 0 s");
    // Of two that differ in the band the rest is said.
    auto other = table;
    other.provenance.entries[2].second = "3-5 um";
    const auto both = polarData({{"a", &table}, {"b", &other}}, "contrast_intensity");
    EXPECT_FALSE(both.conditions.contains("µm")) << both.conditions.toStdString();
    EXPECT_TRUE(both.conditions.contains("altitude 1500 m"));
}

TEST(ResultPlotTest, DrawsACurveForEachTurnOfAPolarPlot) {
    ResultTable table = test::polarTable("camera-azimuth");
    for (int angle = 0; angle < 360; angle += 10) {
        table.addRow({1.0 * angle, 1.0 * angle, 30.0, 0.0, 1.0, 2.0 + angle});
    }
    const auto data = polarData({{"run", &table}}, "contrast_intensity");
    ASSERT_EQ(data.curves.size(), 2U);
    EXPECT_EQ(data.curves[0].name, "elevation 12°");
    EXPECT_EQ(data.curves[1].name, "elevation 30°");
    EXPECT_EQ(data.curves[0].x.size(), 36U);
    EXPECT_EQ(data.curves[1].y.front(), 2.0);
    EXPECT_TRUE(data.title.contains("several view offsets")) << data.title.toStdString();
    const NamedResult a{"a", &table, false}, b{"b", &table, false};
    EXPECT_EQ(polarData({a, b}, "intensity").curves[3].name, "b, elevation 30°");
}

TEST(ResultPlotTest, TurnsCounterClockwiseForTheOtherModes) {
    for (const auto* type : {"camera-elevation", "model-yaw"}) {
        const auto table = test::polarTable(type);
        EXPECT_FALSE(polarData({{"run", &table}}, "intensity").clockwise) << type;
    }
}

TEST(ResultPlotTest, KnowsTheModeFromTheColumnsWhereNothingStatesIt) {
    EXPECT_EQ(polarTypeOf(test::polarTable()), "camera-azimuth");
}

TEST(ResultPlotTest, RefusesToOverlayDifferentSweeps) {
    const auto azimuth = test::polarTable("camera-azimuth");
    const auto yaw = test::polarTable("model-yaw");
    EXPECT_THROW(polarData({{"a", &azimuth}, {"b", &yaw}}, "intensity"), irsg::InputError);
    const auto range = test::rangeTable();
    EXPECT_THROW(cartesianData({{"a", &azimuth}, {"b", &range}}, "intensity"), irsg::InputError);
}

TEST(ResultPlotTest, NamesTheColumnsThereAreWhenOneIsMissing) {
    const auto table = test::rangeTable();
    try {
        cartesianData({{"run", &table}}, "irradiance");
        FAIL();
    } catch (const irsg::InputError& error) {
        EXPECT_NE(error.diagnostics().front().expected.find("contrast_intensity"),
                  std::string::npos);
    }
    EXPECT_THROW(plottableQuantities(ResultTable()), irsg::InputError);
}

/// A range result of two objects in two bands, each column a constant.
ResultTable tableOfSeries() {
    ResultTable table;
    table.add(irsg::Quantity::range);
    double value = 1.0;
    std::vector<double> row = {100.0};
    for (const char* object : {"", "near.", "far."}) {
        for (const char* band : {"@3-5um", "@8-12um"}) {
            table.add(object + std::string("contrast_intensity") + band, "W sr-1");
            row.push_back(value++);
        }
    }
    table.addRow(row);
    row[0] = 200.0;
    table.addRow(row);
    return table;
}

TEST(ResultPlotTest, DrawsACurveForEachObjectAndBand) {
    const auto table = tableOfSeries();
    EXPECT_EQ(plottableQuantities(table), std::vector<std::string>{"contrast_intensity"});
    EXPECT_EQ(quantityTitle(table, "contrast_intensity"), "Contrast intensity (W·sr⁻¹)");
    const auto data = cartesianData({{"run", &table}}, "contrast_intensity");
    ASSERT_EQ(data.curves.size(), 6U);
    EXPECT_EQ(data.curves[0].name, "run: all, 3-5 µm");
    EXPECT_EQ(data.curves[3].name, "run: near, 8-12 µm");
    EXPECT_EQ(data.curves[3].y.front(), 4.0);
    EXPECT_EQ(data.yTitle, "Contrast intensity (W·sr⁻¹)");
    // One column alone is drawn as ever.
    const auto one = cartesianData({{"run", &table}}, "near.contrast_intensity@8-12um");
    ASSERT_EQ(one.curves.size(), 1U);
    EXPECT_EQ(one.curves[0].name, "run");
    EXPECT_EQ(one.yTitle, "Contrast intensity, near, 8-12 um (W·sr⁻¹)");
}

TEST(ResultPlotTest, OverlaysBandsOnAResultOfOneBand) {
    const auto several = tableOfSeries(), one = test::rangeTable();
    EXPECT_TRUE(goOnOnePlot(one, several));
    const auto data = cartesianData({{"a", &one}, {"b", &several}}, "contrast_intensity");
    ASSERT_EQ(data.curves.size(), 7U);
    EXPECT_EQ(data.curves[0].name, "a");
    EXPECT_EQ(data.curves[1].name, "b: all, 3-5 µm");
}

TEST(ResultPlotTest, HasALogarithmicAxisWhereValuesStandByEqualRatios) {
    const auto plain = test::rangeTable();
    EXPECT_FALSE(cartesianData({{"run", &plain}}, "contrast_intensity").xLogarithmic);
    for (const char* key : {"range.log", "condition.log"}) {
        auto table = test::rangeTable();
        table.provenance.add(key, "true");
        EXPECT_TRUE(cartesianData({{"run", &table}}, "contrast_intensity").xLogarithmic) << key;
    }
}

TEST(ResultPlotTest, SamplesWarnOfWhatTheirRowsDo) {
    ResultTable table = test::polarTable();
    table.setWarning(3, "cut by the frame");
    table.provenance.add("warning", "at 30 deg: cut by the frame");
    const PolarData polar = polarData({{"a", &table}}, "contrast_intensity");
    EXPECT_EQ(polar.curves[0].warningOf(3), "cut by the frame");
    EXPECT_EQ(polar.curves[0].warningOf(4), "");
    EXPECT_EQ(polar.warnings, QStringList{"at 30 deg: cut by the frame"});
    EXPECT_TRUE(polar.conditions.endsWith("hollow points: cut by the frame"));

    ResultTable range = test::rangeTable();
    const PlotData plain = cartesianData({{"a", &range}}, "contrast_intensity");
    EXPECT_TRUE(plain.curves[0].warnings.empty());
    range.setWarning(0, "too near");
    range.provenance.add("warning", "too near");
    const ResultTable other = test::rangeTable();
    const PlotData both = cartesianData({{"a", &range}, {"b", &other}}, "contrast_intensity");
    EXPECT_EQ(both.curves[0].warningOf(0), "too near");
    EXPECT_TRUE(both.curves[1].warnings.empty());
    EXPECT_EQ(both.warnings, QStringList{"a: too near"});
}

TEST(ResultPlotTest, LabelsAxesWithUnits) {
    const auto table = test::rangeTable();
    const auto data = cartesianData({{"run", &table}}, "contrast_intensity");
    EXPECT_EQ(data.xTitle, "Range (m)");
    EXPECT_EQ(data.yTitle, "Contrast intensity (W·sr⁻¹)");
}

} // namespace
} // namespace smat::gui
