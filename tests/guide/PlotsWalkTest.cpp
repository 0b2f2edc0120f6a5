#include <QApplication>
#include <QClipboard>
#include <QImage>
#include <QwtLegend>
#include <QwtLegendLabel>
#include <QwtPlotCanvas>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotExport.h"
#include "gui/plot/PlotPanel.h"
#include "gui/plot/PolarPlot.h"
#include "smatcore/results/ResultFolder.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

class PlotsWalkTest : public test::GuideFixture {};

TEST_F(PlotsWalkTest, ZoomReadExportAndOverlay) {
    test::GuideWalk walk("plots", "");
    test::keepClipboard();
    openSample();
    workbench.set("render.errors", "off"); // a plot without, for the end of the walk
    runAnalysis("range");
    auto* page = window->currentPage();
    CartesianPlot& plot = *page->cartesianPlot();
    QWidget* sheet = plot.canvas();
    const QPointF middle(sheet->rect().center());
    const auto whole = plot.view();

    walk.step("zoom | wheel at the cursor, or drag a rectangle");
    wheel(sheet, middle, 1);
    EXPECT_LT(plot.view().x.maximum - plot.view().x.minimum, whole.x.maximum - whole.x.minimum);
    drag(sheet, Qt::LeftButton, middle - QPointF(60, 40), {120, 80});
    const auto part = plot.view();
    walk.step("move | drag with the right button");
    drag(sheet, Qt::RightButton, middle, {40, 20});
    EXPECT_NE(plot.view(), part);
    walk.step("go back | Backspace takes a zoom back, a double click shows all");
    QTest::keyClick(&plot, Qt::Key_Backspace);
    EXPECT_EQ(plot.view(), part);
    QTest::mouseDClick(sheet, Qt::LeftButton, {}, middle.toPoint());
    EXPECT_EQ(plot.view(), whole);

    walk.step("read | hover: the crosshair shows every curve, interpolated");
    QString read;
    QObject::connect(&plot, &CartesianPlot::readoutChanged, &plot,
                     [&](const QString& text) { read = text; });
    mouse(sheet, QEvent::MouseMove, middle, Qt::NoButton, Qt::NoButton);
    EXPECT_TRUE(read.contains("Range (m)") && read.contains("Range plot")) << read.toStdString();

    walk.step("hide a curve | click on it in the legend");
    auto* entry = plot.legend()->findChild<QwtLegendLabel*>();
    ASSERT_NE(entry, nullptr);
    QTest::mouseClick(entry, Qt::LeftButton);
    EXPECT_FALSE(plot.isCurveVisible(0));
    QTest::mouseClick(entry, Qt::LeftButton);
    EXPECT_TRUE(plot.isCurveVisible(0));

    walk.step(
        "change an axis | log x, log y; dB for the radius of a polar plot; Axis limits… takes "
        "exact numbers");
    for (const auto& [name, axis] :
         {std::pair("logX", QwtPlot::xBottom), std::pair("logY", QwtPlot::yLeft)}) {
        const bool was = plot.isLogarithmic(axis);
        page->panel()->action(name)->trigger();
        EXPECT_NE(plot.isLogarithmic(axis), was) << name;
        page->panel()->action(name)->trigger();
    }
    onDialog = [](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("limit1From")->setText("612.5");
        dialog.findChild<QLineEdit*>("limit1To")->setText("987.25");
    };
    page->panel()->action("axisLimits")->trigger();
    onDialog = nullptr;
    EXPECT_EQ(plot.view().x, (Interval{612.5, 987.25}));

    walk.step("copy | picture, all values or the visible ones");
    page->panel()->action("copyPicture")->trigger();
    EXPECT_FALSE(QApplication::clipboard()->image().isNull());
    page->panel()->action("copyValues")->trigger();
    const auto visible = QApplication::clipboard()->text().count('\n');
    page->panel()->action("copyAllValues")->trigger();
    EXPECT_EQ(QApplication::clipboard()->text().count('\n'), 1 + 5);
    EXPECT_LT(visible, 1 + 5);

    walk.step("export | SVG, PDF, PNG at twice the size, CSV of all values or the visible ones");
    for (const char* name : {"a.svg", "a.pdf", "a.png"}) {
        chosen = path(name);
        page->panel()->action("savePlot")->trigger();
        EXPECT_GT(std::filesystem::file_size(folder / name), 1000U) << name;
    }
    EXPECT_EQ(QImage(path("a.png")).size(), 2 * cartesianPaper);
    chosen = path("all.csv");
    page->panel()->action("saveAllValues")->trigger();
    chosen = path("seen.csv");
    page->panel()->action("saveValues")->trigger();
    EXPECT_GT(std::filesystem::file_size(folder / "all.csv"),
              std::filesystem::file_size(folder / "seen.csv"));

    walk.step("conditions: band, range, aspect, altitude, atmosphere and time, as far as all "
              "curves share");
    for (const char* word : {"3-5 µm", "azimuth 60°", "altitude 100 m", "time 0 s"}) {
        EXPECT_TRUE(plot.data().conditions.contains(word))
            << word << " in " << plot.data().conditions.toStdString();
    }
    runAnalysis("polar");
    auto* polar = window->currentPage()->polarPlot();
    EXPECT_TRUE(polar->data().conditions.contains("range 1000 m"))
        << polar->data().conditions.toStdString();
    window->currentPage()->panel()->action("decibel")->trigger();
    EXPECT_EQ(polar->radiusScale(), RadiusScale::decibel);
    workbench.set("sensor.band", "8-12");
    runAnalysis("polar");
    selectResults({1, 2});
    act("overlayResultsAction");
    const auto named = [this](int curve) {
        return window->currentPage()->polarPlot()->data().curves.at(curve).name;
    };
    EXPECT_EQ(named(0), "3-5 µm");
    EXPECT_EQ(named(1), "8-12 µm");
    EXPECT_FALSE(window->currentPage()->polarPlot()->data().conditions.contains("µm"));
    // And the paint.
    for (const double emissivity : {0.9, 0.3}) {
        workbench.database().edit("paint", [=](irsg::SignatureDatabase& database) {
            database.materials.begin()->second.emissivity = irsg::Spectrum::constant(emissivity);
        });
        runAnalysis("polar");
    }
    selectResults({3, 4});
    act("overlayResultsAction");
    EXPECT_EQ(named(0), "ε 0.9");
    EXPECT_EQ(named(1), "ε 0.3");
    walk.step("A renamed result keeps its name there.");
    workbench.resultStore().rename(workbench.results()[3].id, "as delivered");
    selectResults({3, 4});
    act("overlayResultsAction");
    EXPECT_EQ(named(0), "as delivered");
    workbench.database().discard();

    walk.step("Points with a warning are hollow: the target reaches out of the frame, for "
              "example. The crosshair shows the sentence, the line below the title repeats it, and "
              "saved values have a column for it.");
    workbench.set("sensor.fov", "1");
    runAnalysis("range");
    const CartesianPlot& cut = *window->currentPage()->cartesianPlot();
    const QString sentence = cut.data().curves[0].warningOf(0);
    EXPECT_TRUE(sentence.contains("beyond the frame")) << sentence.toStdString();
    EXPECT_TRUE(cut.data().conditions.contains("hollow points: " + sentence));
    const double first = cut.transform(QwtPlot::xBottom, cut.data().curves[0].x[0]);
    EXPECT_TRUE(cut.readoutAt(QPointF(first + 1.0, 40.0)).contains(sentence));
    EXPECT_TRUE(plotValues(cut, PlotPart::all, ',').contains(",warning\n"));
    workbench.set("sensor.fov", "10");

    walk.step("Missing points leave a gap. If a result has an error");
    EXPECT_FALSE(page->panel()->action("errorBands")->isEnabled());
    workbench.set("render.errors", "sum");
    workbench.set("range.points", "3");
    runAnalysis("range");
    EXPECT_TRUE(window->currentPage()->panel()->action("errorBands")->isEnabled());
    const auto text = smat::test::contentOf(folder / "all.csv");
    EXPECT_NE(text.find("987.25"), text.find("1000")) << "a table of numbers";
    EXPECT_EQ(text.find("1,000.0"), std::string::npos);

    walk.step(
        "A signature table has a page of its own, with a map over azimuth and elevation and a "
        "ball");
    runAnalysis("table");
    EXPECT_NE(window->currentPage()->tablePanel(), nullptr);

    walk.step("smat plot RESULT.csv -o FILE.svg");
    chosen = path("RESULT.csv");
    selectResults({0});
    act("saveResultAction");
    const auto ran = smat::test::runProgram(
        {std::string(SMAT_BINARY_DIR) + "/bin/smat", "plot", "RESULT.csv", "-o", "FILE.svg"},
        folder);
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_GT(std::filesystem::file_size(folder / "FILE.svg"), 1000U);
    EXPECT_TRUE(told.isEmpty()) << said();
}

} // namespace
} // namespace smat::gui
