// What is counted of an image beside it: statistics, histogram and the table of figures.
#include "gui/image/ImageInspector.h"

#include <QLabel>
#include <QwtScaleDiv>
#include <QwtScaleDraw>
#include <QwtScaleMap>
#include <QwtText>

#include "gui/image/FiguresTable.h"
#include "gui/image/HistogramPlot.h"
#include "gui/image/ImageCanvas.h"
#include "irsg/image/ImageIntensity.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/ImageViewFixture.h"
#include "tests/gui/SampleProject.h"

namespace smat::gui {
namespace {

using test::ImageViewTest;

TEST_F(ImageViewTest, StatisticsFollowADraggedRectangle) {
    EXPECT_TRUE(view.statistics().startsWith("Image 8 × 6"));
    QTest::mousePress(view.canvas(), Qt::LeftButton, {},
                      view.canvas()->widgetPoint({1.2, 0.2}).toPoint());
    QTest::mouseRelease(view.canvas(), Qt::LeftButton, {},
                        view.canvas()->widgetPoint({2.8, 1.8}).toPoint());
    EXPECT_TRUE(view.statistics().startsWith("Rectangle 2 × 2 at (1, 0)"))
        << view.statistics().toStdString();
    EXPECT_TRUE(view.statistics().contains("mean 2"));
    QTest::mouseClick(view.canvas(), Qt::LeftButton, {},
                      view.canvas()->widgetPoint({4.5, 4.5}).toPoint());
    EXPECT_TRUE(view.statistics().startsWith("Image"));
}

TEST_F(ImageViewTest, HistogramAndTableFollowTheRectangle) {
    QTest::keyClick(view.canvas(), Qt::Key_H);
    ASSERT_TRUE(test::waitUntil([&] { return !view.isBusy(); }));
    const auto& histogram = view.inspector()->histogram()->histogram();
    EXPECT_EQ(histogram.counts.front(), 47u);
    EXPECT_EQ(histogram.counts.back(), 1u);
    EXPECT_TRUE(view.inspector()
                    ->histogram()
                    ->axisTitle(QwtPlot::xBottom)
                    .text()
                    .contains("Radiance (W·m⁻²·sr⁻¹)"));
    view.canvas()->setSelection(irsg::PixelRectangle{1, 0, 2, 2});
    emit view.canvas()->selectionChanged();
    ASSERT_TRUE(test::waitUntil([&] { return !view.isBusy(); }));
    EXPECT_EQ(view.inspector()->histogram()->histogram().counts.front(), 3u);
    EXPECT_TRUE(view.inspector()->table()->allText().contains("Mean\t1.08333\t2\n"))
        << view.inspector()->table()->allText().toStdString();
    test::keepScreenshot(view, "image-view-histogram");
}

TEST(HistogramPlot, NumbersBesideEachOtherDoNotRunIntoEachOther) {
    // As with the sun in the picture: six digits, or thirty decades.
    const struct {
        double low, high;
        bool logarithmic;
    } rows[] = {{0.0, 2.4e6, false}, {0.02, 6.1e6, true}, {3.1, 4.2e3, true}, {1e-20, 1e10, true}};
    HistogramPlot plot;
    plot.show();
    for (const int width : {200, 260, 420, 900}) {
        plot.resize(width, 160);
        for (const auto& row : rows) {
            irsg::Histogram histogram;
            histogram.logarithmic = row.logarithmic;
            histogram.edges = {row.low, row.high};
            histogram.counts = {7};
            plot.setHistogram(histogram, "Radiance");
            const auto ticks = plot.axisScaleDiv(QwtPlot::xBottom).ticks(QwtScaleDiv::MajorTick);
            EXPECT_GE(ticks.size(), 1) << width << " px to " << row.high;
            const QFont font = plot.axisFont(QwtPlot::xBottom);
            for (qsizetype i = 1; i < ticks.size(); ++i) {
                const auto half = [&](double tick) {
                    return 0.5 *
                           plot.axisScaleDraw(QwtPlot::xBottom)->label(tick).textSize(font).width();
                };
                const auto at = [&](double tick) {
                    return plot.canvasMap(QwtPlot::xBottom).transform(tick);
                };
                EXPECT_LT(at(ticks[i - 1]) + half(ticks[i - 1]), at(ticks[i]) - half(ticks[i]))
                    << width << " px to " << row.high << ", number " << i;
            }
        }
    }
}

TEST(FiguresTable, NamesOfANarrowTableWrapAndNumbersStayWhole) {
    FiguresTable table;
    table.setFigures({"Figure", "Image"},
                     {{"Mean", "1.24316"}, {"Contrast intensity of the object", "225.332 W·sr⁻¹"}});
    table.resize(640, 300);
    table.show();
    QTest::qWait(20);
    EXPECT_EQ(table.rowHeight(1), table.rowHeight(0));
    table.resize(220, 300);
    QTest::qWait(20);
    EXPECT_GE(table.rowHeight(1), table.rowHeight(0) + table.fontMetrics().height() / 2);
    EXPECT_GE(table.columnWidth(1), table.fontMetrics().horizontalAdvance("225.332 W·sr⁻¹"));
    table.resize(640, 300);
    QTest::qWait(20);
    EXPECT_EQ(table.rowHeight(1), table.rowHeight(0));
}

TEST_F(ImageViewTest, StatisticsOfARectangleKnowItsContrastIntensity) {
    irsg::RadianceImage image = small();
    image.attributes["sensor.horizontal_field_of_view_deg"] = "2";
    image.attributes["range_m"] = "1000";
    image.attributes["background_W_m2_sr"] = "1";
    view.setImage(image);
    const auto intensity = irsg::contrastIntensity_W_sr(image, image.primary());
    ASSERT_TRUE(intensity);
    EXPECT_TRUE(view.statistics().contains(
        QString("contrast intensity %1 W·sr⁻¹").arg(*intensity, 0, 'g', 4)))
        << view.statistics().toStdString();
    view.setImage(small());
    EXPECT_FALSE(view.statistics().contains("contrast intensity"));
}

} // namespace
} // namespace smat::gui
