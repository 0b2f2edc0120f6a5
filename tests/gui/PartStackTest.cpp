// Plots that stack what parts add to a sum.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotExport.h"
#include "gui/plot/PolarPlot.h"
#include "gui/plot/ResultPlot.h"
#include "irsg/core/Errors.h"
#include "tests/gui/GuiEnvironment.h"

namespace smat::gui {
namespace {

/// Two parts that add up to a sum, and one that adds nothing.
ResultTable ofParts(const char* abscissa = "range") {
    ResultTable table;
    table.add(abscissa, "m");
    for (const char* key :
         {"intensity", "f/cold.intensity", "f/hot.intensity", "f/gone.intensity"}) {
        table.add(key, "W sr-1");
    }
    table.addRow({1.0, 11.0, 1.0, 10.0, 0.0});
    table.addRow({2.0, 18.0, -2.0, 20.0, 0.0});
    table.addRow({3.0, 33.0, 3.0, 30.0, 0.0});
    return table;
}

TEST(PartStack, LayersLieOnEachOtherTheLargestFirstAndTheSumIsALine) {
    const ResultTable table = ofParts();
    ASSERT_TRUE(canStack(table, "intensity"));
    const PlotData data = cartesianData({{"run", &table}}, "intensity", true);
    ASSERT_EQ(data.curves.size(), 3U); // without the part that adds nothing
    const Curve &hot = data.curves[0], &cold = data.curves[1], &all = data.curves[2];
    EXPECT_EQ(hot.name, "hot");
    EXPECT_EQ(cold.name, "cold");
    EXPECT_EQ(all.name, "all");
    EXPECT_EQ(hot.base, (std::vector<double>{0.0, 0.0, 0.0}));
    EXPECT_EQ(hot.y, (std::vector<double>{10.0, 20.0, 30.0}));
    // What is below 0 goes downwards from 0.
    EXPECT_EQ(cold.base, (std::vector<double>{10.0, 0.0, 30.0}));
    EXPECT_EQ(cold.y, (std::vector<double>{11.0, -2.0, 33.0}));
    EXPECT_EQ(all.y, (std::vector<double>{11.0, 18.0, 33.0}));
    EXPECT_FALSE(all.isLayer());
    // What is read is the part's own.
    EXPECT_EQ(cold.readoutAt(3.0), "3");
    EXPECT_EQ(cold.readoutAt(2.0), "-2");
    const QString csv = toCsv(data.curves, "x", "y");
    EXPECT_TRUE(csv.contains("\n2,20,-2,18\n")) << csv.toStdString();
    // Without the stack there are four lines.
    EXPECT_EQ(cartesianData({{"run", &table}}, "intensity").curves.size(), 4U);
}

TEST(PartStack, IsForOneBandOneTurnAndPartsOrObjects) {
    ResultTable bands = ofParts();
    bands.add("intensity@3-5um", "W sr-1");
    ResultTable two;
    two.add("range", "m");
    for (const char* key :
         {"intensity@3-5um", "f/a.intensity@3-5um", "intensity@8-12um", "f/a.intensity@8-12um"}) {
        two.add(key, "W sr-1");
    }
    two.addRow({1.0, 1.0, 1.0, 2.0, 2.0});
    EXPECT_FALSE(canStack(two, "intensity"));
    EXPECT_THROW((void)cartesianData({{"run", &two}}, "intensity", true), irsg::LogicError);
    ResultTable objects;
    objects.add("range", "m");
    for (const char* key : {"intensity", "near.intensity", "far.intensity"}) {
        objects.add(key, "W sr-1");
    }
    objects.addRow({1.0, 3.0, 1.0, 2.0});
    ASSERT_TRUE(canStack(objects, "intensity"));
    const PlotData data = cartesianData({{"run", &objects}}, "intensity", true);
    EXPECT_EQ(data.curves[0].name, "far");
    ResultTable alone;
    alone.add("range", "m");
    alone.add("intensity", "W sr-1");
    alone.addRow({1.0, 3.0});
    EXPECT_FALSE(canStack(alone, "intensity"));
}

TEST(PartStack, ItsAreasAreFilledBetweenTheirEdges) {
    const ResultTable table = ofParts();
    CartesianPlot plot(PlotStyle::paper());
    plot.setData(cartesianData({{"run", &table}}, "intensity", true));
    plot.resize(600, 400);
    plot.show();
    const QImage picture = plot.canvas()->grab().toImage();
    const auto at = [&](double x, double y) {
        return picture.pixelColor(static_cast<int>(plot.transform(QwtPlot::xBottom, x)),
                                  static_cast<int>(plot.transform(QwtPlot::yLeft, y)));
    };
    const QColor hot = at(2.37, 8.1), paper = at(1.53, 29.3);
    EXPECT_NE(hot, paper);
    EXPECT_EQ(at(2.13, 7.3), hot);
    EXPECT_NE(at(2.93, 30.6), paper);
    EXPECT_NE(at(2.93, 30.6), hot); // of the cold one
}

TEST(PartStack, APolarStackClosesAndKeepsItsValues) {
    ResultTable table;
    table.provenance.add("polar.type", "camera-azimuth");
    table.add("angle", "deg");
    table.add("elevation", "deg");
    for (const char* key : {"intensity", "f/a.intensity", "f/b.intensity"}) {
        table.add(key, "W sr-1");
    }
    for (int angle = 0; angle < 360; angle += 30) {
        table.addRow({1.0 * angle, 0.0, 30.0 + angle, 10.0, 20.0 + angle});
    }
    PolarPlot plot(PlotStyle::paper());
    plot.setData(polarData({{"run", &table}}, "intensity", true));
    plot.resize(500, 500);
    EXPECT_EQ(plot.data().curves.size(), 3U);
    EXPECT_TRUE(plot.readoutAt(plot.canvasPoint(90.0, 60.0)).contains("a: 10"))
        << plot.readoutAt(plot.canvasPoint(90.0, 60.0)).toStdString();
    EXPECT_TRUE(plotValues(plot, PlotPart::all).contains("110"));
    // Layers do not become decibels, which would not add.
    PolarData shown = inShownUnits(plot.stored());
    EXPECT_EQ(shown.radiusTitle, plot.stored().radiusTitle);
}

} // namespace
} // namespace smat::gui
